// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pqPropertyWidget.h>
#include <vtkSmartPointer.h>

class QLabel;
class vtkSMProxy;

/**
 * A line in the panel of a reader that tells what was read, which is the reader's information
 * property Summary. It stands in place of an editor of the property FileName.
 */
class pqRUCSummaryWidget : public pqPropertyWidget
{
  Q_OBJECT

public:
  pqRUCSummaryWidget(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent = nullptr);
  ~pqRUCSummaryWidget() override;

private:
  Q_DISABLE_COPY(pqRUCSummaryWidget)

  void onRead();

  QLabel* Text;
  vtkSmartPointer<vtkSMProxy> Reader;
  unsigned long Observer;
};
