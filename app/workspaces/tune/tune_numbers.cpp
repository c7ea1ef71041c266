#include "app/workspaces/tune/tune_numbers.h"

#include "control/base/units.h"
#include "widgets/controls/copy_menu.h"
#include "widgets/language/display_units.h"
#include "widgets/language/unbroken.h"
#include "widgets/language/whole_numbers.h"
#include "widgets/theme/theme_style.h"

#include <QCoreApplication>
#include <QEvent>
#include <QHeaderView>
#include <QKeyEvent>

#include <cmath>

namespace halbench::app {
namespace {

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::TuneNumberWords)
};

QString amount(double value, const QString& unit, int digits = 3) {
    return std::isfinite(value) ? widgets::numberText(value, digits) + unit : Words::tr("infinite");
}

QString amount(const std::optional<double>& value, const QString& unit, int digits = 3) {
    return value ? amount(*value, unit, digits) : QStringLiteral("\u2013");
}

/// What a frequency in rad/s is multiplied by, and the unit that it then has.
struct FrequencyScale {
    double factor;
    QString unit;
};

FrequencyScale frequencyScale(const DisplayUnits& units) {
    return units.frequency == FrequencyUnit::RadiansPerSecond
               ? FrequencyScale{1.0, QStringLiteral(" rad/s")}
               : FrequencyScale{0.5 / Pi, QStringLiteral(" Hz")};
}

/// Three rows of one step: a figure each, so that no column is as wide as a sentence. `metrics` gives null
/// for a loop without the step.
template <typename Row, typename Metrics>
void appendStep(const Row& row, const QString& title, const QString& help, const Metrics& metrics) {
    const auto add = [&](const QString& name, const auto& figure, const QString& unit) {
        row(name.arg(title), help, [&](const AnalysisResult& loop) {
            const control::StepMetrics* step = metrics(loop);
            return step == nullptr ? QStringLiteral("\u2013") : amount(figure(*step), unit);
        });
    };
    add(
        Words::tr("%1: rise time"), [](const control::StepMetrics& step) { return step.riseTime_s; },
        QStringLiteral(" s"));
    add(
        Words::tr("%1: overshoot"), [](const control::StepMetrics& step) { return step.overshoot_percent; },
        QStringLiteral(" %"));
    add(
        Words::tr("%1: settling time (2 %)"),
        [](const control::StepMetrics& step) { return step.settlingTime_s; }, QStringLiteral(" s"));
}

const control::StepMetrics* linearStep(const AnalysisResult& loop) {
    return loop.step ? &*loop.step : nullptr;
}

const control::StepMetrics* largeStep(const AnalysisResult& loop) {
    return loop.largeStep && loop.largeStep->hasArrived() ? &loop.largeStep->metrics : nullptr;
}

bool isUnsettled(const std::optional<AnalysisResult>& loop) {
    return loop && loop->largeStep && !loop->largeStep->hasArrived();
}

QString largeStepState(const AnalysisResult& loop) {
    return !loop.largeStep ? QStringLiteral("\u2013")
           : loop.largeStep->hasArrived()
               ? Words::tr("settled")
               : Words::tr("not settled after %1")
                     .arg(amount(loop.largeStep->duration_s(), QStringLiteral(" s")));
}

/// What 5 % to 95 % of the motors that the data allow have, times the factor of the unit that is shown.
QString intervalWords(const std::optional<control::Robustness::Interval>& spread, double factor = 1.0) {
    return spread
               ? Words::tr("%1 to %2").arg(amount(factor * spread->p5, {}), amount(factor * spread->p95, {}))
               : Words::tr("not known");
}

