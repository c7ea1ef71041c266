#include "widgets/live_plot/live_plot.h"

#include "widgets/live_plot/axes/value_scale_draw.h"
#include "widgets/live_plot/axis_mouse.h"
#include "widgets/theme/theme_style.h"

#include <QFontInfo>
#include <QFontMetrics>
#include <QPainter>
#include <qwt_plot_canvas.h>
#include <qwt_plot_layout.h>
#include <qwt_scale_widget.h>

#include <algorithm>
#include <cmath>

namespace halbench::widgets {
namespace {

constexpr double ZStep = 1e-3; ///< the first curve, what is measured, is drawn above its reference
constexpr int Margin = 2;
/// The picture may end a device pixel before the canvas does, see fillEdges().
constexpr int Edge_px = 2;

/// Shows the plot's picture and nothing below it: each fill of a large area costs as much as several curves.
class PictureCanvas : public QwtPlotCanvas {
public:
    using QwtPlotCanvas::QwtPlotCanvas;

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        plot()->drawCanvas(&painter);
    }
};

QwtPlotCanvas* makeCanvas(QwtPlot* plot) {
    auto* canvas = new PictureCanvas(plot);
    canvas->setFrameStyle(QFrame::NoFrame);
    // Everything is drawn anew each frame: a second buffer would only be copied.
    canvas->setPaintAttribute(QwtPlotCanvas::BackingStore, false);
    canvas->setAttribute(Qt::WA_OpaquePaintEvent);
    canvas->setFocusPolicy(Qt::NoFocus); // the plot has it
    canvas->setMouseTracking(true);
    return canvas;
}

/// At a scale as 1.04 a rectangle has one device pixel more or less, by where it stands: a picture of the
/// rounded size can leave the canvas's last column or row as an older frame painted it.
void fillEdges(QPainter& painter, const QRect& place, const QColor& background) {
    painter.fillRect(place.adjusted(place.width() - Edge_px, 0, 0, 0), background);
    painter.fillRect(place.adjusted(0, place.height() - Edge_px, 0, 0), background);
    painter.fillRect(place.adjusted(0, 0, Edge_px - place.width(), 0), background);
    painter.fillRect(place.adjusted(0, 0, 0, Edge_px - place.height()), background);
}

} // namespace

LivePlot::LivePlot(QWidget* parent)
    : QwtPlot(parent), m_grid(new GridItem), m_bands(new BandItem), m_overlay(new OverlayItem),
      m_valueScale(new ValueScaleDraw), m_rightScale(new ValueScaleDraw) {
    setCanvas(makeCanvas(this));
    canvas()->installEventFilter(this);
    plotLayout()->setCanvasMargin(0);
    plotLayout()->setAlignCanvasToScales(true);
    setAutoReplot(false);
    enableAxis(xBottom, false); // the stack has one time axis for all
    // Labels are measured at each new division, seen or not.
    axisScaleDraw(xBottom)->enableComponent(QwtAbstractScaleDraw::Labels, false);
    setAxisScaleDraw(yLeft, m_valueScale);
    axisWidget(yLeft)->setMargin(0);
    setAxisScaleDraw(yRight, m_rightScale);
    axisWidget(yRight)->setMargin(0);
    new AxisMouse(*this, false);
    new AxisMouse(*this, true);
    m_grid->attach(this);
    m_bands->attach(this);
    m_overlay->attach(this);
    setFocusPolicy(Qt::StrongFocus);
    setAcceptDrops(true);
    setMinimumHeight(3 * fontMetrics().height());
    // Half a label of the time axis reaches beyond the right end.
    setContentsMargins(Margin, Margin, 2 * fontMetrics().averageCharWidth() + Margin, Margin);
}

LivePlot::~LivePlot() = default;

void LivePlot::setSpec(const PlotSpec& spec, const control::SampleHistory* history,
                       const SignalColours& colours) {
    m_spec = spec;
    m_history = history;
    for (HistoryCurve* curve : m_curves) {
        curve->detach();
        delete curve;
    }
    m_curves.clear();
    m_places.clear();
    for (const PlotCurve& curve : m_spec.curves) {
        const int index = static_cast<int>(m_curves.size());
        const int place = colours.placeOf(curve.signal, index);
        auto* item = new HistoryCurve(curve, patternAt(place));
        item->setZ(item->z() - ZStep * index);
        item->setYAxis(axisOf(curve));
        item->attach(this);
        m_curves.push_back(item);
        m_places.push_back(place);
    }
    colourCurves();
    makeReferenceCurves();
    m_bands->set(m_spec.bands, m_theme);
    m_grid->setVisible(!m_spec.curves.empty());
    m_overlay->setMessage(m_spec.curves.empty() ? tr("Drag signals here or press Insert") : QString());
    m_autoRange = AutoRange(smallestLength(false));
    m_rightAutoRange = AutoRange(smallestLength(true));
    m_userRange = m_spec.fixedRange;
    m_rightUserRange = m_spec.right.fixedRange;
    setLevel(m_level);
    nameItself();
    setAccessibleDescription(tr("Arrow keys move a cursor or scroll, plus and minus zoom the time (Ctrl: the "
                                "values), Space pauses, F fits, Insert adds signals."));
    updateTitle();
}

