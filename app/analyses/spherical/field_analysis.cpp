#include "app/analyses/spherical/field_analysis.h"

#include "app/analyses/spherical/placement_choice.h"
#include "control/base/units.h"
#include "models/spherical/rotor_field.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace halbench::app {

namespace {

constexpr std::array<std::string_view, 3> HarmonicNames = {"none", "h1", "h2"};
constexpr double Circle_deg = 360.0;

std::vector<AnalysisKey> fieldKeys() {
    using enum AnalysisKeyType;
    return {
        {"theta_deg", Number, 0, 180, "", "angle from the shaft; default 60"},
        {"radius_mm", Number, 5, 500, "", "distance from the centre; default 50"},
        {"q_T", Number, -10, 10, "", "strength of the field tensor at 50 mm; default 0.0991865"},
        {"harmonics", Choice, 0, 0, "none|h1|h2", "further harmonics of the field; default none"},
        {"step_deg", Number, 0.1, 90, "", "distance of two azimuths; default 1"},
    };
}

/// (B_r, B_theta, B_phi) in the rotor's frame.
Eigen::Vector3d sphericalField_T(const models::RotorField& field, double radius_m, double theta_rad,
                                 double phi_rad) {
    const double s = std::sin(theta_rad);
    const double c = std::cos(theta_rad);
    const Eigen::Vector3d radial(s * std::cos(phi_rad), s * std::sin(phi_rad), c);
    const Eigen::Vector3d polar(c * std::cos(phi_rad), c * std::sin(phi_rad), -s);
    const Eigen::Vector3d azimuthal(-std::sin(phi_rad), std::cos(phi_rad), 0.0);
    const Eigen::Vector3d field_T = field.field_T(Eigen::Matrix3d::Identity(), radius_m * radial);
    return {radial.dot(field_T), polar.dot(field_T), azimuthal.dot(field_T)};
}

struct FieldCircle {
    std::vector<double> phi_deg;
    std::vector<Eigen::Vector3d> whole_T;
    std::vector<Eigen::Vector3d> main_T; ///< without the harmonics
};

FieldCircle circleOf(const models::RotorFieldConfig& config, double radius_m, double theta_rad,
                     double step_deg) {
    models::RotorFieldConfig main = config;
    main.harmonics.clear();
    const models::RotorField whole(config);
    const models::RotorField alone(main);
    FieldCircle circle;
    const int last = static_cast<int>(std::floor(Circle_deg / step_deg + 1e-9));
    for (int i = 0; i <= last; ++i) {
        circle.phi_deg.push_back(i * step_deg);
        const double phi_rad = degreesToRadians(circle.phi_deg.back());
        circle.whole_T.push_back(sphericalField_T(whole, radius_m, theta_rad, phi_rad));
        circle.main_T.push_back(sphericalField_T(alone, radius_m, theta_rad, phi_rad));
    }
    return circle;
}

std::vector<double> component(const std::vector<Eigen::Vector3d>& field_T, int axis) {
    std::vector<double> values;
    for (const Eigen::Vector3d& at : field_T) {
        values.push_back(at[axis]);
    }
    return values;
}

AnalysisPlot plotOf(const FieldCircle& circle, bool hasHarmonics) {
    constexpr std::array Names = {"B_r", "B_theta", "B_phi"};
    AnalysisPlot plot;
    plot.title = "Flux density about the rotor";
    plot.x = {"azimuth phi", "deg"};
    for (int axis = 0; axis < 3; ++axis) {
        AnalysisPanel panel{{Names[static_cast<std::size_t>(axis)], "T"}, {}};
        panel.curves.push_back({"without harmonics", circle.phi_deg, component(circle.main_T, axis)});
        if (hasHarmonics) {
            panel.curves.push_back({"with harmonics", circle.phi_deg, component(circle.whole_T, axis)});
        }
        plot.panels.push_back(panel);
    }
    return plot;
}

AnalysisTable tableOf(const FieldCircle& circle) {
    AnalysisTable table;
    table.columns = {"phi_rad",       "radial_T",     "polar_T",         "azimuthal_T",
                     "main_radial_T", "main_polar_T", "main_azimuthal_T"};
    for (std::size_t i = 0; i < circle.phi_deg.size(); ++i) {
        table.values.push_back(degreesToRadians(circle.phi_deg[i]));
        table.values.insert(table.values.end(), circle.whole_T[i].begin(), circle.whole_T[i].end());
        table.values.insert(table.values.end(), circle.main_T[i].begin(), circle.main_T[i].end());
    }
    return table;
}

JsonValue vectorJson(const Eigen::Vector3d& value_T) {
    JsonValue document = JsonValue::object();
    document.set("radial_T", value_T[0]).set("polar_T", value_T[1]);
    return document.set("azimuthal_T", value_T[2]);
}

Result<AnalysisOutcome> runField(const AnalysisValues& values, const devices::RecordedFile*,
                                 const std::string&, const AnalysisControl&) {
    const Result<models::PlacementDevice> device = deviceChoice(values);
    if (!device) {
        return failure(device.error());
    }
    const double theta_deg = values.numberOr("theta_deg", 60.0);
    const std::string_view harmonics = HarmonicNames[choiceIndex(HarmonicNames, values.text("harmonics"))];
    models::RotorFieldConfig config;
    config.strength_T = device->strength_T;
    config.harmonics = models::harmonicPreset(
        static_cast<models::HarmonicPreset>(choiceIndex(HarmonicNames, harmonics.data())));
    const FieldCircle circle =
        circleOf(config, device->radius_m, degreesToRadians(theta_deg), values.numberOr("step_deg", 1.0));
    Eigen::Vector3d largest_T = Eigen::Vector3d::Zero();
    Eigen::Vector3d effect_T = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < circle.phi_deg.size(); ++i) {
        largest_T = largest_T.cwiseMax(circle.main_T[i].cwiseAbs());
        effect_T = effect_T.cwiseMax((circle.whole_T[i] - circle.main_T[i]).cwiseAbs());
    }
    AnalysisOutcome outcome;
    outcome.body.set("theta_deg", theta_deg).set("radius_m", device->radius_m);
    outcome.body.set("strength_T", device->strength_T).set("harmonics", harmonics);
    outcome.body.set("poses", static_cast<std::uint64_t>(circle.phi_deg.size()));
    outcome.body.set("main_largest", vectorJson(largest_T)).set("harmonics_largest", vectorJson(effect_T));
    outcome.summary = fmt::format("field of the rotor at theta {:g} deg, {:g} mm\n"
                                  "  B_r largest {:.5f} T, B_theta {:.5f} T, B_phi {:.5f} T\n"
                                  "  harmonics '{}' change them by up to {:.5f}, {:.5f} and {:.5f} T\n",
                                  theta_deg, 1e3 * device->radius_m, largest_T[0], largest_T[1], largest_T[2],
                                  harmonics, effect_T[0], effect_T[1], effect_T[2]);
    outcome.table = tableOf(circle);
    outcome.plots.push_back(plotOf(circle, !config.harmonics.empty()));
    return outcome;
}

} // namespace

Analysis fieldAnalysis() {
    return {"field",
            "halbench.field/1",
            "Flux density of a spherical rotor on a circle about its shaft",
            RecordingUse::None,
            true,
            fieldKeys(),
            runField,
            {},
            true};
}

} // namespace halbench::app
