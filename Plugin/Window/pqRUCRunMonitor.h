// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QProcess>

struct RunProgress;

/**
 * Opens the run window while one of the plugin's filters runs for longer than a second, tells it
 * the progress, and passes on its Stop.
 *
 * ParaView works on one thread: while a filter runs, the window of ParaView answers nothing, and it
 * is not safe to let it answer in the middle of a run, with all that a click may set off (ParaView
 * itself gave it up, see pqProgressManager). So the run window is a program of its own,
 * RepresentativeUnitCellRun, beside the plugin, and the two talk in lines whenever progress comes
 * in. The window receives what it shows, as one JSON object in each line (RunState.h), and sends
 * `stop`.
 *
 * The form of a text of progress tells whether it comes from this plugin (RunProgress.h). What
 * changes during a run stands in that text; the rest stands in the hints of the filter's proxy, so
 * that a new filter needs no line here:
 *
 *     <Run stop="Ends the search and keeps the best cell so far" quantity="F2"
 *       title="Objective F2"/>
 *
 * `stop` tells what Stop does. `quantity` is the name of the value of the progress that is drawn
 * against time, on a logarithmic axis, and `title` the title of that drawing; without them nothing
 * is drawn.
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

  QByteArray describe(const RunProgress& progress, int percent) const;
  void open();
  void stopRun();

  QProcess Window;
  QElapsedTimer Running; // since the first progress of this run
  QByteArray Unsaid;     // what the window was not told yet
  bool Opened = false;   // in this run
};
