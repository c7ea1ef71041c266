#include "app/workbench/recording_control.h"

#include "app/recordings/name_reservation.h"
#include "app/workbench/recording_folders.h"
#include "widgets/language/display_units.h"
#include "widgets/language/phrasebook.h"

#include <QDir>
#include <QFileInfo>
#include <QPointer>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::app {

namespace {

constexpr double UsualRate_Hz = 100.0; ///< is lowered to what the device has, unasked
constexpr int RateDigits = 6;
constexpr int LookPeriod_ms = 100;

/// Rows as wished, or as dense as the stream can: a whole number of its rows apart.
double periodFor(double rate_Hz, double stream_Hz) {
    const double stride = std::max(1.0, std::round(stream_Hz / rate_Hz));
    return stride / stream_Hz;
}

StreamLayout layoutFor(const devices::Catalogue& catalogue, const std::vector<std::string>& names,
                       double period_s) {
    StreamLayout layout;
    layout.period_s = period_s;
    for (const std::string& name : names) {
        const SignalSpec* spec = catalogue.findSignal(name);
        layout.columns.push_back({name, spec != nullptr ? spec->unit : std::string()});
    }
    return layout;
}

/// A name from when it was found until its file has it, or nothing is recorded after all.
class NameHold : public QObject {
public:
    NameHold(RecordingControl& control, std::unique_ptr<QLockFile> lock)
        : QObject(&control), m_lock(std::move(lock)) {
        connect(&control, &RecordingControl::changed, this, [this, &control] {
            if (!control.isRecording() || control.status().rows > 0) {
                m_lock.reset();
                deleteLater();
            }
        });
    }

private:
    std::unique_ptr<QLockFile> m_lock;
};

} // namespace

RecordingControl::RecordingControl(DeviceSession& session, LiveSignals& liveSignals, QObject* parent)
    : QObject(parent), m_session(session), m_liveSignals(liveSignals), m_folder(defaultRecordingFolder()) {
    m_look.setInterval(LookPeriod_ms);
    connect(&m_look, &QTimer::timeout, this, &RecordingControl::look);
    connect(&m_session, &DeviceSession::stateChanged, this, &RecordingControl::onSession);
}

RecordingControl::~RecordingControl() {
    m_session.setBlockSink({});
}

void RecordingControl::setFolder(const QString& folder) {
    if (folder != m_folder) {
        m_folder = folder;
        Q_EMIT folderChanged();
    }
}

void RecordingControl::setNameMask(const QString& mask) {
    if (mask != m_nameMask) {
        m_nameMask = mask;
        Q_EMIT nameMaskChanged();
    }
}

/// Keeps rows while a start from before now is possible, and the signals of a recording among them, so that
/// the stream does not change when it starts.
void RecordingControl::hold() {
    const bool isHolding = m_preTrigger_s > 0.0 || m_isWaiting;
    m_feed->keep(isHolding ? std::optional(m_preTrigger_s) : std::nullopt);
    m_session.setBlockSink(
        isHolding ? TimedBlockSink([feed = m_feed](const TimedBlock& block) { feed->push(block); })
                  : TimedBlockSink());
    m_liveSignals.want(this, isHolding ? m_session.catalogue().defaultSignals : std::vector<std::string>());
    m_liveSignals.wantRate(this, isHolding ? m_rate_Hz : 0.0);
}

void RecordingControl::setRate_Hz(double rate_Hz) {
    m_rate_Hz = rate_Hz;
    if (!isRecording() && (m_preTrigger_s > 0.0 || m_isWaiting)) {
        m_liveSignals.wantRate(this, rate_Hz); // of the rows that are kept
    }
}

double RecordingControl::usedRate_Hz() const {
    return m_rate_Hz > 0.0 ? m_rate_Hz : m_liveSignals.rate_Hz();
}

void RecordingControl::setPreTrigger_s(double length_s) {
    if (length_s != m_preTrigger_s) {
        m_preTrigger_s = length_s;
        if (!isRecording()) {
            hold();
        }
        Q_EMIT changed();
    }
}

void RecordingControl::setChoice(const RecordingChoice& choice) {
    if (isRecording() || m_isWaiting) {
        return;
    }
    m_isAtEvent = choice.isAtTrigger;
    m_postTrigger_s = choice.after_s;
    setPreTrigger_s(choice.before_s);
    Q_EMIT choiceChanged();
    Q_EMIT changed();
}

