#include "app/experiments/run_plan.h"

#include "app/actuators/htm/known_motor.h"
#include "app/documents/presets.h"
#include "app/experiments/step_configs.h"
#include "app/procedures/base/axis_choice.h"
#include "app/procedures/base/coil_forecast.h"
#include "app/procedures/frequency/axes_frequency.h"
#include "app/procedures/frequency/frequency_board.h"
#include "app/procedures/relay/relay_plan.h"
#include "app/procedures/tune/position_law_parameters.h"

#include <fmt/format.h>

#include <algorithm>

namespace halbench::app {

namespace {

/// What the plan knows at one step: the law that will run then and how warm the coils will be.
class Planner {
public:
    Planner(devices::Device& device, const control::SampledPositionLaw& law, const CoilTemperatures& start)
        : m_device(device), m_motor(knownMotor(device.info()).value_or(KnownMotor{})), m_law(law),
          m_coils(start) {}

    Result<StepPlan> plan(const ExperimentStep& step) {
        StepPlan plan{step.kind, step.name, 0.0, 0.0, m_coils.highest_degC};
        Result<void> planned;
        if (step.kind == "identify") {
            planned = planIdentify(step, plan);
        } else if (step.kind == "frequency") {
            planned = planResponse(step, plan);
        } else if (step.kind == "relay") {
            planned = planSwing(step, plan);
        } else if (step.kind == "calibrate") {
            planned = planCalibrate(step, plan);
        } else if (step.kind == "move") {
            planned = planMove(step, plan);
        } else if (step.kind == "apply") {
            planned = planApply(step, plan);
        } else if (step.kind == "set") {
            planSet(step);
        } else {
            plan.duration_s = step.number("duration_s").value_or(0.0) + longestWait_s(step);
        }
        if (!planned) {
            return failure(planned.error());
        }
        return plan;
    }

private:
    /// The plan is of a trigger that comes at the last moment.
    static double longestWait_s(const ExperimentStep& step) {
        const bool isTriggered = step.kind == "record" && step.text("trigger");
        return isTriggered ? recordConfigOf(step).trigger->patience_s : 0.0;
    }

    void heat(StepPlan& plan, double meanSquare_A2) {
        const double reached_degC =
            forecastCoil_degC(coilModel(m_device.catalogue()), m_coils, meanSquare_A2, plan.duration_s);
        plan.highestTemperature_degC = std::max(plan.highestTemperature_degC, reached_degC);
        m_coils.highest_degC = m_coils.lowest_degC = reached_degC;
    }

    Result<void> planIdentify(const ExperimentStep& step, StepPlan& plan) {
        const Actuator& actuator = actuatorOf(m_device.info().model);
        const Result<IdentifyConfig> config = identifyConfigOf(step, actuator);
        if (!config) {
            return failure(config.error());
        }
        const IdentifyPrediction prediction = actuator.identify.predict(*config, m_coils.highest_degC);
        plan.duration_s = prediction.duration_s;
        plan.peakCurrent_A = prediction.peakCurrent_A;
        plan.highestTemperature_degC = prediction.highestTemperature_degC;
        m_coils.highest_degC = m_coils.lowest_degC = prediction.highestTemperature_degC;
        return {};
    }

    Result<void> planResponse(const ExperimentStep& step, StepPlan& plan) {
        if (m_device.catalogue().axes.size() > 1) {
            const auto duration_s =
                axesFrequencyDuration_s(m_device.catalogue(), axesFrequencyConfigOf(step));
            plan.duration_s = duration_s.value_or(0.0);
            return duration_s ? Result<void>() : failure(duration_s.error());
        }
        const auto response =
            planFrequency(frequencyConfigOf(step), frequencyMargins(m_device.catalogue(), m_law));
        if (!response) {
            return failure(response.error());
        }
        plan.duration_s = response->duration_s();
        plan.peakCurrent_A = response->peakCurrent_A;
        heat(plan, response->meanSquare_A2);
        return {};
    }

    /// As for the published motor: the model of an earlier step is not there yet.
    Result<void> planSwing(const ExperimentStep& step, StepPlan& plan) {
        const RelayBoard board{m_law.period_s, m_law.delaySamples, m_law.limit_A};
        const auto relay = planRelay(relayConfigOf(step), board);
        if (!relay) {
            return failure(relay.error());
        }
        plan.duration_s = relay->duration_s();
        plan.peakCurrent_A = relay->limit_A;
        heat(plan, relay->meanSquare_A2);
        return {};
    }

    Result<void> planCalibrate(const ExperimentStep& step, StepPlan& plan) {
        const Result<CalibrateConfig> config = calibrateConfigOf(step);
        if (!config) {
            return failure(config.error());
        }
        const CalibrateEntry& calibrate = actuatorOf(m_device.info().model).calibrate;
        const CalibratePrediction prediction = calibrate.predict(*config, m_coils.highest_degC);
        plan.duration_s = prediction.duration_s;
        plan.peakCurrent_A = prediction.peakCurrent_A;
        heat(plan, prediction.meanSquare_A2);
        return {};
    }

