// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pqPropertyWidget.h>
#include <vtkObject.h>
#include <vtkSmartPointer.h>

#include <QTimer>

#include <utility>
#include <vector>

class QLabel;

/**
 * A line in the panel that tells before Apply how long a run will take, how much memory it will
 * use, and what automatic values are. It stands in place of an editor of the property
 * SpheresInInput.
 *
 * The line asks another proxy of the same kind and input, which has the numbers that stand in the
 * panel now, for its information properties EstimatedTime, EstimatedMemory and AutomaticValues. The
 * filter itself is not touched, and nothing runs.
 */
class pqRUCEstimateWidget : public pqPropertyWidget
{
  Q_OBJECT

public:
  pqRUCEstimateWidget(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent = nullptr);
  ~pqRUCEstimateWidget() override;

private Q_SLOTS:
  void estimate();

private:
  Q_DISABLE_COPY(pqRUCEstimateWidget)

  void onChange() { this->Delay.start(); }

  QLabel* Text;
  QTimer Delay; // of many changes at once only the last one counts
  std::vector<std::pair<vtkSmartPointer<vtkObject>, unsigned long>> Observed;
};
