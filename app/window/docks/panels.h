#pragma once

#include "app/window/docks/panel_needs.h"
#include "app/window/docks/perspective.h"
#include "app/workbench/workbench.h"

#include <QString>
#include <QWidget>

#include <functional>
#include <vector>

namespace halbench::app {

enum class PanelArea { Left, Centre, Right, Bottom };

/// One panel of the window: who makes it, where it goes, in which perspectives it is open.
struct PanelSpec {
    QString id; ///< stable, in layout files
    QString title;
    PanelArea area = PanelArea::Centre;
    std::vector<Perspective> perspectives;
    QString helpAddress;                 ///< page and section of resources/help, as in English
    PanelNeed need = PanelNeed::Nothing; ///< of the open device; without one every panel is there
    std::function<bool(const devices::Catalogue&)> isMadeFor; ///< likewise, when given
    std::function<QWidget*(Workbench&)> make;
};

/// Every panel there is, in the order in which they are docked.
std::vector<PanelSpec> panelSpecs();

} // namespace halbench::app
