// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRUCEstimateWidget.h"

#include <vtkCommand.h>
#include <vtkPVDataInformation.h>
#include <vtkSMDoubleVectorProperty.h>
#include <vtkSMIdTypeVectorProperty.h>
#include <vtkSMInputProperty.h>
#include <vtkSMIntVectorProperty.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMPropertyIterator.h>
#include <vtkSMProxy.h>
#include <vtkSMSessionProxyManager.h>
#include <vtkSMSourceProxy.h>
#include <vtkSMStringVectorProperty.h>
#include <vtkSmartPointer.h>

#include <QHBoxLayout>
#include <QLabel>

#include <cmath>

namespace
{
template <class Property>
bool TakeEdited(vtkSMProperty* from, vtkSMProperty* to)
{
  auto* edited = Property::SafeDownCast(from);
  auto* property = Property::SafeDownCast(to);
  if (!edited || !property)
  {
    return false;
  }
  const unsigned int count = edited->GetNumberOfUncheckedElements();
  property->SetNumberOfElements(count);
  for (unsigned int n = 0; n < count; ++n)
  {
    property->SetElement(n, edited->GetUncheckedElement(n));
  }
  return true;
}

template <class Act>
void ForEachProperty(vtkSMProxy* proxy, const Act& act)
{
  auto properties = vtkSmartPointer<vtkSMPropertyIterator>::Take(proxy->NewPropertyIterator());
  for (properties->Begin(); !properties->IsAtEnd(); properties->Next())
  {
    if (!properties->GetProperty()->GetInformationOnly())
    {
      act(properties->GetKey(), properties->GetProperty());
    }
  }
}

// The number of spheres of the input on all ranks together, which a rank of the server does not
// know
vtkIdType CountSpheres(vtkSMProxy* proxy)
{
  const vtkSMPropertyHelper input(proxy, "Input", true);
  auto* source =
    input.GetNumberOfElements() > 0 ? vtkSMSourceProxy::SafeDownCast(input.GetAsProxy()) : nullptr;
  return source ? source->GetDataInformation(input.GetOutputPort())->GetNumberOfPoints() : 0;
}

// Makes another proxy like the filter's, with what stands in the panel now; null where the session
// is gone
vtkSmartPointer<vtkSMProxy> MakeScratch(vtkSMProxy* filter)
{
  vtkSMSessionProxyManager* proxies = filter->GetSessionProxyManager();
  auto scratch = vtkSmartPointer<vtkSMProxy>::Take(
    proxies ? proxies->NewProxy(filter->GetXMLGroup(), filter->GetXMLName()) : nullptr);
  if (!scratch)
  {
    return nullptr;
  }
  ForEachProperty(filter,
    [&](const char* name, vtkSMProperty* edited)
    {
      vtkSMProperty* property = scratch->GetProperty(name);
      if (property && !TakeEdited<vtkSMIntVectorProperty>(edited, property) &&
        !TakeEdited<vtkSMDoubleVectorProperty>(edited, property) &&
        !TakeEdited<vtkSMIdTypeVectorProperty>(edited, property) &&
        !TakeEdited<vtkSMStringVectorProperty>(edited, property))
      {
        property->Copy(edited);
      }
    });
  if (scratch->GetProperty("SpheresInInput")) // filters of images have none
  {
    vtkSMPropertyHelper(scratch, "SpheresInInput").Set(CountSpheres(filter));
  }
  scratch->UpdateVTKObjects();
  scratch->UpdatePropertyInformation();
  return scratch;
}

// A number with one or two digits, as more would promise too much
QString RoundedText(double value)
{
  const double digit = std::pow(10.0, std::floor(std::log10(value)) - (value < 10.0 ? 0 : 1));
  return QString::number(std::round(value / digit) * digit, 'g', 12);
}

QString TimeText(double seconds)
{
  if (seconds < 1.0)
  {
    return "less than a second";
  }
  if (seconds < 90.0)
  {
    return RoundedText(seconds) + " s";
  }
  return seconds < 5400.0 ? RoundedText(seconds / 60.0) + " minutes"
                          : RoundedText(seconds / 3600.0) + " hours";
}

QString MemoryText(double megabytes)
{
  return megabytes < 1000.0 ? RoundedText(std::max(megabytes, 1.0)) + " MB"
                            : RoundedText(megabytes / 1000.0) + " GB";
}
}

pqRUCEstimateWidget::pqRUCEstimateWidget(vtkSMProxy* proxy, vtkSMProperty*, QWidget* parent)
  : pqPropertyWidget(proxy, parent)
  , Text(new QLabel(this))
{
  this->setShowLabel(false);
  this->Text->setObjectName("Estimate");
  this->Text->setWordWrap(true);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 4, 0, 4);
  layout->addWidget(this->Text);

  this->Delay.setSingleShot(true);
  this->Delay.setInterval(200);
  QObject::connect(&this->Delay, &QTimer::timeout, this, &pqRUCEstimateWidget::estimate);
  ForEachProperty(proxy,
    [this](const char*, vtkSMProperty* property)
    {
      for (const unsigned long event :
        { vtkCommand::ModifiedEvent, vtkCommand::UncheckedPropertyModifiedEvent })
      {
        this->Observed.push_back(
          { property, property->AddObserver(event, this, &pqRUCEstimateWidget::onChange) });
      }
    });
  this->Delay.start();
}

pqRUCEstimateWidget::~pqRUCEstimateWidget()
{
  for (const auto& [property, observer] : this->Observed)
  {
    property->RemoveObserver(observer);
  }
}

void pqRUCEstimateWidget::estimate()
{
  const vtkSmartPointer<vtkSMProxy> scratch = MakeScratch(this->proxy());
  if (!scratch)
  {
    return;
  }
  const double seconds = vtkSMPropertyHelper(scratch, "EstimatedTime").GetAsDouble();
  const double memory = vtkSMPropertyHelper(scratch, "EstimatedMemory").GetAsDouble();

  QString text = "<b>Estimated:</b> ";
  text += seconds > 0.0 ? TimeText(seconds) : "time not known before the run";
  if (memory > 0.0)
  {
    text += ", " + MemoryText(memory) + " on every rank";
  }
  const QString automatic = vtkSMPropertyHelper(scratch, "AutomaticValues").GetAsString();
  if (!automatic.isEmpty())
  {
    text += "<br>0 stands for about: " + automatic.toHtmlEscaped();
  }
  this->Text->setText(text);
}
