#include "app/actuators/planar/platen_motion.h"

#include "app/procedures/base/coil_forecast.h"
#include "app/procedures/base/procedure_steps.h"
#include "app/procedures/excite/excitation_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace halbench::app {
namespace {

constexpr double Rate_Hz = 1000.0;
constexpr double Settle_s = 1.0;
constexpr double Tail_s = 0.05;
constexpr double Pause_degC = 60.0;
constexpr double Refuse_degC = 70.0;
constexpr double MeanSquare_A2 = 0.05; // of the legs as planned, with room
constexpr std::array<const char*, 3> AxisNames = {"x", "y", "phi"};
enum Mode { CoilCurrents = 1, Position = 2 };

std::vector<std::string> coilNames(const char* prefix) {
    std::vector<std::string> names;
    for (int k = 1; k <= models::CoilCount; ++k) {
        names.push_back(fmt::format("{}{}", prefix, k));
    }
    return names;
}

std::vector<std::string> hallNames() {
    std::vector<std::string> names;
    for (int j = 1; j <= models::ChipCount; ++j) {
        names.push_back(fmt::format("hall.x{}", j));
        names.push_back(fmt::format("hall.y{}", j));
    }
    return names;
}

std::vector<std::string> wantedSignals() {
    std::vector<std::string> names = {"position.x", "position.y", "position.phi",
                                      "speed.x",    "speed.y",    "speed.phi"};
    for (const auto& more : {coilNames("current.coil"), hallNames(), coilNames("coil_temperature.coil")}) {
        names.insert(names.end(), more.begin(), more.end());
    }
    return names;
}

std::vector<devices::GuardLimit> guardLimits(const devices::Catalogue& catalogue, const PlatenBoard& board) {
    constexpr double Speed_m_s = 0.4, Speed_rad_s = 10.0, Window_rad = 0.03;
    std::vector<devices::GuardLimit> limits;
    for (const devices::AxisSpec& axis : catalogue.axes) {
        const bool turns = axis.positionUnit == "rad";
        const double window = turns ? Window_rad : axis.id == "x" ? board.windowX_m : board.windowY_m;
        const auto more = excitationLimits(catalogue, turns ? Speed_rad_s : Speed_m_s, window, axis);
        limits.insert(limits.end(), more.begin(), more.end());
    }
    return limits;
}

// The chips of a row see what flowed until then: the currents of the row before.
Result<PlatenMotion> motionFrom(Recording recording) {
    PlatenMotion motion;
    const std::size_t rows = recording.rows();
    if (rows < 2) {
        return failure(ErrorCode::InvalidInput, "no rows came from the device", "measure again");
    }
    std::vector<std::vector<double>> pose, current, field;
    for (const char* axis : AxisNames) {
        pose.push_back(recording.column(fmt::format("position.{}", axis)));
    }
    for (const std::string& name : coilNames("current.coil")) {
        current.push_back(recording.column(name));
    }
    for (const std::string& name : hallNames()) {
        field.push_back(recording.column(name));
    }
    for (const auto* group : {&pose, &current, &field}) {
        for (const std::vector<double>& column : *group) {
            if (column.size() != rows) {
                return failure(ErrorCode::InvalidInput, "the device lacks a signal of the platen",
                               "Its catalogue needs position, current.coil1 to 6 and hall.x1 to y3.");
            }
        }
    }
    motion.samples.resize(rows);
    motion.current_A.resize(rows);
    for (std::size_t n = 0; n < rows; ++n) {
        for (std::size_t k = 0; k < models::CoilCount; ++k) {
            motion.current_A[n](static_cast<int>(k)) = current[k][n];
        }
        for (std::size_t i = 0; i < models::FieldCount; ++i) {
            motion.samples[n].reading_T(static_cast<int>(i)) = field[i][n];
        }
        motion.samples[n].current_A = motion.current_A[n > 0 ? n - 1 : 0];
        motion.samples[n].pose = {pose[0][n], pose[1][n], pose[2][n]};
    }
    motion.recording = std::move(recording);
    return motion;
}

Result<void> switchTo(devices::Device& device, Mode mode) {
    std::vector<ParameterValue> values;
    for (const char* axis : AxisNames) {
        values.push_back({fmt::format("reference.{}.shape", axis), 0.0});
        values.push_back({fmt::format("reference.{}.base", axis), 0.0});
        values.push_back({fmt::format("reference.{}.target", axis), 0.0});
    }
    values.push_back({"hb.mode", static_cast<double>(mode)});
    return device.writeParameters(values);
}

// The fit knows least squares without lag; windows guard what the board can guard.
Result<void> prepare(devices::Device& device) {
    const ParameterValue values[] = {
        {"speed.estimator", 0.0}, {"window.position_enabled", 1.0}, {"window.speed_enabled", 1.0}};
    return device.writeParameters(values);
}

/// Where the armed platen is held, without the noise of its position.
Result<models::PlanarPose> heldPose(devices::Device& device) {
    std::vector<std::string> names;
    for (const char* axis : AxisNames) {
        names.push_back(fmt::format("reference.{}", axis));
    }
    const auto held = device.readSignals(names);
    return held ? Result<models::PlanarPose>(models::PlanarPose{(*held)[0], (*held)[1], (*held)[2]})
                : failure(held.error());
}

Result<void> follow(devices::Device& device, PlatenRoom room, LegPlan plan,
                    const ProcedureObserver& observer) {
    if (auto done = switchTo(device, Position); !done) {
        return done;
    }
    if (auto armed = device.arm(); !armed) {
        return armed;
    }
    if (auto settled = waitObserved(device, observer, Settle_s, 0.0, 0.02, "position hold"); !settled) {
        return settled;
    }
    if (auto entered = enterState(observer, ProcedureState::Record); !entered) {
        return entered;
    }
    const auto held = heldPose(device);
    if (!held) {
        return failure(held.error());
    }
    room.start = *held;
    const std::vector<MotionLeg> legs = plan(room);
    const double whole_s = durationOf(legs);
    double done_s = 0.0;
    for (const MotionLeg& leg : legs) {
        if (auto written = device.writeParameters(legValues(leg)); !written) {
            return written;
        }
        const double from = 0.02 + 0.96 * done_s / whole_s;
        done_s += leg.duration_s;
        const double to = 0.02 + 0.96 * done_s / whole_s;
        if (auto moved = waitObserved(device, observer, leg.duration_s, from, to, leg.text); !moved) {
            return moved;
        }
    }
    if (auto rested = waitObserved(device, observer, Tail_s, 0.98, 1.0, "comes to rest"); !rested) {
        return rested;
    }
    return device.disarm();
}

/// Until the board has brought the platen to rest and no coil carries current: from then on it glides. Rows
/// without current follow, which the fit of the pulses needs.
Result<void> awaitBraked(devices::Device& device, const ProcedureObserver& observer) {
    constexpr double Longest_s = 0.35; // the board brakes for 0.3 s at most
    constexpr double Poll_s = 0.01;
    const std::vector<std::string> names = coilNames("current.coil");
    for (double waited_s = 0.0; waited_s < Longest_s; waited_s += Poll_s) {
        if (auto waited = waitObserved(device, observer, Poll_s); !waited) {
            return waited;
        }
        const auto current_A = device.readSignals(names);
        if (!current_A) {
            return failure(current_A.error());
        }
        if (std::all_of(current_A->begin(), current_A->end(), [](double each) { return each == 0.0; })) {
            break;
        }
    }
    return waitObserved(device, observer, Poll_s);
}

Result<void> pulse(devices::Device& device, const ProcedureObserver& observer, int coil, double current_A) {
    constexpr double Pulse_s = 0.01; // 0.5 A move the platen by 0.1 mm in that time
    const std::string name = fmt::format("hb.current_{}", coil);
    if (auto armed = device.arm(); !armed) {
        return armed;
    }
    // Forth, twice as long back, forth: at the end the platen is about where it was and at rest.
    constexpr int Repetitions = 4;
    for (int repetition = 0; repetition < Repetitions; ++repetition) {
        for (const double part : {1.0, -1.0, -1.0, 1.0}) {
            const ParameterValue value[] = {{name, part * current_A}};
            if (auto written = device.writeParameters(value); !written) {
                return written;
            }
            if (auto waited = waitObserved(device, observer, Pulse_s); !waited) {
                return waited;
            }
        }
    }
    const ParameterValue zero[] = {{name, 0.0}};
    if (auto written = device.writeParameters(zero); !written) {
        return written;
    }
    if (auto waited = waitObserved(device, observer, Pulse_s); !waited) {
        return waited;
    }
    if (auto disarmed = device.disarm(); !disarmed) {
        return disarmed;
    }
    return awaitBraked(device, observer);
}

/// Position of the platen, and the window of each axis.
struct PlatenPlace {
    std::array<double, 3> position{}, window{};
};

Result<PlatenPlace> placeOf(devices::Device& device) {
    std::vector<std::string> positions, windows;
    for (const char* axis : AxisNames) {
        positions.push_back(fmt::format("position.{}", axis));
        windows.push_back(fmt::format("window.{}", axis));
    }
    const auto position = device.readSignals(positions);
    const auto window = position ? device.readParameters(windows) : failure(position.error());
    if (!window) {
        return failure(window.error());
    }
    PlatenPlace place;
    std::copy_n(position->begin(), AxisNames.size(), place.position.begin());
    std::copy_n(window->begin(), AxisNames.size(), place.window.begin());
    return place;
}

/// Without current the platen glides between the pulses, and turns most of all.
bool isOff(const PlatenPlace& here, const PlatenPlace& start) {
    constexpr std::array<double, 3> Most = {3e-3, 3e-3, 4e-3};
    for (std::size_t i = 0; i < Most.size(); ++i) {
        if (std::fabs(here.position[i] - start.position[i]) > Most[i]) {
            return true;
        }
    }
    return false;
}

/// Holds the platen for the way back to where the pulses began, then lets it go at rest.
Result<void> goBack(devices::Device& device, const ProcedureObserver& observer, const PlatenPlace& start) {
    constexpr double Caught_s = 0.2;
    if (auto done = switchTo(device, Position); !done) {
        return done;
    }
    if (auto armed = device.arm(); !armed) {
        return armed;
    }
    if (auto caught = waitObserved(device, observer, Caught_s); !caught) {
        return caught;
    }
    const auto held = heldPose(device);
    if (!held) {
        return failure(held.error());
    }
    const auto& [x_m, y_m, angle_rad] = start.position;
    const MotionLeg leg = returnLeg(*held, {x_m, y_m, angle_rad});
    if (auto written = device.writeParameters(legValues(leg)); !written) {
        return written;
    }
    if (auto moved = waitObserved(device, observer, leg.duration_s + Caught_s); !moved) {
        return moved;
    }
    if (auto disarmed = device.disarm(); !disarmed) {
        return disarmed;
    }
    if (auto braked = awaitBraked(device, observer); !braked) {
        return braked;
    }
    return switchTo(device, CoilCurrents);
}

/// A platen without current glides wherever the cable or a tilt pulls it. A stop far from where the motion
/// began says how far: that is a likely cause, whichever limit stopped it.
Error withDrift(Error error, devices::Device& device, const PlatenPlace& start) {
    constexpr double Far_ratio =
        0.5; // of its window; the legs themselves stay within the room of the windows
    const auto now = error.code == ErrorCode::SafetyStop ? placeOf(device) : failure(error);
    if (!now) {
        return error;
    }
    std::size_t farthest = 0;
    std::array<double, 3> away{};
    for (std::size_t i = 0; i < away.size(); ++i) {
        away[i] = std::fabs(now->position[i] - start.position[i]);
        farthest = away[i] / start.window[i] > away[farthest] / start.window[farthest] ? i : farthest;
    }
    if (away[farthest] < Far_ratio * start.window[farthest]) {
        return error;
    }
    const bool turns = std::string_view(AxisNames[farthest]) == "phi";
    error.message = fmt::format("{}; axis {} was {:.1f} {} from where it began", error.message,
                                AxisNames[farthest], 1e3 * away[farthest], turns ? "mrad" : "mm");
    error.hint =
        "Nothing was changed. Take the load of cable or tilt off the platen, clear the stop, move the "
        "platen to the middle, and start again.";
    return error;
}

/// `body` moves the platen; it is told where that begins, and may say that it begins anew.
template <typename Body>
Result<PlatenMotion> recorded(devices::Device& device, const PlatenBoard& board,
                              const ProcedureObserver& observer, Body body) {
    const devices::LinkStatistics before = device.statistics();
    const double start_s = device.clock().now_s();
    auto start = placeOf(device);
    if (!start) {
        return failure(start.error());
    }
    StreamRecorder recorder(device, observer);
    recorder.guardBy(guardLimits(device.catalogue(), board));
    if (auto started = recorder.start(wantedSignals(), Rate_Hz); !started) {
        return failure(started.error());
    }
    if (const Result<void> done = body(*start); !done) {
        return failure(withDrift(recorder.causeOf(done.error()), device, *start));
    }
    auto recording = recorder.finish();
    if (!recording) {
        return failure(recording.error());
    }
    const RowLossCause loss = causeOfRowLoss(before, device.statistics());
    const bool isEmpty = recording->rows() == 0;
    auto motion = motionFrom(*std::move(recording));
    if (!motion) {
        return failure(isEmpty ? withCause(motion.error(), loss) : motion.error());
    }
    motion->loss = loss;
    motion->duration_s = device.clock().now_s() - start_s;
    return motion;
}

} // namespace

