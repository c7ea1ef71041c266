#include "app/procedures/identify/axes_estimate.h"

#include "control/base/distributions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace halbench::app {
namespace {

using control::Estimate;
using control::EstimateSource;

enum Named { Damping, Gain, Breakaway };

void remark(DataQuality& quality, Verdict verdict, std::string code, std::string message, std::string hint) {
    quality.verdict = std::max(quality.verdict, verdict);
    quality.findings.push_back({std::move(code), std::move(message), std::move(hint)});
}

Estimate estimateOf(double value, double deviation, double freedom, std::string unit) {
    const double half = control::studentQuantile(0.975, freedom) * deviation;
    return {value, std::pair(value - half, value + half), EstimateSource::Identified, std::move(unit)};
}

/// What is never negative; an interval that reaches below ends at zero.
Estimate notNegative(Estimate estimate) {
    estimate.value = std::max(*estimate.value, 0.0);
    estimate.interval95 = {std::max(estimate.interval95->first, 0.0),
                           std::max(estimate.interval95->second, 0.0)};
    return estimate;
}

double deviationOf(const AxisFit& fit, Named named) {
    return std::sqrt(fit.covariance(named, named));
}

} // namespace

void AxesEstimate::add(const devices::AxisSpec& spec, const Result<AxisFit>& fit,
                       const MeasuredTiming& timing) {
    if (!fit) {
        remark(m_result.quality, Verdict::Refused, "not_determined",
               fmt::format("axis {}: {}", spec.id, fit.error().message), fit.error().hint);
        return;
    }
    IdentifiedAxis axis;
    axis.axis = spec.id;
    axis.positionUnit = spec.positionUnit;
    axis.effortUnit = spec.effortUnit;
    axis.timing = timing;
    axis.dampingRate =
        notNegative(estimateOf(fit->dampingRate_1_s, deviationOf(*fit, Damping), fit->freedom, "1/s"));
    axis.accelerationGain =
        estimateOf(fit->accelerationGain, deviationOf(*fit, Gain), fit->freedom, accelerationGainUnit(axis));
    axis.breakawayEffort = notNegative(
        estimateOf(fit->breakawayEffort, deviationOf(*fit, Breakaway), fit->freedom, spec.effortUnit));
    addCovariance(spec.id, *fit);
    addConstants(spec, *fit);
    judge(axis, *fit);
    m_result.notes["windows_" + spec.id] = fit->windows;
    m_result.notes["delay_s_" + spec.id] = fit->delay_s;
    m_result.notes["unexplained_ratio_" + spec.id] = fit->unexplained_ratio;
    m_result.model.axes.push_back(std::move(axis));
}

void AxesEstimate::addCovariance(const std::string& axis, const AxisFit& fit) {
    for (const char* name : {".damping_rate", ".acceleration_gain", ".breakaway_effort"}) {
        m_result.model.covarianceNames.push_back(axis + name);
    }
    m_fits.push_back(fit);
}

void AxesEstimate::addConstants(const devices::AxisSpec& axis, const AxisFit& fit) {
    if (axis.positionUnit != "m") {
        return; // a mass says nothing of an inertia
    }
    const double friction = fit.accelerationGain * fit.breakawayEffort;
    const double frictionDeviation = std::sqrt(
        std::max(0.0, std::pow(fit.breakawayEffort, 2) * fit.covariance(Gain, Gain) +
                          2.0 * friction * fit.covariance(Gain, Breakaway) +
                          std::pow(fit.accelerationGain, 2) * fit.covariance(Breakaway, Breakaway)));
    struct Constant {
        const char* name;
        const char* title;
        double perMass, deviation;
        std::string unit;
    };
    const std::array<Constant, 3> constants = {
        {{"damping_", "damping", fit.dampingRate_1_s, deviationOf(fit, Damping), "N*s/m"},
         {"friction_", "friction", friction, frictionDeviation, "N"},
         {"force_constant_", "force per effort", fit.accelerationGain, deviationOf(fit, Gain),
          "N/" + axis.effortUnit}}};
    for (const Constant& constant : constants) {
        Estimate estimate{std::nullopt, std::nullopt, EstimateSource::NotIdentifiable, constant.unit};
        if (m_mass_kg) {
            estimate = notNegative(estimateOf(*m_mass_kg * constant.perMass, *m_mass_kg * constant.deviation,
                                              fit.freedom, constant.unit));
        }
        m_result.constants.push_back(
            {constant.name + axis.id, fmt::format("{} of {}", constant.title, axis.title), estimate});
    }
}

