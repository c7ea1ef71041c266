// A frame of sixteen long curves against the plotting libraries of Qt programs, drawn into widgets of the
// same size with the same pens from the same samples. Built where the peers are installed: `./dev bench
// --peers`.
#include "control/base/random.h"
#include "control/base/units.h"
#include "tests/bench/goal.h"
#include "tests/control/history/history_blocks.h"
#include "widgets/figure/offscreen_application.h"
#include "widgets/live_plot/live_plot_stack.h"

#include <QApplication>
#include <QtCharts/QChartView>
#include <QtCharts/QLineSeries>
#include <QtCharts/QValueAxis>
#include <qcustomplot.h>
#include <qwt_plot.h>
#include <qwt_plot_curve.h>

#include <cmath>
#include <memory>
#include <vector>

namespace halbench::bench {
namespace {

constexpr std::size_t Signals = 16;
constexpr std::size_t SignalsPerPlot = 4;
constexpr std::size_t Plots = Signals / SignalsPerPlot;
constexpr std::size_t Samples = 1'000'000;
constexpr double Period_s = 0.001;
constexpr double View_s = static_cast<double>(Samples) * Period_s;
constexpr double Extent = 1.3;
constexpr double PenWidth = 1.5;
constexpr QSize Screen(1600, 900);
constexpr std::size_t Budget_bytes = std::size_t{512} << 20;
constexpr int Rounds = 3;

/// Four swings and 5 % noise.
class Source {
public:
    Source() {
        Random random(1);
        for (double& noise : m_noise) {
            noise = 0.05 * random.gaussian();
        }
    }
    double at(std::size_t row, std::size_t column) const {
        const double turns = 4.0 * static_cast<double>(row) / static_cast<double>(Samples);
        return std::sin(2.0 * Pi * turns + static_cast<double>(column)) +
               m_noise[(row * 7 + column * 131) % m_noise.size()];
    }

private:
    std::vector<double> m_noise = std::vector<double>(99'991);
};

QPen pen(std::size_t signal) {
    return {QColor::fromHsv(static_cast<int>(signal % SignalsPerPlot) * 90, 200, 200), PenWidth};
}

/// Processor time of drawing all of these anew into the window's buffer.
template <typename Widgets, typename Redraw>
double frameOf_s(const Widgets& widgets, Redraw redraw) {
    for (const auto& widget : widgets) {
        widget->resize(Screen.width(), Screen.height() / static_cast<int>(Plots));
        widget->show();
    }
    QApplication::processEvents();
    return processorTime_s(
        [&] {
            for (const auto& widget : widgets) {
                redraw(*widget);
            }
            QApplication::processEvents();
        },
        Rounds);
}

double ours_s(const Source& source) {
    std::vector<std::string> names;
    std::vector<widgets::PlotSpec> plots(Plots, {"field", "T", {}, {}, {}});
    for (std::size_t i = 0; i < Signals; ++i) {
        names.push_back("signal." + std::to_string(i));
        plots[i / SignalsPerPlot].curves.push_back(
            {names[i], QString::fromStdString(names[i]), "T", 1.0, static_cast<int>(i % SignalsPerPlot)});
    }
    control::SampleHistory history(Budget_bytes);
    const auto layout = control::layoutOf(names, Period_s);
    for (std::size_t row = 0; row < Samples; row += 10'000) {
        history.append(control::blockOf(
            layout, row, 10'000, [&](std::size_t at, std::size_t column) { return source.at(at, column); }));
    }
    widgets::LivePlotStack stack;
    stack.setTheme(widgets::loadTheme("light").value());
    stack.setHistory(&history);
    stack.setPlots(std::move(plots));
    stack.resize(Screen);
    stack.setTimeSpan(View_s);
    stack.show();
    QApplication::processEvents();
    constexpr std::size_t Frames = 20;
    std::size_t row = Samples;
    return processorTime_s(
               [&] {
                   for (std::size_t i = 0; i < Frames; ++i, row += 33) {
                       history.append(
                           control::blockOf(layout, row, 33, [&](std::size_t at, std::size_t column) {
                               return source.at(at, column);
                           }));
                       stack.refresh();
                       QApplication::processEvents();
                   }
               },
               Rounds) /
           static_cast<double>(Frames);
}

/// As they come, with the smooth lines that ours have; or with everything that their manuals name against
/// slowness, at the price of how it looks: lines without smoothing, and what falls on one pixel or out of
/// view left out.
enum class Peer { Plain, Fast };

double qwt_s(const Source& source, Peer kind) {
    std::vector<std::unique_ptr<QwtPlot>> plots;
    for (std::size_t i = 0; i < Signals; ++i) {
        if (i % SignalsPerPlot == 0) {
            plots.push_back(std::make_unique<QwtPlot>());
            plots.back()->setAxisScale(QwtPlot::xBottom, 0.0, View_s);
            plots.back()->setAxisScale(QwtPlot::yLeft, -Extent, Extent);
        }
        QVector<double> times;
        QVector<double> values;
        for (std::size_t row = 0; row < Samples; ++row) {
            times << static_cast<double>(row) * Period_s;
            values << source.at(row, i);
        }
        auto* curve = new QwtPlotCurve; // the plot owns it
        curve->setPen(pen(i));
        curve->setRenderHint(QwtPlotItem::RenderAntialiased, kind == Peer::Plain);
        curve->setPaintAttribute(QwtPlotCurve::ClipPolygons, true);
        curve->setPaintAttribute(QwtPlotCurve::FilterPoints, kind == Peer::Fast);
        curve->setSamples(times, values);
        curve->attach(plots.back().get());
    }
    return frameOf_s(plots, [](QwtPlot& plot) { plot.replot(); });
}

double customPlot_s(const Source& source, Peer kind) {
    std::vector<std::unique_ptr<QCustomPlot>> plots;
    for (std::size_t i = 0; i < Signals; ++i) {
        if (i % SignalsPerPlot == 0) {
            plots.push_back(std::make_unique<QCustomPlot>());
            plots.back()->xAxis->setRange(0.0, View_s);
            plots.back()->yAxis->setRange(-Extent, Extent);
            if (kind == Peer::Fast) {
                plots.back()->setNotAntialiasedElements(QCP::aeAll);
                plots.back()->setPlottingHints(QCP::phFastPolylines | QCP::phCacheLabels);
            }
        }
        auto container = QSharedPointer<QCPGraphDataContainer>::create();
        QVector<QCPGraphData> points;
        for (std::size_t row = 0; row < Samples; ++row) {
            points << QCPGraphData(static_cast<double>(row) * Period_s, source.at(row, i));
        }
        container->set(points, true);
        QCPGraph* graph = plots.back()->addGraph();
        graph->setAdaptiveSampling(true);
        graph->setAntialiased(kind == Peer::Plain);
        graph->setPen(pen(i));
        graph->setData(container);
    }
    return frameOf_s(plots, [](QCustomPlot& plot) { plot.replot(QCustomPlot::rpImmediateRefresh); });
}

double charts_s(const Source& source) {
    std::vector<std::unique_ptr<QtCharts::QChartView>> views;
    for (std::size_t plot = 0; plot < Plots; ++plot) {
        auto* chart = new QtCharts::QChart; // the view owns it, and it its axes and curves
        auto* times = new QtCharts::QValueAxis;
        auto* values = new QtCharts::QValueAxis;
        times->setRange(0.0, View_s);
        values->setRange(-Extent, Extent);
        chart->addAxis(times, Qt::AlignBottom);
        chart->addAxis(values, Qt::AlignLeft);
        for (std::size_t i = plot * SignalsPerPlot; i < (plot + 1) * SignalsPerPlot; ++i) {
            QVector<QPointF> points;
            for (std::size_t row = 0; row < Samples; ++row) {
                points << QPointF(static_cast<double>(row) * Period_s, source.at(row, i));
            }
            auto* series = new QtCharts::QLineSeries;
            series->setPen(pen(i));
            series->replace(points);
            chart->addSeries(series);
            series->attachAxis(times);
            series->attachAxis(values);
        }
        views.push_back(std::make_unique<QtCharts::QChartView>(chart));
        views.back()->setRenderHint(QPainter::Antialiasing);
    }
    return frameOf_s(views, [](QtCharts::QChartView& view) { view.viewport()->update(); });
}

int run() {
    const Source source;
    const double own_s = ours_s(source);
    Goals goals;
    goals.below("frame, 16 signals of a million samples each in view at 1600x900", 1e3 * own_s, 33.0, "ms");
    goals.atLeast("the same against QCustomPlot with adaptive sampling",
                  customPlot_s(source, Peer::Plain) / own_s, 8.0, "x");
    // Ours stays as it is: smooth, and no spike lost. No more is promised than not to be slower.
    goals.atLeast("the same against QCustomPlot without smoothing, with fast polylines",
                  customPlot_s(source, Peer::Fast) / own_s, 1.0, "x");
    goals.atLeast("the same against plain QwtPlotCurve", qwt_s(source, Peer::Plain) / own_s, 200.0, "x");
    goals.atLeast("the same against QwtPlotCurve without smoothing, with FilterPoints",
                  qwt_s(source, Peer::Fast) / own_s, 1.0, "x");
    goals.atLeast("the same against QtCharts' line series", charts_s(source) / own_s, 200.0, "x");
    return goals.exitCode();
}

} // namespace
} // namespace halbench::bench

int main() {
    const auto application = halbench::widgets::OffscreenApplication::ensure();
    return halbench::bench::run();
}
