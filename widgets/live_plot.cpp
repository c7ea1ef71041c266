#include "widgets/live_plot.h"

#include "widgets/value_scale_draw.h"

#include <QFontMetrics>
#include <QResizeEvent>
#include <qwt_plot_canvas.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_layout.h>
#include <qwt_scale_widget.h>

#include <algorithm>
#include <cmath>

namespace halbench::widgets {
namespace {

constexpr int CurveColours = 8;
/// Height of a labelled tick in lines of text.
constexpr int LinesPerTick = 2;
/// A steady signal is not magnified beyond so many units of its last shown digit.
constexpr double SmallestDigits = 10.0;
/// Labels are given at least this room, so that the first larger number moves nothing.
constexpr char UsualLabel[] = "-000.00";

QwtPlotCanvas* makeCanvas(QwtPlot* plot) {
    auto* canvas = new QwtPlotCanvas(plot);
    canvas->setFrameStyle(QFrame::NoFrame);
    // Everything is drawn anew each frame: a second buffer would only be copied.
    canvas->setPaintAttribute(QwtPlotCanvas::BackingStore, false);
    canvas->setPaintAttribute(QwtPlotCanvas::Opaque, true);
    canvas->setFocusPolicy(Qt::NoFocus); // the plot has it
    canvas->setMouseTracking(true);
    return canvas;
}

double smallestLength(const PlotSpec& spec) {
    double smallest = 0.0;
    for (const PlotCurve& curve : spec.curves) {
        const double length = SmallestDigits * std::pow(10.0, -curve.decimals);
        smallest = smallest == 0.0 ? length : std::min(smallest, length);
    }
    return smallest;
}

} // namespace

LivePlot::LivePlot(QWidget* parent)
    : QwtPlot(parent), m_grid(new QwtPlotGrid), m_bands(new BandItem), m_overlay(new OverlayItem),
      m_valueScale(new ValueScaleDraw) {
    setCanvas(makeCanvas(this));
    canvas()->installEventFilter(this);
    plotLayout()->setCanvasMargin(0);
    plotLayout()->setAlignCanvasToScales(true);
    setAutoReplot(false);
    enableAxis(xBottom, false); // the stack has one time axis for all
    setAxisScaleDraw(yLeft, m_valueScale);
    axisWidget(yLeft)->setMargin(0);
    m_grid->attach(this);
    m_bands->attach(this);
    m_overlay->attach(this);
    setFocusPolicy(Qt::StrongFocus);
    setAcceptDrops(true);
    setMinimumHeight(6 * fontMetrics().height());
}

LivePlot::~LivePlot() = default;

void LivePlot::setSpec(const PlotSpec& spec, const control::SampleHistory* history) {
    m_spec = spec;
    m_history = history;
    for (HistoryCurve* curve : m_curves) {
        curve->detach();
        delete curve;
    }
    m_curves.clear();
    for (const PlotCurve& curve : m_spec.curves) {
        const int index = static_cast<int>(m_curves.size());
        auto* item = new HistoryCurve(curve, static_cast<LinePattern>(index / CurveColours % 4));
        item->setColour(m_theme.curves[static_cast<std::size_t>(index % CurveColours)]);
        item->attach(this);
        m_curves.push_back(item);
    }
    m_bands->set(m_spec.bands, m_theme);
    m_overlay->setMessage(m_spec.curves.empty() ? tr("Drag signals here or press Insert") : QString());
    m_autoRange = AutoRange(smallestLength(m_spec));
    m_userRange = m_spec.fixedRange;
    setAccessibleName(m_spec.quantity.isEmpty() ? tr("Empty plot") : tr("Plot of %1").arg(m_spec.quantity));
    setAccessibleDescription(
        tr("Arrow keys move a cursor, plus and minus zoom, Space pauses, F fits, Insert adds signals."));
    updateTitle();
}

void LivePlot::setTheme(const Theme& theme) {
    m_theme = theme;
    setCanvasBackground(theme.plotBackground);
    m_grid->setMajorPen(theme.plotGrid, 1.0);
    m_bands->set(m_spec.bands, theme);
    m_overlay->setTheme(theme);
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
        m_curves[i]->setColour(theme.curves[i % CurveColours]);
    }
    QPalette colours = palette();
    colours.setColor(QPalette::Window, theme.panel);
    colours.setColor(QPalette::WindowText, theme.plotAxis);
    colours.setColor(QPalette::Text, theme.plotAxis);
    setPalette(colours);
    setAutoFillBackground(true);
    updateTitle();
}