Result<PlatenMotion> recordMotion(devices::Device& device, const PlatenBoard& board, const PlatenRoom& room,
                                  LegPlan plan, const ProcedureObserver& observer) {
    const auto heat =
        admitHeat(device, observer, MeanSquare_A2, durationOf(plan(room)), Pause_degC, Refuse_degC);
    if (!heat) {
        return failure(heat.error());
    }
    if (auto prepared = prepare(device); !prepared) {
        return failure(prepared.error());
    }
    if (auto entered = enterState(observer, ProcedureState::Excite); !entered) {
        return failure(entered.error());
    }
    return recorded(device, board, observer,
                    [&](PlatenPlace&) { return follow(device, room, plan, observer); });
}

namespace {

bool isRotationVisible(const models::PlanarPose& pose, const PlatenBoard& board) {
    constexpr double LeastSight = 0.6; // errors of the chips of 1 % turn the pose by less than 10 mrad there
    return rotationSight(pose.x_m, pose.y_m, board.geometry.matrix.pitch_m) >= LeastSight;
}

Result<PlatenRoom> roomAt(const PlatenReach& reach, const PlatenBoard& board) {
    return roomWithin(reach.pose, reach.low_m, reach.high_m, board.geometry.matrix.pitch_m);
}

/// Lines, and the legs over them to where a platen has room and shows its rotation.
struct WayToRoom {
    PlatenRoom lines;
    LegPlan plan = straighteningLegs;
};

/// To the nearest lines, or to the middle where those leave no room. Errors: Refused, where an axis has no
/// line or the window allows no pitch in the middle either: before anything is armed.
Result<WayToRoom> wayToRoom(const PlatenReach& reach, const PlatenBoard& board) {
    WayToRoom way{linesWithin(reach.pose, reach.low_m, reach.high_m, board.geometry.matrix.pitch_m)};
    if (way.lines.lines[0].empty() || way.lines.lines[1].empty()) {
        return failure(roomAt(reach, board).error());
    }
    const auto roomOn = [&board](const std::array<double, 2>& place_m) {
        return roomAt(reachFrom({place_m[0], place_m[1], 0.0}, board), board);
    };
    if (roomOn(nearestLines(way.lines))) {
        return way;
    }
    way.plan = centringLegs;
    const auto middle = roomOn(middleLines(way.lines));
    return middle ? Result<WayToRoom>(way) : failure(middle.error());
}

Result<void> goToRoom(devices::Device& device, const PlatenBoard& board, const ProcedureObserver& observer,
                      const PlatenReach& reach) {
    const auto way = wayToRoom(reach, board);
    if (!way) {
        return failure(way.error());
    }
    ProcedureObserver quiet = observer;
    quiet.onState = nullptr; // part of the preparation
    const auto moved = recordMotion(device, board, way->lines, way->plan, quiet);
    return moved ? Result<void>() : failure(moved.error());
}

} // namespace

