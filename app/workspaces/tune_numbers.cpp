#include "app/workspaces/tune_numbers.h"

#include "control/base/units.h"
#include "widgets/display_units.h"
#include "widgets/theme_style.h"

#include <QCoreApplication>
#include <QEvent>
#include <QHeaderView>
#include <QKeyEvent>

#include <cmath>
#include <functional>

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

std::optional<double> inHertz(const std::optional<double>& frequency_rad_s) {
    return frequency_rad_s ? std::optional(*frequency_rad_s / (2.0 * Pi)) : std::nullopt;
}

QString stepWords(const std::optional<control::StepMetrics>& step) {
    return step ? Words::tr("%1 overshoot, settled after %2")
                      .arg(amount(step->overshoot_percent, QStringLiteral(" %")),
                           amount(step->settlingTime_s, QStringLiteral(" s")))
                : QStringLiteral("\u2013");
}

} // namespace

std::vector<TuneNumber> tuneNumbers(const TuneResult& proposed,
                                    const std::optional<AnalysisResult>& present) {
    std::vector<TuneNumber> numbers;
    const auto row = [&](const QString& name, const QString& help,
                         const std::function<QString(const AnalysisResult&)>& text) {
        numbers.push_back({name, text(proposed.predicted), present ? text(*present) : QString(), help});
    };
    row(Words::tr("Closed loop"), Words::tr("Poles of the sampled loop with the device's delay"),
        [](const AnalysisResult& loop) {
            return loop.isStable ? Words::tr("stable") : Words::tr("UNSTABLE");
        });
    row(Words::tr("Gain margin"),
        Words::tr("Factor on the gain that makes the loop unstable; at least 2 is usual"),
        [](const AnalysisResult& loop) {
            return amount(loop.margins.gainMargin_ratio, QStringLiteral(" \u00d7"));
        });
    row(Words::tr("Phase margin"), Words::tr("At the gain crossover; at least 30\u00b0 is usual"),
        [](const AnalysisResult& loop) {
            return amount(loop.margins.phaseMargin_deg, QStringLiteral("\u00b0"));
        });
    numbers.push_back(
        {Words::tr("\u2026 of 95 % of the motors"),
         Words::tr("%1, %2").arg(amount(proposed.robust.gainMargin_ratio_p5, QStringLiteral(" \u00d7")),
                                 amount(proposed.robust.phaseMargin_deg_p5, QStringLiteral("\u00b0"))),
         {},
         Words::tr("5th percentile over motors drawn from the identified uncertainty")});
    numbers.push_back({Words::tr("Unstable motors"),
                       amount(100.0 * proposed.robust.unstable_fraction, QStringLiteral(" %")),
                       {},
                       Words::tr("Share of the motors that the data allow which this loop makes unstable")});
    row(Words::tr("Gain crossover"), Words::tr("Where the open loop has the gain 1"),
        [](const AnalysisResult& loop) {
            return amount(inHertz(loop.margins.gainCrossover_rad_s), QStringLiteral(" Hz"));
        });
    row(Words::tr("Delay margin"), Words::tr("Dead time that uses up the phase margin"),
        [](const AnalysisResult& loop) {
            return amount(1e3 * loop.margins.delayMargin_s, QStringLiteral(" ms"));
        });
    row(Words::tr("Modulus margin"),
        Words::tr("Smallest distance of the open loop from -1; at least 0.5 is usual"),
        [](const AnalysisResult& loop) { return amount(loop.margins.modulusMargin, {}); });
    row(Words::tr("Largest K_P"), Words::tr("Above it the sampled loop is unstable"),
        [](const AnalysisResult& loop) {
            return amount(loop.proportionalLimit_A_per_rad, QStringLiteral(" A/rad"));
        });
    row(Words::tr("Friction band at rest"),
        Words::tr("Friction may hold the rotor this far from its reference"), [](const AnalysisResult& loop) {
            return QStringLiteral("\u00b1") +
                   amount(radiansToDegrees(loop.frictionBand_rad), QStringLiteral("\u00b0"));
        });
    row(Words::tr("Linear step"), Words::tr("Small steps, without friction and current limit"),
        [](const AnalysisResult& loop) { return stepWords(loop.step); });
    row(Words::tr("Step of 100\u00b0"), Words::tr("With friction and current limit"),
        [](const AnalysisResult& loop) {
            return stepWords(loop.largeStep ? std::optional(loop.largeStep->metrics) : std::nullopt);
        });
    return numbers;
}

TuneNumbers::TuneNumbers(QWidget* parent) : QTableWidget(0, 3, parent) {
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setTabKeyNavigation(false);
    verticalHeader()->hide();
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    horizontalHeader()->setStretchLastSection(true);
    refreshWords();
}

void TuneNumbers::refreshWords() {
    setHorizontalHeaderLabels(
        {tr("Prediction"), tr("Proposed"), m_isUndecided ? tr("Before the apply") : tr("On the device")});
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
        const QString texts[] = {number.name, number.proposed, number.present};
        for (int column = 0; column < 3; ++column) {
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
