#include "app/actuators/planar/platen_legs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

constexpr double ChirpEnds_s = 0.03; // before its leg: one that is cut off would leave the axis displaced
constexpr std::array<const char*, 3> AxisNames = {"x", "y", "phi"};
constexpr std::array<double, 3> Accelerations = {1.0, 1.0, 4.0};

// Shapes of the board's generator.
constexpr double ShapeNone = 0.0, ShapeChirp = 5.0, ShapeTravel = 8.0;

double travelTime_s(const AxisWave& wave, std::size_t axis) {
    const double distance = std::fabs(wave.distance);
    const double ramp_s = wave.speed / Accelerations[axis];
    return distance < wave.speed * ramp_s ? 2.0 * std::sqrt(distance / Accelerations[axis])
                                          : distance / wave.speed + ramp_s;
}

AxisWave travel(double distance, double speed) {
    AxisWave wave;
    wave.shape = AxisWave::Shape::Travel;
    wave.distance = distance;
    wave.speed = speed;
    return wave;
}

// Whole cycles within the time.
AxisWave chirp(double amplitude, double from_Hz, double to_Hz, double duration_s) {
    AxisWave wave;
    wave.shape = AxisWave::Shape::Chirp;
    wave.amplitude = amplitude;
    wave.from_Hz = from_Hz;
    const double cycles = std::max(1.0, std::round(0.5 * (from_Hz + to_Hz) * duration_s));
    wave.to_Hz = 2.0 * cycles / duration_s - from_Hz;
    if (wave.to_Hz <= 0.0) {
        wave.from_Hz = wave.to_Hz = cycles / duration_s;
    }
    return wave;
}

MotionLeg legOf(const std::array<AxisWave, 3>& waves, const char* text) {
    constexpr double Rest_s = 0.05;
    MotionLeg leg;
    leg.waves = waves;
    for (std::size_t axis = 0; axis < waves.size(); ++axis) {
        const double time_s =
            waves[axis].shape == AxisWave::Shape::Travel ? travelTime_s(waves[axis], axis) : 0.0;
        leg.duration_s = std::max(leg.duration_s, std::ceil(1e2 * (time_s + Rest_s)) * 1e-2);
    }
    leg.text = text;
    return leg;
}

MotionLeg travelLeg(std::size_t axis, double distance, double speed, const char* text) {
    std::array<AxisWave, 3> waves;
    waves[axis] = travel(distance, speed);
    return legOf(waves, text);
}

void shakeOthers(MotionLeg& leg, std::size_t axis) {
    constexpr std::array<double, 3> Amplitudes = {0.5e-3, 0.5e-3, 4e-3};
    constexpr std::array<double, 3> Highest_Hz = {8.0, 7.0, 5.0}; // not the same at the same time
    for (std::size_t other = 0; other < 3; ++other) {
        if (other != axis) {
            leg.waves[other] = chirp(Amplitudes[other], 1.0, Highest_Hz[other], leg.duration_s - ChirpEnds_s);
        }
    }
}

// Legs from where the platen stands, each to a place.
class Itinerary {
public:
    explicit Itinerary(const models::PlanarPose& start) : m_place{start.x_m, start.y_m, start.angle_rad} {}

    void goTo(std::size_t axis, double target, double speed, const char* text, bool isShaken) {
        MotionLeg leg = travelLeg(axis, target - m_place[axis], speed, text);
        if (isShaken) {
            shakeOthers(leg, axis);
        }
        m_place[axis] = target;
        m_legs.push_back(std::move(leg));
    }
    std::vector<MotionLeg> legs() && { return std::move(m_legs); }

private:
    std::array<double, 3> m_place;
    std::vector<MotionLeg> m_legs;
};

double nearest(const std::vector<double>& lines, double place) {
    return *std::min_element(lines.begin(), lines.end(), [place](double a, double b) {
        return std::fabs(a - place) < std::fabs(b - place);
    });
}

// Onto a line of each axis, y first: from anywhere but the worst points one of them is near.
void goToLines(Itinerary& itinerary, const PlatenRoom& room) {
    constexpr double Speed_m_s = 0.05;
    itinerary.goTo(1, nearest(room.lines[1], room.start.y_m), Speed_m_s, "goes to a line", false);
    itinerary.goTo(0, nearest(room.lines[0], room.start.x_m), Speed_m_s, "goes to a line", false);
}

void goBack(Itinerary& itinerary, const PlatenRoom& room) {
    constexpr double Speed_m_s = 0.1, Speed_rad_s = 0.1;
    // Not into the end stop at which a platen without current may have stood.
    constexpr double Farthest_rad = 0.5 * TravelAngle_rad;
    const double angle_rad = std::clamp(room.start.angle_rad, -Farthest_rad, Farthest_rad);
    itinerary.goTo(2, angle_rad, Speed_rad_s, "goes back", false);
    // As it came: off the lines for the shortest way only.
    itinerary.goTo(0, nearest(room.lines[0], room.start.x_m), Speed_m_s, "goes back", false);
    itinerary.goTo(1, nearest(room.lines[1], room.start.y_m), Speed_m_s, "goes back", false);
    itinerary.goTo(0, room.start.x_m, Speed_m_s, "goes back", false);
    itinerary.goTo(1, room.start.y_m, Speed_m_s, "goes back", false);
}

} // namespace

