#pragma once

#include "app/workbench/drive_axes.h"
#include "app/workbench/drive_commands.h"
#include "app/workbench/reference_run.h"
#include "app/workbench/workbench.h"

#include <QObject>

#include <optional>
#include <utility>

namespace halbench::app {

/// The way of the set-point of the chosen axis: a short one is a step of the loop, a long one an even ramp of
/// the board, no leap. Thread: GUI.
class SetpointMotion : public QObject {
    Q_OBJECT

public:
    static constexpr double LargestStep_deg = 30.0; ///< of an axis that turns for ever

    SetpointMotion(Workbench& bench, DriveCommands& commands, DriveAxes& axes, ReferenceRun& reference,
                   QObject* parent = nullptr);

    bool isOnWay() const { return m_way.has_value(); }
    /// Where it goes: another than the set-point while a ramp is on its way.
    double goal() const;
    double largestStep() const; ///< in the unit of the axis
    /// Position mode: too far for a step.
    bool isLeap(double value) const;
    void set(double value, double ramp_rad_s);

    /// The newest samples of the reference. A way that has ended may have another behind it, which is begun
    /// where `canMove`.
    void follow(bool canMove);
    /// Another motion takes over where the ramp is.
    void leave();
    /// The reference ends before the way does.
    void breakOff();
    /// The same, and no other way follows.
    void giveUp();
    void clear();

private:
    /// A ramp of the board that carries the set-point to another one.
    struct Way {
        double from_rad, to_rad;
        bool isAnswered = false; ///< by the board
        bool isBroken = false;   ///< it ends before
    };

    void sendStep(double value);
    void sendRamp(double value, double ramp_rad_s);
    void refuseLeap();
    double reached() const;

    Workbench& m_bench;
    DriveCommands& m_commands;
    DriveAxes& m_axes;
    ReferenceRun& m_reference;
    std::optional<Way> m_way;
    std::optional<std::pair<double, double>> m_next; ///< set-point and speed, when the way has ended
};

} // namespace halbench::app
