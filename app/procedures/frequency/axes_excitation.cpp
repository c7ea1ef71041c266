#include "app/procedures/frequency/axes_excitation.h"

#include "app/procedures/base/axis_choice.h"
#include "app/procedures/base/procedure_steps.h"
#include "app/procedures/excite/excitation_limits.h"
#include "app/procedures/excite/move_reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halbench::app {
namespace {

constexpr double OnTheWay_s = 0.3; // rows that are recorded but not here yet
constexpr double Slack_s = 2.0;    // a generator runs on until the next experiment takes over
constexpr double EffortTarget = 1.0;

/// How far each axis swings, from the blocks as they come.
class SwingWatch {
public:
    explicit SwingWatch(std::vector<std::string> signals)
        : m_signals(std::move(signals)), m_low(m_signals.size()), m_high(m_signals.size()) {
        reset();
    }
    void reset() {
        std::fill(m_low.begin(), m_low.end(), std::numeric_limits<double>::infinity());
        std::fill(m_high.begin(), m_high.end(), -std::numeric_limits<double>::infinity());
    }
    void take(const SampleBlock& block) {
        for (std::size_t i = 0; i < m_signals.size(); ++i) {
            const int column = block.layout->indexOf(m_signals[i]);
            for (std::size_t row = 0; column >= 0 && row < block.rows(); ++row) {
                const double value = block.value(row, static_cast<std::size_t>(column));
                m_low[i] = std::min(m_low[i], value);
                m_high[i] = std::max(m_high[i], value);
            }
        }
    }
    /// Half of the way from end to end.
    double swing(std::size_t axis) const { return std::max(0.0, 0.5 * (m_high[axis] - m_low[axis])); }

private:
    std::vector<std::string> m_signals;
    std::vector<double> m_low, m_high;
};

std::vector<std::string> positionSignals(const devices::Catalogue& catalogue,
                                         const std::vector<devices::AxisSpec>& axes) {
    std::vector<std::string> names;
    for (const devices::AxisSpec& axis : axes) {
        names.push_back(signalOf(catalogue, axis.roles.position));
    }
    return names;
}

/// The excitation as one object, so that its steps share device, recorder and watch.
class AxesExcitation {
public:
    AxesExcitation(devices::Device& device, const ProcedureObserver& observer, AxesFrequencyRun& run)
        : m_device(device), m_outer(observer), m_run(run),
          m_watch(positionSignals(device.catalogue(), run.axes)), m_observer(observer),
          m_recorder(device, m_observer) {
        m_observer = listeningIn(m_outer, [this](const SampleBlock& block) { m_watch.take(block); });
        m_observer.checkAbort = [this]() -> Result<void> {
            const Result<void> goOn = m_outer.checkAbort ? m_outer.checkAbort() : Result<void>();
            return goOn ? m_recorder.check() : goOn;
        };
    }

    Result<void> drive() {
        auto limits = guardLimits();
        if (!limits) {
            return failure(limits.error());
        }
        m_recorder.guardBy(*std::move(limits));
        if (auto started = m_recorder.start(wantedSignals(), 1.0 / m_run.plan.period_s); !started) {
            return started;
        }
        if (const Result<void> done = armAndExcite(); !done) {
            return failure(m_recorder.causeOf(done.error()));
        }
        auto recording = m_recorder.finish();
        if (!recording) {
            return failure(recording.error());
        }
        m_run.recording = *std::move(recording);
        return {};
    }

private:
    std::vector<std::string> wantedSignals() const {
        const devices::Catalogue& catalogue = m_device.catalogue();
        std::vector<std::string> names;
        for (const devices::AxisSpec& axis : catalogue.axes) {
            for (const std::string* role : {&axis.roles.position, &axis.roles.speed, &axis.roles.command}) {
                names.push_back(signalOf(catalogue, *role));
            }
        }
        names.push_back(signalOf(catalogue, "current_scale"));
        names.push_back(signalOf(catalogue, "sensors_left_out"));
        return withWatchedSignals(catalogue, names);
    }

    Result<std::vector<devices::GuardLimit>> guardLimits() const {
        const devices::Catalogue& catalogue = m_device.catalogue();
        std::vector<devices::GuardLimit> limits;
        for (const devices::AxisSpec& axis : catalogue.axes) {
            const std::string names[] = {parameterOf(catalogue, axis.roles.speedWindow),
                                         parameterOf(catalogue, axis.roles.positionWindow)};
            const auto windows = m_device.readParameters(names);
            if (!windows) {
                return failure(windows.error());
            }
            const auto more = excitationLimits(catalogue, windows->front(), windows->back(), axis);
            limits.insert(limits.end(), more.begin(), more.end());
        }
        return limits;
    }