    Result<void> planMove(const ExperimentStep& step, StepPlan& plan) {
        const Result<MoveConfig> config = moveConfigOf(step);
        if (!config) {
            return failure(config.error());
        }
        const double runs = step.number("repeat").value_or(1.0);
        const Result<void> isMovable = checkAxisOf(m_device.catalogue(), step);
        if (!isMovable) {
            return isMovable;
        }
        const Result<devices::AxisSpec> axis = chosenAxis(m_device.catalogue(), config->axis);
        if (axis && axis->effortUnit == "A") {
            addMove(*config, plan, runs);
        } else { // no model of the axis: as much as the board lets flow
            plan.duration_s = runs * moveOutlook(*config, m_device.catalogue()).armed_s;
            plan.peakCurrent_A = m_law.limit_A;
        }
        return {};
    }

    void addMove(const MoveConfig& config, StepPlan& plan, double runs = 1.0) {
        const MovePrediction prediction =
            predictMove(config, m_law, m_motor.rotor, m_motor.torqueConstant_Nm_per_A);
        plan.duration_s = runs * prediction.duration_s;
        plan.peakCurrent_A = prediction.peakCurrent_A;
        heat(plan, prediction.meanSquare_A2);
    }

    Result<void> planApply(const ExperimentStep& step, StepPlan& plan) {
        const std::vector<devices::AxisSpec>& axes = m_device.catalogue().axes;
        if (axes.size() > 1) { // a step of each, with as much as the board lets flow
            for (const devices::AxisSpec& axis : axes) {
                const double most = axis.turnsForever ? 1.0 : 2.0; // as long to leave the end of its travel
                plan.duration_s += most * (axis.settle_s + ApplyVerification().duration_s);
            }
            plan.peakCurrent_A = m_law.limit_A;
            return {};
        }
        const Result<Preset> preset = findPreset("htm", step.text("preset").value_or("recommended"));
        if (!preset) {
            return failure(preset.error());
        }
        takeValues(preset->values);
        if (const std::optional<double> height_deg = step.number("verify_step_deg")) {
            MoveConfig config;
            config.reference.amplitude = *height_deg * 3.14159265358979323846 / 180.0;
            addMove(config, plan);
        }
        return {};
    }

    void planSet(const ExperimentStep& step) { takeValues(valuesOf(step)); }

    void takeValues(const std::vector<ParameterValue>& values) {
        const std::pair<const char*, double*> targets[] = {
            {"gain.kp", &m_law.kp_A_per_rad},
            {"gain.ki", &m_law.ki_A_per_rad_s},
            {"gain.kd", &m_law.kd_As_per_rad},
            {"feedforward.inertia", &m_law.inertia_As2_per_rad},
            {"feedforward.viscous", &m_law.viscous_As_per_rad},
            {"feedforward.coulomb", &m_law.coulomb_A},
            {"stiction.current", &m_law.stiction_A},
            {"limit.current", &m_law.limit_A}};
        for (const ParameterValue& value : values) {
            for (const auto& [role, target] : targets) {
                if (value.name == m_device.catalogue().parameterForRole(role)) {
                    *target = value.value;
                }
            }
        }
    }

    devices::Device& m_device;
    KnownMotor m_motor;
    control::SampledPositionLaw m_law;
    CoilTemperatures m_coils;
};

} // namespace

Result<RunPlan> planRun(const Experiment& experiment, devices::Device& device) {
    if (const Result<void> waited = device.clock().waitFor(0.02); !waited) { // the first samples
        return failure(waited.error());
    }
    const Result<CoilTemperatures> coils = readCoilTemperatures(device);
    if (!coils) {
        return failure(coils.error());
    }
    const Result<control::SampledPositionLaw> law = readPositionLaw(device);
    if (!law) {
        return failure(law.error());
    }
    Planner planner(device, *law, *coils);
    RunPlan plan;
    for (const ExperimentStep& step : experiment.steps) {
        Result<StepPlan> planned = planner.plan(step);
        if (!planned) {
            return failure(planned.error());
        }
        plan.duration_s += planned->duration_s;
        plan.peakCurrent_A = std::max(plan.peakCurrent_A, planned->peakCurrent_A);
        plan.highestTemperature_degC =
            std::max(plan.highestTemperature_degC, planned->highestTemperature_degC);
        plan.steps.push_back(*std::move(planned));
    }
    return plan;
}

JsonValue planDocument(const ResultHeader& header, const RunPlan& plan) {
    JsonValue document = toJson(header);
    JsonValue steps = JsonValue::array();
    for (const StepPlan& step : plan.steps) {
        JsonValue entry = JsonValue::object();
        entry.set("name", step.name).set("kind", step.kind).set("duration_s", step.duration_s);
        entry.set("peak_current_A", step.peakCurrent_A);
        steps.push(entry.set("highest_temperature_degC", step.highestTemperature_degC));
    }
    document.set("steps", steps).set("duration_s", plan.duration_s);
    document.set("peak_current_A", plan.peakCurrent_A);
    return document.set("highest_temperature_degC", plan.highestTemperature_degC);
}

std::string planText(const RunPlan& plan) {
    std::string text =
        fmt::format("{:<20} {:<10} {:>10} {:>10} {:>12}\n", "step", "kind", "time s", "peak A", "coil degC");
    for (const StepPlan& step : plan.steps) {
        text += fmt::format("{:<20} {:<10} {:>10.1f} {:>10.2f} {:>12.1f}\n", step.name, step.kind,
                            step.duration_s, step.peakCurrent_A, step.highestTemperature_degC);
    }
    return text + fmt::format("{:<20} {:<10} {:>10.1f} {:>10.2f} {:>12.1f}\n", "total", "", plan.duration_s,
                              plan.peakCurrent_A, plan.highestTemperature_degC);
}

} // namespace halbench::app
