#include "app/session/device_session.h"

#include "app/session/disconnect_task.h"
#include "devices/open/open_device.h"
#include "devices/open/remembered_port.h"

#include <QtCore/QLocale>

#include <utility>

namespace halbench::app {

namespace {

constexpr int HeartbeatPeriod_ms = 100;
/// What a procedure that was asked to end gets for its own way of disarming.
constexpr int RestorePatience_ms = 300;
/// Two minutes at 1 kHz: a window that was suspended for less loses nothing.
constexpr std::size_t InboxCapacity_rows = 120000;

/// Log lines of a board on their way to the window: one that chatters must not keep it from its keys.
constexpr int MostWaitingLines = 200;

struct LineValve {
    std::atomic<int> waiting = 0;
    std::atomic<std::uint64_t> leftOut = 0;
};

} // namespace

DeviceSession::DeviceSession(QObject* parent) : QObject(parent), m_inbox(InboxCapacity_rows) {
    connect(&m_heartbeat, &QTimer::timeout, this, [this] {
        if (m_connection) {
            m_connection->confirmAlive();
        }
        if (m_held) {
            m_held->connection->confirmAlive();
        }
    });
    m_heartbeat.start(HeartbeatPeriod_ms);
}

DeviceSession::~DeviceSession() {
    end();
}

void DeviceSession::connectDevice(const QString& uri, Pace pace, std::optional<std::uint64_t> seed) {
    const Wish wish{uri, pace, seed};
    if (!m_connection && !m_held) {
        open(wish);
        return;
    }
    if (isHeldFor(wish)) {
        hold();
        open(wish);
        return;
    }
    m_next = wish;
    leave();
}

/// A procedure has the device for itself; the panels that open recordings wait for its end, and for
/// disarming.
bool DeviceSession::isHeldFor(const Wish& wish) const {
    return wish.isRecording() && m_state == SessionState::Connected && m_info.transport != "replay" &&
           m_procedure.isEmpty() && !m_held;
}

void DeviceSession::hold() {
    if (m_report.board.isArmed) {
        m_connection->post([](devices::Device& device) { (void)device.disarm(); });
    }
    m_connection->setLiveStream({});
    m_connection->setPace({0.0});
    auto held = std::make_unique<HeldDevice>();
    held->number = m_number;
    held->info = m_info;
    held->catalogue = m_catalogue;
    held->report = m_report;
    held->pace = m_pace;
    held->returns = m_returns;
    held->outage_s = m_outage_s;
    {
        const std::lock_guard lock(m_connectionMutex);
        held->connection = std::move(m_connection);
        m_held = std::move(held);
    }
    m_number = 0; // what it still sends belongs to nobody
    takeBlocks();
    setState(SessionState::Disconnected);
}

/// Its connection is the present one again.
std::unique_ptr<HeldDevice> DeviceSession::useHeld() {
    const std::lock_guard lock(m_connectionMutex);
    std::unique_ptr<HeldDevice> held = std::move(m_held);
    m_connection = std::move(held->connection);
    m_number = held->number;
    return held;
}

void DeviceSession::takeHeldBack() {
    const std::unique_ptr<HeldDevice> held = useHeld();
    m_info = held->info;
    m_catalogue = held->catalogue;
    m_report = held->report;
    m_returns = held->returns;
    m_outage_s = held->outage_s;
    setPace(held->pace);
    const SessionState away = m_report.isReturning ? SessionState::Reconnecting : SessionState::Lost;
    setState(m_report.lost ? away : SessionState::Connected);
    message(MessageLevel::Info, tr("connection"), tr("back to %1").arg(QString::fromStdString(m_info.id)));
}

void DeviceSession::closeRecording() {
    m_next.reset();
    leave();
}

void DeviceSession::open(const Wish& wish) {
    m_pace = wish.pace;
    m_report = {};
    m_returns = 0;
    const auto orders = std::make_shared<devices::LinkOrders>();
    const std::string address = wish.uri.toStdString();
    const devices::OpenOptions options = optionsFor(wish, orders);
    const auto port = std::make_shared<devices::RememberedPort>(); // the connection thread's
    const auto open = [address, options, port] {
        auto device = devices::openDevice(address, options);
        if (device && !(*device)->info().isSimulated) {
            *port = devices::rememberPort(address, devices::listDevices());
        }
        return device;
    };
    const auto reopen = [options, port]() -> Result<std::unique_ptr<devices::Device>> {
        const Result<std::string> now = devices::addressNow(*port, devices::listDevices());
        return now ? devices::openDevice(*now, options) : failure(now.error());
    };
    const bool hasLine = address.rfind("sim:", 0) != 0 && !wish.isRecording();
    const std::uint64_t number = ++m_lastNumber;
    m_number = number;
    {
        const std::lock_guard lock(m_connectionMutex);
        m_connection = std::make_unique<Connection>(
            open, wish.pace, events(number), Connection::UsualPatience_s, orders,
            hasLine ? std::optional<ReturnPlan>({reopen, m_returnTimes}) : std::nullopt);
    }
    setState(SessionState::Connecting);
    message(MessageLevel::Info, tr("connection"), tr("connecting %1").arg(wish.uri));
}

devices::OpenOptions DeviceSession::optionsFor(const Wish& wish,
                                               std::shared_ptr<devices::LinkOrders> orders) {
    devices::OpenOptions options;
    options.seed = wish.seed;
    options.orders = std::move(orders);
    options.cacheFolder = devices::userCacheFolder();
    options.onProgress = [this](double fraction) { onGui([this, fraction] { openProgress(fraction); }); };
    options.onMessage = [this, valve = std::make_shared<LineValve>()](const std::string& text) {
        if (valve->waiting >= MostWaitingLines) {
            ++valve->leftOut;
            return;
        }
        ++valve->waiting;
        onGui([this, valve, text] {
            --valve->waiting;
            message(MessageLevel::Info, tr("board"), QString::fromStdString(text));
            if (const std::uint64_t count = valve->leftOut.exchange(0); count > 0) {
                message(MessageLevel::Warning, tr("board"),
                        tr("%1 more messages not shown (too many at once)")
                            .arg(QLocale().toString(static_cast<qulonglong>(count))));
            }
        });
    };
    return options;
}

void DeviceSession::disconnectDevice() {
    m_next.reset();
    m_isLeavingAll = m_held != nullptr;
    leave();
}

/// The GUI thread must not wait for a fit, a board or a name server: Esc and the picture would be dead
/// meanwhile.
void DeviceSession::leave() {
    if (!m_connection || m_state == SessionState::Leaving) {
        return;
    }
    abortProcedure();
    if (report().board.isArmed) {
        message(MessageLevel::Info, tr("connection"), tr("armed: will be disarmed before disconnecting"));
    }
    setState(SessionState::Leaving);
    if (m_procedure.isEmpty()) {
        DisconnectTask::say(*this, *m_connection);
        m_connection->close();
    } else {
        QTimer::singleShot(RestorePatience_ms, this, &DeviceSession::disarmWhatStillRuns);
    }
}

/// A procedure that moves the actuator has disarmed it by now; a fit may take its time, and nothing stays
/// armed for it.
void DeviceSession::disarmWhatStillRuns() {
    if (m_state == SessionState::Leaving && !m_procedure.isEmpty()) {
        m_connection->post([](devices::Device& device) { (void)device.disarm(); });
    }
}

std::unique_ptr<Connection> DeviceSession::takeConnection() {
    const std::lock_guard lock(m_connectionMutex);
    return std::move(m_connection);
}

/// The last that a connection says.
void DeviceSession::left() {
    takeConnection().reset(); // its thread has nothing left to do
    takeBlocks();
    const bool isOther = m_next && !m_next->isRecording() && m_next->uri != heldDevice();
    if (m_held && (std::exchange(m_isLeavingAll, false) || isOther)) {
        useHeld(); // still leaving: first the recording, now the device
        DisconnectTask::say(*this, *m_connection);
        m_connection->close();
        return;
    }
    setState(SessionState::Disconnected);
    message(MessageLevel::Info, tr("connection"), tr("disconnected"));
    if (!m_connection) {
        goOn();
    }
}

/// After a device or a recording was left.
void DeviceSession::goOn() {
    if (m_held && (!m_next || !m_next->isRecording())) {
        m_next.reset();
        takeHeldBack();
    } else if (m_next) {
        open(*std::exchange(m_next, std::nullopt));
    }
}

void DeviceSession::end() {
    m_next.reset();
    abortProcedure();
    if (m_procedureThread.joinable()) {
        m_procedureThread.join();
        m_procedureDevice.reset();
        m_procedure.clear();
    }
    if (m_connection) {
        DisconnectTask::say(*this, *m_connection);
    }
    takeConnection().reset();
    if (m_held) {
        DisconnectTask::say(*this, *m_held->connection);
        const std::lock_guard lock(m_connectionMutex);
        m_held.reset();
    }
    m_state = SessionState::Disconnected;
}

/// Of the connection of this number, whether it is the present one or that of the held device.
ConnectionEvents DeviceSession::events(std::uint64_t number) {
    const auto say = [this, number](auto function, std::function<void(HeldDevice&)> held = {}) {
        onGui([this, number, function, held] {
            if (m_connection && m_number == number) { // not after end()
                function();
            } else if (m_held && m_held->number == number && held) {
                held(*m_held);
            }
        });
    };
    ConnectionEvents events;
    events.onOpened = [this, say](const devices::DeviceInfo& info, const devices::Catalogue& catalogue) {
        say([this, info, catalogue] { opened(info, catalogue); });
    };
    events.onRefused = [this, say](const Error& error) { say([this, error] { refused(error); }); };
    events.onReport = [this, say](const ConnectionReport& report) {
        say([this, report] { reported(report); }, [report](HeldDevice& held) { held.report = report; });
    };
    events.onReturned = [this, say](const devices::DeviceInfo& info, double outage_s, std::uint64_t returns) {
        say([this, info, outage_s, returns] { returned(info, outage_s, returns); },
            [info, outage_s, returns](HeldDevice& held) {
                held.info = info;
                held.outage_s = outage_s;
                held.returns = returns;
                held.report.lost.reset();
                held.report.isReturning = false;
            });
    };
    events.onClosed = [this, say] { say([this] { left(); }); };
    events.onStreamRefused = [this, say](const Error& error) {
        say([this, error] {
            message(MessageLevel::Warning, tr("samples"),
                    QString::fromStdString(error.message + ". " + error.hint));
        });
    };
    events.onBlock = [this, number](const TimedBlock& block) {
        if (m_number != number) {
            return; // a rest of the stream of the held device
        }
        m_inbox.push(block);
        TimedBlockSink sink;
        {
            const std::lock_guard lock(m_mutex);
            sink = m_blockSink;
        }
        if (sink) {
            sink(block);
        }
    };
    return events;
}

void DeviceSession::opened(const devices::DeviceInfo& info, const devices::Catalogue& catalogue) {
    if (m_state == SessionState::Leaving) {
        return;
    }
    m_info = info;
    m_catalogue = catalogue;
    setState(SessionState::Connected);
    message(MessageLevel::Info, tr("connection"),
            tr("connected %1, firmware %2")
                .arg(QString::fromStdString(info.id), QString::fromStdString(info.firmware)));
}

void DeviceSession::refused(const Error& error) {
    if (m_state == SessionState::Leaving) {
        left();
        return;
    }
    takeConnection().reset();
    setState(SessionState::Disconnected);
    message(MessageLevel::Error, tr("connection"), QString::fromStdString(error.message));
    connectFailed(QString::fromStdString(error.message), QString::fromStdString(error.hint));
    if (!m_connection) {
        goOn();
    }
}

void DeviceSession::reported(const ConnectionReport& report) {
    const bool isNewlyLost = report.lost && (!m_report.lost || m_report.isReturning != report.isReturning);
    const bool isNewlySilent = report.isStoppedForSilence && !m_report.isStoppedForSilence;
    m_report = report;
    if (isNewlyLost) {
        if (m_state != SessionState::Leaving) {
            setState(report.isReturning ? SessionState::Reconnecting : SessionState::Lost);
        }
        message(isPlayedToTheEnd() ? MessageLevel::Info : MessageLevel::Error, tr("connection"),
                QString::fromStdString(report.lost->message));
    }
    if (isNewlySilent) {
        message(MessageLevel::Error, tr("stop"), tr("Window not responding while armed: actuator stopped"));
    }
    reportChanged();
}

void DeviceSession::returned(const devices::DeviceInfo& info, double outage_s, std::uint64_t returns) {
    m_info = info; // its port may have another name now
    m_returns = returns;
    m_outage_s = outage_s;
    m_report.deviceTime_s += outage_s;
    m_report.lost.reset();
    m_report.isReturning = false;
    if (m_state == SessionState::Leaving) {
        return;
    }
    setState(SessionState::Connected);
    message(MessageLevel::Info, tr("connection"),
            tr("%1 reconnected after %2 s, disarmed")
                .arg(QString::fromStdString(m_info.id), QLocale().toString(outage_s, 'f', 1)));
}

void DeviceSession::setState(SessionState state) {
    if (state != m_state) {
        m_state = state;
        stateChanged();
    }
}

void DeviceSession::setPace(Pace pace) {
    m_pace = pace;
    if (m_connection) {
        m_connection->setPace(pace);
    }
}

void DeviceSession::setLiveStream(const std::vector<std::string>& signalNames, double rate_Hz) {
    if (m_connection) {
        m_connection->setLiveStream({signalNames, rate_Hz});
    }
}

std::vector<TimedBlock> DeviceSession::takeBlocks() {
    const std::uint64_t skipped = m_inbox.skippedRows();
    if (const std::uint64_t more = skipped - std::exchange(m_skippedRows, skipped); more > 0) {
        message(MessageLevel::Warning, tr("samples"),
                tr("%Ln sample(s) not shown: rate too high for the window", nullptr, static_cast<int>(more)));
    }
    return m_inbox.take();
}

void DeviceSession::setBlockSink(TimedBlockSink sink) {
    const std::lock_guard lock(m_mutex);
    m_blockSink = std::move(sink);
}

void DeviceSession::stopActuator() noexcept {
    const std::lock_guard lock(m_connectionMutex);
    if (m_connection) {
        m_connection->stop();
    }
    if (m_held) {
        m_held->connection->stop();
    }
    m_isAborting = true; // a procedure that only computes ends as well
}

ProcedureObserver DeviceSession::observer() {
    ProcedureObserver observer;
    observer.onState = [this](ProcedureState stage) { onGui([this, stage] { procedureStage(stage); }); };
    observer.onProgress = [this](double fraction, const std::string& text) {
        onGui([this, fraction, text] { procedureProgress(fraction, QString::fromStdString(text)); });
    };
    observer.checkAbort = [this]() -> Result<void> {
        if (m_isAborting) {
            return failure(ErrorCode::Interrupted, "cancelled by the user", "old gains restored");
        }
        return {};
    };
    return observer;
}

bool DeviceSession::startProcedure(const QString& name,
                                   std::function<void(devices::Device&, const ProcedureObserver&)> body) {
    if (m_state != SessionState::Connected || !m_procedure.isEmpty()) {
        return false;
    }
    m_isAborting = false;
    m_procedure = name;
    m_procedureDevice = std::make_unique<SharedDevice>(*m_connection, m_returns, m_info, m_catalogue);
    m_procedureThread = std::thread(
        [this, body = std::move(body), observer = observer()] { body(*m_procedureDevice, observer); });
    procedureChanged();
    return true;
}

void DeviceSession::abortProcedure() {
    m_isAborting = true;
}

void DeviceSession::endProcedureThread() {
    if (m_procedureThread.joinable()) {
        m_procedureThread.join();
        m_procedureDevice.reset();
        m_procedure.clear();
        procedureChanged();
        if (m_state == SessionState::Leaving) {
            DisconnectTask::say(*this, *m_connection);
            m_connection->close();
        }
    }
}

} // namespace halbench::app
