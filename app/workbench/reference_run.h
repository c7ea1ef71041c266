#pragma once

#include "app/procedures/excite/move_reference.h"
#include "app/workbench/drive_axes.h"
#include "app/workbench/drive_commands.h"
#include "app/workbench/workbench.h"

#include <QObject>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace halbench::app {

/// The board's generator on the chosen axis: started, followed by the samples, ended. Thread: GUI.
class ReferenceRun : public QObject {
    Q_OBJECT

public:
    ReferenceRun(Workbench& bench, DriveCommands& commands, DriveAxes& axes, QObject* parent = nullptr)
        : QObject(parent), m_bench(bench), m_commands(commands), m_axes(axes) {}

    bool isRunning() const { return m_axes.motion().reference.isRunning(); }
    /// Its shape by the board's code; 0 when that is not known.
    std::size_t runningShape() const;
    /// A mode was entered.
    void forgetShape() { m_startedShape.reset(); }
    /// Twenty steps a second shake what a ramp of the board moves evenly, but a board that begins each
    /// reference where it was armed would leap back.
    bool rampsOnBoard() const;

    /// False, and told, where the board would leap back.
    bool admitsStart();
    void start(std::vector<ParameterValue> values);
    /// A path or table; its pieces are written first. Nothing else moves from here until it has begun.
    void startPath(const MoveReference& reference, const std::vector<std::string>& axes);
    /// Values of a ramp, without mode; the others hold. It counts as running from now on.
    std::vector<ParameterValue> beginRamp(double rate, double amplitude, double duration_s);
    void end();
    /// Newest samples. A ramp to a set-point is none of the position that is held beside it.
    void look(bool isDriven, bool isOnWay);

private:
    Workbench& m_bench;
    DriveCommands& m_commands;
    DriveAxes& m_axes;
    std::optional<double> m_startedShape;
    std::vector<std::string> m_pathAxes; ///< that the last path moved
};

} // namespace halbench::app