/// How far the loop is from instability, each with its interval.
template <typename Row>
void appendMargins(const Row& row, const control::Robustness& robust, const FrequencyScale& frequency) {
    row(
        Words::tr("Gain margin"), Words::tr("Gain factor at the stability limit; usually at least 2"),
        [](const AnalysisResult& loop) {
            return amount(loop.margins.gainMargin_ratio, QStringLiteral(" \u00d7"));
        },
        intervalWords(robust.gainMargin_ratio));
    row(
        Words::tr("Phase margin"), Words::tr("Phase margin at the gain crossover; usually at least 30°"),
        [](const AnalysisResult& loop) {
            return amount(loop.margins.phaseMargin_deg, QStringLiteral("\u00b0"));
        },
        intervalWords(robust.phaseMargin_deg));
    row(
        Words::tr("Delay margin"), Words::tr("Additional delay at the stability limit"),
        [](const AnalysisResult& loop) {
            return amount(1e3 * loop.margins.delayMargin_s, QStringLiteral(" ms"));
        },
        intervalWords(robust.delayMargin_s, 1e3));
    row(
        Words::tr("Modulus margin"),
        Words::tr("Smallest distance of the open loop from -1; usually at least 0.5"),
        [](const AnalysisResult& loop) { return amount(loop.margins.modulusMargin, {}); },
        intervalWords(robust.modulusMargin));
    row(
        Words::tr("Gain crossover"), Words::tr("Frequency at which the open-loop gain is 1"),
        [&frequency](const AnalysisResult& loop) {
            const auto& crossover_rad_s = loop.margins.gainCrossover_rad_s;
            return amount(crossover_rad_s ? std::optional(*crossover_rad_s * frequency.factor) : std::nullopt,
                          frequency.unit);
        },
        intervalWords(robust.gainCrossover_rad_s, frequency.factor));
}

/// What the motion shows; without intervals.
template <typename Row>
void appendMotion(const Row& row, const DisplayUnits& units, bool hasUnsettled) {
    row(Words::tr("Largest K_P"), Words::tr("Stability limit of the sampled loop"),
        [](const AnalysisResult& loop) {
            return amount(loop.proportionalLimit_A_per_rad, QStringLiteral(" A/rad"));
        });
    row(Words::tr("Friction band at rest"), Words::tr("Possible standstill error due to friction"),
        [&units](const AnalysisResult& loop) {
            return std::isfinite(loop.frictionBand_rad)
                       ? QStringLiteral("\u00b1") + angleText(loop.frictionBand_rad, units)
                       : Words::tr("infinite");
        });
    appendStep(row, Words::tr("Linear step"), Words::tr("Small steps, without friction and current limit"),
               linearStep);
    const QString large = Words::tr("Step of %1").arg(angleText(LargeStep_rad, units));
    const QString conditions = Words::tr("With friction and current limit");
    if (hasUnsettled) {
        row(large, conditions, largeStepState);
    }
    appendStep(row, large, conditions, largeStep);
}

QString boundWords(const control::BoundUse& use, const QString& unit) {
    const QString text = Words::tr("%1 of %2").arg(amount(use.value, unit), amount(use.bound, unit));
    return use.isActive() ? Words::tr("%1: limit active").arg(text) : text;
}

/// For methods that keep no bound on it.
void appendSensitivity(std::vector<TuneNumber>& numbers, const control::LoopAssessment& assessment) {
    numbers.push_back({Words::tr("Sensitivity peak Ms"),
                       amount(assessment.peaks.Ms_ratio, {}),
                       {},
                       {},
                       Words::tr("Maximum amplification of disturbances; usually at most 2")});
}

/// What the law asks of current and delay.
void appendProof(std::vector<TuneNumber>& numbers, const control::LoopAssessment& assessment,
                 const DisplayUnits& units) {
    const auto add = [&numbers](const QString& name, const QString& value, const QString& help) {
        numbers.push_back({name, value, {}, {}, help});
    };
    add(Words::tr("Noise gain"), amount(assessment.noiseGain_A_per_rad, QStringLiteral(" A/rad")),
        Words::tr("Current noise per radian of angle noise"));
    add(Words::tr("Largest step without saturation"),
        assessment.isStable && std::isfinite(assessment.largestStep_rad)
            ? angleText(assessment.largestStep_rad, units)
            : QStringLiteral("\u2013"),
        Words::tr("Larger steps reach the current limit"));
    add(Words::tr("One sample more delay"),
        assessment.poleRadiusOneSampleLater < 1.0 ? Words::tr("stays stable") : Words::tr("UNSTABLE"),
        Words::tr("Stability of the loop with one more sample of delay"));
}

/// What a load does, with its interval.
void appendDisturbance(std::vector<TuneNumber>& numbers, const Disturbance& disturbance,
                       const DisplayUnits& units) {
    const control::LoadStep& step = disturbance.step;
    const auto& band = disturbance.band;
    const QString load = widgets::numberText(disturbance.load_A, 2);
    numbers.push_back(
        {Words::tr("Peak after a load step equal to %1 A").arg(load),
         angleText(step.peak_rad, units),
         band ? Words::tr("%1 to %2")
                    .arg(angleText(band->peak_rad.p5, units), angleText(band->peak_rad.p95, units))
              : Words::tr("not known"),
         {},
         Words::tr("Largest deviation of the linear loop after the load step")});
    numbers.push_back(
        {Words::tr("Settling after load"),
         step.recoveryTime_s ? Words::tr("after %1 s").arg(amount(*step.recoveryTime_s, {}))
                             : Words::tr("longer than the time shown"),
         intervalWords(band ? band->recoveryTime_s : std::nullopt),
         {},
         Words::tr("Time until the angle stays within 10 % of the peak around its final value")});
}

