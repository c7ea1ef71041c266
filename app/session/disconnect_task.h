#pragma once

#include "devices/device.h"

#include <QtCore/QObject>

#include <functional>

namespace halbench::app {

class Connection;

/// What is still to be done with a device that is left on purpose, by whoever changed something of it for a
/// while: on the connection thread, after a running procedure and before the device is disarmed and closed. A
/// child of its session; deleted, it does nothing.
class DisconnectTask : public QObject {
    Q_OBJECT

public:
    using Job = std::function<void(devices::Device&)>;

    DisconnectTask(QObject& session, Job job);

    /// Gives a connection those of its session; a device that is lost takes none.
    static void say(const QObject& session, Connection& connection);

private:
    const Job m_job;
};

} // namespace halbench::app
