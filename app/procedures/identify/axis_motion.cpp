#include "app/procedures/identify/axis_motion.h"

#include "app/procedures/base/axis_choice.h"
#include "app/procedures/base/procedure_steps.h"
#include "app/procedures/excite/excitation_limits.h"
#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace halbench::app {
namespace {

constexpr double Rate_Hz = 1000.0;
constexpr double Rest_s = 0.2; // between two axes, and before the end
constexpr double ShapeNone = 0.0, ShapeSine = 3.0;

AxisLeg steady(double distance, double speed) {
    return {std::copysign(speed, distance), std::fabs(distance) / speed, 0.0, 0.0};
}

/// Over the distance, with as many cycles of a sine as fit best.
AxisLeg shaken(double distance, double speed, double frequency_Hz) {
    constexpr double Share_ratio = 0.5; // of the speed
    AxisLeg leg = steady(distance, speed);
    const double cycles = std::max(1.0, std::round(frequency_Hz * leg.duration_s));
    leg.frequency_Hz = cycles / leg.duration_s;
    leg.amplitude = Share_ratio * speed / (2.0 * Pi * leg.frequency_Hz);
    return leg;
}

std::vector<ParameterValue> heldValues(const devices::Catalogue& catalogue) {
    std::vector<ParameterValue> values;
    for (const devices::AxisSpec& axis : catalogue.axes) {
        values.push_back({axis.generator + ".shape", ShapeNone});
        values.push_back({axis.generator + ".base", 0.0});
        if (catalogue.findParameter(targetOf(axis)) != nullptr) {
            values.push_back({targetOf(axis), 0.0});
        }
    }
    return values;
}

std::vector<ParameterValue> legValues(const devices::Catalogue& catalogue, const devices::AxisSpec& axis,
                                      const AxisLeg& leg) {
    std::vector<ParameterValue> values = heldValues(catalogue);
    const std::string& generator = axis.generator;
    values.push_back({generator + ".shape", leg.amplitude > 0.0 ? ShapeSine : ShapeNone});
    values.push_back({generator + ".base", leg.speed});
    values.push_back({generator + ".duration", leg.duration_s});
    if (leg.amplitude > 0.0) {
        values.push_back({generator + ".amplitude", leg.amplitude});
        values.push_back({generator + ".frequency", leg.frequency_Hz});
    }
    values.push_back({"reference.start", 1.0});
    return values;
}

/// The motion as one object, so that its steps share device, recorder and clock.
class AxesRecorder {
public:
    AxesRecorder(devices::Device& device, const std::vector<AxisPlan>& plans,
                 const ProcedureObserver& observer)
        : m_device(device), m_plans(plans), m_outer(observer), m_observer(observer),
          m_recorder(device, m_outer) {
        m_observer.checkAbort = [this]() -> Result<void> {
            const Result<void> goOn = m_outer.checkAbort ? m_outer.checkAbort() : Result<void>();
            return goOn ? m_recorder.check() : goOn;
        };
    }

    Result<AxesMotion> record() {
        const devices::LinkStatistics before = m_device.statistics();
        const double start_s = m_device.clock().now_s();
        m_recorder.guardBy(limits());
        if (auto started = m_recorder.start(signals(), Rate_Hz); !started) {
            return failure(started.error());
        }
        if (const Result<void> done = drive(); !done) {
            return failure(m_recorder.causeOf(done.error()));
        }
        auto recording = m_recorder.finish();
        if (!recording) {
            return failure(recording.error());
        }
        auto motion = motionOf(*std::move(recording));
        if (motion) {
            motion->loss = causeOfRowLoss(before, m_device.statistics());
            motion->duration_s = m_device.clock().now_s() - start_s;
        }
        return motion;
    }

private:
    std::vector<devices::GuardLimit> limits() const {
        std::vector<devices::GuardLimit> all;
        for (const AxisPlan& plan : m_plans) {
            const auto more =
                excitationLimits(m_device.catalogue(), plan.speedWindow, plan.window, plan.axis);
            all.insert(all.end(), more.begin(), more.end());
        }
        return all;
    }

    std::vector<std::string> signals() const {
        const devices::Catalogue& catalogue = m_device.catalogue();
        std::vector<std::string> names;
        for (const AxisPlan& plan : m_plans) {
            for (const std::string* role :
                 {&plan.axis.roles.position, &plan.axis.roles.speed, &plan.axis.roles.effort}) {
                names.push_back(signalOf(catalogue, *role));
            }
        }
        return withWatchedSignals(catalogue, names);
    }

    Result<void> drive() {
        if (auto armed = m_device.arm(); !armed) {
            return armed;
        }
        double settle_s = Rest_s;
        for (const AxisPlan& plan : m_plans) {
            settle_s = std::max(settle_s, plan.axis.settle_s);
            m_whole_s += durationOf(plan) + Rest_s;
        }
        m_whole_s += settle_s;
        if (auto settled = wait(settle_s, "position hold"); !settled) {
            return settled;
        }
        if (auto entered = enterState(m_outer, ProcedureState::Record); !entered) {
            return entered;
        }
        for (const AxisPlan& plan : m_plans) {
            if (auto moved = move(plan); !moved) {
                return moved;
            }
        }
        return m_device.disarm();
    }

