#include "app/workspaces/tune/tune_numbers.h"

#include "control/base/units.h"
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

QString stepWords(const control::StepMetrics& step) {
    return Words::tr("rise %1, %2 overshoot, within 2 % after %3")
        .arg(amount(step.riseTime_s, QStringLiteral(" s")),
             amount(step.overshoot_percent, QStringLiteral(" %")),
             amount(step.settlingTime_s, QStringLiteral(" s")));
}

QString linearStepWords(const AnalysisResult& loop) {
    return loop.step ? stepWords(*loop.step) : QStringLiteral("\u2013");
}

QString largeStepWords(const AnalysisResult& loop) {
    if (!loop.largeStep) {
        return QStringLiteral("\u2013");
    }
    return loop.largeStep->hasArrived()
               ? stepWords(loop.largeStep->metrics)
               : Words::tr("not there after %1")
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
        Words::tr("Gain margin"),
        Words::tr("Factor on the gain that makes the loop unstable; at least 2 is usual"),
        [](const AnalysisResult& loop) {
            return amount(loop.margins.gainMargin_ratio, QStringLiteral(" \u00d7"));
        },
        intervalWords(robust.gainMargin_ratio));
    row(
        Words::tr("Phase margin"), Words::tr("At the gain crossover; at least 30\u00b0 is usual"),
        [](const AnalysisResult& loop) {
            return amount(loop.margins.phaseMargin_deg, QStringLiteral("\u00b0"));
        },
        intervalWords(robust.phaseMargin_deg));
    row(
        Words::tr("Delay margin"), Words::tr("Dead time that uses up the phase margin"),
        [](const AnalysisResult& loop) {
            return amount(1e3 * loop.margins.delayMargin_s, QStringLiteral(" ms"));
        },
        intervalWords(robust.delayMargin_s, 1e3));
    row(
        Words::tr("Modulus margin"),
        Words::tr("Smallest distance of the open loop from -1; at least 0.5 is usual"),
        [](const AnalysisResult& loop) { return amount(loop.margins.modulusMargin, {}); },
        intervalWords(robust.modulusMargin));
    row(
        Words::tr("Gain crossover"), Words::tr("Where the open loop has the gain 1"),
        [&frequency](const AnalysisResult& loop) {
            const auto& crossover_rad_s = loop.margins.gainCrossover_rad_s;
            return amount(crossover_rad_s ? std::optional(*crossover_rad_s * frequency.factor) : std::nullopt,
                          frequency.unit);
        },
        intervalWords(robust.gainCrossover_rad_s, frequency.factor));
}

/// What the motion shows; without intervals.
template <typename Row>
void appendMotion(const Row& row, const DisplayUnits& units) {
    row(Words::tr("Largest K_P"), Words::tr("Above it the sampled loop is unstable"),
        [](const AnalysisResult& loop) {
            return amount(loop.proportionalLimit_A_per_rad, QStringLiteral(" A/rad"));
        });
    row(Words::tr("Friction band at rest"),
        Words::tr("Friction may hold the rotor this far from its reference"),
        [&units](const AnalysisResult& loop) {
            return std::isfinite(loop.frictionBand_rad)
                       ? QStringLiteral("\u00b1") + angleText(loop.frictionBand_rad, units)
                       : Words::tr("infinite");
        });
    row(Words::tr("Linear step"), Words::tr("Small steps, without friction and current limit"),
        linearStepWords);
    row(Words::tr("Step of %1").arg(angleText(LargeStep_rad, units)),
        Words::tr("With friction and current limit"), largeStepWords);
}

QString boundWords(const control::BoundUse& use, const QString& unit) {
    const QString text = Words::tr("%1 of %2").arg(amount(use.value, unit), amount(use.bound, unit));
    return use.isActive() ? Words::tr("%1: at its bound").arg(text) : text;
}

