#pragma once

#include "app/workbench/workbench.h"

#include <QString>
#include <QWidget>

#include <functional>
#include <optional>
#include <vector>

namespace halbench::app {

/// The five tasks that the window arranges its panels for.
enum class Perspective { Monitor, Identify, Tune, Record, Field };

inline constexpr Perspective AllPerspectives[] = {Perspective::Monitor, Perspective::Identify,
                                                  Perspective::Tune, Perspective::Record, Perspective::Field};

/// As the user reads it.
QString perspectiveTitle(Perspective perspective);
/// As files and preferences name it; stable.
QString perspectiveId(Perspective perspective);
/// Nothing for a name that is none.
std::optional<Perspective> perspectiveOf(const QString& id);

enum class PanelArea { Left, LeftBelow, Centre, Right, Bottom };

/// One panel of the window: who makes it, where it goes, in which perspectives it is open.
struct PanelSpec {
    QString id; ///< stable, in layout files
    QString title;
    PanelArea area = PanelArea::Centre;
    std::vector<Perspective> perspectives;
    QString helpAddress; ///< page and section of resources/help, as in English
    std::function<QWidget*(Workbench&)> make;
};

/// Monitors beside the first one, closed until the user opens them; a project keeps their plots by this.
inline constexpr const char* FurtherMonitors[] = {"monitor2", "monitor3"};

/// Every panel there is, in the order in which they are docked.
std::vector<PanelSpec> panelSpecs();

} // namespace halbench::app
