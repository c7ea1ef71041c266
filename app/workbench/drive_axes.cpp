#include "app/workbench/drive_axes.h"

#include "app/procedures/base/axis_choice.h"
#include "app/workbench/drive_ability.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::app {

std::vector<devices::AxisSpec> DriveAxes::all() const {
    return axesOf(m_bench->session().catalogue());
}

bool DriveAxes::areSeveral() const {
    return m_bench->session().catalogue().axes.size() > 1;
}

void DriveAxes::useFirst() {
    m_axis = all().front();
    m_others.clear();
}

void DriveAxes::choose(const std::string& id) {
    const std::vector<devices::AxisSpec> axes = all();
    const auto chosen = std::find_if(axes.begin(), axes.end(),
                                     [&id](const devices::AxisSpec& axis) { return axis.id == id; });
    if (chosen == axes.end() || id == m_axis.id) {
        return;
    }
    m_others[m_axis.id] = m_motion;
    m_axis = *chosen;
    m_motion = m_others[id];
}

void DriveAxes::clearMotion() {
    m_motion = {0.0, 0.0, m_motion.origin, {}};
    m_others.clear();
}

void DriveAxes::takeOrigin() {
    m_motion.origin.reset();
    m_staleSample_s.clear();
    for (const devices::AxisSpec& axis : all()) {
        if (const auto latest = m_bench->history().latest(signal(axis.roles.position))) {
            m_staleSample_s[axis.id] = latest->time_s;
        }
    }
    m_awaitsOrigin = isStreamed(m_axis);
}

bool DriveAxes::isStreamed(const devices::AxisSpec& axis) const {
    const std::vector<std::string>& streamed = m_bench->liveSignals().streamed();
    return std::find(streamed.begin(), streamed.end(), signal(axis.roles.position)) != streamed.end();
}

void DriveAxes::forgetOrigin() {
    m_motion.origin.reset();
    m_awaitsOrigin = false;
}

/// Nothing without a sample that is newer than the axis's stale one.
std::optional<double> DriveAxes::newPosition(const devices::AxisSpec& axis) const {
    const auto latest = m_bench->history().latest(signal(axis.roles.position));
    const auto stale = m_staleSample_s.find(axis.id);
    const bool isNew = latest && std::isfinite(latest->value) &&
                       (stale == m_staleSample_s.end() || latest->time_s != stale->second);
    return isNew ? std::optional(latest->value) : std::nullopt;
}

bool DriveAxes::seekOrigins() {
    if (!m_awaitsOrigin) {
        return false;
    }
    // The board counts every axis from where the mode began, whichever is chosen then: all of them at once,
    // since their first samples may come in different packets.
    std::map<std::string, double> positions;
    for (const devices::AxisSpec& axis : all()) {
        if (const std::optional<double> position = newPosition(axis)) {
            positions[axis.id] = *position;
        } else if (isStreamed(axis)) {
            return false;
        }
    }
    for (const auto& [id, position] : positions) {
        motionOf(id).origin = position;
    }
    m_awaitsOrigin = !m_motion.origin;
    return !m_awaitsOrigin;
}

double DriveAxes::excursion() const {
    const auto latest = m_bench->history().latest(signal(m_axis.roles.position));
    return m_motion.origin && latest ? std::abs(latest->value - *m_motion.origin) : 0.0;
}

std::optional<std::pair<double, double>> DriveAxes::setpointRange(double share_ratio) const {
    if (!isPositionMode() || m_bench->deviceValue("window.position_enabled").value_or(0.0) < 0.5) {
        return std::nullopt;
    }
    const double end =
        share_ratio * m_bench->deviceValue(parameter(m_axis.roles.positionWindow)).value_or(0.0);
    const double held = m_motion.reference.angle_rad();
    return std::pair(-end - held, end - held);
}

std::string DriveAxes::signal(const std::string& role) const {
    return signalOfRole(m_bench->session().catalogue(), role);
}

std::string DriveAxes::parameter(const std::string& role) const {
    return parameterOfRole(m_bench->session().catalogue(), role);
}

std::string DriveAxes::setpointName() const {
    return areSeveral() ? "hb.setpoint." + m_axis.id : std::string("hb.setpoint");
}

std::string DriveAxes::generator(const char* parameterName) const {
    return m_axis.generator + "." + parameterName;
}

std::vector<ParameterValue> DriveAxes::withOthersHeld(std::vector<ParameterValue> values) const {
    for (const devices::AxisSpec& axis : all()) {
        if (axis.id != m_axis.id) {
            values.insert(values.begin(),
                          {{axis.generator + ".shape", 0.0}, {axis.generator + ".base", 0.0}});
        }
    }
    // The order of a path whose start was lost on the line is none for this start.
    const bool isPath = std::any_of(values.begin(), values.end(),
                                    [](const ParameterValue& value) { return value.name == "path.shape"; });
    if (!isPath && m_bench->session().catalogue().findParameter("path.shape") != nullptr) {
        values.insert(values.begin(), {"path.shape", 0.0});
    }
    return values;
}

std::vector<ParameterValue> DriveAxes::withAllHeld(std::vector<ParameterValue> values) const {
    values.insert(values.begin(), {{m_axis.generator + ".shape", 0.0}, {m_axis.generator + ".base", 0.0}});
    return withOthersHeld(std::move(values));
}

double DriveAxes::commanded(const std::string& id) const {
    const auto other = m_others.find(id);
    const AxisMotion& motion = id == m_axis.id || other == m_others.end() ? m_motion : other->second;
    const bool isKnown = id == m_axis.id || other != m_others.end();
    return isKnown ? motion.setpoint + motion.reference.angle_rad() : 0.0;
}

} // namespace halbench::app
