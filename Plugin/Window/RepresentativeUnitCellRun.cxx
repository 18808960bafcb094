// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The window that shows a run of the plugin's filters and stops it: see pqRUCRunMonitor.h, which
// starts it.
//
//     RepresentativeUnitCellRun [x y]      centred at this place of the screen
//
// It reads lines, each a RunState, until the end of its standard input and shows them, and writes
// the line `stop` when its button is pressed.
#include "RunState.h"

#include <QApplication>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QProgressBar>
#include <QPushButton>
#include <QScreen>
#include <QSocketNotifier>
#include <QVBoxLayout>
#include <QWidget>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

#include <unistd.h>

namespace
{
// The logarithms of 1, 2, 5, 10, … from the last at or below `low` to the first at or above `high`,
// or of whole decades where these would be many
std::vector<double> Ticks(double low, double high)
{
  constexpr double margin = 1e-9;
  const std::vector<double> steps = high - low > 2.0
    ? std::vector<double>{ 0.0 }
    : std::vector<double>{ 0.0, std::log10(2.0), std::log10(5.0) };
  std::vector<double> ticks;
  for (double decade = std::floor(low); ticks.empty() || ticks.back() < high - margin; ++decade)
  {
    for (const double step : steps)
    {
      const double tick = decade + step;
      if (!ticks.empty() && tick <= low + margin)
      {
        ticks.clear();
      }
      if (ticks.size() < 2 || ticks.back() < high - margin)
      {
        ticks.push_back(tick);
      }
    }
  }
  return ticks;
}

// A value against time, on a logarithmic axis
class ConvergencePlot : public QWidget
{
public:
  void add(const RunState& state)
  {
    if (!state.Drawn.isEmpty() && state.Value > 0.0 && std::isfinite(state.Value))
    {
      this->Title = state.Drawn;
      this->Points.push_back({ state.Seconds, std::log10(state.Value) });
      this->setVisible(true);
      this->update();
    }
  }

protected:
  void paintEvent(QPaintEvent*) override
  {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const int line = this->fontMetrics().height();
    const int left = this->fontMetrics().horizontalAdvance("0.0000") + 8;
    this->Frame =
      QRectF(left, 1.5 * line, this->width() - left - 12, this->height() - 3.0 * line - 4);
    painter.fillRect(this->Frame, this->palette().base());
    painter.drawText(QRectF(0, 0, this->Frame.right(), line), Qt::AlignHCenter, this->Title);

    const auto [low, high] = std::minmax_element(this->Points.begin(), this->Points.end(),
      [](const QPointF& a, const QPointF& b) { return a.y() < b.y(); });
    const std::vector<double> ticks = Ticks(low->y(), high->y());
    this->Low = ticks.front();
    this->High = ticks.back();
    this->Last = std::max(this->Points.back().x(), 1.0);
    this->drawAxes(painter, ticks);
    this->drawCurve(painter);
  }

private:
  QPointF place(const QPointF& point) const
  {
    return { this->Frame.left() + this->Frame.width() * point.x() / this->Last,
      this->Frame.bottom() -
        this->Frame.height() * (point.y() - this->Low) / (this->High - this->Low) };
  }

  void drawAxes(QPainter& painter, const std::vector<double>& ticks) const
  {
    const int line = this->fontMetrics().height();
    for (const double exponent : ticks)
    {
      const double y = this->place({ 0.0, exponent }).y();
      painter.setPen(this->palette().color(QPalette::Midlight));
      painter.drawLine(QPointF(this->Frame.left(), y), QPointF(this->Frame.right(), y));
      painter.setPen(this->palette().color(QPalette::Text));
      painter.drawText(QRectF(0, y - line / 2.0, this->Frame.left() - 5, line),
        Qt::AlignRight | Qt::AlignVCenter, QString::number(std::pow(10.0, exponent), 'g', 2));
    }
    painter.drawRect(this->Frame);
    const QRectF below(this->Frame.left(), this->Frame.bottom() + 2, this->Frame.width(), line);
    painter.drawText(below, Qt::AlignLeft, "0");
    painter.drawText(below, Qt::AlignHCenter, "Time (s)");
    painter.drawText(below, Qt::AlignRight, QString::number(this->Last, 'f', 0));
  }

  void drawCurve(QPainter& painter) const
  {
    QPainterPath path(this->place(this->Points.front()));
    for (const QPointF& point : this->Points)
    {
      path.lineTo(this->place(point));
    }
    painter.setPen(QPen(QColor("#1f77b4"), 2.0));
    painter.drawPath(path);
  }

  QString Title;
  std::vector<QPointF> Points; // seconds, logarithm of the value
  // How it is drawn now: the frame on the widget, the logarithms at its bottom and top, and its
  // last second
  QRectF Frame;
  double Low = 0.0, High = 1.0, Last = 1.0;
};

class RunWindow : public QWidget
{
public:
  RunWindow()
  {
    this->setWindowTitle("Representative Unit Cell: running");
    this->setWindowFlags(Qt::Dialog | Qt::WindowStaysOnTopHint);
    this->setAttribute(Qt::WA_ShowWithoutActivating);
    this->Text.setWordWrap(true);
    this->Text.setMinimumWidth(420);
    this->Bar.setRange(0, 1000);
    this->Plot.setMinimumHeight(200);
    this->Plot.setVisible(false);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(&this->Title);
    layout->addWidget(&this->Text);
    layout->addWidget(&this->Bar);
    layout->addWidget(&this->Plot, 1);
    layout->addWidget(&this->Stop, 0, Qt::AlignRight);
    QFont bold = this->Title.font();
    bold.setBold(true);
    this->Title.setFont(bold);
    QObject::connect(&this->Stop, &QPushButton::clicked, this, &RunWindow::stop);
  }

  void tell(const RunState& state)
  {
    this->Title.setText(state.Title);
    this->Text.setText(state.Text);
    this->Stop.setVisible(!state.Stop.isEmpty());
    this->Stop.setToolTip(state.Stop);
    this->Bar.setValue(static_cast<int>(1000.0 * state.Fraction));
    this->Plot.add(state);
  }

private:
  void stop()
  {
    std::cout << "stop" << std::endl;
    this->Stop.setEnabled(false);
    this->Stop.setText("Stopping…");
  }

  QLabel Title, Text;
  QProgressBar Bar;
  ConvergencePlot Plot;
  QPushButton Stop{ "Stop" };
};
}

int main(int argc, char** argv)
{
  QApplication application(argc, argv);
  RunWindow window;
  QByteArray unread;
  QSocketNotifier input(STDIN_FILENO, QSocketNotifier::Read);
  QObject::connect(&input, &QSocketNotifier::activated, &window,
    [&]()
    {
      char part[4096];
      const ssize_t size = read(STDIN_FILENO, part, sizeof(part));
      if (size <= 0)
      {
        QApplication::quit();
        return;
      }
      unread.append(part, static_cast<int>(size));
      for (int end = unread.indexOf('\n'); end >= 0; end = unread.indexOf('\n'))
      {
        window.tell(RunState::FromLine(unread.left(end)));
        unread.remove(0, end + 1);
      }
    });
  window.adjustSize();
  const QRect screen = QGuiApplication::primaryScreen()->availableGeometry();
  const QPoint centre =
    argc == 3 ? QPoint(std::atoi(argv[1]), std::atoi(argv[2])) : screen.center();
  window.move(centre - window.rect().center());
  window.show();
  return QApplication::exec();
}