std::vector<ParameterValue> legValues(const MotionLeg& leg) {
    std::vector<ParameterValue> values;
    for (std::size_t axis = 0; axis < leg.waves.size(); ++axis) {
        const AxisWave& wave = leg.waves[axis];
        const std::string generator = fmt::format("reference.{}.", AxisNames[axis]);
        const bool isTravel = wave.shape == AxisWave::Shape::Travel;
        const double shape = wave.shape == AxisWave::Shape::Hold ? ShapeNone
                             : isTravel                          ? ShapeTravel
                                                                 : ShapeChirp;
        values.push_back({generator + "shape", shape});
        values.push_back({generator + "base", 0.0});
        if (isTravel) {
            values.push_back({generator + "amplitude", wave.distance});
            values.push_back({generator + "rate", wave.speed});
            values.push_back({generator + "acceleration", Accelerations[axis]});
        } else if (shape == ShapeChirp) {
            values.push_back({generator + "amplitude", wave.amplitude});
            values.push_back({generator + "frequency", wave.from_Hz});
            values.push_back({generator + "frequency_end", wave.to_Hz});
            values.push_back({generator + "duration", leg.duration_s - ChirpEnds_s});
        }
    }
    values.push_back({"reference.start", 1.0});
    return values;
}

double durationOf(const std::vector<MotionLeg>& legs) {
    double whole_s = 0.0;
    for (const MotionLeg& leg : legs) {
        whole_s += leg.duration_s;
    }
    return whole_s;
}

MotionLeg returnLeg(const models::PlanarPose& from, const models::PlanarPose& to) {
    constexpr double Speed_m_s = 0.05, Speed_rad_s = 0.1;
    return legOf({travel(to.x_m - from.x_m, Speed_m_s), travel(to.y_m - from.y_m, Speed_m_s),
                  travel(to.angle_rad - from.angle_rad, Speed_rad_s)},
                 "goes back");
}

std::array<double, 2> nearestLines(const PlatenRoom& room) {
    return {nearest(room.lines[0], room.start.x_m), nearest(room.lines[1], room.start.y_m)};
}

std::array<double, 2> middleLines(const PlatenRoom& room) {
    return {nearest(room.lines[0], 0.0), nearest(room.lines[1], 0.0)};
}

namespace {

void turnStraight(Itinerary& itinerary) {
    constexpr double Speed_rad_s = 0.05;
    itinerary.goTo(2, 0.0, Speed_rad_s, "turns straight", false);
}

} // namespace

std::vector<MotionLeg> straighteningLegs(const PlatenRoom& room) {
    Itinerary itinerary(room.start);
    goToLines(itinerary, room);
    turnStraight(itinerary);
    return std::move(itinerary).legs();
}

std::vector<MotionLeg> centringLegs(const PlatenRoom& room) {
    constexpr double Speed_m_s = 0.1;
    Itinerary itinerary(room.start);
    goToLines(itinerary, room);
    for (std::size_t axis = 0; axis < 2; ++axis) {
        itinerary.goTo(axis, middleLines(room)[axis], Speed_m_s, "goes to the middle", false);
    }
    turnStraight(itinerary);
    return std::move(itinerary).legs();
}

std::vector<MotionLeg> identificationLegs(const PlatenRoom& room) {
    constexpr int Rounds = 8;
    constexpr double Turn_rad = 6e-3;
    // The chirps come to many phases of the lattice: y stops beside its lines, both stop on their way.
    constexpr std::array<double, Rounds> Beside_m = {4e-3, -4e-3, -2e-3, 2e-3, 3e-3, -3e-3, -4e-3, 4e-3};
    constexpr std::array<double, Rounds / 2> Share = {0.3, 0.55, 0.42, 0.68};
    Itinerary itinerary(room.start);
    goToLines(itinerary, room);
    const auto turn = [&](double speed) {
        itinerary.goTo(2, Turn_rad, speed, "turns", true);
        itinerary.goTo(2, -Turn_rad, speed, "turns", true);
    };
    for (int round = 0; round < Rounds; ++round) {
        const bool isFast = round % 4 < 2;
        const auto index = static_cast<std::size_t>(round);
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const bool isUp = round % 2 == 0;
            const double from = isUp ? room.low(axis) : room.high(axis);
            const double to = isUp ? room.high(axis) : room.low(axis);
            if (round >= Rounds / 2) {
                const double way = from + Share[index - Rounds / 2] * (to - from);
                itinerary.goTo(axis, way, 0.16, "goes to a place between", true);
                turn(isFast ? 0.16 : 0.08);
            }
            itinerary.goTo(axis, to + (axis == 1 ? Beside_m[index] : 0.0), isFast ? 0.16 : 0.06,
                           "sweeps at constant speed", true);
            turn(isFast ? 0.16 : 0.08);
        }
    }
    goBack(itinerary, room);
    return std::move(itinerary).legs();
}

std::vector<MotionLeg> calibrationLegs(const PlatenRoom& room) {
    constexpr double Line_m_s = 0.06, Way_m_s = 0.1;
    constexpr double Turn_rad = 5e-3;
    constexpr int Passes = 3;
    Itinerary itinerary(room.start);
    goToLines(itinerary, room);
    for (int pass = 0; pass < Passes; ++pass) {
        itinerary.goTo(2, pass % 2 == 0 ? Turn_rad : -Turn_rad, 0.1, "turns", false);
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const std::vector<double>& lines = room.lines[1 - axis];
            const auto line = static_cast<std::size_t>(pass) * (lines.size() - 1) / (Passes - 1);
            itinerary.goTo(1 - axis, lines[line], Way_m_s, "goes to the next line", false);
            itinerary.goTo(axis, room.low(axis), Way_m_s, "goes to the start of a line", false);
            itinerary.goTo(axis, room.high(axis) + (axis == 1 ? 4e-3 : 0.0), Line_m_s, "sweeps over a pitch",
                           false);
            itinerary.goTo(axis, room.high(axis), Line_m_s, "goes to the next line", false);
        }
    }
    goBack(itinerary, room);
    return std::move(itinerary).legs();
}

} // namespace halbench::app