/// For methods that keep no bound on it.
void appendSensitivity(std::vector<TuneNumber>& numbers, const control::DesignProof& proof) {
    numbers.push_back(
        {Words::tr("Peak of sensitivity, Ms"),
         amount(proof.peaks.Ms_ratio, {}),
         {},
         {},
         Words::tr("Disturbances near the crossover are made so many times larger; at most 2 is usual")});
}

/// What the law asks of current and delay.
void appendProof(std::vector<TuneNumber>& numbers, const control::DesignProof& proof,
                 const DisplayUnits& units) {
    const auto add = [&numbers](const QString& name, const QString& value, const QString& help) {
        numbers.push_back({name, value, {}, {}, help});
    };
    add(Words::tr("Noise gain"), amount(proof.noiseGain_A_per_rad, QStringLiteral(" A/rad")),
        Words::tr("Current that flickers for each radian of noise in the angle"));
    add(Words::tr("Largest linear step"),
        proof.isStable && std::isfinite(proof.largestStep_rad) ? angleText(proof.largestStep_rad, units)
                                                               : QStringLiteral("\u2013"),
        Words::tr("A larger one reaches the current limit"));
    add(Words::tr("One more sample of delay"),
        proof.poleRadiusOneSampleLater < 1.0 ? Words::tr("stays stable") : Words::tr("UNSTABLE"),
        Words::tr("Whether the loop bears a current that comes one sample later"));
}

/// What a load does, with its interval.
void appendDisturbance(std::vector<TuneNumber>& numbers, const Disturbance& disturbance,
                       const DisplayUnits& units) {
    const control::LoadStep& step = disturbance.step;
    const auto& band = disturbance.band;
    const QString load = widgets::numberText(disturbance.load_A, 2);
    numbers.push_back(
        {Words::tr("Peak under a load worth %1 A").arg(load),
         angleText(step.peak_rad, units),
         band ? Words::tr("%1 to %2")
                    .arg(angleText(band->peak_rad.p5, units), angleText(band->peak_rad.p95, units))
              : Words::tr("not known"),
         {},
         Words::tr("How far the load moves the linear loop from its reference")});
    numbers.push_back({Words::tr("Recovered from it"),
                       step.recoveryTime_s ? Words::tr("after %1 s").arg(amount(*step.recoveryTime_s, {}))
                                           : Words::tr("not in the time that is shown"),
                       intervalWords(band ? band->recoveryTime_s : std::nullopt),
                       {},
                       Words::tr("From then on the angle stays within a tenth of the peak around where it "
                                 "ends")});
}

QString cycleWords(const PredictedCycle& cycle, const DisplayUnits& units) {
    return Words::tr("%1 at %2 Hz, to %3 %")
        .arg(QStringLiteral("\u00b1") + angleText(cycle.amplitude_rad, units, 2),
             widgets::numberText(cycle.frequency_Hz, 2), widgets::fixedText(100.0 * cycle.accuracy_ratio, 0));
}

/// What friction and the current limit make of it.
void appendCycles(std::vector<TuneNumber>& numbers, const TuneResult& result, const DisplayUnits& units) {
    numbers.push_back({Words::tr("Integral ends a rest"),
                       std::isfinite(result.release_s)
                           ? Words::tr("after %1 s").arg(widgets::numberText(result.release_s, 2))
                           : Words::tr("never"),
                       {},
                       {},
                       Words::tr("From half of the friction band; then the rotor jumps and may rest again: "
                                 "it hunts")});
    const QString name = Words::tr("Limit cycle");
    const QString help = Words::tr("A swing that friction and the current limit let the loop keep up, by "
                                   "harmonic balance");
    if (!result.cycles || result.cycles->empty()) {
        numbers.push_back({name,
                           result.cycles ? Words::tr("none") : Words::tr("not predicted"),
                           {},
                           {},
                           result.cycles ? help
                                         : Words::tr("The micro-step assist, or a motor without friction, "
                                                     "is not in the balance")});
        return;
    }
    for (const PredictedCycle& cycle : *result.cycles) {
        numbers.push_back({cycle.isStable ? name : Words::tr("Swing that grows"),
                           cycleWords(cycle, units),
                           {},
                           {},
                           cycle.isStable ? help : Words::tr("A smaller one comes to rest")});
    }
}

