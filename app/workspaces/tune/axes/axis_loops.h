#pragma once

#include "app/documents/axes_frequency_file.h"
#include "app/documents/axis_loop_documents.h"
#include "app/documents/axis_model_file.h"
#include "app/procedures/frequency/measured_loop.h"
#include "app/procedures/tune/tune_axes.h"
#include "control/design/crossover_design.h"
#include "devices/device.h"

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace halbench::app {

/// Origin of the gains of one axis: a method with its targets, or a law that was edited or read.
struct AxisChoice {
    std::string method = "recommended"; ///< of control::axisDesignMethods(), or "device", "edited"
    control::DesignTargets targets;
    std::optional<LoopLaw> law; ///< with "device" and "edited"
};

/// A loop of one axis to be designed or judged; answered by a worker.
struct AxisQuestion {
    AxisModel model;
    LoopConditions conditions; ///< with its axis
    AxisChoice choice;
    std::optional<LoopLaw> present; ///< of the device, drawn beside it
};

struct AxisAnswer {
    TuneResult proposed;
    std::optional<AnalysisResult> present;
};

/// A pure function. Errors: of tuneAxes and judgeAxes.
Result<AxisAnswer> answerAxis(const AxisQuestion& question);

/// State of the tuning of several axes, without widgets: model, surroundings, choice and answer of each axis.
/// Thread: GUI.
class AxisLoops {
public:
    /// Every axis begins with the recommended method.
    void setModel(AxisModelFile model);
    bool hasModel() const { return m_model.has_value(); }
    const AxisModelFile& model() const { return *m_model; }
    /// Surroundings and gains of the device as it is now; the axes whose question is another since.
    /// Errors: of axisConditionsOf.
    Result<std::vector<std::string>> readDevice(const devices::Catalogue& catalogue,
                                                const std::map<std::string, double>& values);

    std::vector<std::string> axes() const; ///< of the model, in its order
    AxisChoice& choice(const std::string& axis) { return m_choices[axis]; }
    std::optional<LoopLaw> present(const std::string& axis) const;
    std::optional<AxisQuestion> question(const std::string& axis) const;

    void setAnswer(const std::string& axis, Result<AxisAnswer> answer);
    void forgetAnswer(const std::string& axis) { m_answers.erase(axis); }
    /// Nothing before it was asked; an error where its gains cannot be judged.
    const Result<AxisAnswer>* answer(const std::string& axis) const;

    /// The law nearest to a crossover and phase margin. Errors: of designCrossover; Refused without an
    /// answer.
    Result<control::CrossoverDesign> filtered(const std::string& axis, const control::CrossoverAim& aim,
                                              control::CrossoverPriority priority) const;
    std::optional<control::CrossoverAim> aim(const std::string& axis) const;

    /// Measured plants by axis, drawn with the gains that are proposed; they outlast the model.
    void setMeasured(std::map<std::string, MeasuredPlant> plants) { m_measured = std::move(plants); }
    /// The plants of a file for these loops. Errors: of plantsFor(); InvalidInput (of another kind of device,
    /// another rate of the loop), Refused without a model.
    Result<std::map<std::string, MeasuredPlant>> plantsOf(const AxesFrequencyFile& file) const;
    void forgetMeasured(const std::string& axis) { m_measured.erase(axis); }
    bool isMeasured(const std::string& axis) const { return m_measured.count(axis) > 0; }
    /// Nothing without a response or an answer, or when the loop runs at another rate than the measured one.
    std::optional<MeasuredLoop> measured(const std::string& axis) const;

    /// Proposes the gains of a file for the axes that it has; gives those of the model that it has not.
    /// Errors: InvalidInput (of another kind of device, none of the axes), Refused (another sampling period).
    Result<std::vector<std::string>> takeGains(const AxisGainsFile& file);

    /// The answers of these axes as one result: the worst verdict counts. Errors: of the first axis without
    /// gains; Refused while one is not answered.
    Result<TuneAxesResult> result(const std::vector<std::string>& axes) const;

private:
    Result<void> checkPeriods(const AxisGainsFile& file) const;

    std::optional<AxisModelFile> m_model;
    std::map<std::string, LoopConditions> m_conditions;
    std::map<std::string, LoopLaw> m_present;
    std::map<std::string, AxisChoice> m_choices;
    std::map<std::string, Result<AxisAnswer>> m_answers;
    std::map<std::string, MeasuredPlant> m_measured;
};

} // namespace halbench::app
