#pragma once

#include "app/session/device_session.h"
#include "app/workbench/display_quantity.h"
#include "app/workbench/freshness.h"
#include "app/workbench/live_signals.h"
#include "app/workbench/recording_control.h"
#include "app/workbench/stop_latch.h"
#include "app/workbench/wall_clock.h"
#include "control/history/sample_history.h"
#include "devices/acquisition/derived_signals.h"

#include <QObject>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace halbench::devices {
class PageFile;
}

namespace halbench::app {

class DriveControl;
class RecordingTrigger;
class ShownRecording;
struct IdentifyResult;
struct Provenance;
struct ResultHeader;
struct SharedResults;
struct TuneResult;

/// A setting that is not what it was before its device was lost.
struct ValueDifference {
    std::string name;
    double before = 0.0;
    double now = 0.0; ///< on the device
};

/// Tells devices apart whose signals are others. A board of another maker may have neither model nor serial
/// number, and its names come from whatever file was chosen: its address stands for it.
QString deviceKey(const devices::DeviceInfo& info);

/// What all panels of the window share: the device, its samples and values, the identified motor, the design.
/// Thread: GUI.
class Workbench : public QObject {
    Q_OBJECT

public:
    explicit Workbench(QObject* parent = nullptr);
    ~Workbench() override;

    DeviceSession& session() { return m_session; }
    /// Whether a stop is latched, and its release.
    StopLatch& stopLatch() { return m_stopLatch; }
    /// Which control of this window asked for the stop that is latched ("by Esc"); empty when none did.
    const QString& stopAsker() const { return m_stopAsker; }
    void setStopAsker(const QString& by); ///< the first counts
    /// What the panels want to see of the device while no procedure streams.
    LiveSignals& liveSignals() { return m_liveSignals; }
    /// What the connected device has, and the signals that are derived from those.
    const devices::Catalogue& catalogue() const { return m_catalogue; }
    const std::vector<devices::DerivedSignal>& derivedSignals() const { return m_derivedList; }
    /// What the connected device makes of it. Errors: devices::deriveSignal().
    Result<devices::Derivation> derive(const devices::DerivedSignal& derived) const;
    /// Those that the device cannot give wait for one that can. What was computed by an expression that is
    /// no more is forgotten.
    void setDerivedSignals(std::vector<devices::DerivedSignal> list);
    /// Whether what is shown is still updated.
    const Freshness& freshness() const { return m_freshness; }
    /// Moving by hand, for every control that does.
    DriveControl& drive() { return *m_drive; }
    /// How time of a simulated device runs, now and when one is connected.
    Pace pace() const { return m_pace; }
    void setPace(Pace pace);
    /// Until the running procedure ends, what the board has as its reference is a current, shown as no angle.
    void setCurrentDriven() { m_isCurrentDriven = true; }
    /// The recording of the panel and of the window's action.
    RecordingControl& recording() { return m_recording; }
    /// What it waits for when it starts at an event.
    RecordingTrigger& recordingTrigger() { return *m_recordingTrigger; }
    void setWallClock(const WallClock& clock);
    QDateTime now() const { return m_wallClock(); } ///< on the wall
    /// All of a recording at once.
    ShownRecording& shownRecording() { return *m_shownRecording; }
    /// Header of a result that begins now, on the device if one is connected. Virtual time begins in 1970, so
    /// that equal seeds give the same bytes as in batch mode.
    ResultHeader beginResult(const std::string& schema) const;
    const control::SampleHistory& history() const { return m_history; }
    /// Moves what arrived into the history; called once per frame.
    void drainSamples();
    /// Puts samples into the history, with what is derived from them. `isAngle`: the reference is one.
    void show(const SampleBlock& block, double shift_s, bool isAngle);
    /// Takes over what was read back from the disk meanwhile. Whether rows come faster than it takes them.
    bool settleHistory();
    /// Where samples go that memory has no room for. Forgets those that are there.
    void setHistoryPages(std::shared_ptr<devices::PageFile> pages);
    /// Forgets the samples, e.g. when another device comes.
    void clearHistory();

