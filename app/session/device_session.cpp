#include "app/session/device_session.h"

#include <QtCore/QLocale>

#include <utility>

namespace halbench::app {

namespace {

constexpr int HeartbeatPeriod_ms = 100;
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
    });
    m_heartbeat.start(HeartbeatPeriod_ms);
}

DeviceSession::~DeviceSession() {
    disconnectDevice();
}

void DeviceSession::connectDevice(const QString& uri, Pace pace, std::optional<std::uint64_t> seed) {
    disconnectDevice();
    m_pace = pace;
    m_report = {};
    devices::OpenOptions options;
    options.seed = seed;
    options.cacheFolder = devices::userCacheFolder();
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
                        tr("%1 more lines came too fast to be shown")
                            .arg(QLocale().toString(static_cast<qulonglong>(count))));
            }
        });
    };
    auto open = [address = uri.toStdString(), options] { return devices::openDevice(address, options); };
    {
        const std::lock_guard lock(m_connectionMutex);
        m_connection = std::make_unique<Connection>(std::move(open), pace, events());
    }
    setState(SessionState::Connecting);
    message(MessageLevel::Info, tr("connection"), tr("connecting %1").arg(uri));
}

void DeviceSession::disconnectDevice() {
    abortProcedure();
    endProcedureThread();
    ++m_generation;
    std::unique_ptr<Connection> leaving;
    {
        const std::lock_guard lock(m_connectionMutex);
        leaving = std::move(m_connection);
    }
    if (!leaving) {
        return;
    }
    leaving.reset();
    takeBlocks();
    setState(SessionState::Disconnected);
    message(MessageLevel::Info, tr("connection"), tr("disconnected"));
}

ConnectionEvents DeviceSession::events() {
    const std::uint64_t generation = m_generation;
    const auto say = [this, generation](auto function) {
        onGui([this, generation, function] {
            if (generation == m_generation) {
                function();
            }
        });
    };
    ConnectionEvents events;
    events.onOpened = [this, say](const devices::DeviceInfo& info, const devices::Catalogue& catalogue) {
        say([this, info, catalogue] { opened(info, catalogue); });
    };
    events.onRefused = [this, say](const Error& error) { say([this, error] { refused(error); }); };
    events.onReport = [this, say](const ConnectionReport& report) {
        say([this, report] { reported(report); });
    };
    events.onStreamRefused = [this, say](const Error& error) {
        say([this, error] {
            message(MessageLevel::Warning, tr("samples"),
                    QString::fromStdString(error.message + ". " + error.hint));
        });
    };
    events.onBlock = [this](SampleBlockPtr block) {
        m_inbox.push(block);
        devices::BlockSink sink;
        {
            const std::lock_guard lock(m_mutex);
            sink = m_blockSink;
        }
        if (sink) {
            sink(std::move(block));
        }
    };
    return events;
}

void DeviceSession::opened(const devices::DeviceInfo& info, const devices::Catalogue& catalogue) {
    m_info = info;
    m_catalogue = catalogue;
    setState(SessionState::Connected);
    message(MessageLevel::Info, tr("connection"),
            tr("connected %1, firmware %2")
                .arg(QString::fromStdString(info.id), QString::fromStdString(info.firmware)));
}

void DeviceSession::refused(const Error& error) {
    {
        const std::lock_guard lock(m_connectionMutex);
        m_connection.reset();
    }
    setState(SessionState::Disconnected);
    message(MessageLevel::Error, tr("connection"), QString::fromStdString(error.message));
    connectFailed(QString::fromStdString(error.message), QString::fromStdString(error.hint));
}

void DeviceSession::reported(const ConnectionReport& report) {
    const bool isNewlyLost = report.lost && !m_report.lost;
    const bool isNewlySilent = report.isStoppedForSilence && !m_report.isStoppedForSilence;
    m_report = report;
    if (isNewlyLost) {
        setState(SessionState::Lost);
        message(MessageLevel::Error, tr("connection"), QString::fromStdString(report.lost->message));
    }
    if (isNewlySilent) {
        message(MessageLevel::Error, tr("stop"),
                tr("the window did not answer while the actuator was armed, so it was stopped"));
    }
    reportChanged();
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

std::vector<SampleBlockPtr> DeviceSession::takeBlocks() {
    const std::uint64_t skipped = m_inbox.skippedRows();
    if (const std::uint64_t more = skipped - std::exchange(m_skippedRows, skipped); more > 0) {
        message(MessageLevel::Warning, tr("samples"),
                tr("%1 rows came faster than the window could show them and are not drawn")
                    .arg(QLocale().toString(static_cast<qulonglong>(more))));
    }
    return m_inbox.take();
}

void DeviceSession::setBlockSink(devices::BlockSink sink) {
    const std::lock_guard lock(m_mutex);
    m_blockSink = std::move(sink);
}

void DeviceSession::stopActuator() noexcept {
    const std::lock_guard lock(m_connectionMutex);
    if (m_connection) {
        m_connection->stop();
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
            return failure(ErrorCode::Interrupted, "ended by the user", "the old gains run again");
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
    m_procedureDevice = std::make_unique<SharedDevice>(*m_connection, m_info, m_catalogue);
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
    }
}

} // namespace halbench::app