Result<std::vector<ParameterValue>> softenLaw(devices::Device& device) {
    // With a quarter and the crosstalk of the assumed layout 2 of 50 places were not stable, as stiff as
    // usual 28; with a tenth the cable pulls the platen out of its window.
    constexpr double Bandwidth_ratio = 0.25;
    const std::array<std::pair<const char*, double>, 3> gains = {
        {{"kp", Bandwidth_ratio * Bandwidth_ratio}, {"ki", 0.0}, {"kd", Bandwidth_ratio}}};
    std::vector<std::string> names;
    for (const char* axis : AxisNames) {
        for (const auto& [gain, share] : gains) {
            names.push_back(fmt::format("gain.{}.{}", axis, gain));
        }
    }
    const auto values = device.readParameters(names);
    if (!values) {
        return failure(values.error());
    }
    std::vector<ParameterValue> before, soft;
    for (std::size_t i = 0; i < names.size(); ++i) {
        before.push_back({names[i], (*values)[i]});
        soft.push_back({names[i], gains[i % gains.size()].second * (*values)[i]});
    }
    const auto written = device.writeParameters(soft);
    return written ? Result<std::vector<ParameterValue>>(std::move(before)) : failure(written.error());
}

Result<void> moveWhereRotationIsVisible(devices::Device& device, const PlatenBoard& board,
                                        const ProcedureObserver& observer, bool& wasHomed) {
    const auto reach = findReach(device, board, observer, wasHomed);
    if (!reach) {
        return failure(reach.error());
    }
    if (!isRotationVisible(reach->pose, board)) {
        return goToRoom(device, board, observer, *reach);
    }
    // What follows the pulses needs room: without any nothing is armed.
    if (roomAt(*reach, board)) {
        return {};
    }
    const auto way = wayToRoom(*reach, board);
    return way ? Result<void>() : failure(way.error());
}

