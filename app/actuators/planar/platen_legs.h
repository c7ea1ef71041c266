#pragma once

#include "app/actuators/planar/platen_board.h"

#include <array>
#include <string>
#include <vector>

namespace halbench::app {

/// From the middle to an end stop in angle (resources/help/planar-theory.md section 3).
constexpr double TravelAngle_rad = 20e-3;

/// Reference of one axis during one leg, from where the axis is held.
struct AxisWave {
    enum class Shape { Hold, Travel, Chirp };
    Shape shape = Shape::Hold;
    double distance = 0.0;  ///< of a travel, m or rad
    double speed = 0.0;     ///< its constant speed, per second
    double amplitude = 0.0; ///< of a chirp: whole cycles, so that it ends where it began
    double from_Hz = 0.0;
    double to_Hz = 0.0;
};

/// References of x, y and angle that start together.
struct MotionLeg {
    std::array<AxisWave, 3> waves;
    double duration_s = 0.0;
    std::string text; ///< for the progress line
};

/// Travels over the room in x and y at two speeds and both ways, short turns of phi, while the other axes are
/// shaken by chirps: excites forces at many places, damping by constant speeds, inertia by accelerations.
std::vector<MotionLeg> identificationLegs(const PlatenRoom& room);
/// Slow travels over the room on lines of y and of x, with the platen turned a little either way.
std::vector<MotionLeg> calibrationLegs(const PlatenRoom& room);

/// Place {x, y} where a line of y crosses one of x: nearest to where the platen stands, nearest to the
/// middle. Every axis has a line.
std::array<double, 2> nearestLines(const PlatenRoom& room);
std::array<double, 2> middleLines(const PlatenRoom& room);

/// To those lines, and there turned to zero: off the lines the rotation that chips show without calibration
/// can be wrong by more than there is between the end stops.
std::vector<MotionLeg> straighteningLegs(const PlatenRoom& room);
std::vector<MotionLeg> centringLegs(const PlatenRoom& room);

/// Straight from one pose to another near by, all axes at once.
MotionLeg returnLeg(const models::PlanarPose& from, const models::PlanarPose& to);

double durationOf(const std::vector<MotionLeg>& legs);

/// Parameters of the board's generators that start a leg.
std::vector<ParameterValue> legValues(const MotionLeg& leg);

} // namespace halbench::app
