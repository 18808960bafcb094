// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRUCToolBar.h"

#include <pqLoadDataReaction.h>
#include <pqObjectBuilder.h>
#include <pqOutputPort.h>
#include <pqPVApplicationCore.h>
#include <pqPipelineSource.h>
#include <pqSaveDataReaction.h>
#include <pqServerManagerModel.h>
#include <vtkDataObject.h>
#include <vtkPVDataInformation.h>
#include <vtkSMOutputPort.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMProxyManager.h>
#include <vtkSMProxySelectionModel.h>
#include <vtkSMSessionProxyManager.h>
#include <vtkSMSourceProxy.h>

#include <QApplication>
#include <QDebug>
#include <QMainWindow>
#include <QMenu>
#include <QMessageBox>
#include <QTimer>
#include <QToolButton>

#include <algorithm>
#include <cstring>

namespace
{
constexpr int UsualCell = 500; // spheres, or half of a smaller pack

// What takes packs without modes
constexpr const char* WithoutModes[] = { "ParticleModes", "PeriodicReplicas", "PeriodicMesh" };
// What takes more than one input, which ParaView's own menu asks for
constexpr const char* OfMenu[] = { "CompareProbabilities", "CompareWithPack" };

// The output that is active in the pipeline browser, or null
pqOutputPort* ActivePort()
{
  vtkSMSessionProxyManager* proxies =
    vtkSMProxyManager::GetProxyManager()->GetActiveSessionProxyManager();
  vtkSMProxySelectionModel* active =
    proxies ? proxies->GetSelectionModel("ActiveSources") : nullptr;
  vtkSMProxy* current = active ? active->GetCurrentProxy() : nullptr;
  auto* port = vtkSMOutputPort::SafeDownCast(current);
  vtkSMProxy* proxy = port ? port->GetSourceProxy() : current;
  auto* source = proxy
    ? pqApplicationCore::instance()->getServerManagerModel()->findItem<pqPipelineSource*>(proxy)
    : nullptr;
  return source ? source->getOutputPort(port ? static_cast<int>(port->GetPortIndex()) : 0)
                : nullptr;
}

// Does what the entry of ParaView's menu of filters does
void ChooseInMenu(const char* name)
{
  for (QWidget* widget : QApplication::allWidgets())
  {
    auto* menu = qobject_cast<QMenu*>(widget);
    if (menu && menu->title() == "Representative Unit Cell")
    {
      for (QAction* action : menu->actions())
      {
        if (action->objectName() == name)
        {
          action->trigger();
          return;
        }
      }
    }
  }
}

bool HasArray(pqOutputPort* port, const char* name)
{
  vtkPVDataInformation* data = port->getDataInformation();
  return data && data->GetArrayInformation(name, vtkDataObject::POINT);
}

template <class List>
bool Contains(const List& list, const char* name)
{
  return std::any_of(std::begin(list), std::end(list),
    [&](const char* other) { return std::strcmp(name, other) == 0; });
}

void Apply()
{
  pqPVApplicationCore::instance()->applyPipeline();
}
}

pqRUCToolBar::pqRUCToolBar(QWidget* parent)
  : QToolBar(parent)
{
  this->setObjectName("RepresentativeUnitCellToolBar");
  this->setWindowTitle(tr("Representative Unit Cell"));
  this->setToolButtonStyle(Qt::ToolButtonTextOnly);
  QAction* open = this->addAction(tr("Open"));
  open->setToolTip(tr("Opens a file of spheres; for a table choose the Sphere Pack Reader"));
  this->connect(open, &QAction::triggered, []() { pqLoadDataReaction::loadData(); });
  const Entry modes = { "ParticleModes", "Particle Modes" };
  this->addAction(this->addEntry(this, modes, tr("Modes")));
  this->addMenu(tr("Statistics"),
    { { "TwoPointProbability", "Two-Point Probability" },
      { "OnePointProbability", "One-Point Probability" },
      { "ThreePointProbability", "Three-Point Probability" },
      { "DirectionalProbability", "Directional Probability" },
      { "ProbabilityMap", "Probability Map" }, { "ChordLengths", "Chord Lengths" },
      { "RadialDistribution", "Radial Distribution" },
      { "ThirdOrderParameters", "Third-Order Parameters" },
      { "NeighbourStatistics", "Neighbour Statistics" }, { "VoidDistances", "Void Distances" } });
  this->addMenu(tr("Cell"),
    { { "UnitCellReconstruction", "Unit Cell Reconstruction" },
      { "PeriodicReplicas", "Periodic Replicas" } });
  const Entry properties = { "EffectiveProperties", "Effective Properties" };
  this->addAction(this->addEntry(this, properties, tr("Properties")));
  this->addMenu(tr("Compare"),
    { { "CompareWithPack", "Compare With Pack" },
      { "CompareProbabilities", "Compare Probabilities" } });
  this->addMenu(
    tr("Mesh"), { { "PeriodicMesh", "Periodic Mesh" }, { "LabelImage", "Label Image" } });
  QAction* save = this->addAction(tr("Export"));
  save->setToolTip(tr("Saves what is active, for ParaView, a solver, or another program"));
  this->connect(save, &QAction::triggered, []() { pqSaveDataReaction::saveActiveData(); });
  this->addSeparator();
  QAction* cell = this->addAction(tr("Representative Cell From This Pack"));
  cell->setToolTip(
    tr("Makes modes, two-point probabilities, a cell of %1 spheres, its copies cut at "
       "the box, and the comparison with the pack, of the active pack")
      .arg(UsualCell));
  this->connect(cell, &QAction::triggered, this, &pqRUCToolBar::makeCell);
  this->widgetForAction(cell)->setObjectName("RepresentativeCell");

  // A row of its own, once ParaView has put the bar into its window, where the others leave no room
  QTimer::singleShot(0, this,
    [this]()
    {
      if (auto* window = qobject_cast<QMainWindow*>(this->window()))
      {
        window->insertToolBarBreak(this);
      }
    });
}

