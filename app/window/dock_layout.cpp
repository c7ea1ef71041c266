#include "app/window/dock_layout.h"

#include "widgets/icons.h"
#include "widgets/stop_button.h"
#include "widgets/theme_style.h"

#include <QGridLayout>
#include <qtadvanceddocking/DockAreaWidget.h>
#include <qtadvanceddocking/DockContainerWidget.h>
#include <qtadvanceddocking/DockManager.h>
#include <qtadvanceddocking/DockWidget.h>
#include <qtadvanceddocking/FloatingDockContainer.h>
#include <qtadvanceddocking/IconProvider.h>

#include <algorithm>

namespace halbench::app {

namespace {

/// Of the arrangement files; raised when panels change so that an old arrangement no longer fits.
constexpr int ArrangementVersion = 1;
/// Parts of the width, and of the height.
constexpr int LeftShare = 150;
constexpr int RightShare = 220;
constexpr int CentreShare = 830;
constexpr int BottomShare = 130;

ads::DockWidgetArea dockArea(PanelArea area) {
    switch (area) {
    case PanelArea::Left:
        return ads::LeftDockWidgetArea;
    case PanelArea::Right:
        return ads::RightDockWidgetArea;
    case PanelArea::Bottom:
        return ads::BottomDockWidgetArea;
    case PanelArea::Centre:
        break;
    }
    return ads::CenterDockWidgetArea;
}

void configureDocking() {
    using Manager = ads::CDockManager;
    Manager::setConfigFlags(Manager::DefaultOpaqueConfig);
    Manager::setConfigFlag(Manager::AllTabsHaveCloseButton, false);
    Manager::setConfigFlag(Manager::ActiveTabHasCloseButton, false);
    Manager::setConfigFlag(Manager::DockAreaHasCloseButton, false);
    Manager::setConfigFlag(Manager::FocusHighlighting, true);
    Manager::setConfigFlag(Manager::XmlCompressionEnabled, false); // layouts that can be compared
    Manager::iconProvider().registerCustomIcon(ads::DockAreaMenuIcon, widgets::themedIcon("chevron-down"));
    Manager::iconProvider().registerCustomIcon(ads::DockAreaUndockIcon, widgets::themedIcon("export"));
}

bool isIn(const PanelSpec& spec, Perspective perspective) {
    return std::find(spec.perspectives.begin(), spec.perspectives.end(), perspective) !=
           spec.perspectives.end();
}

} // namespace

DockLayout::DockLayout(Workbench& bench, QWidget* container) : QObject(container), m_specs(panelSpecs()) {
    configureDocking();
    m_manager = new ads::CDockManager(container);
    widgets::clearOwnSheet(*m_manager);
    for (const PanelArea area : {PanelArea::Centre, PanelArea::Left, PanelArea::Right, PanelArea::Bottom}) {
        for (const PanelSpec& spec : m_specs) {
            if (spec.area == area) {
                addPanel(spec, bench);
            }
        }
    }
    m_first = m_manager->saveState(ArrangementVersion);
    arrange(m_perspective);
    connect(m_manager, &ads::CDockManager::floatingWidgetCreated, this,
            [this](ads::CFloatingDockContainer* window) { addStop(*window); });
}

/// Below the panels, so that it never covers one; it goes with the floating window.
void DockLayout::addStop(ads::CFloatingDockContainer& window) {
    ads::CDockContainerWidget* panels = window.dockContainer();
    auto* stop = new widgets::StopButton(widgets::StopButton::Variant::Compact, panels);
    connect(stop, &widgets::StopButton::stopRequested, this, &DockLayout::stopRequested);
    auto* grid = static_cast<QGridLayout*>(panels->layout());
    grid->addWidget(stop, grid->rowCount(), 0, 1, grid->columnCount(), Qt::AlignRight);
}

QWidget* DockLayout::panel(const QString& id) const {
    return m_docks.value(id)->widget();
}

QWidget* DockLayout::widget() const {
    return m_manager;
}

void DockLayout::addPanel(const PanelSpec& spec, Workbench& bench) {
    auto* dock = new ads::CDockWidget(spec.title);
    dock->setObjectName(spec.id);
    dock->setWidget(spec.make(bench), ads::CDockWidget::ForceNoScrollArea);
    dock->setMinimumSizeHintMode(ads::CDockWidget::MinimumSizeHintFromContent);
    ads::CDockAreaWidget* neighbour = nullptr;
    for (const PanelSpec& other : m_specs) {
        const auto placed = m_docks.find(other.id);
        if (other.area == spec.area && placed != m_docks.end()) {
            neighbour = (*placed)->dockAreaWidget();
        }
    }
    if (neighbour != nullptr) {
        m_manager->addDockWidget(ads::CenterDockWidgetArea, dock, neighbour);
    } else {
        m_manager->addDockWidget(dockArea(spec.area), dock);
    }
    m_docks.insert(spec.id, dock);
}

void DockLayout::arrange(Perspective perspective) {
    for (const PanelSpec& spec : m_specs) {
        m_docks.value(spec.id)->toggleView(isIn(spec, perspective));
    }
    // Of panels behind each other the first of the list is in front.
    for (auto spec = m_specs.rbegin(); spec != m_specs.rend(); ++spec) {
        if (isIn(*spec, perspective)) {
            m_docks.value(spec->id)->setAsCurrentTab();
        }
    }
    shareSpace();
}

/// First shares of the window: the data get the most of it.
void DockLayout::shareSpace() {
    for (const PanelSpec& spec : m_specs) {
        ads::CDockWidget* dock = m_docks.value(spec.id);
        if (dock->isClosed() || dock->dockAreaWidget() == nullptr) {
            continue;
        }
        if (spec.area == PanelArea::Left) {
            m_manager->setSplitterSizes(dock->dockAreaWidget(), {LeftShare, CentreShare, RightShare});
        } else if (spec.area == PanelArea::Bottom) {
            m_manager->setSplitterSizes(dock->dockAreaWidget(), {CentreShare, BottomShare});
        }
    }
}

void DockLayout::setPerspective(Perspective perspective) {
    if (perspective == m_perspective) {
        return;
    }
    m_arrangements[perspectiveId(m_perspective)] = m_manager->saveState(ArrangementVersion);
    m_perspective = perspective;
    const QByteArray kept = m_arrangements.value(perspectiveId(perspective));
    if (kept.isEmpty() || !m_manager->restoreState(kept, ArrangementVersion)) {
        arrange(perspective);
    }
    perspectiveChanged();
}

void DockLayout::reset() {
    m_arrangements.clear();
    m_manager->restoreState(m_first, ArrangementVersion);
    arrange(m_perspective);
}

QString DockLayout::helpPageOf(const QWidget* widget) const {
    for (const PanelSpec& spec : m_specs) {
        if (widget != nullptr && m_docks.value(spec.id)->isAncestorOf(widget)) {
            return spec.helpPage;
        }
    }
    return {};
}

QHash<QString, QByteArray> DockLayout::arrangements() {
    m_arrangements[perspectiveId(m_perspective)] = m_manager->saveState(ArrangementVersion);
    return m_arrangements;
}

void DockLayout::setArrangements(const QHash<QString, QByteArray>& arrangements) {
    m_arrangements = arrangements;
    const QByteArray kept = m_arrangements.value(perspectiveId(m_perspective));
    if (!kept.isEmpty() && !m_manager->restoreState(kept, ArrangementVersion)) {
        m_arrangements.remove(perspectiveId(m_perspective));
        arrange(m_perspective);
    }
}

} // namespace halbench::app
