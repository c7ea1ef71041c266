#pragma once

#include "app/workbench/latest_task.h"
#include "app/workbench/workbench.h"
#include "app/workspaces/tune/tune_question.h"

#include <QObject>
#include <QTimer>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace halbench::app {

/// Origin of the proposed gains: a method with its targets, or a law under the name of its origin.
struct GainSource {
    std::string method;
    control::DesignTargets targets = {};
    std::optional<LoopLaw> law = {};
};

/// Question, sketch and judgement of the proposed gains, without widgets. Workers answer; only the newest
/// question counts, and its judgement follows its sketch: gains that can be applied must not come before
/// their curves are seen. Thread: GUI.
class TuneSession : public QObject {
    Q_OBJECT
public:
    explicit TuneSession(Workbench& bench, QObject* parent = nullptr);

    /// Actuator model of presets and conditions: that of the connected device, else the default one.
    std::string model() const;
    const LoopConditions& conditions() const { return m_conditions; }
    /// Takes the conditions of the device or the default actuator, and the gains in `values` as the present
    /// ones. Returns whether either is another; many values are read often.
    bool readConditions(const std::map<std::string, double>& values);

    /// Sketches and judges these gains; `record`: a measured move to replay with them. An error is the
    /// problem of the proposal. Nothing happens without an identified motor.
    void ask(const Result<GainSource>& source, std::shared_ptr<const WhatIfBasis> record);
    bool isSketching() const { return m_sketching.isBusy(); }
    /// Whether an answer about the proposed gains is still to come.
    bool isComputing() const { return m_sketching.isBusy() || m_judging.isBusy(); }
    /// The motor is another one: its gains are no longer proposed.
    void forgetProposed() { m_proposed.reset(); }
    /// There is no motor any more: drops the sketch and all questions.
    void forget();
    void forgetWhatIf();

    /// While gains are dragged the judgement waits; the next sketch would come before it.
    void setMoving(bool isMoving) { m_isMoving = isMoving; }
    bool isMoving() const { return m_isMoving; }
    /// Judges what waited for the end of a drag, and computes the band of the large step.
    void completeMove();

    const std::optional<TuneSketch>& sketch() const { return m_sketch; }
    /// The judged gains, which can be applied.
    const std::optional<TuneResult>& proposed() const { return m_proposed; }
    /// Of the closed loop of the proposed gains.
    std::optional<double> bandwidth_rad_s() const { return m_bandwidth_rad_s; }
    /// Why nothing is proposed.
    const std::optional<Error>& problem() const { return m_problem; }
    /// The law of the sketch unless there is a problem.
    std::optional<LoopLaw> drawnLaw() const;
    /// Whether the drawn law is this one on the board.
    bool isDrawn(const LoopLaw& law) const;
    /// Predictions of the gains on the device.
    const SteadyPrediction& steady() const { return m_steady; }
    const std::optional<AnalysisResult>& present() const;
    /// Why the drawn gains cannot be applied to the connected device, at once or gradually; nothing: they
    /// can.
    std::optional<Error> obstacle(bool isGradual) const;

Q_SIGNALS:
    void conditionsChanged();
    void sketchFailed(); ///< before refused()
    void sketched();     ///< other gains may be asked for at once
    void judged();
    void refused();   ///< a problem
    void refreshed(); ///< the sketch has another band

private:
    /// A proposal and its loop's bandwidth.
    using Answer = std::pair<Result<TuneResult>, std::optional<double>>;

    Result<TuneQuestion> question(const Result<GainSource>& source,
                                  std::shared_ptr<const WhatIfBasis> record) const;
    void takeSketch(Result<TuneSketch> sketch);
    void judge();
    void takeAnswer(const Answer& answer);
    void spreadLargeStep();
    void refuse(const Error& error);

    Workbench& m_bench;
    LatestTask m_sketching; ///< what can be drawn at once
    LatestTask m_judging;   ///< the rest
    LatestTask m_spreading; ///< the band of the large step, which takes longest
    QTimer m_rest;          ///< until dragged gains rest
    bool m_isMoving = false;
    LoopConditions m_conditions;
    std::optional<LoopLaw> m_present;    ///< on the device, or before an apply
    std::optional<TuneQuestion> m_asked; ///< to be judged once its sketch is seen
    std::optional<TuneSketch> m_sketch;
    SteadyPrediction m_steady; ///< of the last sketch
    std::optional<TuneResult> m_proposed;
    std::optional<double> m_bandwidth_rad_s;
    std::optional<Error> m_problem;
};

} // namespace halbench::app
