#include "app/procedures/frequency/axes_frequency.h"

#include "app/procedures/base/axis_choice.h"
#include "app/procedures/base/coil_forecast.h"
#include "app/procedures/base/offered_procedure.h"
#include "app/procedures/base/procedure_steps.h"
#include "app/procedures/base/restored_result.h"
#include "app/procedures/frequency/axes_excitation.h"
#include "app/procedures/frequency/axes_frequency_judge.h"
#include "app/procedures/frequency/axes_frequency_plan.h"
#include "app/procedures/move/leave_end.h"
#include "app/procedures/tune/position_law_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

constexpr double DefaultPeriod_s = 1e-3;

Result<void> checkBoard(const devices::Catalogue& catalogue, const std::vector<devices::AxisSpec>& axes) {
    for (const devices::AxisSpec& axis : axes) {
        if (axis.roles.command.empty() || catalogue.signalForRole(axis.roles.command).empty() ||
            catalogue.findParameter(effortTargetOf(axis)) == nullptr) {
            return failure(
                ErrorCode::DeviceRefused,
                fmt::format("the board cannot add an excitation to the command of axis {}", axis.id),
                fmt::format("it needs a parameter '{}' and a signal of the command", effortTargetOf(axis)));
        }
        if (!(axis.effortLimit > 0.0)) {
            return failure(ErrorCode::DeviceRefused,
                           fmt::format("the effort that axis {} has at its limit is not known", axis.id),
                           "add effort_limit to the axis in the profile of the device");
        }
    }
    return {};
}

double periodOf(const devices::Catalogue& catalogue) {
    const auto known = catalogue.knownConstants.find("T_s");
    return known == catalogue.knownConstants.end() ? DefaultPeriod_s : known->second;
}

std::vector<double> effortsOf(const std::vector<devices::AxisSpec>& axes, double current_ratio) {
    std::vector<double> efforts;
    for (const devices::AxisSpec& axis : axes) {
        efforts.push_back(current_ratio * axis.effortLimit);
    }
    return efforts;
}

/// The profile's efforts are those at the current of its constant I_max.
Result<double> currentRatio(devices::Device& device) {
    const devices::Catalogue& catalogue = device.catalogue();
    const auto largest = catalogue.knownConstants.find("I_max");
    const std::string limit = catalogue.parameterForRole("limit.current");
    if (largest == catalogue.knownConstants.end() || limit.empty()) {
        return 1.0;
    }
    const std::string names[] = {limit};
    const auto value = device.readParameters(names);
    return value ? Result<double>(value->front() / largest->second) : failure(value.error());
}

Result<AxesFrequencyPlan> roughPlan(const devices::Catalogue& catalogue, const AxesFrequencyConfig& config) {
    const auto axes = chosenAxes(catalogue, config.axis);
    if (!axes) {
        return failure(axes.error());
    }
    if (auto able = checkBoard(catalogue, *axes); !able) {
        return failure(able.error());
    }
    return planAxesFrequency(config, *axes, effortsOf(*axes, 1.0), periodOf(catalogue));
}

Result<void> prepareBoard(devices::Device& device) {
    const devices::Catalogue& catalogue = device.catalogue();
    std::vector<ParameterValue> values = {{parameterOf(catalogue, "window.position_enabled"), 1.0},
                                          {parameterOf(catalogue, "window.speed_enabled"), 1.0}};
    for (const devices::AxisSpec& axis : catalogue.axes) {
        values.push_back({axis.generator + ".shape", 0.0});
        values.push_back({axis.generator + ".base", 0.0});
    }
    values.push_back({"reference.start", 0.0});
    values.push_back({"hb.mode", static_cast<double>(devices::BoardMode::Position)});
    return device.writeParameters(values);
}

/// Of one coil when all axes ask for their effort at once.
double meanSquare_A2(const AxesFrequencyRun& run, const devices::Catalogue& catalogue) {
    const auto largest = catalogue.knownConstants.find("I_max");
    const double limit_A = largest == catalogue.knownConstants.end() ? 1.0 : largest->second;
    const double peak_A = limit_A * run.config.effort_ratio * static_cast<double>(run.axes.size());
    return 0.5 * peak_A * peak_A;
}

