#pragma once

#include "app/workbench/drive_axes.h"
#include "app/workbench/drive_commands.h"
#include "app/workbench/reference_run.h"
#include "app/workbench/workbench.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <optional>
#include <vector>

namespace halbench::app {

/// Jogging of the chosen axis: a motion that ends when the key is let go, and on the board when nobody renews
/// it. Thread: GUI.
class DriveJog : public QObject {
    Q_OBJECT

public:
    DriveJog(Workbench& bench, DriveCommands& commands, DriveAxes& axes, ReferenceRun& reference,
             QObject* parent = nullptr);

    bool isActive() const { return m_timer.isActive(); }
    /// In the unit of the axis per second; in a current mode in A.
    void start(double rate);
    void stop() { m_timer.stop(); }
    /// Of another device: no answer is awaited.
    void forgetPending() { m_isPending = false; }
    /// The board has a motion that is to be ended: no set-point was moved.
    bool usesReference() const;

private:
    void step();
    void moveSetpoint();
    void send(std::vector<ParameterValue> values, double setpoint);
    double nextSetpoint(double step_s) const;
    std::optional<double> room() const;
    std::optional<std::vector<ParameterValue>> ramp() const;

    Workbench& m_bench;
    DriveCommands& m_commands;
    DriveAxes& m_axes;
    ReferenceRun& m_reference;
    QTimer m_timer;
    double m_rate = 0.0;
    bool m_isPending = false;
    QElapsedTimer m_sinceStep; ///< not valid before the first
    QElapsedTimer m_jogged;
    std::optional<double> m_room; ///< when it began; nothing without an end
};

} // namespace halbench::app
