#pragma once

#include "app/workbench/reference_hold.h"
#include "app/workbench/workbench.h"
#include "control/base/result.h"
#include "devices/device.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <cstdint>
#include <functional>
#include <map>
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
    bool isAvailable() const;
    /// The device knows our arming (resources/help/protocol.md 3.15); boards of other makers do not.
    bool canDrive() const;
    bool hasSeveralAxes() const;
    /// Which mean what moves; the device's, or that of a board without a profile.
    std::vector<devices::AxisSpec> axes() const;
    /// The axis that set-point, jog and reference move; the others hold. Positions below are in its unit.
    const devices::AxisSpec& axis() const { return m_axis; }
    /// Ignored while a motion runs: it would go on unseen.
    void chooseAxis(const std::string& id);
    bool canChooseAxis() const { return !isRunning() && !isJogging() && !isPending(); }
    bool isArmed() const;
    bool isStopped() const;  ///< a stop or a fault is latched
    bool canRelease() const; ///< and it is no longer too early
    /// A device is there to be armed, no stop is latched or was released a moment ago, nothing is on its way.
    bool canArm() const;
    bool canDisarm() const;
    /// Armed, free, in a mode that drives, and neither an arm nor a mode is still on its way to the board.
    bool canMove() const;
    bool isPending() const { return m_pending != 0; }
    /// Certain that nothing is armed or on its way to be: there is no device, or one that says so in values
    /// that are not old, and neither a procedure nor an order from here could change it.
    bool isNothingToStop() const;
    /// A device that is not simulated asks once per connection before it is armed the first time.
    bool needsConsent() const;
    /// Several places can ask; one answer, or nothing to arm any more, ends the question everywhere.
    void askConsent() { m_isAsking = true; }
    void giveConsent();
    void dismissConsent();

    void arm(); ///< refused without consent
    void disarm();
    /// Releases the latched stop; arming is another act.
    void releaseStop();

    /// What the board was told last; it stays when it cannot be told another.
    devices::BoardMode mode() const { return m_mode; }
    /// At once; while armed with the set-point at zero and the angle counted from where the rotor is.
    void setMode(devices::BoardMode mode);
    /// rad, added to where the mode was entered and to what a reference holds; or A, by mode.
    double setpoint() const { return m_setpoint; }
    /// Where it goes: another than setpoint() while a ramp is on its way.
    double goal() const;
    /// A way that is no leap is a step. A longer one is an even ramp of the board with this speed; refused
    /// while a reference runs and where the board makes no ramp that begins where it stands.
    void setSetpoint(double value, double ramp_rad_s);
    static constexpr double LargestStep_deg = 30.0; ///< of an axis that turns for ever
    double largestStep() const;                     ///< in the unit of the axis
    /// Position mode: too far for a step.
    bool isLeap(double value) const;
    /// What keeps set-point and held angle together inside the board's excursion window; nothing in other
    /// modes and while the window is off.
    std::optional<std::pair<double, double>> setpointRange_rad(double share_ratio = 1.0) const;
    /// Angle at which a reference stands or is held, beside the set-point.
    double held_rad() const { return m_reference.angle_rad(); }
    /// Angle from which the position mode counts; nothing before it was seen.
    std::optional<double> origin_rad() const { return m_origin_rad; }
    /// It was taken when a mode was chosen while armed, not by arming.
    bool isOriginOfMode() const { return m_isOriginOfMode; }
    /// Armed, but no sample has told yet where the rotor stands: until then nothing moves from here.
    bool awaitsOrigin() const { return m_awaitsOrigin; }
    /// How far the rotor is from there, as the board's excursion window counts; 0 while that is not known.
    double excursion_rad() const;

    /// Position: a ramp of the board with `rate` rad/s, beside the set-point. Current modes: `rate` is a
    /// current in A. The board itself ends both after 0.3 s unless the hold is renewed, so that a window that
    /// hangs moves nothing. A board whose next reference would leap back gets a set-point that moves instead.
    void startJog(double rate);
    void stopJog();
    bool isJogging() const { return m_jog.isActive(); }

    /// Values of the board's generator; does nothing while a motion of it runs. In position mode it begins at
    /// the angle that is held; refused where the board would leap back instead (continuesReference()).
    void startReference(std::vector<ParameterValue> values);
    void stopReference();
    /// The board's generator runs, or has just been told to.
    bool isRunning() const { return m_reference.isRunning(); }
    /// Its shape by the board's code; 0 when that is not known.
    std::size_t runningShape() const;

