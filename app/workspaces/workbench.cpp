#include "app/workspaces/workbench.h"

#include <utility>

namespace halbench::app {

namespace {

/// Ten minutes of twelve signals at 1 kHz and their pyramids, with room to spare.
constexpr std::size_t HistoryBudget_bytes = 256U << 20U;

std::vector<std::string> parameterNames(const devices::Catalogue& catalogue) {
    std::vector<std::string> names;
    for (const ParameterSpec& spec : catalogue.parameters) {
        names.push_back(spec.name);
    }
    return names;
}

} // namespace

Workbench::Workbench(QObject* parent) : QObject(parent), m_history(HistoryBudget_bytes) {
    connect(&m_session, &DeviceSession::stateChanged, this, &Workbench::onSessionState);
    connect(&m_session, &DeviceSession::procedureChanged, this, [this] {
        if (m_session.procedure().isEmpty()) {
            readValues(true); // what the procedure wrote or restored
        }
    });
}

Workbench::~Workbench() {
    m_session.disconnect(this); // panels that hear of it may be gone already
    m_session.disconnectDevice();
}

void Workbench::drainSamples() {
    const std::vector<SampleBlockPtr> blocks = m_session.takeBlocks();
    for (const SampleBlockPtr& block : blocks) {
        m_history.append(*block);
    }
    if (!blocks.empty()) {
        samplesArrived();
    }
}

void Workbench::clearHistory() {
    m_history.clear();
    samplesArrived();
}

std::optional<double> Workbench::deviceValue(const std::string& parameter) const {
    const auto found = m_values.find(parameter);
    return found == m_values.end() ? std::nullopt : std::optional(found->second);
}

void Workbench::onSessionState() {
    if (m_session.state() == SessionState::Connected) {
        clearHistory();
        refreshValues();
    } else if (m_session.state() == SessionState::Disconnected) {
        m_values.clear();
        valuesChanged();
    }
    deviceChanged();
}

void Workbench::refreshValues() {
    readValues(false);
}

void Workbench::readValues(bool areOurs) {
    if (m_session.state() != SessionState::Connected) {
        return;
    }
    m_session.request([names = parameterNames(m_session.catalogue())](
                          devices::Device& device) { return device.readParameters(names); },
                      [this, areOurs](Result<std::vector<double>> values) { takeValues(values, areOurs); });
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
    valuesChanged();
}

void Workbench::writeValues(std::vector<ParameterValue> values, std::function<void(Result<void>)> then) {
    const auto names = parameterNames(m_session.catalogue());
    struct Outcome {
        Result<void> written;
        Result<std::vector<double>> values;
    };
    const auto outcome = std::make_shared<Outcome>();
    m_session.request(
        [=](devices::Device& device) -> Result<void> {
            outcome->written = device.writeParameters(values);
            outcome->values = device.readParameters(names);
            return outcome->written;
        },
        [this, outcome, then](Result<void> written) {
            takeValues(outcome->values, true);
            then(std::move(written));
        });
}

void Workbench::setDisplayUnits(const DisplayUnits& units) {
    if (units != m_displayUnits) {
        m_displayUnits = units;
        displayUnitsChanged();
    }
}

void Workbench::setIdentification(std::optional<IdentifyResult> result, Provenance provenance) {
    m_identification = std::move(result);
    m_provenance = std::move(provenance);
    if (!m_identification) {
        m_design.reset();
        m_isDesignFromProject = false;
    }
    identificationChanged();
}

void Workbench::setDesign(std::optional<TuneResult> design, bool isFromProject) {
    m_design = std::move(design);
    m_isDesignFromProject = isFromProject;
    designChanged();
}

} // namespace halbench::app
