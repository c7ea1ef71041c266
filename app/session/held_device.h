#pragma once

#include "app/session/connection.h"

#include <QtCore/QString>

#include <cstdint>
#include <memory>

namespace halbench::app {

/// A connected device while a recording is open in its place: its connection goes on serving the link,
/// nothing streams, and the time of a simulated one stands still.
struct HeldDevice {
    std::unique_ptr<Connection> connection;
    std::uint64_t number = 0; ///< of the connection, which its events carry
    devices::DeviceInfo info;
    devices::Catalogue catalogue;
    ConnectionReport report; ///< the newest
    Pace pace;               ///< that it had
    std::uint64_t returns = 0;
    double outage_s = 0.0;

    QString address() const { return QString::fromStdString(info.uri); }
};

} // namespace halbench::app
