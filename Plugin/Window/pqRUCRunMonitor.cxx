// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRUCRunMonitor.h"

#include "RunProgress.h"
#include "RunState.h"
#include "vtkRUCStopRequest.h"

#include <pqApplicationCore.h>
#include <pqProgressManager.h>
#include <vtkClientServerStream.h>
#include <vtkNew.h>
#include <vtkPVPluginTracker.h>
#include <vtkPVXMLElement.h>
#include <vtkSMProxy.h>
#include <vtkSMProxyIterator.h>
#include <vtkSMProxyManager.h>
#include <vtkSMSession.h>
#include <vtkSMSessionProxyManager.h>

#include <QApplication>
#include <QFileInfo>
#include <QWidget>

#include <optional>
#include <string>

namespace
{
constexpr int Patience = 1000; // milliseconds

// The hint `Run` of the filters in the pipeline with this label, or null
vtkPVXMLElement* FindHint(const std::string& label)
{
  vtkSMSessionProxyManager* proxies =
    vtkSMProxyManager::GetProxyManager()->GetActiveSessionProxyManager();
  vtkNew<vtkSMProxyIterator> sources;
  sources->SetSessionProxyManager(proxies);
  sources->SetModeToOneGroup();
  for (sources->Begin("sources"); proxies && !sources->IsAtEnd(); sources->Next())
  {
    vtkSMProxy* proxy = sources->GetProxy();
    if (proxy->GetXMLLabel() == label && proxy->GetHints())
    {
      return proxy->GetHints()->FindNestedElementByName("Run");
    }
  }
  return nullptr;
}

QString Program()
{
  auto* tracker = vtkPVPluginTracker::GetInstance();
  for (unsigned int n = 0; n < tracker->GetNumberOfPlugins(); ++n)
  {
    if (QString(tracker->GetPluginName(n)) == "RepresentativeUnitCell")
    {
      const QFileInfo plugin(tracker->GetPluginFileName(n));
      return QFileInfo(plugin.canonicalFilePath()).path() + "/RepresentativeUnitCellRun";
    }
  }
  return {};
}
}

pqRUCRunMonitor::pqRUCRunMonitor(QObject* parent)
  : QObject(parent)
{
}

void pqRUCRunMonitor::onStartup()
{
  auto* progress = pqApplicationCore::instance()->getProgressManager();
  QObject::connect(progress, &pqProgressManager::progress, this, &pqRUCRunMonitor::onProgress);
  QObject::connect(
    progress, &pqProgressManager::enableProgress, this, &pqRUCRunMonitor::onEnableProgress);
}

void pqRUCRunMonitor::onShutdown()
{
  this->onEnableProgress(false);
}

void pqRUCRunMonitor::onEnableProgress(bool running)
{
  if (!running)
  {
    // The window ends when its input does.
    this->Running.invalidate();
    this->Window.closeWriteChannel();
    this->Window.waitForFinished(Patience);
  }
}

void pqRUCRunMonitor::onProgress(const QString& text, int percent)
{
  const std::optional<RunProgress> progress = RunProgress::FromText(text.toStdString());
  if (!progress)
  {
    return;
  }
  if (!this->Running.isValid())
  {
    this->Running.start();
    this->Opened = false;
    this->Unsaid.clear();
  }
  this->Unsaid += this->describe(*progress, percent);
  if (!this->Opened)
  {
    if (this->Running.elapsed() < Patience)
    {
      return;
    }
    this->Opened = true;
    this->open();
  }
  if (this->Window.state() != QProcess::Running)
  {
    return; // closed by the user: the run goes on
  }
  this->Window.write(this->Unsaid);
  this->Unsaid.clear();
  // There is no event loop that would write and read meanwhile
  this->Window.waitForBytesWritten(0);
  this->Window.waitForReadyRead(0);
  while (this->Window.canReadLine())
  {
    if (this->Window.readLine().trimmed() == "stop")
    {
      this->stopRun();
    }
  }
}

QByteArray pqRUCRunMonitor::describe(const RunProgress& progress, int percent) const
{
  RunState state;
  state.Seconds = 1e-3 * this->Running.elapsed();
  state.Fraction = percent / 100.0;
  state.Title = QString::fromStdString(progress.Filter);
  state.Text = QString::fromStdString(progress.Activity);
  vtkPVXMLElement* hint = FindHint(progress.Filter);
  if (progress.Stoppable)
  {
    state.Stop = hint && hint->GetAttribute("stop") ? hint->GetAttribute("stop") : "Ends the run";
  }
  if (!progress.Quantity.empty())
  {
    state.Text += QString::fromStdString(", " + progress.Quantity + " = ") +
      QString::number(progress.Value, 'g', 4);
    if (hint && hint->GetAttributeOrEmpty("quantity") == progress.Quantity)
    {
      state.Drawn = hint->GetAttributeOrEmpty("title");
      state.Value = progress.Value;
    }
  }
  return state.ToLine();
}

void pqRUCRunMonitor::open()
{
  QStringList place;
  if (const QWidget* main = QApplication::activeWindow())
  {
    const QPoint centre = main->mapToGlobal(main->rect().center());
    place << QString::number(centre.x()) << QString::number(centre.y());
  }
  this->Window.start(Program(), place);
  this->Window.waitForStarted(Patience);
}

void pqRUCRunMonitor::stopRun()
{
  vtkSMSession* session = vtkSMProxyManager::GetProxyManager()->GetActiveSession();
  if (!session)
  {
    return;
  }
  const vtkClientServerID id(session->GetNextGlobalUniqueIdentifier());
  vtkClientServerStream stream;
  stream << vtkClientServerStream::New << "vtkRUCStopRequest" << id << vtkClientServerStream::End
         << vtkClientServerStream::Invoke << id << "Make" << vtkRUCStopRequest::Token()
         << vtkClientServerStream::End << vtkClientServerStream::Delete << id
         << vtkClientServerStream::End;
  session->ExecuteStream(vtkPVSession::DATA_SERVER_ROOT, stream);
}