void LivePlot::setLooks(const SignalColours& colours, const CurveLooks& looks) {
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
        PlotCurve& curve = m_spec.curves[i];
        const auto look = looks.find(curve.signal);
        curve.ownName = look == looks.end() ? QString() : look->second.name;
        m_places[i] = colours.placeOf(curve.signal, static_cast<int>(i));
        m_curves[i]->setOwnName(curve.ownName);
        m_curves[i]->setPattern(patternAt(m_places[i]));
    }
    colourCurves();
    makeReferenceCurves();
}

void LivePlot::colourCurves() {
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
        m_curves[i]->setColour(m_theme.curves[static_cast<std::size_t>(m_places[i] % CurveColours)]);
    }
}

void LivePlot::setColumn(std::optional<int> column) {
    m_column = column;
    nameItself();
}

void LivePlot::nameItself() {
    const QString name = m_spec.quantity.isEmpty() ? tr("Empty plot")
                         : hasRightAxis(m_spec)
                             ? tr("Plot of %1, right axis %2").arg(m_spec.quantity, m_spec.right.quantity)
                             : tr("Plot of %1").arg(m_spec.quantity);
    setAccessibleName(m_column ? tr("%1, column %2").arg(name, QString::number(*m_column + 1)) : name);
}

void LivePlot::setTheme(const Theme& theme) {
    m_theme = theme;
    setCanvasBackground(theme.plotBackground);
    m_grid->setColour(theme.plotGrid);
    m_bands->set(m_spec.bands, theme);
    m_overlay->setTheme(theme);
    colourCurves();
    makeReferenceCurves();
    QPalette colours = palette();
    colours.setColor(QPalette::Window, theme.panel);
    colours.setColor(QPalette::WindowText, theme.plotAxis);
    colours.setColor(QPalette::Text, theme.plotAxis);
    setPalette(colours);
    setAutoFillBackground(true);
    updateTitle();
}

void LivePlot::focusInEvent(QFocusEvent* event) {
    QwtPlot::focusInEvent(event);
    m_overlay->setFocused(true);
    replot();
}

void LivePlot::focusOutEvent(QFocusEvent* event) {
    QwtPlot::focusOutEvent(event);
    m_overlay->setFocused(false);
    replot();
}

void LivePlot::rescale(bool keepsHeld) {
    m_autoRange = AutoRange(smallestLength(false));
    m_rightAutoRange = AutoRange(smallestLength(true));
    if (!keepsHeld) {
        m_userRange = m_spec.fixedRange;
        m_rightUserRange = m_spec.right.fixedRange;
    }
}

void LivePlot::drawCanvas(QPainter* painter) {
    const double ratio = painter->device()->devicePixelRatioF();
    const QRect place = canvas()->contentsRect();
    const QSize pixels(static_cast<int>(std::lround(place.width() * ratio)),
                       static_cast<int>(std::lround(place.height() * ratio)));
    if (m_image.size() != pixels) {
        m_image = QImage(pixels, QImage::Format_RGB32);
    }
    m_image.setDevicePixelRatio(ratio);
    m_image.fill(canvasBackground().color());
    QPainter onImage(&m_image);
    onImage.setFont(painter->font());
    if (m_history != nullptr) {
        const control::SampleHistory::Glance glance(*m_history);
        m_overlay->setHover(readAtPointer());
        QwtPlot::drawCanvas(&onImage);
        m_isWhole = glance.isWhole();
    } else {
        QwtPlot::drawCanvas(&onImage);
    }
    onImage.end();
    fillEdges(*painter, place, canvasBackground().color());
    painter->drawImage(place.topLeft(), m_image);
}

void LivePlot::setCursors(const CursorPairs& cursors) {
    m_cursors = cursors;
    m_overlay->setCursors(cursors);
}

void LivePlot::setEvent(const std::optional<double>& event_s) {
    m_event_s = event_s;
    m_overlay->setEvent(event_s);
}

QRect LivePlot::canvasRect() const {
    return canvas()->geometry();
}

double LivePlot::timeAt(double canvasX) const {
    return canvasMap(xBottom).invTransform(canvasX);
}

} // namespace halbench::widgets