void AxesEstimate::judge(const IdentifiedAxis& axis, const AxisFit& fit) {
    constexpr double Most_ratio = 0.1;
    DataQuality& quality = m_result.quality;
    const double half =
        0.5 * (axis.accelerationGain.interval95->second - axis.accelerationGain.interval95->first);
    if (!(fit.accelerationGain > 0.0 && half < Most_ratio * fit.accelerationGain)) {
        remark(quality, Verdict::Refused, "not_excited",
               fmt::format("axis {}: the acceleration per effort is {:.3g} +- {:.2g} {}", axis.axis,
                           fit.accelerationGain, half, axis.accelerationGain.unit),
               "The motion does not excite the axis enough: check that nothing holds it.");
    } else if (fit.unexplained_ratio > Most_ratio) {
        remark(quality, Verdict::Refused, "not_explained",
               fmt::format("axis {}: damping, friction and effort leave {:.3g} % of the acceleration "
                           "unexplained",
                           axis.axis, 100.0 * fit.unexplained_ratio),
               "The axis has a force that depends on the position, or another axis acts on it.");
    } else if (axis.dampingRate.interval95->first <= 0.0) {
        remark(quality, Verdict::Doubtful, "damping_not_seen",
               fmt::format("axis {}: damping is below the resolution, at most {:.3g} 1/s", axis.axis,
                           axis.dampingRate.interval95->second),
               "Design with the upper bound, or identify again with a wider window.");
    }
    const double quantile = control::studentQuantile(0.975, fit.freedom);
    if (fit.breakawayEffort + quantile * deviationOf(fit, Breakaway) < 0.0) {
        remark(quality, Verdict::Refused, "friction_below_zero",
               fmt::format("axis {}: negative friction, not possible", axis.axis),
               "The axis has a force that the model lacks, or position and effort are shifted in time.");
    }
    if (fit.dampingRate_1_s + quantile * deviationOf(fit, Damping) < 0.0) {
        remark(quality, Verdict::Refused, "damping_below_zero",
               fmt::format("axis {}: negative damping, not possible", axis.axis),
               "The axis has a force that the model lacks, or position and effort are shifted in time.");
    }
    constexpr double Certain = 0.9995; // one healthy axis in a thousand is called doubtful
    if (std::fabs(fit.drag_t) > control::studentQuantile(Certain, fit.freedom)) {
        remark(
            quality, Verdict::Doubtful, "damping_not_constant",
            fmt::format("axis {}: damping changes with the speed, the intervals do not include it",
                        axis.axis),
            "Use the values near the speeds of the motion only; look for drag, or friction that grows with "
            "the speed.");
    }
    if (axis.breakawayEffort.interval95->first <= 0.0) {
        remark(quality, Verdict::Good, "friction_bound",
               fmt::format("axis {}: friction is below the resolution, at most {:.2g} {}", axis.axis,
                           axis.breakawayEffort.interval95->second, axis.effortUnit),
               "Nothing to do where the axis has none.");
    }
    if (fit.leftOut > 0) {
        remark(quality, Verdict::Doubtful, "rows_lost",
               fmt::format("axis {}: {} of {} windows of the motion miss rows", axis.axis, fit.leftOut,
                           fit.leftOut + fit.windows),
               "measure again");
    }
}

AxesIdentifyResult AxesEstimate::result() && {
    const std::size_t size = m_result.model.covarianceNames.size();
    m_result.model.covariance.assign(size, std::vector<double>(size, 0.0));
    for (std::size_t axis = 0; axis < m_fits.size(); ++axis) {
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                m_result.model.covariance[3 * axis + i][3 * axis + k] =
                    m_fits[axis].covariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k));
            }
        }
    }
    if (!m_mass_kg && !m_result.constants.empty()) {
        remark(m_result.quality, Verdict::Good, "mass_not_given",
               "only ratios follow from the motion: damping, friction and force have no absolute value",
               "Weigh a slide and give its mass: --given m=0.2, in an experiment given = { m = 0.2 }.");
    }
    return std::move(m_result);
}

} // namespace halbench::app
