#include "app/window/panels.h"

#include "app/wizards/calibrate_panel.h"
#include "app/wizards/identify_panel.h"
#include "app/workspaces/configuration_panel.h"
#include "app/workspaces/device_panel.h"
#include "app/workspaces/drive_panel.h"
#include "app/workspaces/field_panel.h"
#include "app/workspaces/log_panel.h"
#include "app/workspaces/monitor_panel.h"
#include "app/workspaces/notes_panel.h"
#include "app/workspaces/parameters_panel.h"
#include "app/workspaces/record_panel.h"
#include "app/workspaces/signals_panel.h"
#include "app/workspaces/tune_panel.h"

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

std::vector<Perspective> everywhere() {
    return {std::begin(AllPerspectives), std::end(AllPerspectives)};
}

} // namespace

QString perspectiveTitle(Perspective perspective) {
    switch (perspective) {
    case Perspective::Monitor:
        return words(QT_TRANSLATE_NOOP("Panels", "Monitor"));
    case Perspective::Identify:
        return words(QT_TRANSLATE_NOOP("Panels", "Identify"));
    case Perspective::Tune:
        return words(QT_TRANSLATE_NOOP("Panels", "Tune"));
    case Perspective::Record:
        return words(QT_TRANSLATE_NOOP("Panels", "Record"));
    case Perspective::Field:
        break;
    }
    return words(QT_TRANSLATE_NOOP("Panels", "Field && Pose"));
}

QString perspectiveId(Perspective perspective) {
    constexpr const char* Ids[] = {"monitor", "identify", "tune", "record", "field"};
    return Ids[static_cast<std::size_t>(perspective)];
}

std::vector<PanelSpec> panelSpecs() {
    return {
        {"devices", words(QT_TRANSLATE_NOOP("Panels", "Devices")), PanelArea::Left, everywhere(),
         "command-line.md", make<DevicePanel>},
        {"signals", words(QT_TRANSLATE_NOOP("Panels", "Signals")), PanelArea::LeftBelow, everywhere(),
         "monitor.md", make<SignalsPanel>},
        {"monitor",
         words(QT_TRANSLATE_NOOP("Panels", "Monitor")),
         PanelArea::Centre,
         {Perspective::Monitor, Perspective::Record},
         "monitor.md",
         make<MonitorPanel>},
        {"field",
         words(QT_TRANSLATE_NOOP("Panels", "Field")),
         PanelArea::Centre,
         {Perspective::Field},
         "monitor.md",
         make<FieldPanel>},
        {"drive",
         words(QT_TRANSLATE_NOOP("Panels", "Drive")),
         PanelArea::Right,
         {Perspective::Monitor},
         "monitor.md",
         make<DrivePanel>},
        {"parameters",
         words(QT_TRANSLATE_NOOP("Panels", "Parameters")),
         PanelArea::Right,
         {Perspective::Monitor, Perspective::Tune},
         "monitor.md",
         make<ParametersPanel>},
        {"configuration",
         words(QT_TRANSLATE_NOOP("Panels", "Configuration")),
         PanelArea::Right,
         {Perspective::Monitor, Perspective::Tune},
         "monitor.md",
         make<ConfigurationPanel>},
        {"record",
         words(QT_TRANSLATE_NOOP("Panels", "Record")),
         PanelArea::Right,
         {Perspective::Monitor, Perspective::Record},
         "monitor.md",
         make<RecordPanel>},
        {"identify",
         words(QT_TRANSLATE_NOOP("Panels", "Identify")),
         PanelArea::Centre,
         {Perspective::Identify},
         "identification.md",
         make<IdentifyPanel>},
        {"calibrate",
         words(QT_TRANSLATE_NOOP("Panels", "Calibrate")),
         PanelArea::Centre,
         {Perspective::Identify},
         "identification.md",
         make<CalibratePanel>},
        {"tune",
         words(QT_TRANSLATE_NOOP("Panels", "Tune")),
         PanelArea::Centre,
         {Perspective::Tune},
         "tuning.md",
         make<TunePanel>},
        {"log", words(QT_TRANSLATE_NOOP("Panels", "Log")), PanelArea::Bottom, everywhere(), "index.md",
         make<LogPanel>},
        {"notes", words(QT_TRANSLATE_NOOP("Panels", "Notes")), PanelArea::Bottom, everywhere(), "projects.md",
         make<NotesPanel>},
    };
}

} // namespace halbench::app
