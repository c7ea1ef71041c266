#include "app/procedures/tune/loop_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace halbench::app {
namespace {

struct Quantity {
    const char* name;   ///< in a model of axes
    const char* symbol; ///< in an estimate
};
constexpr std::array Quantities = {Quantity{"damping_rate", "c_over_J"},
                                   Quantity{"acceleration_gain", "phi_over_J"},
                                   Quantity{"breakaway_effort", "Kf_over_phi"}};

void addStability(AnalysisResult& result) {
    if (!result.isStable) {
        const auto& stable = result.stableGains;
        const std::string hint =
            !stable ? std::string("no common factor on these gains gives stability: change their ratio")
            : stable->to_ratio <= 1.0
                ? fmt::format("stable below {:.3g} times these gains", stable->to_ratio)
                : fmt::format("stable above {:.3g} times these gains", stable->from_ratio);
        result.warnings.push_back(
            {"unstable", fmt::format("the sampled loop is unstable: pole radius {:.4f}", result.poleRadius),
             hint + ", or use method recommended"});
        return;
    }
    constexpr double LeastPhaseMargin_deg = 20.0;
    constexpr double LeastGainMargin_ratio = 1.5;
    if (result.margins.phaseMargin_deg < LeastPhaseMargin_deg ||
        std::abs(std::log(result.margins.gainMargin_ratio)) < std::log(LeastGainMargin_ratio)) {
        result.warnings.push_back(
            {"small_margin",
             fmt::format("small margins: phase {:.3g} deg, gain factor {:.3g}",
                         result.margins.phaseMargin_deg, result.margins.gainMargin_ratio),
             "usual minimum: 30 deg and factor 2"});
    }
}

void addLargeStep(AnalysisResult& result, const LoopAxis& axis, double effortLimit) {
    if (!result.isStable || !result.largeStep) {
        return;
    }
    constexpr double NotableOvershoot_percent = 15.0;
    const std::string height = positionText(axis, result.largeStep->amplitude_rad);
    const auto overshoot_percent = result.largeStep->overshoot_percent();
    if (!overshoot_percent) {
        result.warnings.push_back(
            {"large_step_not_arrived",
             fmt::format(
                 "with friction and the effort limit of {:.3g} {} a step of {} is not settled after {:.3g} s",
                 effortLimit, axis.effortUnit, height, result.largeStep->duration_s()),
             "use a faster loop, or one with more integral action"});
    } else if (*overshoot_percent > NotableOvershoot_percent) {
        result.warnings.push_back({"large_steps_overshoot",
                                   fmt::format("with friction and the effort limit of {:.3g} {} a step of {} "
                                               "overshoots by {:.3g} %",
                                               effortLimit, axis.effortUnit, height, *overshoot_percent),
                                   "reduce the set-point weight, or use a slower loop"});
    }
}

} // namespace

LoopAxis loopAxisOf(const devices::AxisSpec& axis) {
    LoopAxis loop{axis.id, axis.positionUnit, axis.effortUnit, axis.designFrequency_rad_s, axis.testStep};
    if (loop.testStep <= 0.0) {
        loop.testStep = LoopAxis::usualStep(axis.positionUnit);
    }
    return loop;
}

double LoopAxis::usualStep(const std::string& positionUnit) {
    return positionUnit == "m" ? 1e-3 : 0.5;
}

MotorEstimate estimateOfAxis(const AxisModel& model, const IdentifiedAxis& axis) {
    MotorEstimate estimate;
    estimate.timing = axis.timing;
    estimate.doubts = model.doubts;
    estimate.values = {{"c_over_J", axis.dampingRate.value.value_or(0.0)},
                       {"phi_over_J", axis.accelerationGain.value.value_or(0.0)},
                       {"Kf_over_phi", axis.breakawayEffort.value.value_or(0.0)}};
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < model.covarianceNames.size(); ++i) {
        for (const Quantity& quantity : Quantities) {
            if (model.covarianceNames[i] == axis.axis + "." + quantity.name) {
                rows.push_back(i);
                estimate.covarianceNames.emplace_back(quantity.symbol);
            }
        }
    }
    for (const std::size_t row : rows) {
        std::vector<double> values;
        for (const std::size_t column : rows) {
            values.push_back(model.covariance[row][column]);
        }
        estimate.covariance.push_back(std::move(values));
    }
    return estimate;
}

std::string positionText(const LoopAxis& axis, double position) {
    struct Prefix {
        double factor;
        const char* name;
    };
    constexpr std::array Prefixes = {Prefix{1.0, ""}, Prefix{1e3, "m"}, Prefix{1e6, "µ"}};
    const auto fits = std::find_if(Prefixes.begin(), Prefixes.end(), [position](const Prefix& prefix) {
        return std::fabs(position) * prefix.factor >= 1.0;
    });
    const Prefix& prefix = position == 0.0          ? Prefixes.front()
                           : fits == Prefixes.end() ? Prefixes.back()
                                                    : *fits;
    return fmt::format("{:.4g} {}{}", position * prefix.factor, prefix.name, axis.positionUnit);
}

void addAxisWarnings(AnalysisResult& result, const LoopAxis& axis, double effortLimit,
                     std::optional<double> later) {
    addStability(result);
    if (result.isStable && later && *later >= 1.0) {
        result.warnings.push_back(
            {"delay_sensitive",
             fmt::format("one more sample of delay makes this loop unstable: delay margin {:.3g} ms",
                         1e3 * result.margins.delayMargin_s),
             "check the delay (delay.samples), or use a slower loop"});
    }
    if (result.frictionBand_rad > 0.05 * axis.testStep) { // of what a step is to prove
        result.warnings.push_back(
            {"friction_band",
             fmt::format("friction holds the axis within {} of the reference",
                         positionText(axis, result.frictionBand_rad)),
             "only the integral action removes the standstill error, slowly; a larger K_P narrows the band"});
    }
    addLargeStep(result, axis, effortLimit);
}

void addAxisRobustness(std::vector<Finding>& warnings, const control::Robustness& robust, bool isStable,
                       bool hasCovariance) {
    if (!hasCovariance) {
        warnings.push_back({"model_without_covariance",
                            "the model has no covariance: robustness assumes an exactly known axis",
                            "identify the axis to get its uncertainty"});
    }
    if (isStable && robust.unstable_fraction > 0.0) {
        warnings.push_back(
            {"not_robust",
             fmt::format("{:.3g} % of the axes within the model's uncertainty are unstable with this loop",
                         100.0 * robust.unstable_fraction),
             "identify more precisely, or choose a slower loop"});
    }
}

} // namespace halbench::app
