#include "app/window/task_flow.h"

#include "app/window/dock_layout.h"
#include "app/window/file_dialogs.h"
#include "app/wizards/calibrate_panel.h"
#include "app/wizards/identify_panel.h"
#include "app/workspaces/tune_panel.h"
#include "control/base/assert.h"

namespace halbench::app {
namespace {

template <typename Panel>
Panel* panelOf(DockLayout& docks, const char* id) {
    return qobject_cast<Panel*>(docks.panel(QString::fromLatin1(id)));
}

} // namespace

void connectTaskFlow(DockLayout& docks, Workbench& bench) {
    auto* identify = panelOf<IdentifyPanel>(docks, "identify");
    auto* calibrate = panelOf<CalibratePanel>(docks, "calibrate");
    auto* tune = panelOf<TunePanel>(docks, "tune");
    HB_ASSERT(identify != nullptr && calibrate != nullptr && tune != nullptr);
    QObject::connect(identify, &IdentifyPanel::tuneRequested, &docks,
                     [&docks] { docks.setPerspective(Perspective::Tune); });
    QObject::connect(tune, &TunePanel::identifyRequested, &docks,
                     [&docks] { docks.setPerspective(Perspective::Identify); });
    identify->setFileChooser(fileDialogs(bench));
    calibrate->setFileChooser(fileDialogs(bench));
    tune->setFileChooser(fileDialogs(bench));
}

} // namespace halbench::app
