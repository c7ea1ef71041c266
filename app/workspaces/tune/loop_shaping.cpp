#include "app/workspaces/tune/loop_shaping.h"

#include "app/workbench/shared_results.h"
#include "app/workspaces/tune/gain_settings.h"
#include "app/workspaces/tune/loop/loop_sliders.h"
#include "app/workspaces/tune/loop/loop_view.h"
#include "app/workspaces/tune/tune_session.h"
#include "widgets/language/phrasebook.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::app {

LoopShaping::LoopShaping(Workbench& bench, TuneSession& session, GainSettings& settings, LoopView& view,
                         QObject* parent)
    : QObject(parent), m_bench(bench), m_session(session), m_settings(settings),
      m_sliders(settings.sliders()) {
    connectControls(m_sliders);
    connectControls(view);
    connect(&view, &LoopView::gainMoved, this, [this](double factor) { move(Kind::Gain, factor); });
    connect(&session, &TuneSession::sketchFailed, this, &LoopShaping::drop);
    connect(&settings, &GainSettings::changed, this, &LoopShaping::drop);
}

template <typename Controls>
void LoopShaping::connectControls(const Controls& controls) {
    connect(&controls, &Controls::taken, this, [this] { start(true); });
    connect(&controls, &Controls::released, this, &LoopShaping::release);
    connect(&controls, &Controls::crossoverMoved, this,
            [this](double crossover_rad_s) { move(Kind::Crossover, crossover_rad_s); });
    connect(&controls, &Controls::phaseMarginMoved, this,
            [this](double phaseMargin_deg) { move(Kind::Margin, phaseMargin_deg); });
}

void LoopShaping::drop() {
    m_drag.reset();
    m_session.setMoving(false);
}

/// From the gains that stand in their fields, also when their picture is still on its way.
bool LoopShaping::start(bool isHeld) {
    drop();
    const auto& identification = m_bench.identification();
    const auto& sketch = m_session.sketch();
    const auto plant = sketch && identification ? plantFromEstimate(motorEstimate(*identification))
                                                : Result<control::PositionPlant>(failure({}));
    if (!plant) {
        return false;
    }
    m_sliders.sayProblem({});
    m_drag.emplace();
    const LoopLaw drawn = sketch->loopLaw();
    m_drag->law = m_settings.isEdited() ? m_settings.editedLaw().value_or(drawn) : drawn;
    m_drag->aim = control::crossoverAimOf(*plant, m_session.conditions().timing, m_drag->law.law.gains,
                                          m_drag->law.filtered.value_or(control::FilteredLaw{}));
    m_drag->isHeld = isHeld;
    m_session.setMoving(isHeld);
    return true;
}

void LoopShaping::move(Kind kind, double value) {
    const bool isStep = !m_drag || !m_drag->isHeld; // a key, with nothing held
    if (isStep && !(m_drag && m_drag->isWaiting) && !start(false)) {
        return;
    }
    if (!aim(kind, value)) {
        return;
    }
    if (m_session.isSketching()) {
        m_drag->isWaiting = true; // each move is seen before the next one is asked for
    } else {
        take();
    }
}

bool LoopShaping::aim(Kind kind, double value) {
    m_drag->kind = kind;
    if (kind == Kind::Gain) {
        m_drag->factor = value;
        m_drag->what = tr("Move a pole");
        return true;
    }
    if (!m_drag->aim) {
        return false;
    }
    if (kind == Kind::Crossover) {
        m_drag->aim->crossover_rad_s = value;
        m_drag->what = tr("Move the crossover");
    } else {
        m_drag->aim->phaseMargin_deg = value;
        m_drag->what = tr("Move the phase margin");
    }
    return true;
}

/// As near to what is wanted as this motor allows; weights and filters stay.
Result<LoopLaw> LoopShaping::movedLaw() {
    const auto plant = plantFromEstimate(motorEstimate(*m_bench.identification()));
    if (!plant) {
        return failure(plant.error());
    }
    const auto gains = m_drag->kind == Kind::Gain ? scaledGains(*plant) : crossingGains(*plant);
    if (!gains) {
        return failure(gains.error());
    }
    LoopLaw law = m_drag->law;
    law.law.gains = *gains;
    if (law.filtered) {
        const auto filter_s = law.filtered->gains.filter_s;
        law.filtered->gains = *gains;
        law.filtered->gains.filter_s = filter_s;
    }
    return law;
}

Result<control::PidGains> LoopShaping::scaledGains(const control::PositionPlant& plant) {
    constexpr double Least_ratio = 1e-3; // a loop of zero has no way back
    control::PidGains gains = m_drag->law.law.gains;
    const double wanted = std::max(Least_ratio, m_drag->factor);
    const double factor = control::stableFactor(plant, m_session.conditions().timing, gains, wanted,
                                                m_drag->law.filtered.value_or(control::FilteredLaw{}));
    gains.proportional *= factor;
    gains.integral *= factor;
    gains.derivative *= factor;
    m_sliders.sayProblem(factor == wanted ? QString() : tr("More gain would be unstable: limited."));
    return gains;
}

Result<control::PidGains> LoopShaping::crossingGains(const control::PositionPlant& plant) {
    const auto priority = m_drag->kind == Kind::Margin ? control::CrossoverPriority::Crossover
                                                       : control::CrossoverPriority::Margin;
    const auto design = control::designCrossover(plant, m_session.conditions().timing, *m_drag->aim, priority,
                                                 m_drag->law.filtered.value_or(control::FilteredLaw{}));
    if (!design) {
        return failure(design.error());
    }
    m_sliders.sayLimit(*m_drag->aim, *design);
    return design->gains;
}

void LoopShaping::take() {
    m_drag->isWaiting = false;
    const auto law = movedLaw();
    const control::PidGains gains = law.value_or(LoopLaw{}).law.gains;
    const bool isNumber = law && std::isfinite(gains.proportional) && std::isfinite(gains.integral) &&
                          std::isfinite(gains.derivative);
    if (!isNumber) {
        m_sliders.sayProblem(law ? QString() : widgets::inWords(law.error().message));
        return;
    }
    m_settings.edit(*law);
    if (!m_drag->isHeld) {
        // Steps of one slider or handle, one after the other, are one.
        m_settings.record(m_drag->what, m_drag->what);
    }
    Q_EMIT moved();
}

void LoopShaping::takeWaiting() {
    if (m_drag && m_drag->isWaiting) {
        take();
    }
}

/// What was wanted last is taken, seen or not; all moves together are one step back.
void LoopShaping::release() {
    if (!m_drag || !m_drag->isHeld) {
        return;
    }
    takeWaiting();
    if (!m_drag->what.isEmpty()) {
        m_settings.record(m_drag->what);
    }
    drop();
    Q_EMIT released();
}

/// What was said of a move stands until something else is done.
void LoopShaping::showLoop() {
    const auto& sketch = m_session.sketch();
    std::optional<control::CrossoverAim> aim;
    if (sketch && m_bench.identification()) {
        const control::StabilityMargins& margins = sketch->predicted.margins;
        if (margins.gainCrossover_rad_s) {
            aim = {*margins.gainCrossover_rad_s, margins.phaseMargin_deg, 0.0};
        }
    }
    m_sliders.setLoop(aim, m_session.conditions().timing);
}

} // namespace halbench::app
