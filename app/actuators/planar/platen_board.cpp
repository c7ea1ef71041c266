#include "app/actuators/planar/platen_board.h"

#include "app/procedures/base/axis_zero.h"
#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

constexpr double Travel_m = 40e-3; // 10 mm before the stops (resources/help/planar-theory.md section 3)
constexpr double WindowShare = 0.9;
constexpr std::array<const char*, 2> AxisNames = {"x", "y"};

} // namespace

double PlatenBoard::waveNumber_per_m() const {
    return 2.0 * Pi / geometry.matrix.pitch_m;
}

Result<PlatenBoard> readBoard(devices::Device& device) {
    std::vector<std::string> names = {
        "coil.force_constant", "coil.pitch",     "coil.width",      "coil.arm",
        "platen.mass",         "platen.inertia", "platen.centre_x", "platen.centre_y",
        "limit.current",       "window.x",       "window.y"};
    const std::size_t plain = names.size();
    for (int j = 1; j <= models::ChipCount; ++j) {
        for (const char* name : {"amplitude", "gain_x", "gain_y", "cross_xy", "cross_yx", "offset_x",
                                 "offset_y", "place_x", "place_y"}) {
            names.push_back(fmt::format("chip.{}_{}", name, j));
        }
    }
    const std::size_t crosstalk = names.size();
    for (int i = 1; i <= models::FieldCount * models::CoilCount; ++i) {
        names.push_back(fmt::format("chip.crosstalk_{}", i));
    }
    const auto values = device.readParameters(names);
    if (!values) {
        return failure(values.error());
    }
    const std::vector<double>& v = *values;
    PlatenBoard board;
    board.forceConstant_N_per_A = v[0];
    board.geometry.matrix.pitch_m = v[1];
    board.geometry.winding.width_m = v[2];
    board.geometry.arm56_m = v[3];
    board.mass_kg = v[4];
    board.inertia_kg_m2 = v[5];
    board.centreX_m = v[6];
    board.centreY_m = v[7];
    board.currentLimit_A = v[8];
    board.windowX_m = v[9];
    board.windowY_m = v[10];
    for (std::size_t j = 0; j < models::ChipCount; ++j) {
        const double* chip = &v[plain + j * ChipParameters];
        board.chips.amplitude_T[j] = chip[0];
        board.chips.gain[j] = {chip[1], chip[2]};
        board.chips.cross[j] = {chip[3], chip[4]};
        board.chips.offset_T[j] = {chip[5], chip[6]};
        board.chips.place_m[j] = {chip[7], chip[8]};
    }
    for (int i = 0; i < models::FieldCount * models::CoilCount; ++i) {
        board.chips.crosstalk_T_per_A(i / models::CoilCount, i % models::CoilCount) =
            v[crosstalk + static_cast<std::size_t>(i)];
    }
    return board;
}

PlatenRoom linesWithin(const models::PlanarPose& start, const std::array<double, 2>& low_m,
                       const std::array<double, 2>& high_m, double pitch_m) {
    const std::array<double, 2> first = {pitch_m / 8.0, -pitch_m / 8.0};
    const std::array<double, 2> distance = {pitch_m / 4.0, pitch_m / 2.0};
    PlatenRoom room;
    room.start = start;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        double line = first[axis] + distance[axis] * std::ceil((low_m[axis] - first[axis]) / distance[axis]);
        for (; line <= high_m[axis]; line += distance[axis]) {
            room.lines[axis].push_back(line);
        }
    }
    return room;
}

Result<PlatenRoom> roomWithin(const models::PlanarPose& start, const std::array<double, 2>& low_m,
                              const std::array<double, 2>& high_m, double pitch_m) {
    PlatenRoom room = linesWithin(start, low_m, high_m, pitch_m);
    for (std::size_t axis = 0; axis < 2; ++axis) {
        if (room.lines[axis].empty() || room.high(axis) - room.low(axis) < 0.999 * pitch_m) {
            return failure(
                ErrorCode::Refused,
                fmt::format(
                    "the platen has no room for a pitch of {:.1f} mm along {}: it may move from {:.1f} to "
                    "{:.1f} mm, and there only on lines that are {:.1f} mm apart",
                    1e3 * pitch_m, AxisNames[axis], 1e3 * low_m[axis], 1e3 * high_m[axis],
                    1e3 * pitch_m / (axis == 0 ? 4.0 : 2.0)),
                "Move it nearer to the middle, or widen window.x and window.y. Nothing was armed.");
        }
    }
    return room;
}

double rotationSight(double x_m, double y_m, double pitch_m) {
    const double gamma_per_m = 2.0 * Pi / pitch_m;
    const double outer = std::fabs(std::cos(gamma_per_m * (y_m + pitch_m / 8.0)));
    const double third = std::fabs(std::sin(2.0 * gamma_per_m * x_m)); // against both slopes of x
    return std::max(outer, third);
}

PlatenReach reachFrom(const models::PlanarPose& pose, const PlatenBoard& board) {
    PlatenReach reach;
    reach.pose = pose;
    const std::array<double, 2> place_m = {pose.x_m, pose.y_m};
    const std::array<double, 2> window_m = {board.windowX_m, board.windowY_m};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        reach.low_m[axis] = std::max(place_m[axis] - WindowShare * window_m[axis], -Travel_m);
        reach.high_m[axis] = std::min(place_m[axis] + WindowShare * window_m[axis], Travel_m);
    }
    return reach;
}

Result<PlatenReach> findReach(devices::Device& device, const PlatenBoard& board,
                              const ProcedureObserver& observer, bool& wasHomed) {
    const auto homed = awaitZero(device, observer);
    if (!homed) {
        return failure(homed.error());
    }
    wasHomed = !*homed;
    const std::string names[] = {"position.x", "position.y", "position.phi"};
    const auto pose = device.readSignals(names);
    if (!pose) {
        return failure(pose.error());
    }
    return reachFrom({(*pose)[0], (*pose)[1], (*pose)[2]}, board);
}

} // namespace halbench::app
