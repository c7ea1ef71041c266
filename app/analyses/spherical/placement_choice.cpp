#include "app/analyses/spherical/placement_choice.h"

#include "app/actuators/spherical/rotation_order.h"
#include "app/documents/text/names.h"
#include "app/documents/text/numbers.h"
#include "app/documents/text/output_file.h"
#include "control/base/units.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace halbench::app {

namespace {

constexpr const char* Hint =
    "use published, recommended, a file of 'halbench place --out', or nine angles in degrees";
constexpr double StandardNoise_T = 100e-6;

Result<models::SensorTriple> tripleOf(const std::array<double, 9>& angles_deg) {
    models::SensorTriple placement;
    for (std::size_t i = 0; i < placement.size(); ++i) {
        placement[i] = {degreesToRadians(angles_deg[3 * i]), degreesToRadians(angles_deg[3 * i + 1]),
                        degreesToRadians(angles_deg[3 * i + 2])};
    }
    return placement;
}

Result<models::SensorTriple> anglesOf(const std::string& text) {
    const std::vector<std::string> parts = splitList(text);
    std::array<double, 9> angles_deg{};
    if (parts.size() != angles_deg.size()) {
        return failure(ErrorCode::Usage, fmt::format("--placement has {} angles, not nine", parts.size()),
                       "give alpha,beta,gamma of sensors 0, 1 and 2 in degrees");
    }
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Result<double> angle = numberOption("--placement", parts[i]);
        if (!angle) {
            return failure(angle.error());
        }
        if (std::abs(*angle) > 180.0) {
            return failure(ErrorCode::OutOfRange, fmt::format("--placement: {} is out of range", parts[i]),
                           "angles lie between -180 and 180 degrees");
        }
        angles_deg[i] = *angle;
    }
    return tripleOf(angles_deg);
}

/// A file of 'halbench place --out': the sensors, and the device that they were placed for.
struct PlacementFile {
    models::SensorTriple placement;
    models::PlacementDevice device;
};

Result<models::SensorTriple> sensorsOf(const JsonValue* sensors, const std::string& path) {
    const bool isList = sensors != nullptr && sensors->isArray() && sensors->items().size() == 3;
    std::array<double, 9> angles_deg{};
    for (std::size_t i = 0; isList && i < angles_deg.size(); ++i) {
        constexpr std::array Names = {"alpha_deg", "beta_deg", "gamma_deg"};
        const JsonValue* angle = sensors->items()[i / 3].find(Names[i % 3]);
        if (angle == nullptr || !angle->isNumber()) {
            return failure(ErrorCode::InvalidInput,
                           fmt::format("{}: sensor {} has no number {}", path, i / 3, Names[i % 3]), Hint);
        }
        angles_deg[i] = angle->number();
    }
    if (!isList) {
        return failure(ErrorCode::InvalidInput, path + ": it holds no placement of three sensors", Hint);
    }
    return tripleOf(angles_deg);
}

/// One of the words of a member; the present choice where it is missing.
template <typename Choice, typename Words>
Result<Choice> wordOf(const JsonValue& placement, const char* key, const Words& words, Choice present,
                      const std::string& path) {
    const JsonValue* member = placement.find(key);
    if (member == nullptr) {
        return present;
    }
    const auto found = member->isText() ? std::find(words.begin(), words.end(), member->text()) : words.end();
    if (found == words.end()) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("{}: placement.{} is none of {}", path, key, fmt::join(words, ", ")),
                       Hint);
    }
    return static_cast<Choice>(found - words.begin());
}

Result<double> positiveOf(const JsonValue& placement, const char* key, double present,
                          const std::string& path) {
    const JsonValue* member = placement.find(key);
    if (member == nullptr) {
        return present;
    }
    if (!member->isNumber() || !(member->number() > 0.0)) {
        return failure(ErrorCode::InvalidInput, fmt::format("{}: placement.{} is not positive", path, key),
                       Hint);
    }
    return member->number();
}