QString cycleWords(const PredictedCycle& cycle, const DisplayUnits& units) {
    return Words::tr("%1 at %2 Hz, to %3 %")
        .arg(QStringLiteral("\u00b1") + angleText(cycle.amplitude_rad, units, 2),
             widgets::numberText(cycle.frequency_Hz, 2), widgets::fixedText(100.0 * cycle.accuracy_ratio, 0));
}

/// What friction and the current limit make of it.
void appendCycles(std::vector<TuneNumber>& numbers, const TuneResult& result, const DisplayUnits& units) {
    numbers.push_back(
        {Words::tr("Stick time before integral moves it"),
         std::isfinite(result.release_s)
             ? Words::tr("after %1 s").arg(widgets::numberText(result.release_s, 2))
             : Words::tr("never"),
         {},
         {},
         Words::tr("From half the friction band. The rotor then jumps and may stick again (hunting)")});
    const QString name = Words::tr("Limit cycle");
    const QString help =
        Words::tr("Sustained oscillation due to friction and current limit (harmonic balance)");
    if (!result.cycles || result.cycles->empty()) {
        numbers.push_back(
            {name,
             result.cycles ? Words::tr("none") : Words::tr("not predicted"),
             {},
             {},
             result.cycles
                 ? help
                 : Words::tr(
                       "Harmonic balance does not cover the micro-step assist or a motor without friction")});
        return;
    }
    for (const PredictedCycle& cycle : *result.cycles) {
        numbers.push_back({cycle.isStable ? name : Words::tr("Growth threshold"),
                           cycleWords(cycle, units),
                           {},
                           {},
                           cycle.isStable ? help : Words::tr("Smaller oscillations decay")});
    }
}

/// What a design of least error was not allowed to exceed.
void appendBounds(std::vector<TuneNumber>& numbers, const control::LeastErrorBounds& bounds,
                  const DisplayUnits& units) {
    const QString help = Words::tr("Active limit: it prevents a smaller error after a load step");
    numbers.push_back({Words::tr("Sensitivity peak Ms"), boundWords(bounds.sensitivity, {}), {}, {}, help});
    if (bounds.current) {
        numbers.push_back({Words::tr("Current in a step of %1").arg(angleText(bounds.step_rad, units)),
                           boundWords(*bounds.current, QStringLiteral(" A")),
                           {},
                           {},
                           help});
    }
}

} // namespace

std::vector<TuneNumber> tuneNumbers(const TuneResult& proposed, const std::optional<AnalysisResult>& present,
                                    const DisplayUnits& units) {
    std::vector<TuneNumber> numbers;
    const auto row = [&](const QString& name, const QString& help, const auto& text,
                         const QString& interval = {}) {
        numbers.push_back(
            {name, text(proposed.predicted), interval, present ? text(*present) : QString(), help});
    };
    const control::Robustness& robust = proposed.robust;
    row(Words::tr("Closed loop"), Words::tr("Poles of the sampled loop, with the device's delay"),
        [](const AnalysisResult& loop) {
            return loop.isStable ? Words::tr("stable") : Words::tr("UNSTABLE");
        });
    numbers.push_back(
        {Words::tr("Share of unstable cases"),
         robust.isUncertain ? amount(100.0 * robust.unstable_fraction, QStringLiteral(" %"))
                            : Words::tr("not known"),
         {},
         {},
         Words::tr("Share of the motors within the model's uncertainty for which this loop is unstable")});
    appendMargins(row, robust, frequencyScale(units));
    if (proposed.bounds) {
        appendBounds(numbers, *proposed.bounds, units);
    }
    if (proposed.assessment && !proposed.bounds) {
        appendSensitivity(numbers, *proposed.assessment);
    }
    if (proposed.assessment) {
        appendProof(numbers, *proposed.assessment, units);
    }
    appendMotion(row, units, isUnsettled(proposed.predicted) || isUnsettled(present));
    if (proposed.disturbance) {
        appendDisturbance(numbers, *proposed.disturbance, units);
    }
    appendCycles(numbers, proposed, units);
    return numbers;
}

