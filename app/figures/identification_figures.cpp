#include "app/figures/identification_figures.h"

#include "control/base/distributions.h"
#include "widgets/figure/figures.h"

#include <QtCore/QCoreApplication>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::app {
namespace {

using control::Estimate;

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::IdentificationFigures)
};

std::string utf8(const QString& text) {
    return text.toStdString();
}

std::optional<double> ratio(const IdentifyResult& result, const std::string& key) {
    const auto found = result.ratios.find(key);
    return found != result.ratios.end() ? found->second.value : std::nullopt;
}

/// The fitted line of one direction: s omega = (|I| - K_f,s/phi) / (c/phi).
struct FitLine {
    double damping_A_s;
    double friction_A[2]; ///< forward, reverse

    double speed_rad_s(double current_A) const {
        const double size = (std::abs(current_A) - friction_A[current_A < 0.0 ? 1 : 0]) / damping_A_s;
        return current_A < 0.0 ? -size : size;
    }
};

std::optional<FitLine> fitLine(const IdentifyResult& result) {
    const auto damping = ratio(result, "c_over_phi");
    const auto friction = ratio(result, "Kf_over_phi");
    if (!damping || !friction || *damping <= 0.0) {
        return std::nullopt;
    }
    const double skew = result.asymmetry && result.asymmetry->value ? *result.asymmetry->value : 0.0;
    return FitLine{*damping, {*friction * (1.0 + skew), *friction * (1.0 - skew)}};
}

widgets::Curve fitCurve(const IdentifyResult& result, const FitLine& line, bool isForward) {
    widgets::Curve curve;
    curve.label = isForward ? utf8(Words::tr("fit forward")) : utf8(Words::tr("fit reverse"));
    curve.style = isForward ? widgets::CurveStyle::Line : widgets::CurveStyle::DashedLine;
    curve.colour = isForward ? 1 : 2;
    for (const SweepPoint& point : result.points) {
        if ((point.current_A >= 0.0) == isForward) {
            curve.x.push_back(point.current_A);
        }
    }
    std::sort(curve.x.begin(), curve.x.end());
    for (const double current_A : curve.x) {
        curve.y.push_back(line.speed_rad_s(current_A));
    }
    return curve;
}

/// Degrees of freedom behind an interval, from its half-width in standard errors.
double freedomOf(const Estimate& estimate, double variance) {
    const double half = 0.5 * (estimate.interval95->second - estimate.interval95->first);
    const double quantile = half / std::sqrt(variance);
    double low = 1.0;
    double high = 1e6;
    for (int i = 0; i < 60; ++i) {
        const double middle = std::sqrt(low * high);
        (control::studentQuantile(0.975, middle) > quantile ? low : high) = middle;
    }
    return std::sqrt(low * high);
}

struct EllipseAxis {
    std::string name;  ///< in the covariance
    std::string words; ///< on the axis
    const Estimate* estimate;
};

std::optional<std::size_t> positionOf(const IdentifyResult& result, const std::string& name) {
    const auto found = std::find(result.covarianceNames.begin(), result.covarianceNames.end(), name);
    return found == result.covarianceNames.end()
               ? std::nullopt
               : std::optional<std::size_t>(static_cast<std::size_t>(found - result.covarianceNames.begin()));
}

std::optional<JointRegion> regionOf(const IdentifyResult& result, const EllipseAxis& x,
                                    const EllipseAxis& y) {
    const auto i = positionOf(result, x.name);
    const auto k = positionOf(result, y.name);
    if (!i || !k || !x.estimate->value || !y.estimate->value || !x.estimate->interval95) {
        return std::nullopt;
    }
    const auto& c = result.covariance;
    const double determinant = c[*i][*i] * c[*k][*k] - c[*i][*k] * c[*i][*k];
    if (!(c[*i][*i] > 0.0) || !(determinant > 0.0)) {
        return std::nullopt;
    }
    // 2 F(0.95; 2, n) in closed form: n (0.05^(-2/n) - 1).
    const double freedom = freedomOf(*x.estimate, c[*i][*i]);
    const double quantile = freedom * std::expm1(-2.0 / freedom * std::log(0.05));
    widgets::EllipseContent content;
    content.title = utf8(Words::tr("Joint 95 % confidence region of damping and friction"));
    content.x = {x.words, x.estimate->unit, false, {}, {}, {}};
    content.y = {y.words, y.estimate->unit, false, {}, {}, {}};
    content.centre = {*x.estimate->value, *y.estimate->value};
    content.covariance = {{{c[*i][*i], c[*i][*k]}, {c[*i][*k], c[*k][*k]}}};
    content.levels = {{utf8(Words::tr("95 % joint region")), quantile}};
    return JointRegion{widgets::ellipseFigure(content), c[*i][*k] / std::sqrt(c[*i][*i] * c[*k][*k])};
}

} // namespace

std::optional<widgets::Figure> steadySpeedFigure(const IdentifyResult& result) {
    const auto line = fitLine(result);
    if (result.points.empty() || !line) {
        return std::nullopt;
    }
    widgets::RegressionContent content;
    content.title = utf8(Words::tr("Steady speed against current amplitude"));
    content.x = {utf8(Words::tr("current amplitude")), "A", false, {}, {}, {}};
    content.y = {utf8(Words::tr("speed")), "rad/s", false, {}, {}, {}};
    for (const SweepPoint& point : result.points) {
        content.points.push_back({point.current_A, point.speed_rad_s,
                                  point.speed_rad_s - line->speed_rad_s(point.current_A), point.isUsed});
    }
    for (const bool isForward : {true, false}) {
        widgets::Curve curve = fitCurve(result, *line, isForward);
        if (!curve.x.empty()) {
            content.fits.push_back(std::move(curve));
        }
    }
    return widgets::regressionFigure(content);
}

std::optional<JointRegion> jointRegion(const IdentifyResult& result) {
    const EllipseAxis c{"viscous_damping", utf8(Words::tr("viscous damping c")), &result.viscousDamping};
    const EllipseAxis kf{"coulomb_friction", utf8(Words::tr("Coulomb friction K_f")),
                         &result.coulombFriction};
    auto region = regionOf(result, c, kf);
    region = region ? region : regionOf(result, {"c", c.words, c.estimate}, {"Kf", kf.words, kf.estimate});
    const auto damping = result.ratios.find("c_over_phi");
    const auto friction = result.ratios.find("Kf_over_phi");
    if (region || damping == result.ratios.end() || friction == result.ratios.end()) {
        return region;
    }
    return regionOf(result, {"c_over_phi", "c/\u03c6", &damping->second},
                    {"Kf_over_phi", "K_f/\u03c6", &friction->second});
}

} // namespace halbench::app