Result<AxesFrequencyResult> measure(devices::Device& device, AxesFrequencyRun run,
                                    const ProcedureObserver& observer) {
    if (auto heat = admitHeat(device, observer, meanSquare_A2(run, device.catalogue()),
                              run.plan.duration_s(run.config.periods), run.config.pauseTemperature_degC,
                              run.config.refuseTemperature_degC);
        !heat) {
        return failure(heat.error());
    }
    for (const devices::AxisSpec& axis : run.axes) {
        if (auto left = leaveEnd(device, axis, observer); !left) {
            return failure(left.error());
        }
    }
    if (auto prepared = prepareBoard(device); !prepared) { // the way from an end had references of its own
        return failure(prepared.error());
    }
    if (auto entered = enterState(observer, ProcedureState::Excite); !entered) {
        return failure(entered.error());
    }
    const devices::LinkStatistics before = device.statistics();
    if (auto driven = exciteAxes(device, observer, run); !driven) {
        return failure(driven.error());
    }
    run.rowLoss = causeOfRowLoss(before, device.statistics());
    if (auto entered = enterState(observer, ProcedureState::Fit); !entered) {
        return failure(entered.error());
    }
    auto result = estimateAxesFrequency(device.catalogue(), std::move(run));
    if (!result) {
        return result;
    }
    if (auto entered = enterState(observer, ProcedureState::Judge); !entered) {
        return failure(entered.error());
    }
    result->quality = judgeAxesFrequency(*result);
    return result;
}

Result<AxesFrequencyRun> preparedRun(devices::Device& device, const AxesFrequencyConfig& config) {
    const devices::Catalogue& catalogue = device.catalogue();
    AxesFrequencyRun run;
    run.config = config;
    run.axes = *chosenAxes(catalogue, config.axis); // checked before
    for (const devices::AxisSpec& axis : run.axes) {
        auto law = readPositionLaw(device, catalogueOfAxis(catalogue, axis));
        if (!law) {
            return failure(law.error());
        }
        law->period_s = periodOf(catalogue);
        run.laws.push_back(*std::move(law));
    }
    const auto ratio = currentRatio(device);
    auto plan = ratio ? planAxesFrequency(config, run.axes, effortsOf(run.axes, *ratio), periodOf(catalogue))
                      : failure(ratio.error());
    if (!plan) {
        return failure(plan.error());
    }
    run.plan = *std::move(plan);
    return run;
}

} // namespace

Result<void> checkAxesFrequency(const devices::Catalogue& catalogue, const AxesFrequencyConfig& config) {
    const auto plan = roughPlan(catalogue, config);
    return plan ? Result<void>() : failure(plan.error());
}

Result<double> axesFrequencyDuration_s(const devices::Catalogue& catalogue,
                                       const AxesFrequencyConfig& config) {
    const auto plan = roughPlan(catalogue, config);
    return plan ? Result<double>(plan->duration_s(config.periods)) : failure(plan.error());
}

Result<AxesFrequencyResult> runAxesFrequency(devices::Device& device, const AxesFrequencyConfig& config,
                                             const ProcedureObserver& observer) {
    if (auto offered = checkProcedureOffered(device.catalogue(), "identify"); !offered) {
        return failure(offered.error());
    }
    if (auto entered = enterState(observer, ProcedureState::Prepare); !entered) {
        return failure(entered.error());
    }
    if (auto checked = checkAxesFrequency(device.catalogue(), config); !checked) {
        return failure(checked.error());
    }
    auto run = preparedRun(device, config);
    if (!run) {
        return failure(run.error());
    }
    // An excitation that stayed on would turn the next move into a force.
    std::vector<std::string> others;
    for (const devices::AxisSpec& axis : device.catalogue().axes) {
        others.push_back(effortTargetOf(axis));
        others.push_back(axis.generator + ".shape");
    }
    auto guard = RestoreGuard::take(device, others);
    if (!guard) {
        return failure(guard.error());
    }
    auto result = restoredResult(*guard, measure(device, *std::move(run), observer));
    const auto entered = enterState(observer, result ? ProcedureState::Done : ProcedureState::Restored);
    if (result && !entered) {
        return failure(entered.error());
    }
    return result;
}

} // namespace halbench::app
