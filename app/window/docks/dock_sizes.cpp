#include "app/window/docks/dock_sizes.h"

#include <QFontMetrics>
#include <qtadvanceddocking/DockAreaWidget.h>
#include <qtadvanceddocking/DockManager.h>
#include <qtadvanceddocking/DockSplitter.h>
#include <qtadvanceddocking/DockWidget.h>

#include <algorithm>

namespace halbench::app {

namespace {

/// First sizes in characters and lines of text; the centre gets the rest.
constexpr int LeftCharacters = 46;
constexpr int RightCharacters = 57;
constexpr int BottomLines = 10;
constexpr int LeastCentre_px = 400; ///< before the window is laid out

} // namespace

ads::CDockAreaWidget* DockSizes::areaOf(PanelArea area) const {
    for (const PanelSpec& spec : m_specs) {
        const auto placed = m_docks.find(spec.id);
        if (spec.area == area && placed != m_docks.end() && !(*placed)->isClosed()) {
            return (*placed)->dockAreaWidget();
        }
    }
    return nullptr;
}

/// How long this part of a splitter is at first; nothing for the part that gets the rest.
std::optional<int> DockSizes::firstLength(const QWidget& part, Qt::Orientation orientation) const {
    const auto holds = [&](PanelArea area) {
        const ads::CDockAreaWidget* there = areaOf(area);
        return there != nullptr && (there == &part || part.isAncestorOf(there));
    };
    const QFontMetrics metrics = part.fontMetrics();
    if (holds(PanelArea::Centre)) {
        return std::nullopt;
    }
    if (orientation == Qt::Horizontal) {
        return metrics.averageCharWidth() * (holds(PanelArea::Right) ? RightCharacters : LeftCharacters);
    }
    return metrics.height() * BottomLines;
}

void DockSizes::share(const ads::CDockManager& manager) const {
    for (auto* splitter : manager.findChildren<ads::CDockSplitter*>()) {
        const Qt::Orientation orientation = splitter->orientation();
        int rest_px = orientation == Qt::Horizontal ? splitter->width() : splitter->height();
        QList<int> sizes;
        for (int i = 0; i < splitter->count(); ++i) {
            sizes << firstLength(*splitter->widget(i), orientation).value_or(0);
            rest_px -= splitter->widget(i)->isHidden() ? 0 : sizes.last();
        }
        for (int& size : sizes) {
            size = size > 0 ? size : std::max(rest_px, LeastCentre_px);
        }
        splitter->setSizes(sizes);
    }
    growCentre(manager);
}

void DockSizes::growCentre(const ads::CDockManager& manager) const {
    for (auto* splitter : manager.findChildren<ads::CDockSplitter*>()) {
        for (int i = 0; i < splitter->count(); ++i) {
            const bool isFlexible = !firstLength(*splitter->widget(i), splitter->orientation());
            splitter->setStretchFactor(i, isFlexible ? 1 : 0);
        }
    }
}

} // namespace halbench::app
