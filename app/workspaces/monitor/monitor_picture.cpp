#include "app/workspaces/monitor/monitor_picture.h"

#include "widgets/figure/figure_file.h"
#include "widgets/language/phrasebook.h"
#include "widgets/live_plot/history_curve.h"
#include "widgets/live_plot/legend_table_model.h"
#include "widgets/live_plot/live_plot_stack.h"
#include "widgets/live_plot/plot_marks.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme_style.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QWidget>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace halbench::app {

namespace {

constexpr std::size_t FigureColumns = 1600; ///< two to a pixel of a picture of usual width
constexpr int PanelHeight_px = 160;
constexpr int LeastHeight_px = 60; ///< of a plot that is low on the screen too
constexpr double ClipboardFineness = 2.0;

/// Each column's smallest and largest sample beside each other.
widgets::Curve drawnCurve(const control::SampleHistory& history, const widgets::PlotCurve& curve,
                          control::TimeRange range) {
    widgets::Curve drawn;
    drawn.label = widgets::curveWords(curve).toStdString();
    drawn.isRight = curve.isRight;
    const auto add = [&](double time_s, double value) {
        drawn.x.push_back(time_s);
        drawn.y.push_back(curve.factor * value);
    };
    const auto lift = [&](double time_s) { add(time_s, std::numeric_limits<double>::quiet_NaN()); };
    if (history.rowsIn(curve.signal, range) <= 2 * FigureColumns) {
        std::vector<control::TimedValue> samples;
        history.samples(curve.signal, range, samples);
        for (const control::TimedValue& sample : samples) {
            if (sample.isAfterGap) {
                lift(sample.time_s);
            }
            if (sample.time_s >= range.begin_s && sample.time_s <= range.end_s) {
                add(sample.time_s, sample.value);
            }
        }
        return drawn;
    }
    std::vector<control::HistoryColumn> columns;
    history.columns(curve.signal, range, FigureColumns, columns);
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const double time_s =
            range.begin_s + range.length_s() * (static_cast<double>(i) + 0.5) / FigureColumns;
        if (columns[i].isAfterGap || columns[i].extremes.isEmpty()) {
            lift(time_s);
        }
        if (!columns[i].extremes.isEmpty()) {
            add(time_s, columns[i].extremes.min);
            add(time_s, columns[i].extremes.max);
        }
    }
    return drawn;
}

/// As on the screen.
int placeOf(const widgets::LivePlotStack& stack, const std::string& signal, std::size_t position) {
    return stack.colours().placeOf(signal, static_cast<int>(position));
}

widgets::CurveStyle styleOf(widgets::LinePattern pattern) {
    switch (pattern) {
    case widgets::LinePattern::Dash:
        return widgets::CurveStyle::DashedLine;
    case widgets::LinePattern::Dot:
        return widgets::CurveStyle::DottedLine;
    case widgets::LinePattern::DashDot:
        return widgets::CurveStyle::DashDotLine;
    case widgets::LinePattern::Solid:
        break;
    }
    return widgets::CurveStyle::Line;
}

/// Dotted, in the colours of the curves they are compared with.
void addReference(widgets::Panel& panel, const widgets::LivePlotStack& stack, const widgets::PlotSpec& plot,
                  control::TimeRange range) {
    const widgets::ReferencePtr& reference = stack.reference();
    const double shift_s = stack.referenceShift_s();
    for (std::size_t i = 0; reference != nullptr && i < plot.curves.size(); ++i) {
        const auto samples = reference->samples.find(plot.curves[i].signal);
        if (samples == reference->samples.end()) {
            continue;
        }
        widgets::Curve trace =
            drawnCurve(*samples->second, plot.curves[i], {range.begin_s - shift_s, range.end_s - shift_s});
        for (double& time_s : trace.x) {
            time_s += shift_s;
        }
        trace.label =
            MonitorPicture::tr("%1, reference").arg(QString::fromStdString(trace.label)).toStdString();
        trace.style = widgets::CurveStyle::DottedLine;
        trace.colour = placeOf(stack, plot.curves[i].signal, i) % widgets::CurveColours;
        panel.curves.push_back(std::move(trace));
    }
}

