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

Result<void> follow(devices::Device& device, const std::vector<MotionLeg>& legs,
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
    constexpr double Braking_s = 0.35; // 0.3 s at most
    return waitObserved(device, observer, Braking_s);
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

/// A platen without current glides wherever the cable or a tilt pulls it. A safety stop away from where the
/// motion began says where that was.
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
    error.message =
        fmt::format("the platen left its window: {:.1f} {} from where it began in {}, the window is "
                    "{:.1f} {}",
                    1e3 * away[farthest], turns ? "mrad" : "mm", AxisNames[farthest],
                    1e3 * start.window[farthest], turns ? "mrad" : "mm");
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

Result<PlatenMotion> recordMotion(devices::Device& device, const PlatenBoard& board,
                                  const std::vector<MotionLeg>& legs, const ProcedureObserver& observer) {
    const auto heat = admitHeat(device, observer, MeanSquare_A2, durationOf(legs), Pause_degC, Refuse_degC);
    if (!heat) {
        return failure(heat.error());
    }
    if (auto prepared = prepare(device); !prepared) {
        return failure(prepared.error());
    }
    if (auto entered = enterState(observer, ProcedureState::Excite); !entered) {
        return failure(entered.error());
    }
    return recorded(device, board, observer, [&](PlatenPlace&) { return follow(device, legs, observer); });
}

Result<PlatenRoom> findStraightRoom(devices::Device& device, const PlatenBoard& board,
                                    const ProcedureObserver& observer, bool& wasHomed) {
    constexpr double Farthest_rad = 0.5 * TravelAngle_rad;
    auto room = findRoom(device, board, observer, wasHomed);
    if (!room || std::fabs(room->start.angle_rad) <= Farthest_rad) {
        return room;
    }
    ProcedureObserver quiet = observer;
    quiet.onState = nullptr; // part of the preparation
    const auto turned = recordMotion(device, board, straighteningLegs(*room), quiet);
    bool isHomed = true;
    return turned ? findRoom(device, board, observer, isHomed) : failure(turned.error());
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
        for (int coil = 1; coil <= models::CoilCount; ++coil) {
            const auto here =
                placeOf(device); // it glides between the pulses, and the window counts from here
            if (!here) {
                return failure(here.error());
            }
            start = *here;
            if (auto pulsed = pulse(device, observer, coil, current_A); !pulsed) {
                return pulsed;
            }
        }
        return {};
    });
}

} // namespace halbench::app
