#include "app/window/panel_connections.h"

#include "app/window/docks/dock_layout.h"
#include "app/window/docks/panels.h"
#include "app/window/file_dialogs.h"
#include "app/wizards/calibrate_panel.h"
#include "app/wizards/frequency_panel.h"
#include "app/wizards/identify_panel.h"
#include "app/wizards/relay_panel.h"
#include "app/workspaces/actuators/registry/actuator_panels.h"
#include "app/workspaces/analysis/spectrum_panel.h"
#include "app/workspaces/analysis/xy_panel.h"
#include "app/workspaces/device/configuration_panel.h"
#include "app/workspaces/device/device_panel.h"
#include "app/workspaces/device/parameters_panel.h"
#include "app/workspaces/drive/drive_panel.h"
#include "app/workspaces/field/field_panel.h"
#include "app/workspaces/monitor/derived_panel.h"
#include "app/workspaces/monitor/monitor_panel.h"
#include "app/workspaces/monitor/signals_panel.h"
#include "app/workspaces/recordings/record_panel.h"
#include "app/workspaces/recordings/recordings_panel.h"
#include "app/workspaces/tune/tune_panel.h"
#include "control/base/assert.h"

#include <qtadvanceddocking/DockWidget.h>

namespace halbench::app {
namespace {

template <typename Panel>
Panel* panelOf(DockLayout& docks, const char* id) {
    return qobject_cast<Panel*>(docks.panel(QString::fromLatin1(id)));
}

/// A moment is the same in every Monitor.
void shareMarkers(MonitorPanel& first, MonitorPanel& further) {
    QObject::connect(&first, &MonitorPanel::markersChanged, &further,
                     [&first, &further] { further.setMarkers(first.markers()); });
    QObject::connect(&further, &MonitorPanel::markersChanged, &first,
                     [&first, &further] { first.setMarkers(further.markers()); });
}

/// The signals at the left and the plots in the middle are of one mind.
void connectMonitor(DockLayout& docks) {
    auto* monitor = panelOf<MonitorPanel>(docks, "monitor");
    auto* signalList = panelOf<SignalsPanel>(docks, "signals");
    auto* devices = panelOf<DevicePanel>(docks, "devices");
    HB_ASSERT(monitor != nullptr && signalList != nullptr && devices != nullptr);
    QObject::connect(signalList, &SignalsPanel::plotRequested, monitor, &MonitorPanel::plot);
    QObject::connect(panelOf<DerivedPanel>(docks, "derived"), &DerivedPanel::plotRequested, monitor,
                     &MonitorPanel::plot);
    QObject::connect(monitor, &MonitorPanel::plottedChanged, signalList, &SignalsPanel::setPlotted);
    QObject::connect(monitor, &MonitorPanel::addSignalsRequested, signalList, [&docks, signalList] {
        docks.raise(QStringLiteral("signals"));
        signalList->setFocus(Qt::ShortcutFocusReason);
    });
    const auto connectMotor = [devices] {
        devices->setAddress(QStringLiteral("sim:htm"));
        devices->connectAddress();
    };
    QObject::connect(monitor, &MonitorPanel::connectRequested, devices, connectMotor);
    for (const char* id : FurtherMonitors) {
        auto* further = panelOf<MonitorPanel>(docks, id);
        ads::CDockWidget* dock = docks.docks().value(QString::fromLatin1(id));
        QObject::connect(further, &MonitorPanel::connectRequested, devices, connectMotor);
        QObject::connect(dock, &ads::CDockWidget::viewToggled, further, &MonitorPanel::setInUse);
        further->setInUse(!dock->isClosed());
        shareMarkers(*monitor, *further);
    }
    QObject::connect(panelOf<RecordPanel>(docks, "record"), &RecordPanel::marked, monitor,
                     &MonitorPanel::takeRecordedMarker);
    QObject::connect(panelOf<SpectrumPanel>(docks, "spectrum"), &SpectrumPanel::connectRequested, devices,
                     connectMotor);
    QObject::connect(panelOf<XyPanel>(docks, "xy"), &XyPanel::connectRequested, devices, connectMotor);
}

} // namespace

void connectPanelConnections(DockLayout& docks, Workbench& bench) {
    auto* identify = panelOf<IdentifyPanel>(docks, "identify");
    auto* calibrate = panelOf<CalibratePanel>(docks, "calibrate");
    auto* frequency = panelOf<FrequencyPanel>(docks, "frequency");
    auto* relay = panelOf<RelayPanel>(docks, "relay");
    auto* tune = panelOf<TunePanel>(docks, "tune");
    auto* configuration = panelOf<ConfigurationPanel>(docks, "configuration");
    HB_ASSERT(identify != nullptr && calibrate != nullptr && frequency != nullptr && relay != nullptr &&
              tune != nullptr && configuration != nullptr);
    QObject::connect(identify, &IdentifyPanel::tuneRequested, &docks,
                     [&docks] { docks.setPerspective(Perspective::Tune); });
    QObject::connect(identify, &IdentifyPanel::axesIdentified, tune, &TunePanel::useAxisModel);
    QObject::connect(frequency, &FrequencyPanel::useRequested, tune,
                     [&docks, tune](const FrequencyResult& result) {
                         docks.setPerspective(Perspective::Tune);
                         tune->useMeasured(measuredPlant(result));
                     });
    QObject::connect(frequency, &FrequencyPanel::axesUseRequested, tune,
                     [&docks, tune](const AxesFrequencyResult& result) {
                         docks.setPerspective(Perspective::Tune);
                         tune->useMeasuredAxes(result);
                     });
    QObject::connect(relay, &RelayPanel::useRequested, tune,
                     [&docks, tune](double gain_A_per_rad, double period_s) {
                         docks.setPerspective(Perspective::Tune);
                         tune->useUltimate(gain_A_per_rad, period_s);
                     });
    const auto identifyNext = [&docks] {
        docks.setPerspective(Perspective::Identify);
        docks.raise(QStringLiteral("identify"));
    };
    QObject::connect(tune, &TunePanel::identifyRequested, &docks, identifyNext);
    QObject::connect(calibrate, &CalibratePanel::identifyRequested, &docks, identifyNext);
    QObject::connect(tune, &TunePanel::savingRequested, &docks,
                     [&docks] { docks.raise(QStringLiteral("parameters")); });
    QObject::connect(tune, &TunePanel::drivingRequested, &docks, [&docks] {
        docks.setPerspective(Perspective::Monitor);
        docks.raise(QStringLiteral("drive"));
    });
    QObject::connect(panelOf<ParametersPanel>(docks, "parameters"), &ParametersPanel::savedInDevice, tune,
                     &TunePanel::onSavedInDevice);
    connectMonitor(docks);
    identify->setFileChooser(fileDialogs(bench));
    calibrate->setFileChooser(fileDialogs(bench));
    frequency->setFileChooser(fileDialogs(bench));
    relay->setFileChooser(fileDialogs(bench));
    tune->setFileChooser(fileDialogs(bench));
    configuration->setFileChooser(fileDialogs(bench));
    panelOf<FieldPanel>(docks, "field")->setFileChooser(fileDialogs(bench));
    for (const ActuatorPanel& panel : actuatorPanels()) {
        if (panel.setFileChooser) {
            panel.setFileChooser(*docks.panel(QString::fromStdString(panel.id)), fileDialogs(bench));
        }
    }
    panelOf<MonitorPanel>(docks, "monitor")->setFileChooser(fileDialogs(bench));
    for (const char* id : FurtherMonitors) {
        panelOf<MonitorPanel>(docks, id)->setFileChooser(fileDialogs(bench));
    }
    panelOf<SpectrumPanel>(docks, "spectrum")->setFileChooser(fileDialogs(bench));
    panelOf<XyPanel>(docks, "xy")->setFileChooser(fileDialogs(bench));
    auto* recordings = panelOf<RecordingsPanel>(docks, "recordings");
    recordings->setFileChooser(fileDialogs(bench));
    QObject::connect(recordings, &RecordingsPanel::whatIfRequested, tune,
                     [&docks, tune](const QString& path) {
                         docks.setPerspective(Perspective::Tune);
                         tune->useRecording(path);
                     });
    QObject::connect(recordings, &RecordingsPanel::played, &docks, [&docks] {
        ads::CDockWidget* monitor = docks.docks().value(QStringLiteral("monitor"));
        monitor->toggleView(true);
        monitor->setAsCurrentTab();
    });
    panelOf<DevicePanel>(docks, "devices")->setFileChooser(fileDialogs(bench));
    panelOf<DrivePanel>(docks, "drive")->setFileChooser(fileDialogs(bench));
}

} // namespace halbench::app