    Result<void> move(const AxisPlan& plan) {
        for (const AxisLeg& leg : plan.legs) {
            if (auto written = m_device.writeParameters(legValues(m_device.catalogue(), plan.axis, leg));
                !written) {
                return written;
            }
            const char* text = leg.amplitude > 0.0 ? "runs with a sine on its speed" : "goes to its place";
            if (auto moved = wait(leg.duration_s, fmt::format("axis {} {}", plan.axis.id, text)); !moved) {
                return moved;
            }
        }
        return wait(Rest_s, "comes to rest");
    }

    Result<void> wait(double duration_s, const std::string& text) {
        const double from = m_done_s / m_whole_s;
        m_done_s += duration_s;
        return waitObserved(m_device, m_observer, duration_s, from, std::min(1.0, m_done_s / m_whole_s),
                            text);
    }

    Result<AxesMotion> motionOf(Recording recording) const {
        AxesMotion motion;
        for (const AxisPlan& plan : m_plans) {
            const devices::AxisSpec& axis = plan.axis;
            AxisRows rows{recording.time_s,
                          recording.column(signalOf(m_device.catalogue(), axis.roles.position)),
                          recording.column(signalOf(m_device.catalogue(), axis.roles.effort))};
            if (rows.position.size() != recording.rows() || rows.effort.size() != recording.rows()) {
                return failure(ErrorCode::InvalidInput,
                               fmt::format("the device lacks position or effort of axis {}", axis.id),
                               "Its profile needs both roles.");
            }
            motion.axes.push_back(std::move(rows));
        }
        motion.recording = std::move(recording);
        return motion;
    }

    devices::Device& m_device;
    const std::vector<AxisPlan>& m_plans;
    const ProcedureObserver& m_outer;
    ProcedureObserver m_observer;
    StreamRecorder m_recorder;
    double m_whole_s = 0.0, m_done_s = 0.0;
};

} // namespace

std::string targetOf(const devices::AxisSpec& axis) {
    return axis.generator + ".target";
}

AxisPlan axisPlan(const devices::AxisSpec& axis, double window, double speedWindow) {
    constexpr double Reach_ratio = 0.4, Speed_ratio = 0.3; // of the windows
    constexpr double FastSweep_s = 1.0;
    constexpr double Slow_ratio = 0.5, Slowest_ratio = 0.2;
    constexpr int Rounds = 3;
    constexpr std::array<double, Rounds> Fast_Hz = {3.0, 5.0, 4.0}, Slow_Hz = {2.0, 4.0, 3.0};
    AxisPlan plan{axis, window, speedWindow, 0.0, {}};
    const double reach = Reach_ratio * window;
    const double fast = std::min(2.0 * reach / FastSweep_s, Speed_ratio * speedWindow);
    const double slow = Slow_ratio * fast;
    plan.slowest = Slowest_ratio * slow;
    plan.legs.push_back(steady(-reach, slow));
    for (std::size_t round = 0; round < Rounds; ++round) {
        for (const double way : {1.0, -1.0}) {
            plan.legs.push_back(shaken(way * 2.0 * reach, fast, Fast_Hz[round]));
        }
        for (const double way : {1.0, -1.0}) {
            plan.legs.push_back(shaken(way * 2.0 * reach, slow, Slow_Hz[round]));
        }
    }
    plan.legs.push_back(steady(reach, slow));
    return plan;
}

double durationOf(const AxisPlan& plan) {
    double whole_s = 0.0;
    for (const AxisLeg& leg : plan.legs) {
        whole_s += leg.duration_s;
    }
    return whole_s;
}

Result<std::vector<AxisPlan>> axisPlans(devices::Device& device, const std::vector<devices::AxisSpec>& axes) {
    std::vector<AxisPlan> plans;
    for (const devices::AxisSpec& axis : axes) {
        const std::string names[] = {parameterOf(device.catalogue(), axis.roles.positionWindow),
                                     parameterOf(device.catalogue(), axis.roles.speedWindow)};
        const auto windows = device.readParameters(names);
        if (!windows) {
            return failure(windows.error());
        }
        plans.push_back(axisPlan(axis, windows->front(), windows->back()));
    }
    return plans;
}

Result<AxesMotion> recordAxes(devices::Device& device, const std::vector<AxisPlan>& plans,
                              const ProcedureObserver& observer) {
    const devices::Catalogue& catalogue = device.catalogue();
    std::vector<ParameterValue> values = heldValues(catalogue);
    const std::string switches[] = {"window.position_enabled", "window.speed_enabled"};
    for (const std::string& role : switches) {
        if (const std::string name = catalogue.parameterForRole(role); !name.empty()) {
            values.push_back({name, 1.0});
        }
    }
    values.push_back({"hb.mode", static_cast<double>(devices::BoardMode::Position)});
    if (auto prepared = device.writeParameters(values); !prepared) {
        return failure(prepared.error());
    }
    if (auto entered = enterState(observer, ProcedureState::Excite); !entered) {
        return failure(entered.error());
    }
    return AxesRecorder(device, plans, observer).record();
}

} // namespace halbench::app
