#include "app/report/report_blocks.h"
#include "app/report/step_sections.h"
#include "control/identify/distributions.h"
#include "widgets/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace halbench::app {
namespace {

using control::Estimate;

ReportEstimate row(const std::string& name, const Estimate& estimate) {
    ReportEstimate result{
        name, estimate.unit, estimate.value, {}, {}, control::estimateSourceName(estimate.source)};
    if (estimate.interval95 && estimate.source == control::EstimateSource::Identified) {
        result.ci95Low = estimate.interval95->first;
        result.ci95High = estimate.interval95->second;
    }
    return result;
}

std::string ratioWords(const std::string& key) {
    static const std::map<std::string, std::string> words = {
        {"c_over_J", "c/J"},
        {"Kf_over_J", "K_f/J"},
        {"phi_over_J", "\u03c6/J"},
        {"c_over_phi", "c/\u03c6"},
        {"Kf_over_phi", "K_f/\u03c6 (breakaway current)"}};
    const auto found = words.find(key);
    return found != words.end() ? found->second : key;
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
    curve.label = isForward ? "fit forward" : "fit reverse";
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

void appendRegression(ReportSection& section, const IdentifyResult& result) {
    const auto line = fitLine(result);
    if (result.points.empty() || !line) {
        return;
    }
    widgets::RegressionContent content;
    content.title = "Steady speed against current amplitude";
    content.x = {"current amplitude", "A", false, {}, {}, {}};
    content.y = {"speed", "rad/s", false, {}, {}, {}};
    std::string left;
    for (const SweepPoint& point : result.points) {
        content.points.push_back({point.current_A, point.speed_rad_s,
                                  point.speed_rad_s - line->speed_rad_s(point.current_A), point.isUsed});
        if (!point.isUsed && !point.note.empty()) {
            left += fmt::format("{}{} A: {}", left.empty() ? " Left out: " : "; ",
                                reportNumber(point.current_A), point.note);
        }
    }
    for (const bool isForward : {true, false}) {
        widgets::Curve curve = fitCurve(result, *line, isForward);
        if (!curve.x.empty()) {
            content.fits.push_back(std::move(curve));
        }
    }
    std::string caption;
    if (result.rSquared && result.residualRms_rad_s) {
        caption = fmt::format("R\u00b2 = {:.4f}; residuals {:.3g} rad/s rms.", *result.rSquared,
                              *result.residualRms_rad_s);
    }
    section.blocks.emplace_back(
        ReportPlot{widgets::regressionFigure(content), caption + left + (left.empty() ? "" : ".")});
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

std::string correlationWords(double correlation) {
    const double shown = std::abs(correlation) < 0.005 ? 0.0 : correlation;
    return fmt::format("Correlation {:.2f}: {}", shown,
                       std::abs(correlation) < 0.5 ? "the two are known nearly independently of each other."
                                                   : "the two must be changed together to stay plausible.");
}

bool appendEllipse(ReportSection& section, const IdentifyResult& result, const EllipseAxis& x,
                   const EllipseAxis& y) {
    const auto i = positionOf(result, x.name);
    const auto k = positionOf(result, y.name);
    if (!i || !k || !x.estimate->value || !y.estimate->value || !x.estimate->interval95) {
        return false;
    }
    const auto& c = result.covariance;
    const double determinant = c[*i][*i] * c[*k][*k] - c[*i][*k] * c[*i][*k];
    if (!(c[*i][*i] > 0.0) || !(determinant > 0.0)) {
        return false;
    }
    // 2 F(0.95; 2, n) in closed form: n (0.05^(-2/n) - 1).
    const double freedom = freedomOf(*x.estimate, c[*i][*i]);
    const double quantile = freedom * std::expm1(-2.0 / freedom * std::log(0.05));
    widgets::EllipseContent content;
    content.title = fmt::format("Joint confidence region of {} and {}", x.words, y.words);
    content.x = {x.words, x.estimate->unit, false, {}, {}, {}};
    content.y = {y.words, y.estimate->unit, false, {}, {}, {}};
    content.centre = {*x.estimate->value, *y.estimate->value};
    content.covariance = {{{c[*i][*i], c[*i][*k]}, {c[*i][*k], c[*k][*k]}}};
    content.levels = {{"95 % joint region", quantile}};
    const double correlation = c[*i][*k] / std::sqrt(c[*i][*i] * c[*k][*k]);
    section.blocks.emplace_back(ReportPlot{widgets::ellipseFigure(content), correlationWords(correlation)});
    return true;
}

void appendJointRegion(ReportSection& section, const IdentifyResult& result) {
    const EllipseAxis c{"viscous_damping", "viscous damping c", &result.viscousDamping};
    const EllipseAxis kf{"coulomb_friction", "Coulomb friction K_f", &result.coulombFriction};
    const bool isDrawn =
        appendEllipse(section, result, c, kf) ||
        appendEllipse(section, result, {"c", c.words, c.estimate}, {"Kf", kf.words, kf.estimate});
    const auto damping = result.ratios.find("c_over_phi");
    const auto friction = result.ratios.find("Kf_over_phi");
    if (!isDrawn && damping != result.ratios.end() && friction != result.ratios.end()) {
        appendEllipse(section, result, {"c_over_phi", "c/\u03c6", &damping->second},
                      {"Kf_over_phi", "K_f/\u03c6", &friction->second});
    }
}

void appendExcitation(ReportSection& section, const Recording& recording) {
    widgets::Figure figure{"The excitation as recorded", {"time", "s", false, {}, {}, {}}, {}};
    constexpr std::array<std::array<const char*, 3>, 2> Signals = {
        {{"speed", "speed", "rad/s"}, {"current_command", "current amplitude", "A"}}};
    for (const auto& [signal, words, unit] : Signals) {
        const std::vector<double> values =
            recording.layout ? recording.column(signal) : std::vector<double>{};
        if (!values.empty()) {
            widgets::Panel panel;
            panel.y = {words, unit, false, {}, {}, {}};
            panel.height_px = 140;
            panel.curves = {{{}, recording.time_s, values, widgets::CurveStyle::Line, 0}};
            figure.panels.push_back(std::move(panel));
        }
    }
    if (!figure.panels.empty()) {
        section.blocks.emplace_back(ReportPlot{std::move(figure), {}});
    }
}

} // namespace

ReportSection identificationSection(const std::string& heading, const IdentifyResult& result) {
    ReportSection section{heading, {}};
    section.blocks.emplace_back(ReportQuality{result.quality});
    section.blocks.emplace_back(estimateTable(
        "Parameters",
        {row("viscous damping c", result.viscousDamping), row("Coulomb friction K_f", result.coulombFriction),
         row("torque constant \u03c6", result.torqueConstant), row("inertia J", result.inertia)}));
    std::vector<ReportEstimate> ratios;
    for (const auto& [key, estimate] : result.ratios) {
        ratios.push_back(row(ratioWords(key), estimate));
    }
    if (result.asymmetry) {
        ratios.push_back(row("asymmetry of the friction", *result.asymmetry));
    }
    section.blocks.emplace_back(estimateTable("Ratios that need no given constant", ratios));
    appendRegression(section, result);
    appendJointRegion(section, result);
    appendExcitation(section, result.recording);
    section.blocks.emplace_back(ReportFacts{
        {{"duration of the excitation", fmt::format("{:.1f} s", result.duration_s)},
         {"highest coil temperature", fmt::format("{:.1f} \u00b0C", result.highestTemperature_degC)}}});
    return section;
}

} // namespace halbench::app