    Result<void> armAndExcite() {
        if (auto armed = m_device.arm(); !armed) {
            return armed;
        }
        double settle_s = 0.0;
        for (const devices::AxisSpec& axis : m_device.catalogue().axes) {
            settle_s = std::max(settle_s, axis.settle_s);
        }
        if (auto settled = wait(settle_s, "position hold"); !settled) {
            return settled;
        }
        if (auto entered = enterState(m_outer, ProcedureState::Record); !entered) {
            return entered;
        }
        for (std::size_t band = 0; band < m_run.plan.bands.size(); ++band) {
            auto effort = pilot(band);
            if (!effort) {
                return failure(effort.error());
            }
            noteBand(band, *effort);
            for (std::size_t experiment = 0; experiment < m_run.axes.size(); ++experiment) {
                if (auto excited = excite(band, experiment, *effort); !excited) {
                    return excited;
                }
            }
        }
        return m_device.disarm();
    }

    /// Little effort at first: the largest that does not swing an axis beyond its reach.
    Result<std::vector<double>> pilot(std::size_t band) {
        std::vector<double> effort = m_run.plan.effort;
        for (double& amplitude : effort) {
            amplitude *= Pilot_ratio;
        }
        const double measured_s = m_run.plan.experiment_s(1) - m_run.plan.settle_s;
        if (auto started = start(band, 0, effort, m_run.plan.experiment_s(1) + 2.0 * OnTheWay_s); !started) {
            return failure(started.error());
        }
        if (auto settled = wait(m_run.plan.settle_s + OnTheWay_s, "tries the excitation"); !settled) {
            return failure(settled.error());
        }
        m_watch.reset();
        if (auto seen = wait(measured_s + OnTheWay_s, "tries the excitation"); !seen) {
            return failure(seen.error());
        }
        for (std::size_t i = 0; i < effort.size(); ++i) {
            const double full = m_watch.swing(i) / Pilot_ratio;
            effort[i] = m_run.plan.effort[i] * std::min(1.0, m_run.plan.reach[i] / std::max(full, 1e-300));
        }
        return effort;
    }

    void noteBand(std::size_t band, const std::vector<double>& effort) {
        const std::vector<int> lines = m_run.plan.bands[band].lines(m_run.axes.size());
        m_run.bands.push_back({m_run.plan.frequency_Hz(lines.front()), m_run.plan.frequency_Hz(lines.back()),
                               m_run.plan.bands[band].linesPerAxis, effort});
    }

    Result<void> excite(std::size_t band, std::size_t experiment, const std::vector<double>& effort) {
        const double duration_s = m_run.plan.experiment_s(m_run.config.periods) + OnTheWay_s;
        if (auto started = start(band, experiment, effort, duration_s); !started) {
            return started;
        }
        const auto settling =
            static_cast<std::size_t>(std::lround((m_run.plan.settle_s + OnTheWay_s) / m_run.plan.period_s));
        m_run.experiments.push_back({band, m_recorder.rows() + settling});
        return wait(duration_s + OnTheWay_s,
                    fmt::format("excites from {:.3g} to {:.3g} Hz, {} of {}", m_run.bands[band].from_Hz,
                                m_run.bands[band].to_Hz, experiment + 1, m_run.axes.size()));
    }

    /// All axes start in the same sample: one order takes what was written before.
    Result<void> start(std::size_t band, std::size_t experiment, const std::vector<double>& effort,
                       double duration_s) {
        std::vector<ParameterValue> values;
        for (const devices::AxisSpec& axis : m_device.catalogue().axes) {
            values.push_back({effortTargetOf(axis), EffortTarget});
            values.push_back({axis.generator + ".shape", 0.0});
            values.push_back({axis.generator + ".base", 0.0});
        }
        for (std::size_t i = 0; i < m_run.axes.size(); ++i) {
            const std::vector<int> lines = m_run.plan.bands[band].linesOf(i, experiment, m_run.axes.size());
            MoveReference reference;
            reference.shape = MoveReference::Shape::Multisine;
            reference.amplitude = effort[i];
            reference.frequency_Hz = m_run.plan.frequency_Hz(lines.front());
            reference.frequencyEnd_Hz = m_run.plan.frequency_Hz(lines.back());
            reference.count = static_cast<int>(lines.size());
            const auto own = generatorParameters(reference, duration_s + Slack_s, m_run.axes[i].generator);
            values.insert(values.end(), own.begin(), own.end());
        }
        values.push_back({"reference.start", 1.0});
        std::erase_if(values, [this](const ParameterValue& value) {
            return m_device.catalogue().findParameter(value.name) == nullptr;
        });
        return m_device.writeParameters(values);
    }

    Result<void> wait(double duration_s, const std::string& text) {
        const double whole_s = m_run.plan.duration_s(m_run.config.periods);
        const double from = std::min(1.0, m_done_s / whole_s);
        m_done_s += duration_s;
        return waitObserved(m_device, m_observer, duration_s, from, std::min(1.0, m_done_s / whole_s), text);
    }

    devices::Device& m_device;
    const ProcedureObserver& m_outer;
    AxesFrequencyRun& m_run;
    SwingWatch m_watch;
    ProcedureObserver m_observer;
    StreamRecorder m_recorder;
    double m_done_s = 0.0;
};

} // namespace

std::string effortTargetOf(const devices::AxisSpec& axis) {
    return axis.generator + ".target";
}

Result<void> exciteAxes(devices::Device& device, const ProcedureObserver& observer, AxesFrequencyRun& run) {
    return AxesExcitation(device, observer, run).drive();
}

} // namespace halbench::app
