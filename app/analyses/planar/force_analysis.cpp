#include "app/analyses/planar/force_analysis.h"

#include "app/analyses/planar/published_numbers.h"
#include "models/planar/current_allocation.h"
#include "models/planar/prism_wrench.h"
#include "models/planar/windings_wrench.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace halbench::app {

namespace {

/// What is demanded of the allocation, one at a time (section 5.4).
struct Demand {
    std::string_view name;
    models::PlanarWrench wrench;
};

/// Largest over a cell, N and N m: beyond the demand, and the vertical force.
struct WrenchError {
    double x_N = 0.0;
    double y_N = 0.0;
    double torque_Nm = 0.0;
    double lift_N = 0.0;
};

std::vector<AnalysisKey> forceKeys() {
    using enum AnalysisKeyType;
    return {
        {"device", Choice, 0, 0, "windings|prism", "model of the device; default windings"},
        {"heading_mrad", Number, -50, 50, "", "rotation of the platen; default 0"},
        {"points", Integer, 4, 200, "", "of the cell along each axis; default 40"},
    };
}

std::array<Demand, 3> demands() {
    constexpr double Force_N = 1.0;
    constexpr double Torque_Nm = 0.04;
    return {Demand{"x", {Force_N, 0.0, 0.0}}, Demand{"y", {0.0, Force_N, 0.0}},
            Demand{"torque", {0.0, 0.0, Torque_Nm}}};
}

/// Forces of the device at a pose.
class ForceDevice {
public:
    ForceDevice(const models::PlanarGeometry& geometry, bool isPrism)
        : m_windings(geometry), m_prism(geometry), m_isPrism(isPrism),
          m_forceConstant_N_per_A(isPrism ? models::publishedForceConstant_N_per_A(geometry)
                                          : models::windingsForceConstant_N_per_A(geometry)) {}

    models::CoilWrench at(const models::PlanarPose& pose) const {
        return m_isPrism ? m_prism.at(pose) : m_windings.at(pose);
    }
    /// That the controller has identified on it.
    double forceConstant_N_per_A() const { return m_forceConstant_N_per_A; }

private:
    models::WindingsWrench m_windings;
    models::PrismWrench m_prism;
    bool m_isPrism;
    double m_forceConstant_N_per_A;
};

void widen(WrenchError& error, const models::CoilWrench& coils, const models::CoilCurrents_A& current_A,
           const models::PlanarWrench& demanded) {
    const Eigen::Vector3d given = coils.wrench * current_A;
    error.x_N = std::max(error.x_N, std::fabs(given[0] - demanded.forceX_N));
    error.y_N = std::max(error.y_N, std::fabs(given[1] - demanded.forceY_N));
    error.torque_Nm = std::max(error.torque_Nm, std::fabs(given[2] - demanded.torque_Nm));
    error.lift_N = std::max(error.lift_N, std::fabs((coils.lift_N_per_A * current_A)[0]));
}

WrenchError errorOf(const ForceDevice& device, const models::PlanarGeometry& geometry, const Demand& demand,
                    double heading_rad, int points) {
    const models::PublishedWrench controller(geometry, device.forceConstant_N_per_A());
    WrenchError error;
    for (int i = 0; i < points * points; ++i) {
        const double step_m = geometry.matrix.pitch_m / points;
        const models::PlanarPose pose{step_m * (i % points), step_m * (i / points), heading_rad};
        widen(error, device.at(pose), models::setWiseCurrents_A(controller, pose, demand.wrench),
              demand.wrench);
    }
    return error;
}

JsonValue errorJson(const Demand& demand, const WrenchError& error) {
    JsonValue entry = JsonValue::object();
    entry.set("demand", std::string(demand.name)).set("error_x_N", error.x_N).set("error_y_N", error.y_N);
    return entry.set("error_torque_Nm", error.torque_Nm).set("lift_N", error.lift_N);
}

std::string errorLine(const Demand& demand, const WrenchError& error) {
    return fmt::format("  demand {:<7} errors {:.2f} mN, {:.2f} mN, {:.3f} mN m; vertical {:.1f} mN\n",
                       demand.name, 1e3 * error.x_N, 1e3 * error.y_N, 1e3 * error.torque_Nm,
                       1e3 * error.lift_N);
}

Result<AnalysisOutcome> runForces(const AnalysisValues& values, const devices::RecordedFile*,
                                  const std::string&, const AnalysisControl&) {
    const models::PlanarGeometry geometry;
    const bool isPrism = values.text("device") == "prism";
    const ForceDevice device(geometry, isPrism);
    const double heading_mrad = values.numberOr("heading_mrad", 0.0);
    const int points = static_cast<int>(values.numberOr("points", 40.0));
    AnalysisOutcome outcome;
    outcome.summary = fmt::format("published model against a device of {}, heading {:g} mrad\n",
                                  isPrism ? "prisms" : "windings", heading_mrad);
    JsonValue errors = JsonValue::array();
    for (const Demand& demand : demands()) {
        const WrenchError error = errorOf(device, geometry, demand, 1e-3 * heading_mrad, points);
        errors.push(errorJson(demand, error));
        outcome.summary += errorLine(demand, error);
    }
    const std::vector<PublishedNumber> numbers = publishedNumbers(geometry);
    JsonValue figures = JsonValue::object();
    for (const PublishedNumber& number : numbers) {
        figures.set(std::string(number.name), number.value);
        outcome.summary += fmt::format(
            "  {:<34} {:.6g}{}\n", number.name, number.value,
            number.printed.empty() ? std::string() : fmt::format("  (printed: {})", number.printed));
    }
    outcome.body.set("device_model", std::string(isPrism ? "prism" : "windings"));
    outcome.body.set("heading_mrad", heading_mrad).set("errors", errors).set("figures", figures);
    return outcome;
}

} // namespace

Analysis forceAnalysis() {
    return {"forces",
            "halbench.forces/1",
            "Force constants, errors of the published force model and its numbers of a planar positioner",
            RecordingUse::None,
            false,
            forceKeys(),
            runForces};
}

} // namespace halbench::app
