#include "app/actuators/htm/known_motor.h"
#include "app/actuators/htm/motor_geometry_analysis.h"
#include "app/documents/axis_loop_documents.h"
#include "app/documents/result_documents.h"
#include "app/experiments/step_runs.h"
#include "app/procedures/base/doubtful_source.h"
#include "app/procedures/tune/position_law_parameters.h"
#include "app/tuning/loop_conditions.h"
#include "control/base/units.h"

#include <array>

namespace halbench::app {

namespace {

/// A key in another unit than the code's, nothing when it is absent.
std::optional<double> scaled(const ExperimentStep& step, std::string_view key, double toSi) {
    const std::optional<double> value = step.number(key);
    return value ? std::optional<double>(*value * toSi) : std::nullopt;
}

Result<MotorAnalysis> torqueAnalysis(StepRun&, const ExperimentStep& step,
                                     const models::HtmParameters& motor) {
    return analyseTorque(motor,
                         {scaled(step, "speed_rpm", rpmToRadPerSecond(1.0)), step.number("torque_Nm")});
}

Result<MotorAnalysis> sensingAnalysis(StepRun&, const ExperimentStep& step,
                                      const models::HtmParameters& motor) {
    return analyseSensing(motor, step.number("temperature_degC").value_or(25.0));
}

Result<MotorAnalysis> polesAnalysis(StepRun& run, const ExperimentStep& step,
                                    const models::HtmParameters& motor) {
    const Result<control::SampledPositionLaw> law = readPositionLaw(run.device);
    if (!law) {
        return failure(law.error());
    }
    PolesQuestion question;
    question.targets.zeta = step.number("zeta");
    question.targets.omega_rad_s = step.number("omega_rad_s");
    question.gains.proportional = law->kp_A_per_rad;
    question.gains.integral = law->ki_A_per_rad_s;
    question.gains.derivative = law->kd_As_per_rad;
    question.timing = {law->period_s, law->delaySamples};
    question.rampRate_rad_s = scaled(step, "rate_deg_s", degreesToRadians(1.0));
    question.accuracy_rad = scaled(step, "accuracy_deg", degreesToRadians(1.0));
    return analysePoles(motor, question);
}

Result<MotorAnalysis> fieldAnalysis(StepRun&, const ExperimentStep& step,
                                    const models::HtmParameters& motor) {
    FieldQuestion question;
    question.ringRadius_m = scaled(step, "ring_radius_mm", 1e-3).value_or(question.ringRadius_m);
    question.remanence_T = step.number("remanence_T").value_or(question.remanence_T);
    return analyseField(motor, question);
}

Result<MotorAnalysis> coilAnalysis(StepRun&, const ExperimentStep& step, const models::HtmParameters& motor) {
    return analyseCoil(motor, scaled(step, "pitch_mm", 1e-3));
}

struct Subject {
    std::string_view what;
    Result<MotorAnalysis> (*analyse)(StepRun&, const ExperimentStep&, const models::HtmParameters&);
};

constexpr std::array Subjects = {Subject{"torque", torqueAnalysis}, Subject{"sensing", sensingAnalysis},
                                 Subject{"poles", polesAnalysis}, Subject{"field", fieldAnalysis},
                                 Subject{"coil", coilAnalysis}};

Result<StepOutcome> motorOutcome(StepRun& run, const ExperimentStep& step) {
    const Result<models::HtmParameters> motor = simulatedMotor(run.device.info());
    if (!motor) {
        return failure(motor.error());
    }
    StepOutcome outcome;
    if (*step.text("what") == "amplifier") {
        Result<AmplifierAnalysis> result = analyseAmplifier(motor->amplifier, motor->currentLimit_A);
        if (!result) {
            return failure(result.error());
        }
        outcome.body = amplifierBody(*result);
        outcome.detail = *std::move(result);
        return outcome;
    }
    for (const Subject& subject : Subjects) {
        if (*step.text("what") == subject.what) {
            Result<MotorAnalysis> result = subject.analyse(run, step, *motor);
            if (!result) {
                return failure(result.error());
            }
            outcome.quality = result->quality;
            outcome.body = motorAnalysisBody(*result);
            outcome.detail = *std::move(result);
        }
    }
    return outcome;
}

Result<StepOutcome> loopOutcome(StepRun& run, const ExperimentStep& step) {
    if (const auto* axes = run.find<TuneAxesOutcome>(*step.text("gains"))) {
        StepOutcome outcome;
        outcome.quality = axes->result.quality;
        outcome.body = axisAnalysisBody(axes->result);
        return outcome;
    }
    const IdentifyResult* model = run.find<IdentifyResult>(*step.text("model"));
    const TuneOutcome* tuned = run.find<TuneOutcome>(*step.text("gains"));
    if (model == nullptr || tuned == nullptr) {
        return failure(missingResult(model == nullptr ? *step.text("model") : *step.text("gains")));
    }
    const Result<LoopConditions> conditions = conditionsOf(run);
    if (!conditions) {
        return failure(conditions.error());
    }
    const MotorEstimate motor = motorEstimate(*model);
    if (const auto fits = checkTimingOfModel(motor.timing, conditions->timing); !fits) {
        return failure(fits.error());
    }
    Result<AnalysisResult> result = runAnalysis(motor, tuned->result.law, *conditions);
    if (!result) {
        return failure(result.error());
    }
    StepOutcome outcome;
    outcome.quality = result->quality;
    outcome.body = analysisBody(*result);
    outcome.detail = *std::move(result);
    return outcome;
}

} // namespace

Error missingResult(const std::string& step) {
    return {ErrorCode::Refused, "step \"" + step + "\" gave no result to work with", "see its findings"};
}

Result<LoopConditions> conditionsOf(StepRun& run) {
    Result<LoopConditions> conditions = loopConditionsOf(run.device);
    if (!conditions) {
        return conditions;
    }
    for (const StepOutcome& step : run.earlier) {
        if (const auto* calibration = std::get_if<CalibrateResult>(&step.detail)) {
            takeStrayInterval(*conditions, strayInterval(*calibration));
            conditions->doubts = doubtsOfCalibration(calibration->quality);
        }
    }
    return conditions;
}

Result<StepOutcome> runAnalyseStep(StepRun& run, const ExperimentStep& step) {
    return *step.text("what") == "loop" ? loopOutcome(run, step) : motorOutcome(run, step);
}

} // namespace halbench::app