/// `device`: what the file does not say.
Result<PlacementFile> fileOf(const std::string& path, const models::PlacementDevice& device) {
    const Result<std::string> text = readFile(path);
    if (!text) {
        return failure(text.error().code, "--placement: " + text.error().message, Hint);
    }
    const Result<JsonValue> document = parseJson(*text, path);
    if (!document) {
        return failure(document.error());
    }
    const JsonValue* placement = document->find("placement");
    const auto sensors = sensorsOf(placement == nullptr ? nullptr : placement->find("sensors"), path);
    if (!sensors) {
        return failure(sensors.error());
    }
    const auto kind = wordOf(*placement, "device", models::SphericalDeviceNames, device.device, path);
    const auto frames = wordOf(*placement, "frames", models::SensorFrameNames, device.frames, path);
    const auto radius_m = positiveOf(*placement, "radius_m", device.radius_m, path);
    const auto strength_T = positiveOf(*placement, "strength_T", device.strength_T, path);
    if (!kind || !frames || !radius_m || !strength_T) {
        return failure(!kind       ? kind.error()
                       : !frames   ? frames.error()
                       : !radius_m ? radius_m.error()
                                   : strength_T.error());
    }
    PlacementFile file{*sensors, device};
    file.device.device = *kind;
    file.device.frames = *frames;
    file.device.radius_m = *radius_m;
    file.device.strength_T = *strength_T;
    return file;
}

bool isFile(const std::string& text) {
    if (text.empty() || text == "published" || text == "recommended") {
        return false;
    }
    const bool isList = text.find(',') != std::string::npos && text.find('.') > text.find(',');
    return !isList && !parseNumber(splitList(text)[0]);
}

Result<models::SensorTriple> namedPlacement(const std::string& text) {
    if (text.empty() || text == "published") {
        return models::publishedPlacement();
    }
    if (text == "recommended") {
        return models::recommendedPlacement();
    }
    if (isFile(text)) {
        const auto file = fileOf(text, {});
        return file ? Result<models::SensorTriple>(file->placement) : failure(file.error());
    }
    return anglesOf(text);
}

} // namespace

models::CoverageModel PlacementChoice::coverageModel() const {
    if (!mounted || device.device == models::SphericalDevice::Additive) {
        return models::coverageModelOf(device, placement);
    }
    models::RotorFieldConfig field;
    field.strength_T = device.strength_T;
    return {field, *mounted};
}

AnalysisDevice sensingDevice() {
    return {"name a device that measures the field of a rotor with three sensors, such as sim:spherical",
            sensingParameters()};
}

std::optional<SensingBoard> chosenBoard(const AnalysisValues& values) {
    const bool isOther = !values.text("placement").empty() || !values.text("frames").empty() ||
                         values.number("radius_mm") || values.number("q_T");
    return isOther || !values.device ? std::nullopt : std::optional(notedSensingBoard(*values.device));
}

double noiseChoice_T(const AnalysisValues& values) {
    const double usual_T = values.device ? notedSensingBoard(*values.device).deviation_T : StandardNoise_T;
    return values.numberOr("noise_uT", 1e6 * usual_T) / 1e6;
}

std::vector<AnalysisKey> placementKeys() {
    using enum AnalysisKeyType;
    return {
        {"placement", Text, 0, 0, "",
         "sensors: published (default), recommended, a file of place, or nine angles in degrees"},
        {"frames", Choice, 0, 0, "zyx|xyz|nat", "how placement angles turn a sensor; default zyx"},
        {"device", Choice, 0, 0, "exact|paper", "model of the device; default exact"},
        {"radius_mm", Number, 5, 500, "", "distance of the sensors from the centre; default 50"},
        {"q_T", Number, -10, 10, "", "strength of the field tensor at 50 mm; default 0.0991865"},
    };
}

Result<models::PlacementDevice> deviceChoice(const AnalysisValues& values) {
    models::PlacementDevice device;
    if (values.device) {
        const SensingBoard board = notedSensingBoard(*values.device);
        device.frames = board.frames;
        device.radius_m = meanRadius_m(board);
        device.strength_T = board.calibration.field.strength_T;
    }
    if (const std::string path = values.text("placement"); isFile(path)) {
        const auto file = fileOf(path, device);
        if (!file) {
            return failure(file.error());
        }
        const double ownStrength_T = device.strength_T;
        device = file->device;
        // The strength is that of a rotor: of the one that is there, not of the one that was planned for.
        device.strength_T = values.device ? ownStrength_T : device.strength_T;
    }
    if (const std::string kind = values.text("device"); !kind.empty()) {
        device.device = static_cast<models::SphericalDevice>(choiceIndex(models::SphericalDeviceNames, kind));
    }
    if (const std::string frames = values.text("frames"); !frames.empty()) {
        device.frames = static_cast<models::SensorFrames>(choiceIndex(models::SensorFrameNames, frames));
    }
    device.radius_m = values.numberOr("radius_mm", 1e3 * device.radius_m) / 1e3;
    device.strength_T = values.numberOr("q_T", device.strength_T);
    if (device.strength_T <= 0.0) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("q = {} T is not positive", formatNumber(device.strength_T)),
                       "the rotor's d axis points where the radial field is positive: turn the rotor frame "
                       "by 90 degrees about the shaft instead of changing the sign");
    }
    if (device.radius_m <= device.rotorRadius_m) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("--radius-mm: sensors {} mm from the centre lie inside the rotor of {} mm",
                                   formatNumber(1e3 * device.radius_m),
                                   formatNumber(1e3 * device.rotorRadius_m)),
                       "place them outside the rotor");
    }
    return device;
}

