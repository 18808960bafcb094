// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QProcess>

/**
 * Opens the run window while one of the plugin's filters runs for longer than a second, tells it
 * the progress, and passes on its Stop.
 *
 * ParaView works on one thread: while a filter runs the window of ParaView answers nothing, and to
 * let it answer in the middle of a run, with all that a click may set off, is not safe (ParaView
 * itself gave it up, see pqProgressManager). So the run window is a program of its own,
 * RepresentativeUnitCellRun, beside the plugin, and the two talk in lines of text whenever progress
 * comes in: to it `seconds<TAB>fraction<TAB>text`, from it `stop`.
 */
class pqRUCRunMonitor : public QObject
{
  Q_OBJECT

public:
  explicit pqRUCRunMonitor(QObject* parent = nullptr);

  void onStartup();
  void onShutdown();

private Q_SLOTS:
  void onProgress(const QString& text, int percent);
  void onEnableProgress(bool running);

private:
  Q_DISABLE_COPY(pqRUCRunMonitor)

  void open();
  void stopRun();

  QProcess Window;
  QElapsedTimer Running; // since the first progress of this run
  QByteArray Unsaid;     // what the window was not told yet
  bool Opened = false;   // in this run
};
