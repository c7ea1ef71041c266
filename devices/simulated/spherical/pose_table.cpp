#include "devices/simulated/spherical/pose_table.h"

#include "control/base/units.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <fstream>

namespace halbench::devices {
namespace {

constexpr const char* Hint = "First line: time_s,alpha_deg,beta_deg,gamma_deg (or ..._rad); then numbers.";

/// As spreadsheets save it: a mark of the encoding before the first line, CR at the end of each.
std::string withoutEnds(std::string line) {
    constexpr std::string_view Mark = "\xEF\xBB\xBF";
    if (line.starts_with(Mark)) {
        line.erase(0, Mark.size());
    }
    if (line.ends_with('\r')) {
        line.pop_back();
    }
    return line;
}

Result<std::array<double, 4>> rowOf(const std::string& line, const std::string& place) {
    std::array<double, 4> row{};
    const char* at = line.data();
    const char* const end = at + line.size();
    for (std::size_t i = 0; i < row.size(); ++i) {
        const auto [stop, status] = std::from_chars(at, end, row[i]);
        const bool isEnd = stop == end || *stop == '\r';
        const bool isGood = status == std::errc() && std::isfinite(row[i]) &&
                            (i + 1 == row.size() ? isEnd : !isEnd && *stop == ',');
        if (!isGood) {
            return failure(ErrorCode::InvalidInput, fmt::format("{}: value {} is not a number", place, i + 1),
                           Hint);
        }
        at = isEnd ? stop : stop + 1;
    }
    return row;
}

/// A rotor tilts by less than a turn; only its spin may count on. Degrees under a name in radians would move
/// it around many times between two rows.
Result<void> checkTilt(const models::OrientationAngles& angles, bool isRadian, const std::string& place) {
    for (const auto& [name, angle_rad] :
         {std::pair{"alpha", angles.alpha_rad}, std::pair{"beta", angles.beta_rad}}) {
        if (std::fabs(angle_rad) > 2.0 * Pi) {
            return failure(ErrorCode::InvalidInput,
                           fmt::format("{}: {} is {:.4g} rad, more than a turn", place, name, angle_rad),
                           isRadian ? "Name columns in degrees alpha_deg, beta_deg, gamma_deg."
                                    : "Write tilts within a turn.");
        }
    }
    return {};
}

} // namespace

Result<std::vector<models::TimedOrientation>> readPoseTable(const std::string& path) {
    std::ifstream file(path);
    std::string line;
    if (!file || !std::getline(file, line)) {
        return failure(ErrorCode::FileSystem, fmt::format("cannot read the poses '{}'", path), Hint);
    }
    line = withoutEnds(line);
    const bool isRadian = line == "time_s,alpha_rad,beta_rad,gamma_rad";
    if (!isRadian && line != "time_s,alpha_deg,beta_deg,gamma_deg") {
        return failure(ErrorCode::InvalidInput, fmt::format("{}:1: not the columns of a motion", path), Hint);
    }
    const double toRadian = isRadian ? 1.0 : degreesToRadians(1.0);
    std::vector<models::TimedOrientation> poses;
    for (std::size_t number = 2; std::getline(file, line); ++number) {
        const std::string place = fmt::format("{}:{}", path, number);
        if (withoutEnds(line).empty()) { // editors leave one at the end
            continue;
        }
        const auto row = rowOf(line, place);
        if (!row) {
            return failure(row.error());
        }
        if (!poses.empty() && (*row)[0] <= poses.back().time_s) {
            return failure(ErrorCode::InvalidInput, place + ": the time does not increase", Hint);
        }
        const models::OrientationAngles angles = {toRadian * (*row)[1], toRadian * (*row)[2],
                                                  toRadian * (*row)[3]};
        if (auto possible = checkTilt(angles, isRadian, place); !possible) {
            return failure(possible.error());
        }
        poses.push_back({(*row)[0], angles});
    }
    if (poses.empty()) {
        return failure(ErrorCode::InvalidInput, path + ": no poses after the first line", Hint);
    }
    return poses;
}

} // namespace halbench::devices