/// What a design of least error was not allowed to exceed.
void appendBounds(std::vector<TuneNumber>& numbers, const control::LeastErrorBounds& bounds,
                  const DisplayUnits& units) {
    const QString help = Words::tr("At its bound: this is what keeps the error after a load from being less");
    numbers.push_back(
        {Words::tr("Peak of sensitivity, Ms"), boundWords(bounds.sensitivity, {}), {}, {}, help});
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
    row(Words::tr("Closed loop"), Words::tr("Poles of the sampled loop with the device's delay"),
        [](const AnalysisResult& loop) {
            return loop.isStable ? Words::tr("stable") : Words::tr("UNSTABLE");
        });
    numbers.push_back({Words::tr("Unstable motors"),
                       robust.gainMargin_ratio
                           ? amount(100.0 * robust.unstable_fraction, QStringLiteral(" %"))
                           : Words::tr("not known"),
                       {},
                       {},
                       Words::tr("Share of the motors that the data allow which this loop makes unstable")});
    appendMargins(row, robust, frequencyScale(units));
    if (proposed.bounds) {
        appendBounds(numbers, *proposed.bounds, units);
    }
    if (proposed.proof && !proposed.bounds) {
        appendSensitivity(numbers, *proposed.proof);
    }
    if (proposed.proof) {
        appendProof(numbers, *proposed.proof, units);
    }
    appendMotion(row, units);
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
    return Words::tr("The rotor will turn by %1, in %2; the board ends it at %3 or %4.")
        .arg(widgets::unbroken(angleText(outlook.excursion_rad, units)),
             widgets::unbroken(widgets::numberText(outlook.armed_s, 2) + QStringLiteral(" s")), end.angle,
             end.speed);
}

QString liveStepWords(const MoveOutlook& outlook, const DisplayUnits& units) {
    const MotionEnd end = endOf(outlook, units);
    return Words::tr(
               "After each step the rotor will turn by %1, to and fro, in %2; the board ends it at %3 or %4.")
        .arg(widgets::unbroken(angleText(outlook.excursion_rad, units)),
             widgets::unbroken(widgets::numberText(outlook.armed_s, 2) + QStringLiteral(" s")), end.angle,
             end.speed);
}

QString agreementWords(const VerificationBand& band, const MoveFigures& measured, const DisplayUnits& units) {
    const double rest_rad = std::abs(measured.finalError);
    const double excess_rad = rest_rad - band.allowed_rad;
    QStringList parts = {
        excess_rad <= 0.0
            ? Words::tr("at rest %1 from the set-point by its own sensors, allowed are %2")
                  .arg(angleText(rest_rad, units, 2), angleText(band.allowed_rad, units, 2))
            : Words::tr("at rest %1 from the set-point by its own sensors, %2 more than allowed")
                  .arg(angleText(rest_rad, units, 2), angleText(excess_rad, units, 2))};
    if (measured.overshoot_percent && band.allowedOvershoot_percent &&
        *measured.overshoot_percent > *band.allowedOvershoot_percent) {
        parts << Words::tr("overshoot %1 %, %2 % more than allowed")
                     .arg(widgets::numberText(*measured.overshoot_percent, 2),
                          widgets::numberText(*measured.overshoot_percent - *band.allowedOvershoot_percent,
                                              3));
    }
    parts << Words::tr("farthest from the prediction, %1, after %2 s")
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
    refreshWords();
}

void TuneNumbers::refreshWords() {
    setHorizontalHeaderLabels({tr("Prediction"), tr("Proposed"), tr("5 % to 95 %"),
                               m_isUndecided ? tr("Before the apply") : tr("On the device")});
    horizontalHeaderItem(2)->setToolTip(
        tr("Of the motors that the identification's uncertainty allows; not known without one"));
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
