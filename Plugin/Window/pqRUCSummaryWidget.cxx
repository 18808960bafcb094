// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRUCSummaryWidget.h"

#include <vtkCommand.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMProxy.h>

#include <QHBoxLayout>
#include <QLabel>

pqRUCSummaryWidget::pqRUCSummaryWidget(vtkSMProxy* proxy, vtkSMProperty*, QWidget* parent)
  : pqPropertyWidget(proxy, parent)
  , Text(new QLabel(this))
  , Reader(proxy)
  , Observer(proxy->AddObserver(vtkCommand::UpdateDataEvent, this, &pqRUCSummaryWidget::onRead))
{
  this->setShowLabel(false);
  this->Text->setObjectName("Summary");
  this->Text->setWordWrap(true);
  this->Text->setTextFormat(Qt::PlainText);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 4, 0, 4);
  layout->addWidget(this->Text);
  this->onRead();
}

pqRUCSummaryWidget::~pqRUCSummaryWidget()
{
  this->Reader->RemoveObserver(this->Observer);
}

void pqRUCSummaryWidget::onRead()
{
  this->Reader->UpdatePropertyInformation(this->Reader->GetProperty("Summary"));
  const QString summary = vtkSMPropertyHelper(this->Reader, "Summary").GetAsString();
  this->Text->setText(summary);
  this->Text->setVisible(!summary.isEmpty());
}