QAction* makeAction(QWidget& panel, const QString& text, const QString& what, const char* icon,
                    const QKeySequence& shortcut) {
    auto* action = new QAction(widgets::themedIcon(QLatin1String(icon)), text, &panel);
    action->setShortcut(shortcut);
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    action->setToolTip(QStringLiteral("%1 (%2)").arg(what, shortcut.toString(QKeySequence::NativeText)));
    panel.addAction(action);
    return action;
}

} // namespace

namespace {

/// Level of a trigger in the unit of the left axis; nothing where its signal is not on that axis.
std::optional<double> levelOf(const widgets::LivePlotStack& stack, const widgets::PlotSpec& plot) {
    for (const widgets::PlotCurve& curve : plot.curves) {
        if (stack.level() && curve.signal == stack.level()->signal && !curve.isRight) {
            return curve.factor * stack.level()->level;
        }
    }
    return std::nullopt;
}

/// What is no curve, as it is now. `hasNames`: in the topmost plot of a time axis.
widgets::PanelLayers layersOf(const widgets::LivePlotStack& stack, const widgets::PlotSpec& plot,
                              bool hasNames) {
    widgets::PanelLayers layers;
    layers.below = [bands = plot.bands](QPainter& painter, const QwtScaleMap& x, const QwtScaleMap& y,
                                        const QRectF& canvas, const widgets::Theme& theme) {
        widgets::BandItem item;
        item.set(bands, theme);
        item.draw(&painter, x, y, canvas);
    };
    layers.above = [markers = stack.markers(), pairs = stack.cursorPairs(), event_s = stack.event_s(),
                    level = levelOf(stack, plot), hasNames](QPainter& painter, const QwtScaleMap& x,
                                                            const QwtScaleMap& y, const QRectF& canvas,
                                                            const widgets::Theme& theme) {
        widgets::OverlayItem item;
        item.setTheme(theme);
        item.setMarkers(markers, {});
        item.setCursors(pairs);
        item.setEvent(event_s);
        item.setLevel(level, 0.0);
        item.setNamesShown(hasNames);
        item.draw(&painter, x, y, canvas);
    };
    return layers;
}

/// As high as the plot is on the screen beside the others; the column with the most plots has the usual
/// height for each of them.
int heightOf(const std::vector<widgets::PlotSpec>& plots, const widgets::PlotSpec& plot) {
    std::size_t most = 0;
    for (const widgets::PlotSpec& each : plots) {
        most = std::max(most, widgets::heightsIn(plots, each.column).size());
    }
    const std::vector<double> heights = widgets::heightsIn(plots, plot.column);
    const double sum = std::accumulate(heights.begin(), heights.end(), 0.0);
    const double share_px = PanelHeight_px * static_cast<double>(most) * plot.height_ratio / sum;
    return std::max(LeastHeight_px, static_cast<int>(std::lround(share_px)));
}

widgets::Panel panelOf(const widgets::LivePlotStack& stack, int plot, const control::SampleHistory& history) {
    const widgets::PlotSpec& spec = stack.plots()[static_cast<std::size_t>(plot)];
    const control::TimeRange range = stack.timeRange(plot);
    const widgets::ValueRange values = stack.valueRange(plot);
    widgets::Panel panel;
    panel.y = {spec.quantity.toStdString(), spec.unit.toStdString(), false, values.low, values.high, {}};
    if (widgets::hasRightAxis(spec)) {
        const widgets::ValueRange right = stack.valueRange(plot, true);
        panel.right = widgets::Axis{spec.right.quantity.toStdString(),
                                    spec.right.unit.toStdString(),
                                    false,
                                    right.low,
                                    right.high,
                                    {}};
    }
    panel.height_px = heightOf(stack.plots(), spec);
    for (std::size_t i = 0; i < spec.curves.size(); ++i) {
        panel.curves.push_back(drawnCurve(history, spec.curves[i], range));
        const int place = placeOf(stack, spec.curves[i].signal, i);
        panel.curves.back().colour = place % widgets::CurveColours;
        panel.curves.back().style = styleOf(widgets::patternAt(place));
    }
    addReference(panel, stack, spec, range);
    return panel;
}

} // namespace

