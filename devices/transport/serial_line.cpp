#include "devices/transport/serial_line.h"

#include "devices/transport/port_access.h"

#include <QtSerialPort/QSerialPort>

#include <fmt/format.h>
#include <linux/serial.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>

namespace halbench::devices {

namespace {

/// With more than this on its way the other side takes nothing: a command is given up after a time.
constexpr std::size_t MaxWaiting = 16384;
constexpr std::chrono::milliseconds SendTimeout{500};
constexpr int MaxReadsAtOnce = 64; // of up to 512 octets
constexpr const char* PluggedHint = "check the cable and that the device is on";

/// Asks the driver not to collect octets; pseudo terminals and CDC-ACM do not know the question.
void setLowLatency(int descriptor) {
    serial_struct line{};
    if (::ioctl(descriptor, TIOCGSERIAL, &line) == 0) {
        line.flags |= ASYNC_LOW_LATENCY;
        (void)::ioctl(descriptor, TIOCSSERIAL, &line);
    }
}

/// What ends the connection. A time-out or an unknown question (DTR of a pseudo terminal) does not.
bool isFatal(QSerialPort::SerialPortError error) {
    return error == QSerialPort::ReadError || error == QSerialPort::WriteError ||
           error == QSerialPort::ResourceError;
}

} // namespace

SerialPort::Line::~Line() {
    {
        const std::lock_guard lock(m_mutex);
        m_isEnding = true;
    }
    wake();
    if (m_thread) {
        m_ended.get_future().wait();
        m_thread->wait();
    }
}

void SerialPort::Line::wake() {
    const std::uint64_t one = 1;
    if (m_wake.isOpen()) {
        (void)!::write(m_wake.number(), &one, sizeof one);
    }
}

Result<void> SerialPort::Line::start() {
    m_wake = Descriptor(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC));
    m_thread.reset(QThread::create([this] { run(); }));
    m_thread->start();
    return m_opened.get_future().get();
}

Result<void> SerialPort::Line::openPort(QSerialPort& port) const {
    const std::string description = "serial:" + m_settings.device;
    if (const std::optional<PortTrouble> trouble = troubleOf(m_settings.device)) {
        return failure(portError(description, *trouble));
    }
    port.setPortName(QString::fromStdString(m_settings.device));
    if (!port.open(QIODevice::ReadWrite)) {
        const bool isBusy = port.error() == QSerialPort::PermissionError;
        return failure(portError(description,
                                 isBusy ? busyTrouble(m_settings.device)
                                        : PortTrouble{port.errorString().toStdString(),
                                                      "give a serial port; 'halbench devices' lists them"}));
    }
    if (!port.setBaudRate(m_settings.baud)) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("{} does not support {} baud", description, m_settings.baud),
                       "use 115200 or a rate supported by the adapter");
    }
    if (m_settings.isLowLatency) {
        setLowLatency(port.handle());
    }
    if (m_settings.isDtrOn) {
        (void)port.setDataTerminalReady(*m_settings.isDtrOn); // pseudo terminals have no such line
    }
    port.clear();
    return {};
}

void SerialPort::Line::run() {
    QSerialPort port;
    Result<void> opened = openPort(port);
    const bool isOpen = opened.has_value();
    m_opened.set_value(std::move(opened));
    if (isOpen) {
        serve(port);
        port.close();
    }
    m_ended.set_value();
}

bool SerialPort::Line::isEnding() {
    const std::lock_guard lock(m_mutex);
    return m_isEnding;
}

void SerialPort::Line::serve(QSerialPort& port) {
    while (!isEnding()) {
        const bool isHungUp = !waitForTraffic(port);
        if (!isWrittenTo(port) || !isReadFrom(port) || isHungUp) {
            giveUp(); // and closes: a hung-up line tells its error without end, in some drivers
            return;
        }
    }
}

/// Until something arrives, can leave, or wake() was called; false when the line was hung up.
bool SerialPort::Line::waitForTraffic(const QSerialPort& port) const {
    const short wanted = port.bytesToWrite() > 0 ? POLLIN | POLLOUT : POLLIN;
    std::array<pollfd, 2> entries{pollfd{port.handle(), wanted, 0}, pollfd{m_wake.number(), POLLIN, 0}};
    if (::poll(entries.data(), entries.size(), -1) < 0) {
        return errno == EINTR;
    }
    if (entries[1].revents != 0) {
        std::uint64_t count = 0;
        (void)!::read(m_wake.number(), &count, sizeof count);
    }
    return (entries[0].revents & (POLLHUP | POLLERR | POLLNVAL)) == 0;
}

/// Takes in what is there, but no flood without end. What the port calls a time-out is nothing.
bool SerialPort::Line::isReadFrom(QSerialPort& port) {
    int reads = 0;
    do {
        const QByteArray octets = port.readAll();
        if (!octets.isEmpty()) {
            m_inbox->put({reinterpret_cast<const std::uint8_t*>(octets.constData()),
                          static_cast<std::size_t>(octets.size())});
        }
    } while (++reads < MaxReadsAtOnce && port.waitForReadyRead(0));
    return !isFatal(port.error());
}

bool SerialPort::Line::isWrittenTo(QSerialPort& port) {
    std::vector<std::uint8_t> octets;
    {
        const std::lock_guard lock(m_mutex);
        octets.swap(m_outgoing);
    }
    if (!octets.empty()) {
        port.write(reinterpret_cast<const char*>(octets.data()), static_cast<qint64>(octets.size()));
    }
    if (port.bytesToWrite() > 0) {
        (void)port.waitForBytesWritten(0); // a full line is no error here, as it is to flush()
    }
    {
        const std::lock_guard lock(m_mutex);
        m_inPort = static_cast<std::size_t>(port.bytesToWrite());
    }
    m_sent.notify_all();
    return !isFatal(port.error());
}

void SerialPort::Line::giveUp() {
    Error error{ErrorCode::DeviceLost,
                fmt::format("serial:{}: the device was unplugged or switched off", m_settings.device),
                PluggedHint};
    {
        const std::lock_guard lock(m_mutex);
        m_error = error;
    }
    m_sent.notify_all();
    m_inbox->fail(std::move(error));
}

Result<void> SerialPort::Line::write(std::span<const std::uint8_t> octets) {
    std::unique_lock lock(m_mutex);
    const auto canTake = [this] { return m_error || m_outgoing.size() + m_inPort < MaxWaiting; };
    if (!m_sent.wait_for(lock, SendTimeout, canTake)) {
        return failure(ErrorCode::DeviceLost,
                       fmt::format("serial:{}: the device accepts no more commands", m_settings.device),
                       PluggedHint);
    }
    if (m_error) {
        return failure(*m_error);
    }
    m_outgoing.insert(m_outgoing.end(), octets.begin(), octets.end());
    lock.unlock();
    wake();
    return {};
}

} // namespace halbench::devices
