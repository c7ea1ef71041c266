#include "app/workspaces/tune/tune_session.h"

#include "app/procedures/tune/position_law_parameters.h"
#include "app/tuning/loop_conditions.h"
#include "app/workbench/shared_results.h"

#include <utility>

namespace halbench::app {
namespace {

/// Whose presets and surroundings count while no device is connected.
constexpr const char* DefaultModel = "htm";

constexpr int Rest_ms = 100;

} // namespace

TuneSession::TuneSession(Workbench& bench, QObject* parent) : QObject(parent), m_bench(bench) {
    m_rest.setSingleShot(true);
    m_rest.setInterval(Rest_ms);
    connect(&m_rest, &QTimer::timeout, this, &TuneSession::judge);
}

std::string TuneSession::model() const {
    const DeviceSession& session = m_bench.session();
    return session.state() == SessionState::Connected ? session.info().model : DefaultModel;
}

bool TuneSession::readConditions(const std::map<std::string, double>& values) {
    const DeviceSession& session = m_bench.session();
    LoopConditions conditions = m_conditions;
    if (session.state() == SessionState::Connected) {
        conditions = loopConditionsOf(session.catalogue(), m_bench.deviceValues());
    } else if (const auto known = loopConditionsOf(DefaultModel)) {
        conditions = *known;
        const auto& identification = m_bench.identification();
        conditions.timing =
            timingOr(identification ? identification->timing : MeasuredTiming{}, conditions.timing);
    }
    const auto law = loopLawFromParameters(values, conditions.timing.period_s);
    const auto present = law ? std::optional(*law) : std::nullopt;
    const bool isElsewhere = conditions != m_conditions;
    if (!isElsewhere && present == m_present) {
        return false;
    }
    m_conditions = conditions;
    m_present = present;
    if (isElsewhere) {
        Q_EMIT conditionsChanged();
    }
    return true;
}

Result<TuneQuestion> TuneSession::question(const Result<GainSource>& source,
                                           std::shared_ptr<const WhatIfBasis> record) const {
    TuneQuestion question;
    question.motor = motorEstimate(*m_bench.identification());
    question.config.conditions = m_conditions;
    if (m_bench.session().state() == SessionState::Connected && !m_bench.deviceValues().empty()) {
        if (const auto fits = checkTimingOfModel(question.motor.timing, m_conditions.timing); !fits) {
            return failure(fits.error());
        }
    }
    if (!source) {
        return failure(source.error());
    }
    takeStrayInterval(question.config.conditions, m_bench.strayInterval95_T_per_A());
    question.config.conditions.doubts = m_bench.calibrationDoubts();
    question.config.method = source->method;
    question.config.targets = source->targets;
    question.law = source->law;
    question.present = m_present;
    question.record = std::move(record);
    question.known = m_steady;
    return question;
}

void TuneSession::ask(const Result<GainSource>& source, std::shared_ptr<const WhatIfBasis> record) {
    if (!m_bench.identification()) {
        return;
    }
    m_problem.reset();
    m_proposed.reset(); // nothing is applied that its prediction has not caught up with
    m_asked.reset();
    m_rest.stop();
    m_sketching.cancel();
    m_judging.cancel(); // answers to older numbers must not come after a number that is none
    m_spreading.cancel();
    auto asked = question(source, std::move(record));
    if (!asked) {
        refuse(asked.error());
        return;
    }
    m_asked = *std::move(asked);
    m_sketching.run([question = *m_asked] { return sketchTuning(question); },
                    [this](Result<TuneSketch> sketch) { takeSketch(std::move(sketch)); });
}

void TuneSession::forget() {
    m_sketch.reset();
    m_asked.reset();
    m_rest.stop();
    m_sketching.cancel();
    m_judging.cancel();
    m_spreading.cancel();
}

void TuneSession::forgetWhatIf() {
    if (m_sketch) {
        m_sketch->whatIf.reset();
    }
}

void TuneSession::completeMove() {
    if (m_rest.isActive()) {
        judge();
    }
    spreadLargeStep();
}

void TuneSession::takeSketch(Result<TuneSketch> sketch) {
    if (!sketch) {
        Q_EMIT sketchFailed();
        refuse(sketch.error());
        judge();
        return;
    }
    m_sketch = *std::move(sketch);
    m_steady = m_sketch->steady;
    Q_EMIT sketched();
    if (m_sketching.isBusy()) {
        return; // for other gains already
    }
    if (m_isMoving) {
        m_rest.start(); // the next move would come before the judgement, and wait for its thread
    } else {
        judge();
    }
}

void TuneSession::judge() {
    m_rest.stop();
    if (!m_asked) {
        return;
    }
    m_judging.run(
        [asked = *m_asked] {
            auto answer = answerTuning(asked);
            const auto loop = answer ? judgeLoop(asked.motor, answer->law, asked.config.conditions)
                                     : failure(answer.error());
            return Answer(std::move(answer), loop ? loop->bandwidth_rad_s : std::nullopt);
        },
        [this](const Answer& answer) { takeAnswer(answer); });
}

void TuneSession::takeAnswer(const Answer& answer) {
    const auto& [proposed, bandwidth_rad_s] = answer;
    if (!proposed) {
        refuse(proposed.error());
        return;
    }
    if (!m_bench.identification()) {
        return; // the project was closed meanwhile
    }
    m_proposed = *proposed;
    m_problem.reset();
    m_bandwidth_rad_s = bandwidth_rad_s;
    Q_EMIT judged();
    spreadLargeStep();
}

/// The last of what is drawn, once the gains rest: a thousand motors with friction and limit.
void TuneSession::spreadLargeStep() {
    if (!m_proposed || m_isMoving || !m_sketch || !m_sketch->uncertainty || !m_sketch->predicted.largeStep) {
        return;
    }
    const TuneConfig defaults;
    const LargeStep& step = *m_sketch->predicted.largeStep;
    m_spreading.run(
        [motor = motorEstimate(*m_bench.identification()),
         law = LoopLaw(m_proposed->law, m_proposed->filtered), conditions = m_proposed->conditions,
         span = StepSpan{step.amplitude_rad, step.duration_s()},
         draws = UncertaintyDraws{defaults.draws, defaults.seed}] {
            return largeStepBand(motor, law, conditions, span, draws);
        },
        [this](const Result<control::StepBand>& band) {
            if (band && m_sketch && m_sketch->uncertainty) {
                m_sketch->uncertainty->largeStep = *band;
                Q_EMIT refreshed();
            }
        });
}

void TuneSession::refuse(const Error& error) {
    m_proposed.reset();
    m_problem = error;
    Q_EMIT refused();
}

std::optional<LoopLaw> TuneSession::drawnLaw() const {
    return m_sketch && !m_problem ? std::optional(m_sketch->loopLaw()) : std::nullopt;
}

bool TuneSession::isDrawn(const LoopLaw& law) const {
    const auto drawn = drawnLaw();
    return drawn && isSameLaw(*drawn, law, m_conditions.timing.period_s);
}

const std::optional<AnalysisResult>& TuneSession::present() const {
    static const std::optional<AnalysisResult> none;
    return m_steady.present ? m_steady.present->predicted : none;
}

std::optional<Error> TuneSession::obstacle(bool isGradual) const {
    if (!m_sketch || m_bench.session().state() != SessionState::Connected) {
        return std::nullopt;
    }
    if (m_sketch->filtered && isGradual) {
        return Error{ErrorCode::Refused,
                     "gains with set-point weights or filters cannot be applied gradually",
                     "switch gradual applying off"};
    }
    const auto offered =
        checkOffered(asFiltered(m_sketch->loopLaw()), boardLawSpec(m_bench.session().catalogue()));
    return offered ? std::nullopt : std::optional(offered.error());
}

} // namespace halbench::app
