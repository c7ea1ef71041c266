// Gains by hand in the Tune panel: the crossover, the margin and the poles are moved, the gains follow.
#include "app/workspaces/tune/loop/filter_editor.h"
#include "app/workspaces/tune/loop/gain_editor.h"
#include "app/workspaces/tune/loop/loop_sliders.h"
#include "app/workspaces/tune/loop/loop_view.h"
#include "app/workspaces/tune/loop/tune_form.h"
#include "app/workspaces/tune/tune_panel.h"
#include "widgets/language/phrasebook.h"

#include <cmath>

namespace halbench::app {

void TunePanel::connectShaping() {
    const auto connectHand = [this](const auto* hand) {
        using Hand = std::remove_cv_t<std::remove_pointer_t<decltype(hand)>>;
        connect(hand, &Hand::taken, this, [this] { startShaping(true); });
        connect(hand, &Hand::released, this, &TunePanel::endShaping);
        connect(hand, &Hand::crossoverMoved, this,
                [this](double crossover_rad_s) { shape(Shaping::Kind::Crossover, crossover_rad_s); });
        connect(hand, &Hand::phaseMarginMoved, this,
                [this](double phaseMargin_deg) { shape(Shaping::Kind::Margin, phaseMargin_deg); });
    };
    connectHand(m_sliders);
    connectHand(m_loop);
    constexpr int Rest_ms = 100;
    m_rest.setSingleShot(true);
    m_rest.setInterval(Rest_ms);
    connect(&m_rest, &QTimer::timeout, this, &TunePanel::judge);
    connect(m_loop, &LoopView::gainMoved, this,
            [this](double factor) { shape(Shaping::Kind::Gain, factor); });
}

/// From the gains that stand in their fields, also when their picture is still on its way.
bool TunePanel::startShaping(bool isHeld) {
    m_shaping.reset();
    const auto& identification = m_bench.identification();
    const auto plant = m_sketch && identification ? plantFromEstimate(motorEstimate(*identification))
                                                  : Result<control::PositionPlant>(failure({}));
    if (!plant) {
        return false;
    }
    m_sliders->sayProblem({});
    m_shaping.emplace();
    const LoopLaw drawn = m_sketch->loopLaw();
    m_shaping->law = m_form->origin() == TuneForm::Origin::Edited ? editedLaw().value_or(drawn) : drawn;
    m_shaping->aim = control::crossoverAimOf(*plant, m_conditions.timing, m_shaping->law.law.gains,
                                             m_shaping->law.filtered.value_or(control::FilteredLaw{}));
    m_shaping->isHeld = isHeld;
    return true;
}

bool TunePanel::isMoving() const {
    return m_shaping && m_shaping->isHeld;
}

void TunePanel::shape(Shaping::Kind kind, double value) {
    const bool isStep = !m_shaping || !m_shaping->isHeld; // a key, with nothing in the hand
    if (isStep && !(m_shaping && m_shaping->isWaiting) && !startShaping(false)) {
        return;
    }
    Shaping& shaping = *m_shaping;
    shaping.kind = kind;
    if (kind == Shaping::Kind::Gain) {
        shaping.factor = value;
        shaping.what = tr("Move a pole");
    } else if (!shaping.aim) {
        return;
    } else if (kind == Shaping::Kind::Crossover) {
        shaping.aim->crossover_rad_s = value;
        shaping.what = tr("Move the crossover");
    } else {
        shaping.aim->phaseMargin_deg = value;
        shaping.what = tr("Move the phase margin");
    }
    if (m_sketching.isBusy()) {
        shaping.isWaiting = true; // each move is seen before the next one is asked for
    } else {
        takeShape();
    }
}

/// Gains for what is wanted, as near as this motor allows; weights and filters stay. Nothing goes to the
/// device.
Result<LoopLaw> TunePanel::filteredLaw() {
    const auto plant = plantFromEstimate(motorEstimate(*m_bench.identification()));
    if (!plant) {
        return failure(plant.error());
    }
    const control::LoopTiming& timing = m_conditions.timing;
    LoopLaw law = m_shaping->law;
    const control::FilteredLaw around = law.filtered.value_or(control::FilteredLaw{});
    control::PidGains& gains = law.law.gains;
    if (m_shaping->kind == Shaping::Kind::Gain) {
        constexpr double Least_ratio = 1e-3; // a loop of zero has no way back
        const double wanted = std::max(Least_ratio, m_shaping->factor);
        const double factor = control::stableFactor(*plant, timing, gains, wanted, around);
        gains.proportional *= factor;
        gains.integral *= factor;
        gains.derivative *= factor;
        m_sliders->sayProblem(factor == wanted ? QString() : tr("More gain would be unstable: limited."));
    } else {
        const auto priority = m_shaping->kind == Shaping::Kind::Margin ? control::CrossoverPriority::Crossover
                                                                       : control::CrossoverPriority::Margin;
        const auto design = control::designCrossover(*plant, timing, *m_shaping->aim, priority, around);
        if (!design) {
            return failure(design.error());
        }
        m_sliders->sayLimit(*m_shaping->aim, *design);
        gains = design->gains;
    }
    if (law.filtered) {
        law.filtered->gains = gains;
        law.filtered->gains.filter_s = around.gains.filter_s;
    }
    return law;
}

void TunePanel::takeShape() {
    m_shaping->isWaiting = false;
    const auto law = filteredLaw();
    const control::PidGains gains = law.value_or(LoopLaw{}).law.gains;
    const bool isNumber = law && std::isfinite(gains.proportional) && std::isfinite(gains.integral) &&
                          std::isfinite(gains.derivative);
    if (!isNumber) {
        m_sliders->sayProblem(law ? QString() : widgets::inWords(law.error().message));
        return;
    }
    useEdited(*law);
    if (!m_shaping->isHeld) {
        // Steps of one slider or handle, one after the other, are one.
        record(m_shaping->what, m_shaping->what);
    }
    ask();
}

/// What was wanted last is taken, seen or not; all moves together are one step back.
void TunePanel::endShaping() {
    if (!m_shaping || !m_shaping->isHeld) {
        return;
    }
    if (m_shaping->isWaiting) {
        takeShape();
    }
    if (!m_shaping->what.isEmpty()) {
        record(m_shaping->what);
    }
    m_shaping.reset();
    if (!m_sketching.isBusy()) {
        drawPredictions(); // the axes may find their extent again
        showShape();
    }
    if (m_rest.isActive()) {
        judge();
    }
    proposeToWhatIf(); // with its band
    if (m_shown) {     // else it follows the answer
        spreadLargeStep(*m_shown);
        replayRecord();
    }
}

void TunePanel::useEdited(const LoopLaw& law) {
    forgetRestored();
    m_form->setEdited();
    m_gains->setLaw(law.law);
    m_filters->setShaping(law.filtered);
}

/// What stands in the fields.
Result<LoopLaw> TunePanel::editedLaw() const {
    const auto law = m_gains->law();
    if (!law) {
        return failure(law.error());
    }
    auto filtered = m_filters->filtered(law->gains);
    return filtered ? Result<LoopLaw>(LoopLaw(*law, *std::move(filtered))) : failure(filtered.error());
}

/// The sliders are where the loop is. What was said of a move stands until something else is done.
void TunePanel::showShape() {
    const auto& identification = m_bench.identification();
    if (!m_sketch || !identification) {
        m_sliders->setLoop(std::nullopt, m_conditions.timing);
        return;
    }
    std::optional<control::CrossoverAim> aim;
    const control::StabilityMargins& margins = m_sketch->predicted.margins;
    if (margins.gainCrossover_rad_s) {
        aim = {*margins.gainCrossover_rad_s, margins.phaseMargin_deg, 0.0};
    }
    m_sliders->setLoop(aim, m_conditions.timing);
}

/// The last of what is drawn, when nobody moves the gains any more: a thousand motors with friction and
/// limit.
void TunePanel::spreadLargeStep(const TuneResult& proposed) {
    if (isMoving() || !m_sketch || !m_sketch->uncertainty || !m_sketch->predicted.largeStep) {
        return;
    }
    const TuneConfig defaults;
    const LargeStep& step = *m_sketch->predicted.largeStep;
    m_spreading.run(
        [motor = motorEstimate(*m_bench.identification()), law = LoopLaw(proposed.law, proposed.filtered),
         conditions = proposed.conditions, span = StepSpan{step.amplitude_rad, step.duration_s()},
         draws = UncertaintyDraws{defaults.draws, defaults.seed}] {
            return largeStepBand(motor, law, conditions, span, draws);
        },
        [this](const Result<control::StepBand>& band) {
            if (band && m_sketch && m_sketch->uncertainty) {
                m_sketch->uncertainty->largeStep = *band;
                drawPredictions();
            }
        });
}

} // namespace halbench::app