double RecordingControl::held_s() const {
    const auto oldest_s = m_feed->oldest_s();
    const auto newest_s = m_feed->newest_s();
    return oldest_s && newest_s ? std::min(*newest_s - *oldest_s, m_preTrigger_s) : 0.0;
}

/// There is a device, and a file of its own for what comes.
bool RecordingControl::isReady() {
    if (m_session.state() != SessionState::Connected) {
        Q_EMIT failed(tr("Nothing to record."), tr("Connect a device first."));
        return false;
    }
    const double most_Hz = m_liveSignals.greatestRate_Hz(m_session.catalogue().defaultSignals);
    if (most_Hz > 0.0 && m_rate_Hz > std::max(most_Hz, UsualRate_Hz)) { // never of the plots' own rate
        Q_EMIT failed(tr("The plotted signals cannot be recorded at %1 Hz.").arg(m_rate_Hz),
                      tr("Maximum of device and link: %1 Hz. Choose a lower rate, or plot fewer signals.")
                          .arg(widgets::numberText(most_Hz, RateDigits)));
        return false;
    }
    const Result<QString> name = newName();
    if (!name) {
        Q_EMIT failed(widgets::inWords(name.error().message), widgets::inWords(name.error().hint));
        return false;
    }
    m_path = QDir(m_folder).filePath(*name + QStringLiteral(".csv"));
    if (QFileInfo::exists(m_path)) {
        Q_EMIT failed(tr("%1 exists already.").arg(m_path),
                      tr("Choose another name; existing recordings are not overwritten."));
        return false;
    }
    return true;
}

/// A name that the user wrote is taken as it is, or not at all; the mask finds a free one.
Result<QString> RecordingControl::newName() const {
    const bool isMasked = m_name.isEmpty() || m_nameMask.contains(QStringLiteral("{name}"));
    return isMasked ? recordingName(m_nameMask, {recordedDevice(m_session.info()), m_name, m_wallClock()},
                                    m_folder)
                    : legalFileName(m_name);
}

void RecordingControl::start() {
    if (isRecording() || m_isWaiting || !isReady()) {
        return;
    }
    m_event_s.reset();
    m_start_s.reset();
    if (m_isAtEvent) {
        m_isWaiting = true;
        if (m_preTrigger_s <= 0.0) {
            hold(); // what comes between the event and the moment in which it is seen
        }
        Q_EMIT changed();
        return;
    }
    m_start_s = m_feed->newest_s();
    prepare();
}

void RecordingControl::startAtEvent(double time_s) {
    if (!std::exchange(m_isWaiting, false)) {
        return;
    }
    if (!isReady()) {
        hold();
        Q_EMIT changed();
        return;
    }
    m_event_s = time_s;
    prepare();
}

void RecordingControl::prepare() {
    if (m_name.isEmpty() || m_nameMask.contains(QStringLiteral("{name}"))) {
        // Another program may have found the same name meanwhile: it gets the next one.
        Result<ReservedName> name = reserveRecordingName(
            m_nameMask, {recordedDevice(m_session.info()), m_name, m_wallClock()}, m_folder);
        if (!name) {
            hold();
            Q_EMIT failed(widgets::inWords(name.error().message), widgets::inWords(name.error().hint));
            Q_EMIT changed();
            return;
        }
        m_path = QDir(m_folder).filePath(name->name + QStringLiteral(".csv"));
        new NameHold(*this, std::move(name->hold));
    }
    m_liveSignals.want(this, m_session.catalogue().defaultSignals);
    m_liveSignals.wantRate(this, m_rate_Hz);
    m_liveSignals.setHeld(true); // its columns are those of now, and a stream that begins anew has a gap
    RecorderConfig config;
    config.path = m_path.toStdString();
    config.disk = m_disk;
    config.queue_rows = m_queue_rows;
    config.layout = layoutFor(m_session.catalogue(), m_liveSignals.streamed(),
                              periodFor(usedRate_Hz(), m_liveSignals.rate_Hz()));
    if (m_event_s && m_postTrigger_s > 0.0) {
        config.end_s = *m_event_s + m_postTrigger_s;
    }
    m_isStarting = true;
    const std::string automaticName =
        m_name.isEmpty() ? QFileInfo(m_path).completeBaseName().toStdString() : std::string();
    const std::string started = m_wallClock().toString(Qt::ISODate).toStdString();
    m_session.request(
        [layout = config.layout, started](devices::Device& device) -> Result<devices::RecordingMeta> {
            return devices::describeRecording(device, layout, started);
        },
        [self = QPointer(this), config, automaticName](const Result<devices::RecordingMeta>& meta) {
            if (!self || !self->m_isStarting) {
                return; // ended before it began
            }
            if (meta) {
                RecorderConfig complete = config;
                complete.meta = *meta;
                complete.meta.automaticName = automaticName;
                self->begin(std::move(complete));
            } else {
                self->stop();
                Q_EMIT self->failed(widgets::inWords(meta.error().message),
                                    widgets::inWords(meta.error().hint));
            }
        });
    Q_EMIT changed();
}