QAction* pqRUCToolBar::addEntry(QWidget* owner, const Entry& entry, const QString& text)
{
  auto* action = new QAction(text, owner);
  action->setObjectName(entry.Name);
  action->setToolTip(tr("%1 of what is active").arg(entry.Label));
  this->connect(action, &QAction::triggered, this, &pqRUCToolBar::start);
  return action;
}

void pqRUCToolBar::addMenu(const QString& text, const QList<Entry>& entries)
{
  auto* button = new QToolButton(this);
  auto* menu = new QMenu(button);
  for (const Entry& entry : entries)
  {
    menu->addAction(this->addEntry(menu, entry, entry.Label));
  }
  button->setObjectName(text);
  button->setText(text);
  button->setMenu(menu);
  button->setPopupMode(QToolButton::InstantPopup);
  this->addWidget(button);
}

pqOutputPort* pqRUCToolBar::findPack()
{
  Apply();
  pqOutputPort* port = ActivePort();
  if (!port || !HasArray(port, "Radius"))
  {
    QMessageBox::information(nullptr, tr("Representative Unit Cell"),
      port ? tr("%1 is no pack of spheres: it has no point array 'Radius'. Select a pack in the "
                "pipeline browser, or take Points To Sphere Pack.")
               .arg(port->getSource()->getSMName())
           : tr("Open a file of spheres first, or select a pack in the pipeline browser."));
    return nullptr;
  }
  return port;
}

pqOutputPort* pqRUCToolBar::findModes(pqOutputPort* pack)
{
  if (HasArray(pack, "Mode"))
  {
    return pack;
  }
  qInfo() << "Particle Modes was put behind" << pack->getSource()->getSMName()
          << "as it has no modes.";
  pqPipelineSource* modes = make("ParticleModes", { { "Input", { pack } } });
  Apply();
  return modes->getOutputPort(0);
}

pqPipelineSource* pqRUCToolBar::make(
  const char* filter, const QMap<QString, QList<pqOutputPort*>>& inputs)
{
  return pqApplicationCore::instance()->getObjectBuilder()->createFilter(
    "filters", filter, inputs, inputs.first().first()->getServer());
}

void pqRUCToolBar::start()
{
  const QByteArray name = this->sender()->objectName().toLatin1();
  if (Contains(OfMenu, name.constData()))
  {
    ChooseInMenu(name.constData());
    return;
  }
  if (pqOutputPort* pack = findPack())
  {
    pack = Contains(WithoutModes, name.constData()) ? pack : findModes(pack);
    make(name.constData(), { { "Input", { pack } } });
  }
}

void pqRUCToolBar::makeCell()
{
  pqOutputPort* pack = findPack();
  if (!pack)
  {
    return;
  }
  pack = findModes(pack);
  make("TwoPointProbability", { { "Input", { pack } } });
  Apply();
  pqPipelineSource* search = make("UnitCellReconstruction", { { "Input", { pack } } });
  const int spheres = static_cast<int>(
    std::min<vtkIdType>(UsualCell, pack->getDataInformation()->GetNumberOfPoints() / 2));
  vtkSMPropertyHelper(search->getProxy(), "NumberOfParticles").Set(spheres);
  search->getProxy()->UpdateVTKObjects();
  Apply();
  pqOutputPort* cell = search->getOutputPort(0);
  pqPipelineSource* copies = make("PeriodicReplicas", { { "Input", { cell } } });
  vtkSMPropertyHelper(copies->getProxy(), "ClipToBox").Set(1);
  copies->getProxy()->UpdateVTKObjects();
  Apply();
  make("CompareWithPack", { { "Input", { pack } }, { "Cell", { cell } } });
  Apply();
}
