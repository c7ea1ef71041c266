#pragma once

#include "devices/transport/descriptor.h"
#include "devices/transport/serial_port.h"

#include <QtCore/QThread>

#include <condition_variable>
#include <future>
#include <mutex>
#include <vector>

class QSerialPort;

namespace halbench::devices {

/// The thread of an open serial port, in which the port lives and dies. Others hand octets over and wake it.
/// It waits by itself instead of in an event loop, which would need an application object.
class SerialPort::Line {
public:
    Line(SerialSettings settings, OctetInbox& inbox) : m_settings(std::move(settings)), m_inbox(&inbox) {}
    ~Line();
    Line(const Line&) = delete;
    Line& operator=(const Line&) = delete;

    /// Starts the thread; returns when the port is open, or why not.
    Result<void> start();
    Result<void> write(std::span<const std::uint8_t> octets);

private:
    void run();
    Result<void> openPort(QSerialPort& port) const;
    void serve(QSerialPort& port);
    bool waitForTraffic(const QSerialPort& port) const;
    bool isReadFrom(QSerialPort& port);
    bool isWrittenTo(QSerialPort& port);
    bool isEnding();
    void giveUp();
    void wake();

    SerialSettings m_settings;
    OctetInbox* m_inbox;
    Descriptor m_wake; ///< an eventfd

    std::mutex m_mutex;
    std::condition_variable m_sent;
    std::vector<std::uint8_t> m_outgoing;
    std::size_t m_inPort = 0; ///< handed to the port and not yet on the wire
    bool m_isEnding = false;
    std::optional<Error> m_error;
    std::promise<Result<void>> m_opened;
    std::promise<void> m_ended; ///< nothing of this object is touched any more

    std::unique_ptr<QThread> m_thread; ///< Qt's own: a port warns in any other
};

} // namespace halbench::devices
