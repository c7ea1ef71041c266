// The axes of a device: one of them is moved, the others hold.
#include "app/procedures/base/axis_choice.h"
#include "app/workbench/drive_ability.h"
#include "app/workbench/drive_control.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::app {

std::vector<devices::AxisSpec> DriveControl::axes() const {
    return axesOf(m_bench.session().catalogue());
}

void DriveControl::useFirstAxis() {
    m_axis = axes().front();
    m_others.clear();
}

std::string DriveControl::signal(const std::string& role) const {
    return signalOfRole(m_bench.session().catalogue(), role);
}

std::string DriveControl::parameter(const std::string& role) const {
    return parameterOfRole(m_bench.session().catalogue(), role);
}

std::string DriveControl::setpointName() const {
    return hasSeveralAxes() ? "hb.setpoint." + m_axis.id : std::string("hb.setpoint");
}

std::string DriveControl::generator(const char* parameterName) const {
    return m_axis.generator + "." + parameterName;
}

/// Without a shape the reference of an axis stays where it is held.
std::vector<ParameterValue> DriveControl::withOthersHeld(std::vector<ParameterValue> values) const {
    for (const devices::AxisSpec& axis : axes()) {
        if (axis.id != m_axis.id) {
            values.insert(values.begin(),
                          {{axis.generator + ".shape", 0.0}, {axis.generator + ".base", 0.0}});
        }
    }
    return values;
}

void DriveControl::chooseAxis(const std::string& id) {
    const std::vector<devices::AxisSpec> all = axes();
    const auto chosen =
        std::find_if(all.begin(), all.end(), [&id](const devices::AxisSpec& axis) { return axis.id == id; });
    if (chosen != all.end() && id != m_axis.id && canChooseAxis()) {
        m_others[m_axis.id] = {m_setpoint, m_sent, m_origin_rad, m_reference};
        m_axis = *chosen;
        const AxisMotion motion = m_others[id];
        m_setpoint = motion.setpoint;
        m_sent = motion.sent;
        m_origin_rad = motion.origin;
        m_reference = motion.reference;
    }
    Q_EMIT changed();
}

/// The board counts every axis from where the mode began, whichever is chosen then.
void DriveControl::seekOtherOrigins() {
    if (!m_awaitsOrigin) {
        return;
    }
    for (const devices::AxisSpec& axis : axes()) {
        const auto latest = m_bench.history().latest(signal(axis.roles.position));
        if (axis.id != m_axis.id && latest && latest->time_s != m_staleSample_s &&
            std::isfinite(latest->value)) {
            m_others[axis.id].origin = latest->value;
        }
    }
}

} // namespace halbench::app
