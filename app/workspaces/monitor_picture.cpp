#include "app/workspaces/monitor_picture.h"

#include "widgets/figure_file.h"
#include "widgets/icons.h"
#include "widgets/legend_table_model.h"
#include "widgets/live_plot_stack.h"
#include "widgets/phrasebook.h"
#include "widgets/theme_style.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QWidget>

#include <algorithm>
#include <limits>

namespace halbench::app {

namespace {

constexpr std::size_t FigureColumns = 1600; ///< two to a pixel of a picture of usual width
constexpr int PanelHeight_px = 160;
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

/// Dotted, in the colours of the curves they are compared with.
void addReference(widgets::Panel& panel, const widgets::LivePlotStack& stack, const widgets::PlotSpec& plot) {
    const widgets::ReferencePtr& reference = stack.reference();
    const double shift_s = stack.referenceShift_s();
    const control::TimeRange range = stack.timeRange(stack.plotsOfActiveAxis().front());
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
        trace.colour = static_cast<int>(i);
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

widgets::Figure monitorFigure(const widgets::LivePlotStack& stack, const control::SampleHistory& history) {
    widgets::Figure figure;
    const std::vector<int> active = stack.plotsOfActiveAxis();
    const control::TimeRange range = stack.timeRange(active.front());
    figure.x = {MonitorPicture::tr("time").toStdString(), "s", false, range.begin_s, range.end_s, {}};
    for (const int i : active) { // a picture has one time axis
        const widgets::PlotSpec& plot = stack.plots()[static_cast<std::size_t>(i)];
        const widgets::ValueRange values = stack.valueRange(i);
        widgets::Panel panel;
        panel.y = {plot.quantity.toStdString(), plot.unit.toStdString(), false, values.low, values.high, {}};
        if (widgets::hasRightAxis(plot)) {
            const widgets::ValueRange right = stack.valueRange(i, true);
            panel.right = widgets::Axis{plot.right.quantity.toStdString(),
                                        plot.right.unit.toStdString(),
                                        false,
                                        right.low,
                                        right.high,
                                        {}};
        }
        panel.height_px = PanelHeight_px;
        for (const widgets::PlotCurve& curve : plot.curves) {
            panel.curves.push_back(drawnCurve(history, curve, range));
        }
        addReference(panel, stack, plot);
        figure.panels.push_back(std::move(panel));
    }
    return figure;
}

MonitorPicture::MonitorPicture(Workbench& bench, widgets::LivePlotStack& stack, QWidget& panel)
    : QObject(&panel), m_bench(bench), m_stack(stack), m_panel(panel) {
    m_copy =
        makeAction(panel, tr("Copy picture"), tr("Copy the plots as a picture"), "copy", QKeySequence::Copy);
    m_save = makeAction(panel, tr("Save picture…"), tr("Save the plots as SVG, PDF or PNG"), "export",
                        QKeySequence(QStringLiteral("Ctrl+E")));
    connect(m_copy, &QAction::triggered, this, &MonitorPicture::copy);
    connect(m_save, &QAction::triggered, this, &MonitorPicture::save);
}

widgets::Figure MonitorPicture::figure() const {
    widgets::Figure figure = monitorFigure(m_stack, *m_stack.history());
    figure.title = tr("Plots of %1").arg(deviceKey(m_bench.session().info())).toStdString();
    return figure;
}

void MonitorPicture::sayLeftOut() {
    const std::vector<int> active = m_stack.plotsOfActiveAxis();
    QStringList names;
    for (int i = 0; i < static_cast<int>(m_stack.plots().size()); ++i) {
        if (std::find(active.begin(), active.end(), i) == active.end()) {
            names << m_stack.plots()[static_cast<std::size_t>(i)].quantity;
        }
    }
    if (!names.isEmpty()) {
        Q_EMIT leftOut(
            tr("On another time axis and not in the picture: %1").arg(names.join(QStringLiteral(", "))));
    }
}

void MonitorPicture::copy() {
    QGuiApplication::clipboard()->setImage(
        widgets::figureImage(figure(), widgets::currentTheme(), ClipboardFineness));
    sayLeftOut();
}

void MonitorPicture::save() {
    const QString path = m_chooser.save ? m_chooser.save(&m_panel, {tr("Save picture"), tr("plots.svg"),
                                                                    tr("Picture (*.svg *.pdf *.png)")})
                                        : QString();
    if (path.isEmpty()) {
        return;
    }
    sayLeftOut();
    const auto format = widgets::pictureFormat(path).value_or(widgets::PictureFormat::Png);
    m_files.run(
        widgets::pictureWriting(widgets::pictureFile(figure(), widgets::currentTheme(), format), path),
        [this](const Result<void>& written) {
            if (!written) {
                Q_EMIT failed(widgets::inWords(written.error().message),
                              widgets::inWords(written.error().hint));
            }
        });
}

} // namespace halbench::app
