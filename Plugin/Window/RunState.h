// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QByteArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QString>

/**
 * What the run window shows at a moment of a run, as pqRUCRunMonitor sends it: one line of JSON.
 */
struct RunState
{
  double Seconds = 0.0;  // since the run began
  double Fraction = 0.0; // the share of the work that is done, 0 to 1
  QString Title;         // the name of the filter
  QString Text;          // what is going on
  QString Stop;          // what Stop does now; empty where the run cannot be stopped
  QString Drawn; // the title of the value that is drawn against time; empty where there is none
  double Value = 0.0; // the value that is drawn

  QByteArray ToLine() const
  {
    const QJsonObject object{ { "seconds", this->Seconds }, { "fraction", this->Fraction },
      { "title", this->Title }, { "text", this->Text }, { "stop", this->Stop },
      { "drawn", this->Drawn }, { "value", this->Value } };
    return QJsonDocument(object).toJson(QJsonDocument::Compact) + '\n';
  }

  static RunState FromLine(const QByteArray& line)
  {
    const QJsonObject object = QJsonDocument::fromJson(line).object();
    RunState state;
    state.Seconds = object["seconds"].toDouble();
    state.Fraction = object["fraction"].toDouble();
    state.Title = object["title"].toString();
    state.Text = object["text"].toString();
    state.Stop = object["stop"].toString();
    state.Drawn = object["drawn"].toString();
    state.Value = object["value"].toDouble();
    return state;
  }
};
