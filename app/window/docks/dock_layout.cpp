#include "app/window/docks/dock_layout.h"

#include "widgets/controls/stop_button.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme_style.h"

#include <QApplication>
#include <QFontMetrics>
#include <QGridLayout>
#include <qtadvanceddocking/DockAreaWidget.h>
#include <qtadvanceddocking/DockContainerWidget.h>
#include <qtadvanceddocking/DockManager.h>
#include <qtadvanceddocking/DockSplitter.h>
#include <qtadvanceddocking/DockWidget.h>
#include <qtadvanceddocking/FloatingDockContainer.h>
#include <qtadvanceddocking/IconProvider.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace halbench::app {

namespace {

/// Of the arrangement files; raised when panels change so that an old arrangement no longer fits.
constexpr int ArrangementVersion = 2;
/// First sizes in characters and lines of text; the centre gets the rest.
constexpr int LeftCharacters = 46;
constexpr int RightCharacters = 57;
constexpr int BottomLines = 10;
constexpr int DeviceLines = 16;
constexpr int LeastCentre_px = 400; ///< before the window is laid out

ads::DockWidgetArea dockArea(PanelArea area) {
    switch (area) {
    case PanelArea::LeftBelow:
        return ads::BottomDockWidgetArea;
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
    Manager::setConfigFlag(Manager::XmlCompressionEnabled, false); // layouts that can be compared,
    Manager::setConfigFlag(Manager::XmlAutoFormattingEnabled);     // line by line
    Manager::iconProvider().registerCustomIcon(ads::DockAreaMenuIcon, widgets::themedIcon("chevron-down"));
    Manager::iconProvider().registerCustomIcon(ads::DockAreaUndockIcon, widgets::themedIcon("export"));
}

bool isIn(const PanelSpec& spec, Perspective perspective) {
    return std::find(spec.perspectives.begin(), spec.perspectives.end(), perspective) !=
           spec.perspectives.end();
}

/// From a tool of a window the shortcuts of that window work, and they do not while a dialog is open: the
/// docking library makes it a window of its own, in which every one of them is dead.
void belongToWindow(ads::CFloatingDockContainer& window) {
    window.setWindowFlags((window.windowFlags() & ~Qt::WindowType_Mask) | Qt::Tool);
}

} // namespace

DockLayout::DockLayout(QWidget* container) : QObject(container), m_specs(panelSpecs()) {
    configureDocking();
    m_manager = new ads::CDockManager(container);
    widgets::clearOwnSheet(*m_manager);
    connect(m_manager, &ads::CDockManager::dockAreaCreated, this, &DockLayout::watchTabs);
    connect(m_manager, &ads::CDockManager::floatingWidgetCreated, this,
            [this](ads::CFloatingDockContainer* window) {
                belongToWindow(*window);
                addStop(*window);
            });
}

void DockLayout::furnish(Workbench& bench) {
    for (const PanelArea area :
         {PanelArea::Centre, PanelArea::Left, PanelArea::LeftBelow, PanelArea::Right, PanelArea::Bottom}) {
        for (const PanelSpec& spec : m_specs) {
            if (spec.area == area) {
                addPanel(spec, bench);
            }
        }
    }
    m_first = m_manager->saveState(ArrangementVersion);
    arrange(m_perspective);
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
    const ads::CDockWidget* dock = m_docks.value(id);
    return dock == nullptr ? nullptr : dock->widget();
}

QWidget* DockLayout::widget() const {
    return m_manager;
}

void DockLayout::addPanel(const PanelSpec& spec, Workbench& bench) {
    auto* dock = new ads::CDockWidget(spec.title);
    dock->setObjectName(spec.id);
    dock->setWidget(spec.make(bench), ads::CDockWidget::ForceNoScrollArea);
    // The docking library lets the widest panel of an area decide, also one that is not open: one that never
    // stands beside panels at the right has their room too.
    dock->setMinimumSizeHintMode(hasRightNeighbour(spec) ? ads::CDockWidget::MinimumSizeHintFromContent
                                                         : ads::CDockWidget::MinimumSizeHintFromDockWidget);
    ads::CDockAreaWidget* neighbour = nullptr;
    for (const PanelSpec& other : m_specs) {
        const auto placed = m_docks.find(other.id);
        if (other.area == spec.area && placed != m_docks.end()) {
            neighbour = (*placed)->dockAreaWidget();
        }
    }
    if (neighbour != nullptr) {
        m_manager->addDockWidget(ads::CenterDockWidgetArea, dock, neighbour);
    } else if (spec.area == PanelArea::LeftBelow) {
        m_manager->addDockWidget(dockArea(spec.area), dock, areaOf(PanelArea::Left));
    } else {
        m_manager->addDockWidget(dockArea(spec.area), dock);
    }
    m_docks.insert(spec.id, dock);
}

bool DockLayout::hasRightNeighbour(const PanelSpec& spec) const {
    return std::any_of(spec.perspectives.begin(), spec.perspectives.end(), [this](Perspective perspective) {
        return std::any_of(m_specs.begin(), m_specs.end(), [perspective](const PanelSpec& other) {
            return other.area == PanelArea::Right && isIn(other, perspective);
        });
    });
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

ads::CDockAreaWidget* DockLayout::areaOf(PanelArea area) const {
    for (const PanelSpec& spec : m_specs) {
        const auto placed = m_docks.find(spec.id);
        if (spec.area == area && placed != m_docks.end() && !(*placed)->isClosed()) {
            return (*placed)->dockAreaWidget();
        }
    }
    return nullptr;
}

/// How long this part of a splitter is at first; nothing for the part that gets the rest.
std::optional<int> DockLayout::firstLength(const QWidget& part, Qt::Orientation orientation) const {
    const auto holds = [&](PanelArea area) {
        const ads::CDockAreaWidget* there = areaOf(area);
        return there != nullptr && (there == &part || part.isAncestorOf(there));
    };
    const QFontMetrics metrics = m_manager->fontMetrics();
    if (holds(PanelArea::Centre)) {
        return std::nullopt;
    }
    if (orientation == Qt::Horizontal) {
        return metrics.averageCharWidth() * (holds(PanelArea::Right) ? RightCharacters : LeftCharacters);
    }
    if (holds(PanelArea::LeftBelow)) {
        return std::nullopt;
    }
    return metrics.height() * (holds(PanelArea::Bottom) ? BottomLines : DeviceLines);
}

/// First sizes: the data get what the panels beside them do not need.
void DockLayout::shareSpace() {
    for (auto* splitter : m_manager->findChildren<ads::CDockSplitter*>()) {
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
    growCentre();
}

/// A larger window enlarges the data, not what stands beside them.
void DockLayout::growCentre() {
    for (auto* splitter : m_manager->findChildren<ads::CDockSplitter*>()) {
        for (int i = 0; i < splitter->count(); ++i) {
            const bool isFlexible = !firstLength(*splitter->widget(i), splitter->orientation());
            splitter->setStretchFactor(i, isFlexible ? 1 : 0);
        }
    }
}

/// Focus stays where it was while that can be seen, else it goes to what is in the middle: never to STOP.
void DockLayout::keepFocus(QWidget* before) {
    if (before != nullptr && before->isVisible()) {
        before->setFocus(Qt::OtherFocusReason);
    } else if (before != nullptr) {
        focusCentre();
    }
}

/// The focus goes with the tab: left alone it goes to the window's first control, which disconnects.
void DockLayout::watchTabs(ads::CDockAreaWidget* area) {
    connect(area, &ads::CDockAreaWidget::currentChanging, this,
            [this, area] { m_hadFocus = area->isAncestorOf(QApplication::focusWidget()); });
    connect(area, &ads::CDockAreaWidget::currentChanged, this, [this, area] {
        const ads::CDockWidget* shown = area->currentDockWidget();
        if (std::exchange(m_hadFocus, false) && shown != nullptr &&
            !shown->isAncestorOf(QApplication::focusWidget())) {
            focusFirst(*shown->widget());
        }
    });
}

void DockLayout::focusCentre() {
    if (const ads::CDockAreaWidget* centre = areaOf(PanelArea::Centre)) {
        focusFirst(*centre->currentDockWidget()->widget());
    }
}

void DockLayout::focusFirst(QWidget& content) {
    QWidget* panel = &content;
    for (QWidget* next = panel->nextInFocusChain(); next != panel; next = next->nextInFocusChain()) {
        if (panel->isAncestorOf(next) && next->isVisible() && next->isEnabled() &&
            (next->focusPolicy() & Qt::TabFocus) != 0) {
            next->setFocus(Qt::OtherFocusReason);
            return;
        }
    }
}

void DockLayout::enterPerspective(Perspective perspective) {
    setPerspective(perspective);
    focusCentre();
}

void DockLayout::setPerspective(Perspective perspective) {
    if (perspective == m_perspective) {
        return;
    }
    if (m_docks.isEmpty()) {
        m_perspective = perspective;
        perspectiveChanged();
        return;
    }
    QWidget* focused =
        m_manager->isAncestorOf(QApplication::focusWidget()) ? QApplication::focusWidget() : nullptr;
    m_arrangements[perspectiveId(m_perspective)] = m_manager->saveState(ArrangementVersion);
    m_perspective = perspective;
    if (!restoreKept()) {
        arrange(perspective);
    }
    growCentre();
    keepFocus(focused);
    perspectiveChanged();
}

/// What cannot be shown is kept under a name of its own: the next saving would write over it.
bool DockLayout::restoreKept() {
    const QString id = perspectiveId(m_perspective);
    const QByteArray kept = m_arrangements.value(id);
    if (kept.isEmpty()) {
        return false;
    }
    const std::optional<ArrangementFault> fault = faultOf(kept, ArrangementVersion);
    if (!fault && m_manager->restoreState(kept, ArrangementVersion)) {
        return true;
    }
    const QString aside = unreadName(m_arrangements, id);
    m_arrangements.insert(aside, m_arrangements.take(id));
    arrangementUnread(m_perspective, fault.value_or(ArrangementFault::Damaged), aside);
    return false;
}

void DockLayout::reset() {
    for (const Perspective perspective : AllPerspectives) { // not what could not be shown
        m_arrangements.remove(perspectiveId(perspective));
    }
    m_manager->restoreState(m_first, ArrangementVersion);
    arrange(m_perspective);
}

QString DockLayout::helpAddressOf(const QWidget* widget) const {
    for (const PanelSpec& spec : m_specs) {
        if (widget != nullptr && m_docks.value(spec.id)->isAncestorOf(widget)) {
            return spec.helpAddress;
        }
    }
    return {};
}

QHash<QString, QByteArray> DockLayout::arrangements() {
    m_arrangements[perspectiveId(m_perspective)] = m_manager->saveState(ArrangementVersion);
    return m_arrangements;
}

/// Not through setPerspective(): that would keep what is on the screen now over what is to be shown.
void DockLayout::setArrangements(const QHash<QString, QByteArray>& arrangements,
                                 std::optional<Perspective> perspective) {
    QWidget* focused =
        m_manager->isAncestorOf(QApplication::focusWidget()) ? QApplication::focusWidget() : nullptr;
    const bool isOther = perspective && *perspective != m_perspective;
    m_perspective = perspective.value_or(m_perspective);
    m_arrangements = arrangements;
    const bool isKept = !m_arrangements.value(perspectiveId(m_perspective)).isEmpty();
    if (!restoreKept() && (isKept || isOther)) {
        arrange(m_perspective);
    }
    growCentre();
    if (isOther) {
        keepFocus(focused);
        perspectiveChanged();
    }
}

} // namespace halbench::app