void LivePlot::updateTitle() {
    const QString whole =
        m_spec.unit.isEmpty() ? m_spec.quantity : QStringLiteral("%1 [%2]").arg(m_spec.quantity, m_spec.unit);
    QwtText title(fontMetrics().elidedText(whole, Qt::ElideRight, std::max(height() - 8, 40)));
    title.setFont(font());
    title.setColor(m_theme.text.isValid() ? m_theme.text : palette().color(QPalette::Text));
    setAxisFont(yLeft, font());
    setAxisTitle(yLeft, title);
    axisWidget(yLeft)->setToolTip(whole);
}

void LivePlot::resizeEvent(QResizeEvent* event) {
    QwtPlot::resizeEvent(event);
    updateTitle();
}

std::optional<ValueRange> LivePlot::dataRange() const {
    control::Extremes all;
    for (const HistoryCurve* curve : m_curves) {
        if (m_history == nullptr || !curve->isVisible()) {
            continue;
        }
        const control::Extremes own = m_history->extremes(curve->curve().signal, m_drawn);
        if (!own.isEmpty()) {
            all.add(curve->curve().factor * own.min);
            all.add(curve->curve().factor * own.max);
        }
    }
    return all.isEmpty() ? std::nullopt : std::optional(ValueRange{all.min, all.max});
}

ValueRange LivePlot::shownRange() const {
    return m_userRange.value_or(m_autoRange.range());
}

void LivePlot::setUserRange(const std::optional<ValueRange>& range) {
    m_userRange = range && range->length() > 0.0 && std::isfinite(range->length()) ? range : std::nullopt;
}

void LivePlot::fitValues() {
    m_userRange.reset();
    if (const auto extent = dataRange()) {
        m_autoRange.fit(*extent);
    }
}

void LivePlot::showFrame(control::TimeRange view, double timeStep_s, control::TimeRange drawn) {
    m_drawn = drawn;
    if (const auto extent = dataRange(); extent && !m_userRange) {
        m_autoRange.update(*extent);
    }
    for (HistoryCurve* curve : m_curves) {
        curve->setSource(m_history, drawn);
    }
    const ValueRange values = shownRange();
    const int lines = std::max(1, canvas()->height() / (LinesPerTick * fontMetrics().height()));
    const double step = niceStep(values.length(), lines);
    m_valueScale->setDecimals(decimalsOf(step));
    setAxisScaleDiv(yLeft, divisionOf(values.low, values.high, step));
    setAxisScaleDiv(xBottom, divisionOf(view.begin_s, view.end_s, timeStep_s));
    replot();
}

void LivePlot::setCursors(const CursorPair& cursors) {
    m_cursors = cursors;
    m_overlay->setCursors(cursors);
}

int LivePlot::neededExtent() const {
    const double usual = fontMetrics().horizontalAdvance(QLatin1String(UsualLabel));
    const double labels = std::max(static_cast<double>(m_valueScale->maxLabelWidth(font())), usual);
    return static_cast<int>(
        std::ceil(m_valueScale->tickLength(QwtScaleDiv::MajorTick) + m_valueScale->spacing() + labels));
}

void LivePlot::setExtent(int extent_px) {
    if (m_valueScale->minimumExtent() != extent_px) {
        m_valueScale->setMinimumExtent(extent_px);
        updateLayout();
    }
}

QRect LivePlot::canvasRect() const {
    return canvas()->geometry();
}

double LivePlot::timeAt(double canvasX) const {
    return canvasMap(xBottom).invTransform(canvasX);
}

} // namespace halbench::widgets
