#pragma once

#include "app/workbench/workbench.h"
#include "control/base/result.h"
#include "devices/device.h"

#include <QObject>

#include <cstdint>
#include <functional>
#include <vector>

namespace halbench::app {

/// Commands of the Drive panel on their way to the device, and their answers. Nothing here waits. Thread:
/// GUI.
class DriveCommands : public QObject {
    Q_OBJECT

public:
    using Action = std::function<Result<void>(devices::Device&)>;

    explicit DriveCommands(Workbench& bench, QObject* parent = nullptr) : QObject(parent), m_bench(bench) {}

    /// `then` runs in this thread when the device has taken it; a failure is told instead.
    void run(Action action, std::function<void()> then);
    void write(std::vector<ParameterValue> values, std::function<void()> then);
    /// The same for what decides how a motion acts: until the board has answered nothing moves from here, and
    /// a stop that comes before its turn cancels it.
    void change(Action action, std::function<void()> then);
    bool isPending() const { return m_pending != 0; }
    /// Another device: its answers are not awaited.
    void forgetPending() { m_pending = 0; }
    /// Tells what became of a command that was sent by other ways.
    void finish(const Result<void>& done, const std::function<void()>& then);

Q_SIGNALS:
    void changed();
    void failed(const QString& text, const QString& remedy);
    void jogEnds(); ///< another command goes first, or one has failed

private:
    Workbench& m_bench;
    std::uint64_t m_changes = 0;
    std::uint64_t m_pending = 0; ///< the newest change without an answer; they are answered in order
};

} // namespace halbench::app
