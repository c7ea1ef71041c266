// The axes of values of a plot: what they show, how they are titled, how wide they are.
#include "widgets/live_plot/axes/sensor_step.h"
#include "widgets/live_plot/axes/value_scale_draw.h"
#include "widgets/live_plot/live_plot.h"
#include "widgets/theme/theme_style.h"

#include <QFontInfo>
#include <QFontMetrics>
#include <QLocale>
#include <qwt_scale_widget.h>

#include <algorithm>
#include <cmath>

namespace halbench::widgets {
namespace {

/// Height of a labelled tick in lines of text; where that leaves only one label they come closer.
constexpr double LinesPerTick = 1.6;
constexpr double FewestLines = 2.5;
/// Labels are given at least this room, so that the first larger number moves nothing.
constexpr char UsualLabel[] = "-000.00";

/// A steady signal is not magnified beyond so many units of its last shown digit, nor a sensor beyond so many
/// of its steps.
constexpr double SmallestDigits = 10.0;
constexpr double SmallestSteps = 20.0;
/// Of the newest rows: more of them say nothing more of a step.
constexpr double StepRows = 500.0;

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

/// What a label at the lower end needs below the axis. The scale takes numbers for letters that end at their
/// line: the tail of a decimal comma goes below it, and a comma without its tail is read as a point.
int roomBelow(const ValueScaleDraw& scale, const QFont& font) {
    const int tail_px = QFontMetrics(font).tightBoundingRect(QLocale().decimalPoint()).bottom() + 1;
    return static_cast<int>(std::ceil(0.5 * scale.maxLabelHeight(font))) + std::max(0, tail_px);
}

/// Where a value of one range stands in another that is drawn as high.
double beside(double value, const ValueRange& from, const ValueRange& to) {
    return to.low + (value - from.low) / from.length() * to.length();
}

} // namespace

/// Tick labels may make the canvas lower, never the axis: what does not change when values do. The axis
/// leaves a margin at either end, and letters on their side are a little wider than their metrics say.
int LivePlot::titleRoom() const {
    return contentsRect().height() - PanelMargin_px;
}

bool LivePlot::isTitleWhole(const TitleForm& form) const {
    const QFontMetrics metrics(sized(font(), form.size_ratio));
    const QString left = titleText(m_spec.quantity, m_spec.unit, form);
    const QString right = titleText(m_spec.right.quantity, m_spec.right.unit, form);
    return std::max(metrics.size(0, left).width(), metrics.size(0, right).width()) <= titleRoom();
}

void LivePlot::setTitleForm(const TitleForm& form) {
    m_titleForm = form;
    updateTitle();
}

void LivePlot::updateTitle() {
    setTitle(yLeft, m_spec.quantity, m_spec.unit);
    setTitle(yRight, m_spec.right.quantity, m_spec.right.unit);
}

void LivePlot::setTitle(int axis, const QString& whole, const QString& unit) {
    const QFont letters = sized(font(), m_titleForm.size_ratio);
    const QFontMetrics metrics(letters);
    QString quantity = whole;
    if (const int excess = metrics.size(0, titleText(quantity, unit, m_titleForm)).width() - titleRoom();
        excess > 0) {
        const int room = std::max(metrics.horizontalAdvance(quantity) - excess, 0);
        quantity = metrics.elidedText(quantity, Qt::ElideRight, room);
    }
    QwtText shown(titleText(quantity, unit, m_titleForm), QwtText::PlainText);
    shown.setFont(letters);
    shown.setColor(m_theme.text.isValid() ? m_theme.text : palette().color(QPalette::Text));
    setAxisFont(axis, font());
    setAxisTitle(axis, shown);
    axisWidget(axis)->setToolTip(titleText(whole, unit, {}).trimmed());
}

std::optional<ValueRange> LivePlot::dataRange(bool isRight) const {
    control::Extremes all;
    for (const HistoryCurve* curve : m_curves) {
        if (m_history == nullptr || !curve->isVisible() || curve->curve().isRight != isRight) {
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

/// Of the finest digits, so that no curve is drawn flat, and of the coarsest sensor, so that none is a block.
double LivePlot::smallestLength(bool isRight) const {
    double digits = 0.0;
    double steps = 0.0;
    for (const PlotCurve& curve : m_spec.curves) {
        if (curve.isRight == isRight) {
            const double length = SmallestDigits * std::pow(10.0, -curve.decimals);
            digits = digits == 0.0 ? length : std::min(digits, length);
            steps = std::max(steps, sensorLength(curve));
        }
    }
    return std::max(digits, steps);
}

/// In the unit shown; 0 where the newest rows show no steps.
double LivePlot::sensorLength(const PlotCurve& curve) const {
    const auto held = curve.isSensor && m_history != nullptr ? m_history->range(curve.signal) : std::nullopt;
    const control::TimeRange seen = m_drawn;
    const std::size_t rows = held ? m_history->rowsIn(curve.signal, seen) : 0;
    if (rows == 0) {
        return 0.0;
    }
    const double end_s = std::min(seen.end_s, held->end_s);
    const double part = std::min(1.0, StepRows / static_cast<double>(rows));
    std::vector<control::TimedValue> samples;
    m_history->samples(curve.signal, {end_s - part * seen.length_s(), end_s}, samples);
    return SmallestSteps * std::abs(curve.factor) * sensorStep(samples).value_or(0.0);
}

ValueRange LivePlot::shownRange() const {
    return shownRange(false);
}

ValueRange LivePlot::shownRange(bool isRight) const {
    return isRight ? m_rightUserRange.value_or(m_rightAutoRange.range())
                   : m_userRange.value_or(m_autoRange.range());
}

void LivePlot::setUserRange(const std::optional<ValueRange>& range) {
    if (!range || isShowable(*range)) {
        m_userRange = range;
    }
}

void LivePlot::setHeldRanges(const HeldRanges& ranges) {
    setUserRange(ranges.left);
    if (!ranges.right || isShowable(*ranges.right)) {
        m_rightUserRange = ranges.right;
    }
}

void LivePlot::zoomValues(const ValueRange& left) {
    const ValueRange before = shownRange();
    const ValueRange right = shownRange(true);
    HeldRanges held{left, std::nullopt};
    if (hasRightAxis(m_spec)) {
        held.right = ValueRange{beside(left.low, before, right), beside(left.high, before, right)};
    }
    if (isShowable(left)) {
        setHeldRanges(held);
    }
}

void LivePlot::fitValues() {
    m_userRange.reset();
    m_rightUserRange.reset();
    if (const auto extent = dataRange(false)) {
        m_autoRange.fit(*extent);
    }
    if (const auto extent = dataRange(true)) {
        m_rightAutoRange.fit(*extent);
    }
}

/// What the disk has not given yet is known too roughly for an axis.
void LivePlot::followData() {
    if (m_history == nullptr) {
        return;
    }
    const control::SampleHistory::Glance glance(*m_history);
    const auto left = dataRange(false);
    const auto right = dataRange(true);
    if (left && !m_userRange && glance.isWhole()) {
        m_autoRange.setSmallestLength(smallestLength(false));
        m_autoRange.update(*left);
    }
    if (right && !m_rightUserRange && glance.isWhole()) {
        m_rightAutoRange.setSmallestLength(smallestLength(true));
        m_rightAutoRange.update(*right);
    }
}

void LivePlot::showFrame(control::TimeRange view, double timeStep_s, control::TimeRange drawn) {
    m_drawn = drawn;
    followData();
    for (HistoryCurve* curve : m_curves) {
        curve->setSource(m_history, drawn);
    }
    showReference(view);
    showScale(false);
    showScale(true);
    showLevel();
    setAxisScaleDiv(xBottom, divisionFrom(m_event_s.value_or(0.0), view.begin_s, view.end_s, timeStep_s));
    replot();
}

/// An axis without curves has no ticks.
void LivePlot::showScale(bool isRight) {
    const ValueRange values = shownRange(isRight);
    const double lines = std::max(1.0, static_cast<double>(canvas()->height()) / fontMetrics().height());
    const double step = labelStep(values, lines);
    const bool isEmpty = isRight ? !hasRightAxis(m_spec) : m_curves.empty();
    ValueScaleDraw& scale = isRight ? *m_rightScale : *m_valueScale;
    scale.setDecimals(decimalsOf(step));
    axisWidget(isRight ? yRight : yLeft)->setMinBorderDist(0, roomBelow(scale, font()));
    setAxisScaleDiv(isRight ? yRight : yLeft, isEmpty ? QwtScaleDiv(values.low, values.high)
                                                      : divisionOf(values.low, values.high, step));
}

void LivePlot::setLevel(const std::optional<PlotLevel>& level) {
    m_level = level;
    showLevel();
}

/// What lies over the curves knows the left axis: a level on the right one is drawn where it stands beside
/// it.
void LivePlot::showLevel() {
    const PlotCurve* curve = levelCurve();
    if (curve == nullptr) {
        m_overlay->setLevel(std::nullopt, 0.0);
        return;
    }
    const ValueRange left = shownRange();
    const ValueRange own = shownRange(curve->isRight);
    m_overlay->setLevel(beside(curve->factor * m_level->level, own, left),
                        std::abs(curve->factor) * m_level->hysteresis * left.length() / own.length());
}

const PlotCurve* LivePlot::levelCurve() const {
    const auto found = std::find_if(m_spec.curves.begin(), m_spec.curves.end(), [this](const PlotCurve& one) {
        return m_level && one.signal == m_level->signal;
    });
    return found == m_spec.curves.end() ? nullptr : &*found;
}

int LivePlot::extentOf(const ValueScaleDraw& scale) const {
    const double usual = fontMetrics().horizontalAdvance(QLatin1String(UsualLabel));
    const double labels = std::max(static_cast<double>(scale.maxLabelWidth(font())), usual);
    return static_cast<int>(std::ceil(scale.tickLength(QwtScaleDiv::MajorTick) + scale.spacing() + labels));
}

int LivePlot::neededExtent() const {
    return extentOf(*m_valueScale);
}

int LivePlot::neededRightExtent() const {
    return extentOf(*m_rightScale);
}

void LivePlot::setExtent(int extent_px) {
    if (m_valueScale->minimumExtent() != extent_px) {
        m_valueScale->setMinimumExtent(extent_px);
        updateLayout();
    }
}

void LivePlot::setRightExtent(std::optional<int> extent_px) {
    if (extent_px.has_value() == axisEnabled(yRight) &&
        m_rightScale->minimumExtent() == extent_px.value_or(m_rightScale->minimumExtent())) {
        return;
    }
    m_rightScale->setMinimumExtent(extent_px.value_or(0.0));
    enableAxis(yRight, extent_px.has_value());
    updateLayout();
}

} // namespace halbench::widgets
