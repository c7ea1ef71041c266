#pragma once

#include "app/workbench/signals/reference_hold.h"
#include "app/workbench/workbench.h"
#include "devices/device.h"

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace halbench::app {

/// Motion of one axis, in its unit of position.
struct AxisMotion {
    double setpoint = 0.0;
    double sent = 0.0;            ///< of it, what the board has as its set-point; ramps have moved the rest
    std::optional<double> origin; ///< from which the position mode counts; nothing before it was seen
    ReferenceHold reference;
};

/// The axes of a driven device: the mode, the axis that is moved while the others hold, the motion of each,
/// and where each one begins. Thread: GUI.
class DriveAxes {
public:
    explicit DriveAxes(Workbench& bench) : m_bench(&bench) {}

    /// The device's, or that of a board without a profile.
    std::vector<devices::AxisSpec> all() const;
    bool areSeveral() const;
    const devices::AxisSpec& chosen() const { return m_axis; }
    void useFirst();
    void choose(const std::string& id);

    devices::BoardMode mode() const { return m_mode; }
    void setMode(devices::BoardMode mode) { m_mode = mode; }
    bool isPositionMode() const { return m_mode == devices::BoardMode::Position; }

    /// Of the chosen axis.
    AxisMotion& motion() { return m_motion; }
    const AxisMotion& motion() const { return m_motion; }
    /// Of any axis of the device.
    AxisMotion& motionOf(const std::string& id) { return id == m_axis.id ? m_motion : m_others[id]; }
    /// Where an axis is told to be, from where it was armed: set-point and what a reference holds.
    double commanded(const std::string& id) const;
    /// Arming, a mode, and each end of it begin at zero; the origin stays.
    void clearMotion();

    /// Waits for samples that are newer than those of now.
    void takeOrigin();
    void forgetOrigin();
    /// Where a motion begins is known before it may begin: what is held and the window's ends count from
    /// there. A sample from before does not tell: a hand, or what came while the link was lost, may have
    /// turned the rotor. True when the chosen axis has just been seen.
    bool seekOrigins();
    bool awaitsOrigin() const { return m_awaitsOrigin; }
    /// How far the axis is from its origin; 0 while that is not known.
    double excursion() const;
    /// What keeps set-point and held position inside the board's excursion window; nothing in other modes and
    /// while the window is off.
    std::optional<std::pair<double, double>> setpointRange(double share_ratio) const;

    std::string signal(const std::string& role) const;
    std::string parameter(const std::string& role) const;
    std::string setpointName() const;
    std::string generator(const char* parameterName) const;
    /// Without a shape the reference of an axis stays where it is held.
    std::vector<ParameterValue> withOthersHeld(std::vector<ParameterValue> values) const;
    /// The same for every axis: a path moves those that it moves.
    std::vector<ParameterValue> withAllHeld(std::vector<ParameterValue> values) const;

private:
    bool isStreamed(const devices::AxisSpec& axis) const;
    std::optional<double> newPosition(const devices::AxisSpec& axis) const;

    Workbench* m_bench;
    devices::BoardMode m_mode = devices::BoardMode::Position;
    devices::AxisSpec m_axis;
    AxisMotion m_motion;
    std::map<std::string, AxisMotion> m_others; ///< by axis
    bool m_awaitsOrigin = false;
    std::map<std::string, double> m_staleSample_s; ///< each axis's last sample before
};

} // namespace halbench::app
