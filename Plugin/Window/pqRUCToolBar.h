// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QMap>
#include <QToolBar>

class pqOutputPort;
class pqPipelineSource;

/**
 * The filters of this plugin in the order of the work: open, modes, statistics, cell, properties,
 * compare, export. A button puts its filter behind what is active in the pipeline browser, which is
 * applied first if it has not been; where the filter needs modes and there are none, Particle Modes
 * comes between, and a message says so. The last button makes a cell of a pack at once.
 */
class pqRUCToolBar : public QToolBar
{
  Q_OBJECT

public:
  explicit pqRUCToolBar(QWidget* parent = nullptr);

private Q_SLOTS:
  void start();
  void makeCell();

private:
  Q_DISABLE_COPY(pqRUCToolBar)

  // A filter: the name of its proxy and its label
  struct Entry
  {
    const char *Name, *Label;
  };

  QAction* addEntry(QWidget* owner, const Entry& entry, const QString& text);
  // A button of the first of some filters, with a menu of all
  void addMenu(const QString& text, const QList<Entry>& entries);
  // The active output as a pack that was applied, or null after a message
  static pqOutputPort* findPack();
  // The same with modes: that of Particle Modes behind it where it has none
  static pqOutputPort* findModes(pqOutputPort* pack);
  static pqPipelineSource* make(
    const char* filter, const QMap<QString, QList<pqOutputPort*>>& inputs);
};