Q_SIGNALS:
    void changed();
    void failed(const QString& text, const QString& remedy);
    void consentSettled();

private:
    using Action = std::function<Result<void>(devices::Device&)>;
    void run(Action action, std::function<void()> then);
    /// The same for what decides how a motion acts: until the board has answered nothing moves from here, and
    /// a stop that comes before its turn cancels it.
    void change(Action action, std::function<void()> then);
    void finish(const Result<void>& done, const std::function<void()>& then);
    void onReport();
    void onDevice();
    void jogStep();
    enum class OriginBy { Arming, Mode };
    void takeOrigin(OriginBy by);
    void seekOrigin();
    void onSamples();
    void settleConsent();
    bool rampsOnBoard() const;
    std::string setpointName() const;
    std::string generator(const char* parameter) const;
    std::string signal(const std::string& role) const;
    std::string parameter(const std::string& role) const;
    void useFirstAxis();
    void seekOtherOrigins();
    std::vector<ParameterValue> withOthersHeld(std::vector<ParameterValue> values) const;
    void refuseLeap();
    void sendRamp(double value, double ramp_rad_s);
    double reached_rad() const;
    void followWay();
    void leaveWay();
    void endReference();
    void clearMotion();
    void moveJogSetpoint();
    void sendJog(std::vector<ParameterValue> values, double setpoint);
    double nextJogSetpoint(double step_s) const;
    std::optional<double> jogRoom_rad() const;
    std::optional<std::vector<ParameterValue>> jogRamp() const;

    Workbench& m_bench;
    devices::BoardMode m_mode = devices::BoardMode::Position;
    /// A ramp of the board that carries the set-point to another one.
    struct Way {
        double from_rad, to_rad;
        bool isAnswered = false; ///< by the board
        bool isBroken = false;   ///< it ends before
    };
    double m_setpoint = 0.0;
    double m_sent = 0.0; ///< of it, what the board has as its set-point; ramps have moved the rest
    /// Motion of an axis that is not chosen.
    struct AxisMotion {
        double setpoint = 0.0, sent = 0.0;
        std::optional<double> origin;
        ReferenceHold reference;
    };
    devices::AxisSpec m_axis;
    std::map<std::string, AxisMotion> m_others; ///< by axis
    std::optional<Way> m_way;
    std::optional<std::pair<double, double>> m_next; ///< set-point and speed, when the way has ended
    std::optional<double> m_origin_rad;
    bool m_isOriginOfMode = false;
    bool m_awaitsOrigin = false;
    std::optional<double> m_staleSample_s; ///< the angle's last sample before: a newer one is waited for
    ReferenceHold m_reference;
    std::optional<double> m_startedShape;
    bool m_hasConsent = false;
    bool m_isAsking = false;
    bool m_wasArmed = false;
    bool m_isJogPending = false;
    std::uint64_t m_changes = 0;
    std::uint64_t m_pending = 0; ///< the newest change without an answer; they are answered in order
    double m_jogRate = 0.0;
    QTimer m_jog;
    QElapsedTimer m_sinceJogStep; ///< not valid before the first
    QElapsedTimer m_jogged;
    std::optional<double> m_jogRoom_rad; ///< when it began; nothing without an end
};

} // namespace halbench::app