std::vector<widgets::PictureSheet> monitorSheets(const widgets::LivePlotStack& stack,
                                                 const control::SampleHistory& history) {
    std::vector<widgets::PictureSheet> sheets;
    const std::vector<widgets::PlotSpec>& plots = stack.plots();
    for (int i = 0; i < static_cast<int>(plots.size()); ++i) {
        const widgets::PlotSpec& plot = plots[static_cast<std::size_t>(i)];
        const bool isNew =
            sheets.empty() || plot.column != sheets.back().column || stack.ownTime(i) || stack.ownTime(i - 1);
        if (isNew) {
            const control::TimeRange range = stack.timeRange(i);
            sheets.emplace_back();
            sheets.back().column = plot.column;
            sheets.back().width_ratio = plot.width_ratio;
            sheets.back().figure.x = {
                MonitorPicture::tr("time").toStdString(), "s", false, range.begin_s, range.end_s, {}};
        }
        sheets.back().figure.panels.push_back(panelOf(stack, i, history));
        sheets.back().layers.push_back(layersOf(stack, plot, isNew));
    }
    widgets::levelColumns(sheets, widgets::widthForColumns(stack.columnCount()));
    return sheets;
}

MonitorPicture::MonitorPicture(Workbench& bench, widgets::LivePlotStack& stack, QWidget& panel)
    : QObject(&panel), m_bench(bench), m_stack(stack), m_panel(panel) {
    m_copy =
        makeAction(panel, tr("Copy picture"), tr("Copy the plots as a picture"), "copy", QKeySequence::Copy);
    m_save = makeAction(panel, tr("Save picture…"), tr("Save the plots as SVG, PDF or PNG"), "picture",
                        QKeySequence(QStringLiteral("Ctrl+E")));
    m_asOnScreen = new QAction(tr("Pictures in window colours"), &panel);
    m_asOnScreen->setCheckable(true);
    m_asOnScreen->setToolTip(tr("Off: light background for paper and documents"));
    connect(m_copy, &QAction::triggered, this, &MonitorPicture::copy);
    connect(m_save, &QAction::triggered, this, &MonitorPicture::save);
}

std::vector<widgets::PictureSheet> MonitorPicture::sheets() const {
    std::vector<widgets::PictureSheet> sheets = monitorSheets(m_stack, *m_stack.history());
    const devices::DeviceInfo& info = m_bench.session().info();
    sheets.front().figure.title =
        tr("Plots of %1").arg(QString::fromStdString(info.id.empty() ? info.uri : info.id)).toStdString();
    return sheets;
}

widgets::Theme MonitorPicture::theme() const {
    return m_asOnScreen->isChecked() ? widgets::currentTheme() : widgets::paperTheme();
}

int MonitorPicture::width_px() const {
    return widgets::widthForColumns(m_stack.columnCount());
}

void MonitorPicture::copy() {
    QGuiApplication::clipboard()->setImage(
        widgets::sheetsImage(sheets(), theme(), ClipboardFineness, width_px()));
}

/// As the plots are now, not after the dialog.
void MonitorPicture::save() {
    const std::vector<widgets::PictureSheet> taken = sheets();
    const int takenWidth_px = width_px();
    const QString path = m_chooser.save ? m_chooser.save(&m_panel, {tr("Save picture"), tr("plots.svg"),
                                                                    tr("Picture (*.svg *.pdf *.png)")})
                                        : QString();
    if (path.isEmpty()) {
        return;
    }
    const auto format = widgets::pictureFormat(path).value_or(widgets::PictureFormat::Png);
    m_files.run(widgets::pictureWriting(widgets::sheetsFile(taken, theme(), format, takenWidth_px), path),
                [this](const Result<void>& written) {
                    if (!written) {
                        Q_EMIT failed(widgets::inWords(written.error().message),
                                      widgets::inWords(written.error().hint));
                    }
                });
}

} // namespace halbench::app
