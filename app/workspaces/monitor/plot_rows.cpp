#include "app/workspaces/monitor/plot_rows.h"

#include "app/workspaces/monitor/monitor_statistics.h"
#include "widgets/language/display_units.h"
#include "widgets/live_plot/live_plot_stack.h"

#include <QCoreApplication>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace halbench::app {

namespace {

using Samples = std::vector<control::TimedValue>;
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::PlotRows)
};

/// A signal is once in the table, however often it is plotted.
std::vector<widgets::PlotCurve> curvesOf(const std::vector<widgets::PlotSpec>& plots) {
    std::vector<widgets::PlotCurve> curves;
    for (const widgets::PlotSpec& plot : plots) {
        for (const widgets::PlotCurve& curve : plot.curves) {
            const bool isNew = std::none_of(curves.begin(), curves.end(), [&](const widgets::PlotCurve& one) {
                return one.signal == curve.signal;
            });
            if (isNew) {
                curves.push_back(curve);
            }
        }
    }
    return curves;
}

Samples samplesOf(const control::SampleHistory& history, const std::string& signal,
                  control::TimeRange range) {
    Samples samples;
    history.samples(signal, range, samples); // and one beyond each end
    std::erase_if(samples, [range](const control::TimedValue& sample) {
        return sample.time_s < range.begin_s || sample.time_s > range.end_s;
    });
    return samples;
}

std::vector<double> momentsOf(const std::vector<Samples>& columns) {
    std::vector<double> moments;
    for (const Samples& samples : columns) {
        const auto middle = static_cast<std::ptrdiff_t>(moments.size());
        for (const control::TimedValue& sample : samples) {
            moments.push_back(sample.time_s);
        }
        std::inplace_merge(moments.begin(), moments.begin() + middle, moments.end());
        moments.erase(std::unique(moments.begin(), moments.end()), moments.end());
    }
    return moments;
}

/// The usual distance of rows, from which gaps are told.
double usualStep_s(const std::vector<double>& moments) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < moments.size(); ++i) {
        steps.push_back(moments[i] - moments[i - 1]);
    }
    if (steps.empty()) {
        return 0.0;
    }
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return std::round(*middle * 1e9) * 1e-9; // times are whole nanoseconds, differences are not
}

QString number(double value) {
    constexpr int Digits = 15; // every decimal of so many comes back from a double
    return std::isfinite(value) ? widgets::numberText(value, Digits) : QString();
}

} // namespace

Result<Recording> plotRows(const std::vector<widgets::PlotSpec>& plots, const control::SampleHistory& history,
                           control::TimeRange range, std::size_t mostValues) {
    StreamLayout layout;
    std::size_t count = 0;
    for (const widgets::PlotCurve& curve : curvesOf(plots)) {
        const std::size_t rows = history.contains(curve.signal) ? history.rowsIn(curve.signal, range) : 0;
        if (rows > 0) {
            layout.columns.push_back({curve.signal, history.unit(curve.signal)});
            count += rows;
        }
    }
    if (count > mostValues) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("{} values exceed the limit for data from the plots", count),
                       "zoom in, move the cursors closer, or record and cut with halbench convert");
    }
    std::vector<Samples> columns;
    for (const StreamLayout::Column& column : layout.columns) {
        columns.push_back(samplesOf(history, column.name, range));
    }
    Recording rows;
    rows.time_s = momentsOf(columns);
    if (rows.time_s.empty()) {
        return failure(ErrorCode::OutOfRange, "no samples of the plots in this time range",
                       "scroll to a range with samples, or move the cursors");
    }
    const std::size_t width = columns.size();
    rows.values.assign(rows.time_s.size() * width, NaN);
    for (std::size_t column = 0; column < width; ++column) {
        std::size_t row = 0;
        for (const control::TimedValue& sample : columns[column]) {
            while (rows.time_s[row] < sample.time_s) {
                ++row;
            }
            rows.values[row * width + column] = sample.value;
        }
    }
    layout.period_s = usualStep_s(rows.time_s);
    rows.layout = std::make_shared<const StreamLayout>(std::move(layout));
    return rows;
}

TakenPlots takenPlots(const widgets::LivePlotStack& stack) {
    const std::vector<int> active = stack.plotsOfActiveAxis();
    TakenPlots taken{{}, stretchInView(stack, active.front()), {}};
    for (int i = 0; i < static_cast<int>(stack.plots().size()); ++i) {
        const widgets::PlotSpec& plot = stack.plots()[static_cast<std::size_t>(i)];
        if (stack.cursors().isVisible || std::find(active.begin(), active.end(), i) != active.end()) {
            taken.plots.push_back(plot);
        } else {
            taken.leftOut << plot.quantity;
        }
    }
    return taken;
}

QString plotTable(const Recording& rows, const std::vector<widgets::PlotSpec>& plots) {
    const std::vector<widgets::PlotCurve> curves = curvesOf(plots);
    std::vector<double> factors;
    QStringList names{Words::tr("time")};
    QStringList units{QStringLiteral("s")};
    for (const StreamLayout::Column& column : rows.layout->columns) {
        const auto curve = std::find_if(curves.begin(), curves.end(), [&](const widgets::PlotCurve& one) {
            return one.signal == column.name;
        });
        names << curve->label;
        units << curve->unit;
        factors.push_back(curve->factor);
    }
    QStringList lines{names.join(QLatin1Char('\t')), units.join(QLatin1Char('\t'))};
    for (std::size_t row = 0; row < rows.rows(); ++row) {
        QStringList fields{number(rows.time_s[row])};
        for (std::size_t column = 0; column < factors.size(); ++column) {
            fields << number(factors[column] * rows.values[row * factors.size() + column]);
        }
        lines << fields.join(QLatin1Char('\t'));
    }
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

} // namespace halbench::app
