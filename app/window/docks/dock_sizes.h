#pragma once

#include "app/window/docks/panels.h"

#include <QHash>

#include <optional>
#include <vector>

namespace ads {
class CDockAreaWidget;
class CDockManager;
class CDockWidget;
} // namespace ads

namespace halbench::app {

/// Sizes of the docked areas: panels beside the centre get what their text needs, the centre the rest, also
/// of a window that grows. Thread: GUI.
class DockSizes {
public:
    DockSizes(const std::vector<PanelSpec>& specs, const QHash<QString, ads::CDockWidget*>& docks)
        : m_specs(specs), m_docks(docks) {}

    /// Null while all its panels are closed.
    ads::CDockAreaWidget* areaOf(PanelArea area) const;
    /// First sizes: the data get what the panels beside them do not need.
    void share(const ads::CDockManager& manager) const;
    /// A larger window enlarges the data, not what stands beside them.
    void growCentre(const ads::CDockManager& manager) const;

private:
    std::optional<int> firstLength(const QWidget& part, Qt::Orientation orientation) const;

    const std::vector<PanelSpec>& m_specs;
    const QHash<QString, ads::CDockWidget*>& m_docks;
};

} // namespace halbench::app
