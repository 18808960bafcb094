// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QSet>

class pqProxy;

/**
 * Moves the camera to the result of a filter of this plugin when the filter is first applied and
 * its result is all that a 3D view shows. ParaView itself does so in an empty view only; but a cell
 * takes the place of its pack, of which it fills a small corner. Where anything else is visible,
 * the camera stays where it is. Spheres are seen from above a corner until somebody turns the
 * camera. A filter is of this plugin if its hints put it into the menu Representative Unit Cell.
 */
class pqRUCCameraReset : public QObject
{
  Q_OBJECT

public:
  explicit pqRUCCameraReset(QObject* parent = nullptr);

  void onStartup();
  void onShutdown() {}

private Q_SLOTS:
  void connectPanels();
  void onApplied(pqProxy* proxy);

private:
  Q_DISABLE_COPY(pqRUCCameraReset)

  QSet<unsigned int> Seen; // global identifiers of proxies
};