namespace {

/// Where the board ends the motion.
struct MotionEnd {
    QString angle;
    QString speed;
};

MotionEnd endOf(const MoveOutlook& outlook, const DisplayUnits& units) {
    const DisplayQuantity speed = displayQuantity("rad/s", units);
    return {widgets::unbroken(angleText(outlook.window_rad, units)),
            widgets::unbroken(widgets::fixedText(outlook.speedLimit_rad_s * speed.factor, 0) +
                              QLatin1Char(' ') + speed.unit)};
}

} // namespace

QString verificationWords(const MoveOutlook& outlook, const DisplayUnits& units) {
    const MotionEnd end = endOf(outlook, units);
    return Words::tr("Verification: %1 in %2. Device stops at %3 or %4.")
        .arg(widgets::unbroken(angleText(outlook.excursion_rad, units)),
             widgets::unbroken(widgets::numberText(outlook.armed_s, 2) + QStringLiteral(" s")), end.angle,
             end.speed);
}

QString liveStepWords(const MoveOutlook& outlook, const DisplayUnits& units) {
    const MotionEnd end = endOf(outlook, units);
    return Words::tr("Verification after each step: %1 forth and back in %2. Device stops at %3 or %4.")
        .arg(widgets::unbroken(angleText(outlook.excursion_rad, units)),
             widgets::unbroken(widgets::numberText(outlook.armed_s, 2) + QStringLiteral(" s")), end.angle,
             end.speed);
}

QString agreementWords(const VerificationBand& band, const MoveFigures& measured, const DisplayUnits& units) {
    const double rest_rad = std::abs(measured.finalError);
    const double excess_rad = rest_rad - band.allowed_rad;
    QStringList parts = {excess_rad <= 0.0
                             ? Words::tr("final error %1 (limit %2)")
                                   .arg(angleText(rest_rad, units, 2), angleText(band.allowed_rad, units, 2))
                             : Words::tr("final error %1 (%2 above the limit)")
                                   .arg(angleText(rest_rad, units, 2), angleText(excess_rad, units, 2))};
    if (measured.overshoot_percent && band.allowedOvershoot_percent &&
        *measured.overshoot_percent > *band.allowedOvershoot_percent) {
        parts << Words::tr("overshoot %1 % (%2 % above the limit)")
                     .arg(widgets::numberText(*measured.overshoot_percent, 2),
                          widgets::numberText(*measured.overshoot_percent - *band.allowedOvershoot_percent,
                                              3));
    }
    parts << Words::tr("max. deviation from the prediction %1 at %2 s")
                 .arg(angleText(std::abs(band.largestOff_rad), units, 2),
                      widgets::numberText(band.largestOffTime_s, 2));
    return parts.join(QStringLiteral("; "));
}

TuneNumbers::TuneNumbers(QWidget* parent) : QTableWidget(0, 4, parent) {
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setTabKeyNavigation(false);
    setItemDelegate(new widgets::WholeNumbers(this));
    verticalHeader()->hide();
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    horizontalHeader()->setStretchLastSection(true);
    widgets::addCopyMenu(*this);
    refreshWords();
}

void TuneNumbers::refreshWords() {
    setHorizontalHeaderLabels({tr("Prediction"), tr("Proposed"), tr("5-95 % band"),
                               m_isUndecided ? tr("Before applying") : tr("On the device")});
    horizontalHeaderItem(2)->setToolTip(tr("Range over the uncertainty of the identified motor"));
    for (int column = 0; column < columnCount(); ++column) {
        horizontalHeaderItem(column)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    }
    setAccessibleName(tr("Predicted figures"));
}

void TuneNumbers::setUndecided(bool isUndecided) {
    m_isUndecided = isUndecided;
    refreshWords();
}

void TuneNumbers::setNumbers(const std::vector<TuneNumber>& numbers) {
    setRowCount(static_cast<int>(numbers.size()));
    for (int i = 0; i < rowCount(); ++i) {
        const TuneNumber& number = numbers[static_cast<std::size_t>(i)];
        const QString texts[] = {number.name, number.proposed, number.interval, number.present};
        for (int column = 0; column < columnCount(); ++column) {
            auto* cell = new QTableWidgetItem(texts[column]);
            cell->setToolTip(number.help);
            setItem(i, column, cell);
        }
    }
}

void TuneNumbers::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        event->ignore(); // Esc stops the motor
    } else {
        QTableWidget::keyPressEvent(event);
    }
}

void TuneNumbers::changeEvent(QEvent* event) {
    QTableWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refreshWords();
    }
}

} // namespace halbench::app
