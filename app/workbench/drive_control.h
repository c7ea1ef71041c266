#pragma once

#include "app/workbench/drive_arming.h"
#include "app/workbench/drive_axes.h"
#include "app/workbench/drive_commands.h"
#include "app/workbench/drive_jog.h"
#include "app/workbench/reference_run.h"
#include "app/workbench/setpoint_motion.h"
#include "app/workbench/workbench.h"
#include "devices/device.h"

#include <QObject>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace halbench::app {

/// Moving the actuator by hand: resources/help/monitor.md, "Drive". Holds what a person decided (mode,
/// set-point, consent); the board owns the rest. Nothing here waits for the device. Thread: GUI.
class DriveControl : public QObject {
    Q_OBJECT

public:
    explicit DriveControl(Workbench& bench, QObject* parent = nullptr);

    /// A device is connected that can be driven from here, and no procedure has it.
    bool isAvailable() const { return m_arming.isAvailable(); }
    /// The device knows our arming (resources/help/protocol.md 3.15); boards of other makers do not.
    bool canDrive() const { return m_arming.canDrive(); }
    bool hasSeveralAxes() const { return m_axes.areSeveral(); }
    /// Which mean what moves; the device's, or that of a board without a profile.
    std::vector<devices::AxisSpec> axes() const { return m_axes.all(); }
    /// The axis that set-point, jog and reference move; the others hold. Positions below are in its unit.
    const devices::AxisSpec& axis() const { return m_axes.chosen(); }
    /// Ignored while a motion runs: it would go on unseen.
    void chooseAxis(const std::string& id);
    bool canChooseAxis() const { return !isRunning() && !isJogging() && !isPending(); }
    bool isArmed() const { return m_arming.isArmed(); }
    /// A stop or a fault is latched.
    bool isStopped() const { return m_arming.isStopped(); }
    /// And it is no longer too early.
    bool canRelease() const { return m_arming.canRelease(); }
    /// A device is there to be armed, no stop is latched or was released a moment ago, nothing is on its way.
    bool canArm() const { return m_arming.canArm(); }
    bool canDisarm() const { return m_arming.canDisarm(); }
    /// Armed, free, in a mode that drives, and neither an arm nor a mode is still on its way to the board.
    bool canMove() const;
    bool isPending() const { return m_commands.isPending(); }
    /// Certain that nothing is armed or on its way to be: there is no device, or one that says so in values
    /// that are not old, and neither a procedure nor an order from here could change it.
    bool isNothingToStop() const { return m_arming.isNothingToStop(); }
    /// A device that is not simulated asks once per connection before it is armed the first time.
    bool needsConsent() const { return m_arming.needsConsent(); }
    /// Several places can ask; one answer, or nothing to arm any more, ends the question everywhere.
    void askConsent() { m_arming.askConsent(); }
    void giveConsent() { m_arming.giveConsent(); }
    void dismissConsent() { m_arming.settleConsent(); }

    void arm(); ///< refused without consent
    void disarm();
    /// Releases the latched stop; arming is another act.
    void releaseStop() { m_arming.releaseStop(); }

    /// What the board was told last; it stays when it cannot be told another.
    devices::BoardMode mode() const { return m_axes.mode(); }
    /// At once; while armed with the set-point at zero and the angle counted from where the rotor is.
    void setMode(devices::BoardMode mode);
    /// rad, added to where the mode was entered and to what a reference holds; or A, by mode.
    double setpoint() const { return m_axes.motion().setpoint; }
    /// Where it goes: another than setpoint() while a ramp is on its way.
    double goal() const { return m_setpoints.goal(); }
    /// A way that is no leap is a step. A longer one is an even ramp of the board with this speed; refused
    /// while a reference runs and where the board makes no ramp that begins where it stands.
    void setSetpoint(double value, double ramp_rad_s);
    static constexpr double LargestStep_deg = SetpointMotion::LargestStep_deg;
    /// In the unit of the axis.
    double largestStep() const { return m_setpoints.largestStep(); }
    /// Position mode: too far for a step.
    bool isLeap(double value) const { return m_setpoints.isLeap(value); }
    /// What keeps set-point and held angle together inside the board's excursion window; nothing in other
    /// modes and while the window is off.
    std::optional<std::pair<double, double>> setpointRange_rad(double share_ratio = 1.0) const {
        return m_axes.setpointRange(share_ratio);
    }
    /// Angle at which a reference stands or is held, beside the set-point.
    double held_rad() const { return m_axes.motion().reference.angle_rad(); }
    /// Angle from which the position mode counts; nothing before it was seen.
    std::optional<double> origin_rad() const { return m_axes.motion().origin; }
    /// It was taken when a mode was chosen while armed, not by arming.
    bool isOriginOfMode() const { return m_isOriginOfMode; }
    /// Armed, but no sample has told yet where the rotor stands: until then nothing moves from here.
    bool awaitsOrigin() const { return m_axes.awaitsOrigin(); }
    /// How far the rotor is from there, as the board's excursion window counts; 0 while that is not known.
    double excursion_rad() const { return isArmed() ? m_axes.excursion() : 0.0; }

    /// Position: a ramp of the board with `rate` rad/s, beside the set-point. Current modes: `rate` is a
    /// current in A. The board itself ends both after 0.3 s unless the hold is renewed, so that a window that
    /// hangs moves nothing. A board whose next reference would leap back gets a set-point that moves instead.
    void startJog(double rate);
    void stopJog();
    bool isJogging() const { return m_jog.isActive(); }

    /// Values of the board's generator; does nothing while a motion of it runs. In position mode it begins at
    /// the angle that is held; refused where the board would leap back instead (continuesReference()).
    void startReference(std::vector<ParameterValue> values);
    /// A path or table, which moves these axes; refused as a reference is.
    void startPath(const MoveReference& reference, const std::vector<std::string>& axes);
    /// Where an axis is told to be, from where it was armed.
    double commanded(const std::string& axis) const { return m_axes.commanded(axis); }
    void stopReference();
    /// The board's generator runs, or has just been told to.
    bool isRunning() const { return m_reference.isRunning(); }
    /// Its shape by the board's code; 0 when that is not known.
    std::size_t runningShape() const { return m_reference.runningShape(); }

Q_SIGNALS:
    void changed();
    void failed(const QString& text, const QString& remedy);
    void consentSettled();

private:
    void onReport();
    void onDevice();
    void onSamples();
    enum class OriginBy { Arming, Mode };
    void takeOrigin(OriginBy by);
    void clearMotion();

    Workbench& m_bench;
    DriveAxes m_axes;
    DriveCommands m_commands;
    DriveArming m_arming;
    ReferenceRun m_reference;
    SetpointMotion m_setpoints;
    DriveJog m_jog;
    bool m_isOriginOfMode = false;
};

} // namespace halbench::app
