#include "app/analyses/spherical/readings_analysis.h"

#include "app/analyses/spherical/orientation_readings.h"
#include "app/analyses/spherical/placement_choice.h"
#include "app/documents/text/numbers.h"
#include "control/base/units.h"
#include "models/spherical/additive_model.h"
#include "models/spherical/coverage/coverage_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {

namespace {

constexpr std::array<std::string_view, 3> AngleNames = {"alpha", "beta", "gamma"};

std::vector<AnalysisKey> readingsKeys() {
    using enum AnalysisKeyType;
    std::vector<AnalysisKey> keys = placementKeys();
    const std::vector<AnalysisKey> own = {
        {"along", Choice, 0, 0, "beta|alpha|gamma", "angle that runs; default beta"},
        {"from_deg", Number, -180, 180, "", "its first value; default -45"},
        {"to_deg", Number, -180, 180, "", "its last value; default 45"},
        {"step_deg", Number, 0.01, 90, "", "distance of two values; default 1"},
        {"alpha_deg", Number, -180, 180, "", "rotation about X; default 0"},
        {"beta_deg", Number, -90, 90, "", "rotation about Y; default 0"},
        {"gamma_deg", Number, -180, 180, "", "rotation about Z; default 0"},
        {"threshold_mT", Number, 0, 1e3, "", "least reading that counts; default 10"},
    };
    keys.insert(keys.end(), own.begin(), own.end());
    return keys;
}

/// Largest magnitude of a component among the sensors at its lowest along the line.
struct Lowest {
    double reading_T = HUGE_VAL;
    double at_deg = 0.0;
};

/// R, Theta and Phi of the three sensors, as magnitudes, over the running angle.
AnalysisPlot plotOf(const AnalysisTable& table, const std::string& along, double threshold_T) {
    AnalysisPlot plot;
    plot.title = "Readings along " + along;
    plot.x = {along, "deg"};
    constexpr std::array Components = {"|R|", "|Theta|", "|Phi|"};
    const std::size_t width = table.columns.size();
    for (std::size_t c = 0; c < Components.size(); ++c) {
        AnalysisPanel panel{{Components[c], "T"}, {}, threshold_T};
        for (std::size_t sensor = 0; sensor < 3; ++sensor) {
            AnalysisCurve curve{fmt::format("sensor {}", sensor), {}, {}};
            for (std::size_t i = 0; i < table.values.size(); i += width) {
                curve.x.push_back(radiansToDegrees(table.values[i]));
                curve.y.push_back(std::fabs(table.values[i + 1 + 3 * sensor + c]));
            }
            panel.curves.push_back(curve);
        }
        plot.panels.push_back(panel);
    }
    return plot;
}

Result<AnalysisOutcome> runReadings(const AnalysisValues& values, const devices::RecordedFile*,
                                    const std::string&, const AnalysisControl&) {
    const Result<PlacementChoice> choice = placementChoice(values);
    if (!choice) {
        return failure(choice.error());
    }
    const double from_deg = values.numberOr("from_deg", -45.0);
    const double to_deg = values.numberOr("to_deg", 45.0);
    const double step_deg = values.numberOr("step_deg", 1.0);
    if (from_deg > to_deg) {
        return failure(ErrorCode::Usage, "from_deg lies above to_deg", "exchange them");
    }
    const std::string along = values.text("along").empty() ? "beta" : values.text("along");
    const models::CoverageModel model = choice->coverageModel();
    const double threshold_T = values.numberOr("threshold_mT", 10.0) / 1e3;
    AnalysisTable table;
    table.columns = {along + "_rad"};
    for (std::string name : defaultReadingNames()) {
        std::replace(name.begin(), name.end(), '.', '_');
        table.columns.push_back(name + "_T");
    }
    std::array<Lowest, models::ComponentCount> lowest;
    models::SphericalReadings largest_T = models::SphericalReadings::Zero();
    const int last = static_cast<int>(std::floor((to_deg - from_deg) / step_deg + 1e-9));
    for (int i = 0; i <= last; ++i) {
        const double at_deg = from_deg + i * step_deg;
        const auto angle_rad = [&](std::string_view name, const char* key) {
            return degreesToRadians(name == along ? at_deg : values.numberOr(key, 0.0));
        };
        const models::SphericalReadings readings_T =
            model.readings_T({angle_rad(AngleNames[0], "alpha_deg"), angle_rad(AngleNames[1], "beta_deg"),
                              angle_rad(AngleNames[2], "gamma_deg")});
        largest_T = largest_T.cwiseMax(readings_T.cwiseAbs());
        table.values.push_back(degreesToRadians(at_deg));
        table.values.insert(table.values.end(), readings_T.begin(), readings_T.end());
        for (int c = 0; c < models::ComponentCount; ++c) {
            const double reading_T = models::largestOfComponent_T(readings_T, c);
            Lowest& low = lowest[static_cast<std::size_t>(c)];
            low = reading_T < low.reading_T ? Lowest{reading_T, at_deg} : low;
        }
    }
    AnalysisOutcome outcome;
    JsonValue components = JsonValue::array();
    JsonValue sensors = JsonValue::array();
    outcome.summary = fmt::format("readings along {}, {} poses\n", along, last + 1);
    for (std::size_t c = 0; c < lowest.size(); ++c) {
        constexpr std::array Names = {"R", "Theta", "Phi"};
        JsonValue component = JsonValue::object();
        component.set("component", Names[c]).set("least_T", lowest[c].reading_T);
        component.set("least_at_deg", lowest[c].at_deg);
        components.push(component.set("covered", lowest[c].reading_T > threshold_T));
        outcome.summary +=
            fmt::format("  {:<6} the largest of the three reads at least {:.2f} mT, at {:g} deg{}\n",
                        Names[c], 1e3 * lowest[c].reading_T, lowest[c].at_deg,
                        lowest[c].reading_T > threshold_T ? "" : ": not covered");
    }
    for (int s = 0; s < 3; ++s) {
        JsonValue sensor = JsonValue::object();
        sensor.set("r_largest_T", largest_T[3 * s]).set("theta_largest_T", largest_T[3 * s + 1]);
        sensors.push(sensor.set("phi_largest_T", largest_T[3 * s + 2]));
    }
    outcome.body.set("placement", placementJson(choice->device, choice->placement)).set("along", along);
    outcome.body.set("poses", last + 1).set("threshold_T", threshold_T);
    outcome.body.set("components", components).set("sensors", sensors);
    outcome.plots.push_back(plotOf(table, along, threshold_T));
    outcome.table = std::move(table);
    return outcome;
}

} // namespace

Analysis readingsAnalysis() {
    return {"readings",
            "halbench.readings/1",
            "Readings of three field sensors along one angle of a spherical rotor",
            RecordingUse::None,
            true,
            readingsKeys(),
            runReadings,
            sensingDevice(),
            true};
}

} // namespace halbench::app