Result<PlatenRoom> findRoom(devices::Device& device, const PlatenBoard& board,
                            const ProcedureObserver& observer, bool& wasHomed) {
    constexpr double Farthest_rad = 0.5 * TravelAngle_rad;
    bool isHomed = true;
    const auto reach = findReach(device, board, observer, isHomed);
    wasHomed = wasHomed && isHomed;
    if (!reach) {
        return failure(reach.error());
    }
    const auto room = roomAt(*reach, board);
    if (room && std::fabs(room->start.angle_rad) <= Farthest_rad && isRotationVisible(room->start, board)) {
        return room;
    }
    if (auto moved = goToRoom(device, board, observer, *reach); !moved) {
        return failure(moved.error());
    }
    const auto now = findReach(device, board, observer, isHomed);
    auto there = now ? roomAt(*now, board) : Result<PlatenRoom>(failure(now.error()));
    if (!there && there.error().code == ErrorCode::Refused) {
        Error error = there.error();
        error.hint = "Widen window.x and window.y. The platen was moved; nothing was changed.";
        return failure(std::move(error));
    }
    return there;
}

Result<PlatenMotion> recordPulses(devices::Device& device, const PlatenBoard& board,
                                  const ProcedureObserver& observer) {
    const double current_A = 0.5 * board.currentLimit_A;
    if (auto prepared = prepare(device); !prepared) {
        return failure(prepared.error());
    }
    return recorded(device, board, observer, [&](PlatenPlace& start) -> Result<void> {
        if (auto done = switchTo(device, CoilCurrents); !done) {
            return done;
        }
        const PlatenPlace first = start;
        for (int coil = 1; coil <= models::CoilCount; ++coil) {
            const auto here = placeOf(device);
            if (!here) {
                return failure(here.error());
            }
            start = *here; // the window counts from here
            if (isOff(*here, first)) {
                if (auto back = goBack(device, observer, first); !back) {
                    return back;
                }
                start = first;
            }
            if (auto pulsed = pulse(device, observer, coil, current_A); !pulsed) {
                return pulsed;
            }
        }
        return {};
    });
}

} // namespace halbench::app
