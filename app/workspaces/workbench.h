#pragma once

#include "app/procedures/identify_procedure.h"
#include "app/procedures/tune.h"
#include "app/session/device_session.h"
#include "control/signals/sample_history.h"

#include <QObject>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace halbench::app {

/// What all panels of the window share: the device, its samples and values, the identified motor, the design.
/// Thread: GUI.
class Workbench : public QObject {
    Q_OBJECT

public:
    explicit Workbench(QObject* parent = nullptr);
    ~Workbench() override;

    DeviceSession& session() { return m_session; }
    const control::SampleHistory& history() const { return m_history; }
    /// Moves what arrived into the history; called once per frame.
    void drainSamples();
    /// Forgets the samples, e.g. when another device comes.
    void clearHistory();

    /// Values on the device as last read; empty while no device is connected.
    const std::map<std::string, double>& deviceValues() const { return m_values; }
    std::optional<double> deviceValue(const std::string& parameter) const;
    void refreshValues();
    /// One transaction, then all values are read back; `then` gets the outcome, after valuesChanged().
    void writeValues(std::vector<ParameterValue> values, std::function<void(Result<void>)> then);

    const std::optional<IdentifyResult>& identification() const { return m_identification; }
    void setIdentification(std::optional<IdentifyResult> result);
    const std::optional<TuneResult>& design() const { return m_design; }
    void setDesign(std::optional<TuneResult> design);

Q_SIGNALS:
    void deviceChanged(); ///< connected, lost or gone
    void valuesChanged();
    void identificationChanged();
    void designChanged();
    void samplesArrived(); ///< at most once per frame

private:
    void onSessionState();
    void takeValues(const Result<std::vector<double>>& values);

    DeviceSession m_session;
    control::SampleHistory m_history;
    std::map<std::string, double> m_values;
    std::optional<IdentifyResult> m_identification;
    std::optional<TuneResult> m_design;
};

} // namespace halbench::app
