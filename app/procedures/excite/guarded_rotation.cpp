#include "app/procedures/excite/guarded_rotation.h"

#include "app/procedures/base/coil_forecast.h"
#include "app/procedures/base/procedure_steps.h"
#include "app/procedures/excite/excitation_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::app {
namespace {

std::vector<std::string> recordedSignals() {
    return {"position",           "speed",
            "reference",          "current_command",
            "reference.running",  "coil_temperature.a",
            "coil_temperature.b", "torn_count",
            "truth.position",     "truth.speed"};
}

} // namespace

void TurnWatch::take(const SampleBlock& block) {
    const int column = block.layout->indexOf("speed");
    const double sign = std::copysign(1.0, m_limits.turn_rad_s);
    for (std::size_t row = 0; m_isOn && column >= 0 && row < block.rows(); ++row) {
        const double speed_rad_s = sign * block.value(row, static_cast<std::size_t>(column));
        m_lowest_rad_s = std::min(m_lowest_rad_s, speed_rad_s);
        m_highest_rad_s = std::max(m_highest_rad_s, speed_rad_s);
    }
}

bool TurnWatch::isNearStandstill() const {
    return m_lowest_rad_s < Least_ratio * std::abs(m_limits.turn_rad_s);
}

Result<void> TurnWatch::check() const {
    if (isNearStandstill()) {
        return failure(ErrorCode::Refused,
                       fmt::format("the speed fell to {:.3g} rad/s at a base speed of {:.3g} rad/s: near "
                                   "standstill friction is not a constant offset",
                                   std::copysign(1.0, m_limits.turn_rad_s) * m_lowest_rad_s,
                                   m_limits.turn_rad_s),
                       m_limits.slowRemedy);
    }
    if (m_limits.highest_rad_s > 0.0 && m_highest_rad_s > Surprise_ratio * m_limits.highest_rad_s) {
        return failure(ErrorCode::Refused,
                       fmt::format("speed of the rotor {:.3g} rad/s, expected {:.3g}", m_highest_rad_s,
                                   m_limits.highest_rad_s),
                       "identify the motor and give its model: the plan was computed for another motor");
    }
    return {};
}

GuardedRotation::GuardedRotation(devices::Device& device, const ProcedureObserver& observer,
                                 TurnLimits limits)
    : m_device(device), m_outer(observer), m_observer(observer), m_watch(std::move(limits)),
      m_recorder(device, m_observer) {
    m_observer = listeningIn(m_outer, [this](const SampleBlock& block) { m_watch.take(block); });
    m_observer.checkAbort = [this]() -> Result<void> {
        const Result<void> goOn = m_outer.checkAbort ? m_outer.checkAbort() : Result<void>();
        const Result<void> isSound = goOn ? m_recorder.check() : goOn;
        return isSound ? m_watch.check() : isSound;
    };
}

Result<Recording> GuardedRotation::record(double speedLimit_rad_s, double period_s,
                                          const std::function<Result<void>()>& move) {
    m_recorder.guardBy(excitationLimits(m_device.catalogue(), speedLimit_rad_s));
    if (auto started =
            m_recorder.start(withWatchedSignals(m_device.catalogue(), recordedSignals()), 1.0 / period_s);
        !started) {
        return failure(started.error());
    }
    if (auto done = move(); !done) {
        return failure(m_recorder.causeOf(done.error()));
    }
    const std::size_t rows = m_recorder.rows(); // behind them the motor is disarmed, the reference is gone
    Result<Recording> recording = m_recorder.finish();
    if (recording && recording->rows() > rows) {
        recording->time_s.resize(rows);
        recording->values.resize(rows * recording->layout->columns.size());
    }
    return recording;
}

Result<void> startGenerator(devices::Device& device, const MoveReference& reference, double duration_s) {
    std::vector<ParameterValue> values = generatorParameters(reference, duration_s);
    std::erase_if(values, [&device](const ParameterValue& value) {
        return device.catalogue().findParameter(value.name) == nullptr;
    });
    values.push_back({"reference.start", 1.0});
    return device.writeParameters(values);
}

} // namespace halbench::app
