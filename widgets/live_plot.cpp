#include "widgets/live_plot.h"

#include "widgets/theme_style.h"
#include "widgets/value_scale_draw.h"

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

constexpr int CurveColours = 8;
constexpr int Margin = 4;
/// Height of a labelled tick in lines of text; where that leaves only one label they come closer.
constexpr double LinesPerTick = 1.6;
constexpr double FewestLines = 2.5;
/// A steady signal is not magnified beyond so many units of its last shown digit.
constexpr double SmallestDigits = 10.0;
/// Labels are given at least this room, so that the first larger number moves nothing.
constexpr char UsualLabel[] = "-000.00";
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

double smallestLength(const PlotSpec& spec) {
    double smallest = 0.0;
    for (const PlotCurve& curve : spec.curves) {
        const double length = SmallestDigits * std::pow(10.0, -curve.decimals);
        smallest = smallest == 0.0 ? length : std::min(smallest, length);
    }
    return smallest;
}

QFont sized(QFont font, double size_ratio) {
    font.setPointSizeF(size_ratio * QFontInfo(font).pointSizeF());
    return font;
}

/// An empty plot has a title of blanks, so that its axis stands where the others stand.
QString titleText(const QString& quantity, const QString& unit, const TitleForm& form) {
    const QString separator(QLatin1Char(form.isUnitBelow ? '\n' : ' '));
    if (!unit.isEmpty()) {
        return quantity + separator + QStringLiteral("[%1]").arg(unit);
    }
    return form.isUnitBelow || quantity.isEmpty() ? quantity + separator + QLatin1Char(' ') : quantity;
}

/// Doubles next to each other must not be pixels apart.
bool isShowable(const ValueRange& range) {
    const double largest = std::max(std::abs(range.low), std::abs(range.high));
    return range.length() > 1e-9 * largest && range.length() < 1e30;
}

/// Distance of the labelled ticks on an axis with room for so many lines of text.
double labelStep(const ValueRange& values, double lines) {
    double step = niceStep(values.length(), static_cast<int>(lines / LinesPerTick));
    while (lines > FewestLines && ticksOf(values, step).size() < 2) {
        step = niceStep(0.4 * step, 1); // the next smaller of 5, 2, 1
    }
    return step;
}

} // namespace

LivePlot::LivePlot(QWidget* parent)
    : QwtPlot(parent), m_grid(new GridItem), m_bands(new BandItem), m_overlay(new OverlayItem),
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
    setMinimumHeight(3 * fontMetrics().height());
    // Half a label of the time axis reaches beyond the right end.
    setContentsMargins(Margin, Margin, 2 * fontMetrics().averageCharWidth() + Margin, Margin);
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
    m_grid->setVisible(!m_spec.curves.empty());
    m_overlay->setMessage(m_spec.curves.empty() ? tr("Drag signals here or press Insert") : QString());
    m_autoRange = AutoRange(smallestLength(m_spec));
    m_userRange = m_spec.fixedRange;
    setLevel(m_level);
    setAccessibleName(m_spec.quantity.isEmpty() ? tr("Empty plot") : tr("Plot of %1").arg(m_spec.quantity));
    setAccessibleDescription(
        tr("Arrow keys move a cursor, plus and minus zoom, Space pauses, F fits, Insert adds signals."));
    updateTitle();
}

void LivePlot::setTheme(const Theme& theme) {
    m_theme = theme;
    setCanvasBackground(theme.plotBackground);
    m_grid->setColour(theme.plotGrid);
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

/// Tick labels may make the canvas lower, never the axis: what does not change when values do. The axis
/// leaves a margin at either end, and letters on their side are a little wider than their metrics say.
int LivePlot::titleRoom() const {
    return contentsRect().height() - PanelMargin_px;
}

bool LivePlot::isTitleWhole(const TitleForm& form) const {
    const QFontMetrics metrics(sized(font(), form.size_ratio));
    const QString lines = titleText(m_spec.quantity, m_spec.unit, form);
    return metrics.size(0, lines).width() <= titleRoom();
}

void LivePlot::setTitleForm(const TitleForm& form) {
    m_titleForm = form;
    updateTitle();
}

void LivePlot::updateTitle() {
    const QFont letters = sized(font(), m_titleForm.size_ratio);
    const QFontMetrics metrics(letters);
    QString quantity = m_spec.quantity;
    if (const int excess =
            metrics.size(0, titleText(quantity, m_spec.unit, m_titleForm)).width() - titleRoom();
        excess > 0) {
        const int room = std::max(metrics.horizontalAdvance(quantity) - excess, 0);
        quantity = metrics.elidedText(quantity, Qt::ElideRight, room);
    }
    QwtText shown(titleText(quantity, m_spec.unit, m_titleForm), QwtText::PlainText);
    shown.setFont(letters);
    shown.setColor(m_theme.text.isValid() ? m_theme.text : palette().color(QPalette::Text));
    setAxisFont(yLeft, font());
    setAxisTitle(yLeft, shown);
    axisWidget(yLeft)->setToolTip(titleText(m_spec.quantity, m_spec.unit, {}).trimmed());
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
    if (!range || isShowable(*range)) {
        m_userRange = range;
    }
}

void LivePlot::fitValues() {
    m_userRange.reset();
    if (const auto extent = dataRange()) {
        m_autoRange.fit(*extent);
    }
}

void LivePlot::rescale(bool keepsHeld) {
    m_autoRange = AutoRange(smallestLength(m_spec));
    m_userRange = keepsHeld ? m_userRange : m_spec.fixedRange;
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
    const double lines = std::max(1.0, static_cast<double>(canvas()->height()) / fontMetrics().height());
    const double step = labelStep(values, lines);
    m_valueScale->setDecimals(decimalsOf(step));
    const QwtScaleDiv division = divisionOf(values.low, values.high, step);
    setAxisScaleDiv(yLeft, m_curves.empty() ? QwtScaleDiv(values.low, values.high) : division);
    setAxisScaleDiv(xBottom, divisionFrom(m_event_s.value_or(0.0), view.begin_s, view.end_s, timeStep_s));
    replot();
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
    QwtPlot::drawCanvas(&onImage);
    onImage.end();
    fillEdges(*painter, place, canvasBackground().color());
    painter->drawImage(place.topLeft(), m_image);
}

void LivePlot::setCursors(const CursorPair& cursors) {
    m_cursors = cursors;
    m_overlay->setCursors(cursors);
}

void LivePlot::setEvent(const std::optional<double>& event_s) {
    m_event_s = event_s;
    m_overlay->setEvent(event_s);
}

void LivePlot::setLevel(const std::optional<PlotLevel>& level) {
    m_level = level;
    const PlotCurve* curve = levelCurve();
    m_overlay->setLevel(curve != nullptr ? std::optional(curve->factor * level->level) : std::nullopt,
                        curve != nullptr ? std::abs(curve->factor) * level->hysteresis : 0.0);
}

const PlotCurve* LivePlot::levelCurve() const {
    const auto found = std::find_if(m_spec.curves.begin(), m_spec.curves.end(), [this](const PlotCurve& one) {
        return m_level && one.signal == m_level->signal;
    });
    return found == m_spec.curves.end() ? nullptr : &*found;
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
