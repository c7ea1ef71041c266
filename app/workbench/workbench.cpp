#include "app/workbench/workbench.h"

#include "app/actuators/actuator.h"
#include "app/documents/configuration_file.h"
#include "app/documents/result_documents.h"
#include "app/workbench/drive_control.h"
#include "app/workbench/piecewise_reading.h"
#include "app/workbench/recording_trigger.h"
#include "app/workbench/shared_results.h"
#include "app/workbench/shown_recording.h"
#include "app/workbench/signals/reference_mask.h"
#include "devices/history/page_file.h"

#include <algorithm>
#include <utility>

namespace halbench::app {

namespace {

/// Ten minutes of twelve signals at 1 kHz and their pyramids, with room to spare; what is older is on the
/// disk.
constexpr std::size_t HistoryBudget_bytes = 256U << 20U;

std::vector<std::string> parameterNames(const devices::Catalogue& catalogue) {
    std::vector<std::string> names;
    for (const ParameterSpec& spec : catalogue.parameters) {
        names.push_back(spec.name);
    }
    return names;
}

bool isSameDesign(const TuneResult& one, const TuneResult& other) {
    const auto text = [](const TuneResult& design) { return toJsonText(gainsBody(design)).value_or(""); };
    return text(one) == text(other);
}

std::vector<StreamLayout::Column> columnsOf(const devices::Catalogue& catalogue) {
    std::vector<StreamLayout::Column> columns;
    for (const SignalSpec& spec : catalogue.signals) {
        columns.push_back({spec.name, spec.unit});
    }
    return columns;
}

} // namespace

QString deviceKey(const devices::DeviceInfo& info) {
    const std::string key = info.model + info.id;
    const bool isNamed = !key.empty() && info.uri.find("a2l=") == std::string::npos;
    return QString::fromStdString(isNamed ? key : key + info.uri);
}

Workbench::Workbench(QObject* parent)
    : QObject(parent), m_history(HistoryBudget_bytes), m_results(std::make_unique<SharedResults>()),
      m_drive(std::make_unique<DriveControl>(*this)),
      m_recordingTrigger(std::make_unique<RecordingTrigger>(*this)),
      m_shownRecording(std::make_unique<ShownRecording>(*this)) {
    connect(&m_session, &DeviceSession::stateChanged, this, &Workbench::onSessionState);
    connect(&m_session, &DeviceSession::procedureChanged, this, [this] {
        if (m_session.procedure().isEmpty()) {
            if (m_isCurrentDriven) {
                drainSamples(); // the last of it
                m_isCurrentDriven = false;
            }
            readValues(true); // what the procedure wrote or restored
        }
    });
    connect(&m_stopLatch, &StopLatch::changed, this, [this] {
        if (std::exchange(m_wasStopped, m_stopLatch.isLatched()) && !m_wasStopped) {
            m_stopAsker.clear(); // who asked for the next one is not known yet
        }
    });
}

Workbench::~Workbench() {
    m_session.disconnect(this); // panels that hear of it may be gone already
    m_session.end();
}

void Workbench::setStopAsker(const QString& by) {
    if (!m_stopLatch.isLatched()) {
        m_stopAsker = by;
    }
}

void Workbench::setWallClock(const WallClock& clock) {
    m_wallClock = clock;
    m_recording.setWallClock(clock);
}

ResultHeader Workbench::beginResult(const std::string& schema) const {
    ResultHeader header;
    header.schema = schema;
    if (m_session.state() == SessionState::Connected) {
        header.device = m_session.info();
    }
    const bool isVirtual = header.device && header.device->isSimulated && m_session.pace().speed_ratio <= 0.0;
    if (!isVirtual) {
        header.started = m_wallClock().toString(Qt::ISODate).toStdString();
    }
    return header;
}

void Workbench::drainSamples() {
    settleHistory();
    const std::vector<TimedBlock> blocks = m_session.takeBlocks();
    if (!blocks.empty()) {
        m_shownRecording->leave(); // it is played now
    }
    // By hand the mode is known; what a procedure drives is drawn as it comes, unless that drives currents.
    const bool isAngle = !m_isCurrentDriven && (!m_session.procedure().isEmpty() ||
                                                m_drive->mode() == devices::BoardMode::Position);
    for (const TimedBlock& block : blocks) {
        show(*block.block, block.shift_s, isAngle);
        if (const auto held = m_history.range(); held && block.rows() > 0) {
            const double shift_s = held->end_s - block.end_s();
            m_recordingTrigger->shifts().note(block.begin_s() + shift_s, shift_s);
        }
    }
    if (!blocks.empty()) {
        m_freshness.samplesCame();
        samplesArrived();
    }
    sayHistoryTrouble();
}

void Workbench::show(const SampleBlock& block, double shift_s, bool isAngle) {
    BlockColumns columns;
    columns.shift_s = shift_s;
    hideReferenceMask(columns, block, m_session.catalogue(), isAngle);
    m_derived.addTo(columns, block);
    m_history.append(block, columns);
}

bool Workbench::settleHistory() {
    m_history.settle();
    return m_history.isBusy();
}

void Workbench::setHistoryPages(std::shared_ptr<devices::PageFile> pages) {
    m_pages = std::move(pages);
    m_isTroubleSaid = false;
    m_history.setStore(m_pages);
}

void Workbench::sayHistoryTrouble() {
    if (m_pages == nullptr || m_isTroubleSaid) {
        return;
    }
    if (const std::optional<Error> trouble = m_pages->trouble()) {
        m_isTroubleSaid = true;
        historyTroubled(*trouble);
    }
}

void Workbench::setPace(Pace pace) {
    m_pace = pace;
    m_session.setPace(pace);
    paceChanged();
}

void Workbench::clearHistory() {
    m_history.clear();
    samplesArrived();
}

std::optional<double> Workbench::deviceValue(const std::string& parameter) const {
    const auto found = m_values.find(parameter);
    return found == m_values.end() ? std::nullopt : std::optional(found->second);
}

Result<devices::Derivation> Workbench::derive(const devices::DerivedSignal& derived) const {
    return devices::deriveSignal(derived, columnsOf(m_session.catalogue()));
}

void Workbench::setDerivedSignals(std::vector<devices::DerivedSignal> list) {
    if (list != m_derivedList) {
        for (const devices::DerivedSignal& before : m_derivedList) {
            if (std::find(list.begin(), list.end(), before) == list.end()) {
                m_history.forget(before.name);
            }
        }
        m_derivedList = std::move(list);
        refreshCatalogue();
        derivedSignalsChanged();
    }
}

void Workbench::refreshCatalogue() {
    m_catalogue = m_session.catalogue();
    m_derived.set(m_derivedList, columnsOf(m_session.catalogue()));
    std::map<std::string, std::vector<std::string>> sources;
    for (const devices::DerivedSignals::Computed& computed : m_derived.computed()) {
        SignalSpec spec;
        spec.name = computed.signal.name;
        spec.unit = computed.signal.unit;
        spec.help = computed.signal.expression;
        m_catalogue.signals.push_back(std::move(spec));
        sources[computed.signal.name] = computed.sources;
    }
    m_liveSignals.setSources(std::move(sources));
}

void Workbench::onSessionState() {
    if (m_session.state() == SessionState::Connected) {
        refreshCatalogue();
    }
    if (m_session.state() == SessionState::Connected && m_session.returns() > 0) {
        onReturn();
    } else if (m_session.state() == SessionState::Connected) {
        clearHistory();
        m_values.clear(); // this device may lack names that the one before had
        m_formerValues.clear();
        m_differences.clear();
        refreshValues();
    } else if (m_session.state() == SessionState::Disconnected) {
        m_values.clear();
        valuesChanged();
    }
    deviceChanged();
}

/// The history stays, and so does what was wished before an earlier loss and is not decided yet.
void Workbench::onReturn() {
    if (m_formerValues.empty()) {
        m_formerValues = m_values;
        for (const ValueDifference& difference : m_differences) {
            m_formerValues[difference.name] = difference.before;
        }
    }
    readInPieces(m_session, parameterNames(m_session.catalogue()), [this](const DeviceValues& values) {
        takeValues(values, false);
        if (values) {
            compareValues();
        }
    });
}

void Workbench::compareValues() {
    m_differences.clear();
    for (const ParameterSpec& spec : m_session.catalogue().parameters) {
        const auto former = m_formerValues.find(spec.name);
        const double now = m_values[spec.name];
        if (isSetting(spec) && former != m_formerValues.end() && former->second != now) {
            m_differences.push_back({spec.name, former->second, now});
        }
    }
    m_formerValues.clear();
    valuesCompared();
}

void Workbench::acceptDifferences() {
    m_differences.clear();
    valuesCompared();
}

void Workbench::writeDifferencesBack(std::function<void(Result<void>)> then) {
    std::vector<ParameterValue> values;
    for (const ValueDifference& difference : m_differences) {
        values.push_back({difference.name, difference.before});
    }
    writeValues(std::move(values), [this, then = std::move(then)](const Result<void>& written) {
        if (written) {
            acceptDifferences();
        }
        then(written);
    });
}

bool Workbench::hasValues() const {
    return !m_values.empty() &&
           (m_session.state() == SessionState::Connected || m_session.isPlayedToTheEnd());
}

void Workbench::refreshValues() {
    readValues(false);
}

void Workbench::confirmValues() {
    readValues(true);
}

void Workbench::readValues(bool areOurs) {
    if (m_session.state() != SessionState::Connected) {
        return;
    }
    readInPieces(m_session, parameterNames(m_session.catalogue()),
                 [this, areOurs](const DeviceValues& values) { takeValues(values, areOurs); });
}

void Workbench::takeValues(const Result<std::vector<double>>& values, bool areOurs) {
    const std::vector<ParameterSpec>& specs = m_session.catalogue().parameters;
    if (!values || values->size() != specs.size()) {
        return; // the session says that the device is lost
    }
    for (std::size_t i = 0; i < specs.size(); ++i) {
        m_values[specs[i].name] = (*values)[i];
    }
    m_areValuesOurs = areOurs;
    m_recording.noteValues(m_values);
    forgetDecidedDifferences();
    valuesChanged();
}

/// One that was changed since is decided: it is neither shown nor written back any more.
void Workbench::forgetDecidedDifferences() {
    const auto isDecided = [this](const ValueDifference& difference) {
        return deviceValue(difference.name) != difference.now;
    };
    if (std::erase_if(m_differences, isDecided) > 0) {
        valuesCompared();
    }
}

void Workbench::writeValues(std::vector<ParameterValue> values, std::function<void(Result<void>)> then) {
    const auto outcome = std::make_shared<Result<void>>();
    m_session.request(
        [values = std::move(values)](devices::Device& device) { return writeChosenValues(device, values); },
        [outcome](const Result<void>& written) { *outcome = written; });
    readInPieces(m_session, parameterNames(m_session.catalogue()),
                 [this, outcome, then = std::move(then)](const DeviceValues& read) {
                     takeValues(read, true);
                     then(*outcome);
                 });
}

void Workbench::setDisplayUnits(const DisplayUnits& units) {
    if (units != m_displayUnits) {
        m_displayUnits = units;
        displayUnitsChanged();
    }
}

void Workbench::setStrayInterval95_T_per_A(std::optional<std::pair<double, double>> interval,
                                           std::vector<Finding> doubts) {
    if (interval != m_strayInterval95_T_per_A || doubts != m_calibrationDoubts) {
        m_strayInterval95_T_per_A = interval;
        m_calibrationDoubts = std::move(doubts);
        strayIntervalChanged();
    }
}

const std::optional<IdentifyResult>& Workbench::identification() const {
    return m_results->identification;
}

const Provenance& Workbench::provenance() const {
    return m_results->provenance;
}

const std::optional<TuneResult>& Workbench::design() const {
    return m_results->design;
}

bool Workbench::isDesignFromProject() const {
    return m_results->isDesignFromProject;
}

const ResultHeader& Workbench::designHeader() const {
    return m_results->designHeader;
}

void Workbench::setIdentification(std::optional<IdentifyResult> result) {
    setIdentification(std::move(result), {});
}

void Workbench::setIdentification(std::optional<IdentifyResult> result, Provenance provenance) {
    m_results->identification = std::move(result);
    m_results->provenance = std::move(provenance);
    if (!m_results->identification) {
        m_results->design.reset();
        m_results->isDesignFromProject = false;
    }
    identificationChanged();
}

void Workbench::setDesign(std::optional<TuneResult> design) {
    // The same design found anew, after values were read, is as old as it was.
    if (design && !(m_results->design && isSameDesign(*design, *m_results->design))) {
        m_results->designHeader = beginResult("halbench.gains/1");
        m_results->designHeader.device = m_results->provenance.header.device;
    }
    m_results->design = std::move(design);
    m_results->isDesignFromProject = false;
    designChanged();
}

void Workbench::setDesignOfProject(TuneResult design, const std::string& started) {
    m_results->designHeader = ResultHeader();
    m_results->designHeader.schema = "halbench.gains/1";
    m_results->designHeader.device = m_results->provenance.header.device;
    if (!started.empty()) {
        m_results->designHeader.started = started;
    }
    m_results->design = std::move(design);
    m_results->isDesignFromProject = true;
    designChanged();
}

} // namespace halbench::app
