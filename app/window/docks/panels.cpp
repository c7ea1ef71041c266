#include "app/window/docks/panels.h"

#include "app/wizards/calibrate_panel.h"
#include "app/wizards/frequency_panel.h"
#include "app/wizards/identify_panel.h"
#include "app/wizards/relay_panel.h"
#include "app/workspaces/actuators/registry/actuator_panels.h"
#include "app/workspaces/analysis/spectrum_panel.h"
#include "app/workspaces/analysis/xy_panel.h"
#include "app/workspaces/device/configuration_panel.h"
#include "app/workspaces/device/device_panel.h"
#include "app/workspaces/device/log_panel.h"
#include "app/workspaces/device/notes_panel.h"
#include "app/workspaces/device/parameters_panel.h"
#include "app/workspaces/drive/drive_panel.h"
#include "app/workspaces/field/field_panel.h"
#include "app/workspaces/monitor/derived_panel.h"
#include "app/workspaces/monitor/monitor_panel.h"
#include "app/workspaces/monitor/signals_panel.h"
#include "app/workspaces/recordings/record_panel.h"
#include "app/workspaces/recordings/recordings_panel.h"
#include "app/workspaces/tune/tune_panel.h"

#include <QCoreApplication>

namespace halbench::app {

namespace {

QString words(const char* text) {
    return QCoreApplication::translate("Panels", text);
}

template <typename Panel>
QWidget* make(Workbench& bench) {
    return new Panel(bench);
}

QWidget* makeFurther(Workbench& bench) {
    return new MonitorPanel(bench, nullptr, MonitorPanel::Rank::Further);
}

constexpr unsigned in(Perspective perspective) {
    return 1U << static_cast<unsigned>(perspective);
}

constexpr unsigned Nowhere = 0; ///< until the user opens it

struct Row {
    const char* id;
    const char* title;
    PanelArea area;
    unsigned perspectives; ///< sum of in()
    const char* helpAddress;
    QWidget* (*make)(Workbench&);
    PanelNeed need = PanelNeed::Nothing;
};

constexpr Row Rows[] = {
    {"devices", QT_TRANSLATE_NOOP("Panels", "Devices"), PanelArea::Centre, in(Perspective::Monitor),
     "monitor.md#devices", make<DevicePanel>},
    {"signals", QT_TRANSLATE_NOOP("Panels", "Signals"), PanelArea::Left, Nowhere, "monitor.md#plots",
     make<SignalsPanel>},
    {"recordings", QT_TRANSLATE_NOOP("Panels", "Recordings"), PanelArea::Centre, in(Perspective::Record),
     "monitor.md#recordings", make<RecordingsPanel>},
    {"monitor", QT_TRANSLATE_NOOP("Panels", "Monitor"), PanelArea::Centre,
     in(Perspective::Monitor) | in(Perspective::Record), "monitor.md#plots", make<MonitorPanel>},
    {"monitor2", QT_TRANSLATE_NOOP("Panels", "Monitor 2"), PanelArea::Centre, Nowhere,
     "monitor.md#further-monitors", makeFurther},
    {"monitor3", QT_TRANSLATE_NOOP("Panels", "Monitor 3"), PanelArea::Centre, Nowhere,
     "monitor.md#further-monitors", makeFurther},
    {"spectrum", QT_TRANSLATE_NOOP("Panels", "Spectrum"), PanelArea::Centre, in(Perspective::Monitor),
     "monitor.md#spectrum", make<SpectrumPanel>},
    {"xy", QT_TRANSLATE_NOOP("Panels", "XY"), PanelArea::Centre, in(Perspective::Monitor), "monitor.md#xy",
     make<XyPanel>},
    {"field", QT_TRANSLATE_NOOP("Panels", "Field"), PanelArea::Centre, in(Perspective::Field),
     "monitor.md#field", make<FieldPanel>, PanelNeed::Picture},
    {"drive", QT_TRANSLATE_NOOP("Panels", "Drive"), PanelArea::Right, Nowhere, "monitor.md#drive",
     make<DrivePanel>, PanelNeed::Drive},
    {"parameters", QT_TRANSLATE_NOOP("Panels", "Parameters"), PanelArea::Right, Nowhere,
     "monitor.md#parameters", make<ParametersPanel>},
    {"configuration", QT_TRANSLATE_NOOP("Panels", "Configuration"), PanelArea::Right, Nowhere,
     "monitor.md#configuration", make<ConfigurationPanel>},
    {"record", QT_TRANSLATE_NOOP("Panels", "Record"), PanelArea::Right, in(Perspective::Record),
     "monitor.md#recording", make<RecordPanel>, PanelNeed::Recording},
    {"identify", QT_TRANSLATE_NOOP("Panels", "Identify"), PanelArea::Centre, in(Perspective::Identify),
     "identification.md#7-in-the-window", make<IdentifyPanel>, PanelNeed::Identification},
    {"calibrate", QT_TRANSLATE_NOOP("Panels", "Calibrate"), PanelArea::Centre, in(Perspective::Identify),
     "identification.md#6-calibrations", make<CalibratePanel>, PanelNeed::Calibration},
    {"frequency", QT_TRANSLATE_NOOP("Panels", "Frequency response"), PanelArea::Centre,
     in(Perspective::Identify), "identification.md#8-frequency-response", make<FrequencyPanel>,
     PanelNeed::Identification},
    {"relay", QT_TRANSLATE_NOOP("Panels", "Relay experiment"), PanelArea::Centre, in(Perspective::Identify),
     "identification.md#9-relay-experiment", make<RelayPanel>, PanelNeed::OneAxisIdentification},
    {"tune", QT_TRANSLATE_NOOP("Panels", "Tune"), PanelArea::Centre, in(Perspective::Tune),
     "tuning.md#in-the-window", make<TunePanel>, PanelNeed::ControlLoop},
    {"log", QT_TRANSLATE_NOOP("Panels", "Log"), PanelArea::Bottom, Nowhere,
     "monitor.md#stop-faults-a-device-that-fails", make<LogPanel>},
    {"derived", QT_TRANSLATE_NOOP("Panels", "Derived signals"), PanelArea::Bottom, Nowhere,
     "monitor.md#derived-signals", make<DerivedPanel>},
    {"notes", QT_TRANSLATE_NOOP("Panels", "Notes"), PanelArea::Bottom, Nowhere, "projects.md",
     make<NotesPanel>},
};

/// Beside the picture of the actuator.
PanelSpec ofActuator(const ActuatorPanel& panel) {
    const auto isMade = [&panel](const devices::Catalogue& catalogue) { return isMadeFor(panel, catalogue); };
    return {QString::fromStdString(panel.id),
            words(panel.title),
            PanelArea::Centre,
            {Perspective::Field},
            QString::fromLatin1(panel.helpAddress),
            PanelNeed::Nothing,
            isMade,
            panel.make};
}

} // namespace

std::vector<PanelSpec> panelSpecs() {
    std::vector<PanelSpec> specs;
    for (const Row& row : Rows) {
        PanelSpec spec{row.id, words(row.title), row.area, {}, row.helpAddress, row.need, {}, row.make};
        for (const Perspective perspective : AllPerspectives) {
            if ((row.perspectives & in(perspective)) != 0) {
                spec.perspectives.push_back(perspective);
            }
        }
        specs.push_back(std::move(spec));
    }
    for (const ActuatorPanel& panel : actuatorPanels()) {
        specs.push_back(ofActuator(panel));
    }
    return specs;
}

} // namespace halbench::app