Result<PlacementChoice> placementChoice(const AnalysisValues& values) {
    Result<models::PlacementDevice> device = deviceChoice(values);
    if (!device) {
        return failure(device.error());
    }
    PlacementChoice choice{*device};
    const std::string text = values.text("placement");
    const Result<models::SensorTriple> placement =
        text.empty() && values.device ? notedSensingBoard(*values.device).placement : namedPlacement(text);
    if (!placement) {
        return failure(placement.error());
    }
    choice.placement = *placement;
    if (const std::optional<SensingBoard> board = chosenBoard(values)) {
        choice.mounted.emplace();
        for (std::size_t i = 0; i < choice.mounted->size(); ++i) {
            (*choice.mounted)[i] = board->calibration.sensors[i].pose;
        }
    }
    if (auto checked = models::checkSensorPoses(choice.poses(), choice.device.rotorRadius_m); !checked) {
        return failure(checked.error());
    }
    return choice;
}

JsonValue anglesJson(double alpha_rad, double beta_rad, double gamma_rad) {
    JsonValue angles = JsonValue::object();
    angles.set("alpha_deg", radiansToDegrees(alpha_rad)).set("beta_deg", radiansToDegrees(beta_rad));
    return angles.set("gamma_deg", radiansToDegrees(gamma_rad));
}

std::string anglesText(double alpha_rad, double beta_rad, double gamma_rad) {
    const auto rounded = [](double angle_rad) {
        return std::round(1e3 * radiansToDegrees(angle_rad)) / 1e3 + 0.0;
    };
    return fmt::format("({:g}, {:g}, {:g})", rounded(alpha_rad), rounded(beta_rad), rounded(gamma_rad));
}

std::string placementText(const models::PlacementDevice& device, const models::SensorTriple& placement) {
    std::vector<std::string> sensors;
    for (const models::PlacementAngles& angles : placement) {
        sensors.push_back(anglesText(angles.alpha_rad, angles.beta_rad, angles.gamma_rad));
    }
    return fmt::format("  sensors at {} deg\n", fmt::join(sensors, ", ")) + placementOrderText(device);
}

std::string placementOrderText(const models::PlacementDevice& device) {
    return fmt::format("  sensors are placed ({}) by (alpha, beta, gamma): {}\n",
                       models::SensorFrameNames[static_cast<std::size_t>(device.frames)],
                       placementOrder(device.frames));
}

JsonValue placementJson(const models::PlacementDevice& device, const models::SensorTriple& placement) {
    JsonValue sensors = JsonValue::array();
    for (const models::PlacementAngles& angles : placement) {
        const Eigen::Vector3d place =
            models::sensorPose(models::placementRotation(angles, device.frames), 1.0).position_m;
        JsonValue sensor = anglesJson(angles.alpha_rad, angles.beta_rad, angles.gamma_rad);
        sensor.set("theta_deg", radiansToDegrees(std::acos(std::fmax(-1.0, std::fmin(1.0, place.z())))));
        sensors.push(sensor.set("phi_deg", radiansToDegrees(std::atan2(place.y(), place.x()))));
    }
    JsonValue document = JsonValue::object();
    document.set("device", models::SphericalDeviceNames[static_cast<std::size_t>(device.device)]);
    document.set("frames", models::SensorFrameNames[static_cast<std::size_t>(device.frames)]);
    document.set("radius_m", device.radius_m).set("strength_T", device.strength_T);
    return document.set("sensors", sensors);
}

} // namespace halbench::app