void RecordingControl::begin(RecorderConfig config) {
    m_isStarting = false;
    m_hasDropped = false;
    m_values.clear();
    for (const auto& note : config.meta.parameters) {
        m_values[note.name] = note.value;
    }
    config.queue_rows += m_feed->rows(); // these come at once
    m_recorder = std::make_shared<Recorder>(std::move(config));
    if (m_event_s) {
        m_recorder->addMarker(*m_event_s, "trigger");
    } else if (m_start_s) {
        m_recorder->addMarker(*m_start_s, "record");
    }
    m_feed->give(m_recorder, m_event_s.value_or(m_start_s.value_or(0.0)) - m_preTrigger_s);
    m_session.setBlockSink([feed = m_feed](const TimedBlock& block) { feed->push(block); });
    m_look.start();
    Q_EMIT changed();
}

void RecordingControl::stop() {
    m_isStarting = false;
    m_isWaiting = false;
    if (m_recorder) {
        m_recorder->finish();
        m_session.setBlockSink({});
    } else {
        hold();
        m_liveSignals.setHeld(false);
    }
    Q_EMIT changed();
}

RecorderStatus RecordingControl::status() const {
    return m_recorder ? m_recorder->status() : RecorderStatus();
}

/// A device that is looked for leaves a gap, with a marker at each of its ends. One that goes away for good
/// ends the recording; what came until then is kept.
void RecordingControl::onSession() {
    const bool isAway = m_session.state() == SessionState::Reconnecting;
    const bool isBack = m_session.state() == SessionState::Connected && m_session.returns() > 0;
    if (!isRecording() && !isAway && !isBack) {
        m_isWaiting = false;
        hold(); // of another device, or of none
        Q_EMIT changed();
    }
    if (!m_recorder || (m_session.state() != SessionState::Connected && !isAway)) {
        m_isInterrupted = false;
        if (isRecording()) {
            stop();
        }
        return;
    }
    if (isAway != m_isInterrupted) {
        m_isInterrupted = isAway;
        const double now_s = m_session.report().deviceTime_s;
        m_recorder->addMarker(now_s, isAway ? "connection lost" : "connection back");
    }
}

void RecordingControl::look() {
    const RecorderStatus status = m_recorder->status();
    if (status.droppedRows > 0 && !m_hasDropped) {
        m_hasDropped = true;
        Q_EMIT rowsDropped();
    }
    if (status.state == RecorderStatus::State::Done) {
        leave();
        Q_EMIT finished(m_path, status);
    } else if (status.state == RecorderStatus::State::Failed) {
        leave();
        const Error error = status.error.value_or(Error());
        Q_EMIT failed(widgets::inWords(error.message),
                      tr("%1. The data recorded until then are in %2.")
                          .arg(widgets::inWords(error.hint), m_path + QStringLiteral(".partial")));
    }
    Q_EMIT changed();
}

void RecordingControl::leave() {
    m_look.stop();
    m_recorder.reset();
    m_feed->leave();
    hold();
    m_liveSignals.setHeld(false); // one that ended by itself
}

void RecordingControl::addMarker(double time_s, const QString& text) {
    if (m_recorder) {
        m_recorder->addMarker(time_s, text.toStdString());
    }
}

void RecordingControl::noteValues(const std::map<std::string, double>& values) {
    if (!m_recorder) {
        return;
    }
    for (const auto& [name, value] : values) {
        const auto known = m_values.find(name);
        if (known != m_values.end() && known->second != value) {
            m_recorder->addChange(m_session.report().deviceTime_s, name, value);
            known->second = value;
        }
    }
}

} // namespace halbench::app