    /// Values on the device as last read; empty while no device is connected.
    const std::map<std::string, double>& deviceValues() const { return m_values; }
    std::optional<double> deviceValue(const std::string& parameter) const;
    /// Whether deviceValues() are those of a device that is there, or of a recording, also after its end.
    bool hasValues() const;
    void refreshValues();
    /// The same after a write from here that did not read back: what differs is ours.
    void confirmValues();
    /// Whether what changed last in the values was written from here, by a panel or a procedure; otherwise
    /// it was found changed.
    bool areValuesOurs() const { return m_areValuesOurs; }
    /// One transaction, then all values are read back; `then` gets the outcome, after valuesChanged().
    void writeValues(std::vector<ParameterValue> values, std::function<void(Result<void>)> then);

    /// What a device that came back has otherwise than before, until the user has decided. Nothing of it is
    /// written by itself.
    const std::vector<ValueDifference>& differences() const { return m_differences; }
    /// The device's values count from now on.
    void acceptDifferences();
    /// Writes what it was before; `then` as in writeValues().
    void writeDifferencesBack(std::function<void(Result<void>)> then);

    /// Units of measured values, as the user prefers them.
    const DisplayUnits& displayUnits() const { return m_displayUnits; }
    void setDisplayUnits(const DisplayUnits& units);

    /// 95 % interval of the stray coefficient of the connected device, when it was calibrated.
    const std::optional<std::pair<double, double>>& strayInterval95_T_per_A() const {
        return m_strayInterval95_T_per_A;
    }
    /// `doubts`: of that calibration.
    void setStrayInterval95_T_per_A(std::optional<std::pair<double, double>> interval,
                                    std::vector<Finding> doubts = {});
    const std::vector<Finding>& calibrationDoubts() const { return m_calibrationDoubts; }

    // Types of the results: app/workbench/shared_results.h.
    const std::optional<IdentifyResult>& identification() const;
    /// Of the identification; it stays beside it.
    const Provenance& provenance() const;
    /// Without a motor there is no design either.
    void setIdentification(std::optional<IdentifyResult> result);
    void setIdentification(std::optional<IdentifyResult> result, Provenance provenance);
    const std::optional<TuneResult>& design() const;
    /// Gains that came with the project, until others are chosen.
    bool isDesignFromProject() const;
    void setDesign(std::optional<TuneResult> design);
    /// One that came with the project, made at the time that it says.
    void setDesignOfProject(TuneResult design, const std::string& started);
    /// Of the design: when it was made, for whose motor.
    const ResultHeader& designHeader() const;

Q_SIGNALS:
    void deviceChanged(); ///< connected, lost or gone
    void valuesChanged();
    void valuesCompared(); ///< with those before the loss; differences() may be empty
    void identificationChanged();
    void designChanged();
    void displayUnitsChanged();
    void derivedSignalsChanged();
    void strayIntervalChanged();
    void paceChanged();
    void historyTroubled(const halbench::Error& error); ///< once: samples are lost earlier than they should
    void samplesArrived();                              ///< at most once per frame

private:
    void sayHistoryTrouble();
    void onSessionState();
    void refreshCatalogue();
    void onReturn();
    void compareValues();
    void forgetDecidedDifferences();
    void readValues(bool areOurs);
    void takeValues(const Result<std::vector<double>>& values, bool areOurs);

    DeviceSession m_session;
    StopLatch m_stopLatch{m_session};
    QString m_stopAsker;
    bool m_wasStopped = false;
    Freshness m_freshness{m_session};
    LiveSignals m_liveSignals{m_session};
    RecordingControl m_recording{m_session, m_liveSignals};
    std::shared_ptr<devices::PageFile> m_pages; ///< of the history; may be none
    bool m_isTroubleSaid = false;
    control::SampleHistory m_history;
    std::vector<devices::DerivedSignal> m_derivedList;
    devices::DerivedSignals m_derived;
    devices::Catalogue m_catalogue;
    std::map<std::string, double> m_values;
    bool m_areValuesOurs = false;
    std::map<std::string, double> m_formerValues; ///< before the loss, until they are compared
    std::vector<ValueDifference> m_differences;
    DisplayUnits m_displayUnits;
    std::optional<std::pair<double, double>> m_strayInterval95_T_per_A;
    std::vector<Finding> m_calibrationDoubts;
    std::unique_ptr<SharedResults> m_results;
    WallClock m_wallClock = wallClock;
    Pace m_pace;
    bool m_isCurrentDriven = false;
    std::unique_ptr<DriveControl> m_drive;
    std::unique_ptr<RecordingTrigger> m_recordingTrigger;
    std::unique_ptr<ShownRecording> m_shownRecording;
};

} // namespace halbench::app
