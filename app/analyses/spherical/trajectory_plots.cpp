#include "app/analyses/spherical/trajectory_plots.h"

#include "control/base/units.h"
#include "models/spherical/orientation.h"

#include <fmt/format.h>

#include <cmath>

namespace halbench::app {

namespace {

std::string nameOf(const ComparedEstimator& estimator) {
    return std::string(models::EstimatorNames[static_cast<std::size_t>(estimator.kind)]);
}

using Drawn = std::vector<const ComparedEstimator*>;

/// One estimator alone, else that of the device's model and the published one; without those that gave
/// nothing.
Drawn drawnOf(const EstimatorComparison& comparison, models::SphericalDevice device) {
    const auto own = device == models::SphericalDevice::Additive ? models::EstimatorKind::Closed
                                                                 : models::EstimatorKind::Refined;
    Drawn drawn;
    for (const ComparedEstimator& estimator : comparison.estimators) {
        const bool isChosen = comparison.estimators.size() == 1 || estimator.kind == own ||
                              estimator.kind == models::EstimatorKind::Swarm;
        if (isChosen && estimator.estimated > 0) {
            drawn.push_back(&estimator);
        }
    }
    return drawn;
}

double angleOf_deg(const Eigen::Matrix3d& rotation, std::size_t angle) {
    const models::OrientationAngles angles = models::anglesOf(rotation);
    return radiansToDegrees(std::array{angles.alpha_rad, angles.beta_rad, angles.gamma_rad}[angle]);
}

AnalysisPlot anglesPlot(const EstimatorComparison& comparison, const Drawn& drawn, const std::string& name) {
    AnalysisPlot plot;
    plot.title = "Orientation along " + name + ", M = Rx(alpha) Ry(beta) Rz(gamma)";
    plot.x = {"sample", ""};
    constexpr std::array Names = {"alpha", "beta", "gamma"};
    for (std::size_t angle = 0; angle < Names.size(); ++angle) {
        AnalysisPanel panel{{Names[angle], "deg"}, {}};
        AnalysisCurve truth{"true", {}, {}};
        for (std::size_t i = 0; i < comparison.truth.size(); ++i) {
            truth.x.push_back(static_cast<double>(i + 1));
            truth.y.push_back(angleOf_deg(comparison.truth[i], angle));
        }
        panel.curves.push_back(std::move(truth));
        for (const ComparedEstimator* estimator : drawn) {
            AnalysisCurve found{nameOf(*estimator), {}, {}, true};
            for (std::size_t i = 0; i < estimator->found.size(); ++i) {
                if (estimator->found[i]) {
                    found.x.push_back(static_cast<double>(i + 1));
                    found.y.push_back(angleOf_deg(*estimator->found[i], angle));
                }
            }
            panel.curves.push_back(std::move(found));
        }
        plot.panels.push_back(std::move(panel));
    }
    return plot;
}

AnalysisPlot errorPlot(const EstimatorComparison& comparison, const std::string& name) {
    /// Rounding of the arithmetic: smaller errors are drawn there, as zero has no place on the axis.
    constexpr double Least_deg = 1e-14;
    AnalysisPlot plot{"Errors along " + name, {"sample", ""}, {{{"error", "deg", true}, {}}}};
    for (const ComparedEstimator& estimator : comparison.estimators) {
        AnalysisCurve curve{nameOf(estimator), {}, {}};
        for (std::size_t i = 0; i < estimator.found.size(); ++i) {
            if (estimator.found[i]) {
                const double error_rad = models::symmetricError_rad(*estimator.found[i], comparison.truth[i]);
                curve.x.push_back(static_cast<double>(i + 1));
                curve.y.push_back(std::max(Least_deg, radiansToDegrees(error_rad)));
            }
        }
        if (!curve.x.empty()) {
            plot.panels.front().curves.push_back(std::move(curve));
        }
    }
    plot.caption = "Modulo the symmetry of the rotor.";
    return plot;
}

AnalysisPlot pathPlot(const EstimatorComparison& comparison, const Drawn& drawn, const std::string& name) {
    AnalysisPlot plot{
        "Path of the shaft along " + name + ", seen along Z", {"shaft x", ""}, {{{"shaft y", ""}, {}}}};
    plot.isEqualScale = true;
    AnalysisCurve truth{"true", {}, {}};
    for (const Eigen::Matrix3d& rotation : comparison.truth) {
        truth.x.push_back(rotation(0, 2));
        truth.y.push_back(rotation(1, 2));
    }
    plot.panels.front().curves.push_back(std::move(truth));
    for (const ComparedEstimator* estimator : drawn) {
        AnalysisCurve found{nameOf(*estimator), {}, {}, true};
        for (const std::optional<Eigen::Matrix3d>& rotation : estimator->found) {
            if (rotation) {
                found.x.push_back((*rotation)(0, 2));
                found.y.push_back((*rotation)(1, 2));
            }
        }
        plot.panels.front().curves.push_back(std::move(found));
    }
    return plot;
}

} // namespace

std::vector<AnalysisPlot> trajectoryPlots(const EstimatorComparison& comparison,
                                          models::SphericalDevice device, const std::string& name) {
    if (comparison.truth.empty()) {
        return {};
    }
    const Drawn drawn = drawnOf(comparison, device);
    return {anglesPlot(comparison, drawn, name), errorPlot(comparison, name),
            pathPlot(comparison, drawn, name)};
}

std::string timingText(const EstimatorComparison& comparison) {
    std::string text;
    for (const ComparedEstimator& estimator : comparison.estimators) {
        if (estimator.timePerPose_s) {
            text += fmt::format("{}{} {:.3g} us", text.empty() ? "time per pose: " : ", ", nameOf(estimator),
                                1e6 * *estimator.timePerPose_s);
        }
    }
    return text.empty() ? text : text + "; the publication's search 1.27 to 1.58 s";
}

} // namespace halbench::app
