#include "app/procedures/identify/identify_torque_law.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halbench::app {
namespace {

using control::DepartureDirection;
using control::TorqueDeparture;
using control::TorqueLinearity;

void remark(IdentifyResult& result, Finding finding) {
    result.quality.verdict = std::max(result.quality.verdict, Verdict::Doubtful);
    result.quality.findings.push_back(std::move(finding));
}

std::string saturationText(const TorqueLinearity& linearity) {
    const double left_percent = 100.0 * (1.0 - linearity.value_ratio);
    switch (linearity.direction) {
    case DepartureDirection::Forward:
        return fmt::format("torque is not proportional to the commanded current: above {:.3g} A forward the "
                           "torque per ampere is {:.0f} % of that below",
                           linearity.knee_A, left_percent);
    case DepartureDirection::Reverse:
        return fmt::format("torque is not proportional to the commanded current: above {:.3g} A in reverse "
                           "the torque per ampere is {:.0f} % of that below",
                           linearity.knee_A, left_percent);
    case DepartureDirection::Both:
        break;
    }
    return fmt::format("torque is not proportional to the commanded current: above {:.3g} A the torque per "
                       "ampere is {:.0f} % of that below",
                       linearity.knee_A, left_percent);
}

Finding findingOf(const TorqueLinearity& linearity) {
    const char* const code = "torque_not_proportional";
    const char* const measureCurrent = "measure the real current: the amplifier may saturate, have a dead "
                                       "zone or unequal gains; identify within its linear range";
    switch (linearity.departure) {
    case TorqueDeparture::Saturation:
        return {code, saturationText(linearity), measureCurrent};
    case TorqueDeparture::Offset:
        return {code,
                fmt::format("torque is not proportional to the commanded current: {:.2g} A less than "
                            "commanded, compared with the coast-downs",
                            linearity.value_ratio),
                measureCurrent};
    case TorqueDeparture::GainByDirection:
        return {code,
                fmt::format("torque is not proportional to the commanded current: torque per ampere differs "
                            "by {:.2g} % between the directions",
                            200.0 * std::fabs(linearity.value_ratio)),
                measureCurrent};
    case TorqueDeparture::GainDrift:
        return {code,
                fmt::format("torque per ampere changed by {:.2g} % during the recording",
                            200.0 * std::fabs(linearity.value_ratio)),
                "let coils and magnets cool, check the supply, then record again"};
    case TorqueDeparture::FrictionDrift:
        return {code,
                fmt::format("friction changed by {:.2g} % during the recording",
                            200.0 * std::fabs(linearity.value_ratio)),
                "warm up the bearings, then record again"};
    case TorqueDeparture::FrictionByLoad:
        return {
            code, "friction increases with the current: driving and braking differ by more than friction",
            "the torque may load the bearings: the uncertainty of the torque constant is larger than stated"};
    case TorqueDeparture::Unnamed:
        break;
    }
    return {code,
            fmt::format("torque is not proportional to the commanded current: not a straight line (lack of "
                        "fit, p = {:.2g})",
                        linearity.probability),
            measureCurrent};
}

// Friction differs from run to run by some per cent (resources/help/htm-theory.md section 9). A scatter that
// is several times as large is a misfit, whose intervals promise too much.
void judgeScatter(IdentifyResult& result, const IdentifyFits& fits) {
    constexpr double LargestScatter_ratio = 0.15;
    constexpr double Visible_ratio = 0.02; // of the largest torque, where there is hardly any friction
    constexpr int EnoughFreedom = 3;
    if (!fits.balance || fits.balance->isScatterAssumed || fits.balance->freedom < EnoughFreedom) {
        return;
    }
    double largest_rad_s2 = 0.0;
    for (const control::SegmentBalance& balance : fits.motion->balances) {
        largest_rad_s2 = std::max(largest_rad_s2, std::fabs(balance.balance_rad_s2));
    }
    const double scatter_rad_s2 = fits.balance->scatter_rad_s2;
    const double friction_rad_s2 = fits.balance->friction_rad_s2.value_or(0.0);
    if (scatter_rad_s2 > LargestScatter_ratio * friction_rad_s2 &&
        scatter_rad_s2 > Visible_ratio * largest_rad_s2) {
        remark(result, {"friction_scatters",
                        fmt::format("torque residuals of the segments up to {:.2g} % of the largest torque: "
                                    "more than run-to-run friction scatter",
                                    100.0 * scatter_rad_s2 / largest_rad_s2),
                        "look at the residuals over current, time and angle, and measure the current that "
                        "flows"});
    }
}

} // namespace

void addDepartureError(control::MotorRatios& ratios, const IdentifyFits& fits) {
    // Below 0.1 something is there. Up to 0.3 it may be: then as much as the data allow of it, but no more
    // than a twentieth. Of a larger one they would show more.
    constexpr double Feared = 0.1, Possible = 0.3, LargestPossible_ratio = 0.05;
    if (!fits.linearity || fits.linearity->departure == TorqueDeparture::Unnamed ||
        !(fits.linearity->probability < Possible)) {
        return;
    }
    const bool isFeared = fits.linearity->probability < Feared;
    const Eigen::Vector3d& moved = isFeared ? fits.linearity->change : fits.linearity->allowed;
    const auto count = static_cast<Eigen::Index>(ratios.ratios.size());
    Eigen::VectorXd change = Eigen::VectorXd::Zero(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const control::MotorRatio& ratio = ratios.ratios[static_cast<std::size_t>(i)];
        if (ratio.numerator == control::MotorConstant::Friction) {
            change(i) = moved(1);
        } else if (ratio.numerator == control::MotorConstant::Torque) {
            change(i) = moved(2);
        }
        if (!isFeared) {
            const double largest = LargestPossible_ratio * std::fabs(ratio.value);
            change(i) = std::clamp(change(i), -largest, largest);
        }
    }
    ratios.errors.push_back({change * change.transpose(), std::numeric_limits<double>::infinity()});
}

double smallestAsymmetry(const IdentifyFits& fits, double currentError_ratio) {
    double largest_A = 0.0;
    double friction_A = 0.0;
    if (fits.balance && fits.balance->asymmetry) {
        for (const control::SegmentBalance& balance : fits.motion->balances) {
            largest_A = std::max(largest_A, std::fabs(balance.current_A));
        }
        const double torque_rad_s2_A = fits.balance->torque_rad_s2_A.value_or(0.0);
        friction_A =
            torque_rad_s2_A > 0.0 ? fits.balance->friction_rad_s2.value_or(0.0) / torque_rad_s2_A : largest_A;
    } else if (fits.sweep) {
        for (const SweepPoint& point : fits.points) {
            largest_A = std::max(largest_A, std::fabs(point.current_A));
        }
        friction_A = fits.sweep->friction_A;
    }
    return friction_A > 0.0 ? currentError_ratio * largest_A / friction_A : 1.0;
}

void judgeTorqueLaw(IdentifyResult& result, const IdentifyFits& fits) {
    if (fits.linearity) {
        result.notes["torque_linearity_p"] = fits.linearity->probability;
        if (fits.linearity->isNotable) {
            remark(result, findingOf(*fits.linearity));
        }
    }
    judgeScatter(result, fits);
}

} // namespace halbench::app
