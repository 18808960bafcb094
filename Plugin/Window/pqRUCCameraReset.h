// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QSet>

class pqProxy;

/**
 * Looks at the result of a filter of this plugin when it is first applied. ParaView does so in an
 * empty view only; but a cell takes the place of its pack, of which it fills a small corner.
 * Whatever else is visible keeps the camera where it is.
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
