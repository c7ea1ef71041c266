#include "app/window/docks/dock_layout.h"

#include "widgets/controls/stop_button.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme_style.h"

#include <QApplication>
#include <QGridLayout>
#include <qtadvanceddocking/DockAreaWidget.h>
#include <qtadvanceddocking/DockContainerWidget.h>
#include <qtadvanceddocking/DockManager.h>
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

/// What the docking library asks translations for, from the menus and tool tips of its tabs.
[[maybe_unused]] constexpr const char* LibraryWords[] = {
    QT_TRANSLATE_NOOP("QObject", "List All Tabs"),
    QT_TRANSLATE_NOOP("QObject", "Detach Group"),
    QT_TRANSLATE_NOOP("QObject", "Close Active Tab"),
    QT_TRANSLATE_NOOP("QObject", "Close Group"),
    QT_TRANSLATE_NOOP("QObject", "Close Tab"),
    QT_TRANSLATE_NOOP("ads::CDockAreaTitleBar", "List All Tabs"),
    QT_TRANSLATE_NOOP("ads::CDockAreaTitleBar", "Detach Group"),
    QT_TRANSLATE_NOOP("ads::CDockAreaTitleBar", "Close Active Tab"),
    QT_TRANSLATE_NOOP("ads::CDockAreaTitleBar", "Close Group"),
    QT_TRANSLATE_NOOP("ads::CDockAreaTitleBar", "Close Other Groups"),
    QT_TRANSLATE_NOOP("ads::CDockWidgetTab", "Detach"),
    QT_TRANSLATE_NOOP("ads::CDockWidgetTab", "Close"),
    QT_TRANSLATE_NOOP("ads::CDockWidgetTab", "Close Others"),
    QT_TRANSLATE_NOOP("ads::CDockWidgetTab", "Close Tab"),
};

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
    Manager::setConfigFlag(Manager::XmlCompressionEnabled, false); // layouts that can be compared,
    Manager::setConfigFlag(Manager::XmlAutoFormattingEnabled);     // line by line
    Manager::iconProvider().registerCustomIcon(ads::DockAreaMenuIcon, widgets::themedIcon("chevron-down"));
    Manager::iconProvider().registerCustomIcon(ads::DockAreaUndockIcon, widgets::themedIcon("detach"));
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

/// Whenever the main window becomes active the docking library puts floating windows above it. On X11 it does
/// so in place; elsewhere (Wayland, no display) by a window flag whose change hides them, with their STOP.
/// Tools of the window stay above it by themselves.
void leaveFloatingWindowsShown(QWidget& window, ads::CDockManager& manager) {
    if (QGuiApplication::platformName() != QLatin1String("xcb")) {
        window.removeEventFilter(&manager);
    }
}

} // namespace

DockLayout::DockLayout(QWidget* container) : QObject(container), m_specs(panelSpecs()) {
    configureDocking();
    m_manager = new ads::CDockManager(container);
    leaveFloatingWindowsShown(*container->window(), *m_manager);
    widgets::clearOwnSheet(*m_manager);
    connect(m_manager, &ads::CDockManager::dockAreaCreated, this, &DockLayout::watchTabs);
    connect(m_manager, &ads::CDockManager::floatingWidgetCreated, this,
            [this](ads::CFloatingDockContainer* window) {
                belongToWindow(*window);
                addStop(*window);
            });
}

void DockLayout::furnish(Workbench& bench) {
    for (const PanelArea area : {PanelArea::Centre, PanelArea::Left, PanelArea::Right, PanelArea::Bottom}) {
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
    } else {
        m_manager->addDockWidget(dockArea(spec.area), dock);
    }
    m_docks.insert(spec.id, dock);
}

bool DockLayout::hasRightNeighbour(const PanelSpec& spec) const {
    return isIn(spec, Perspective::Monitor) || isIn(spec, Perspective::Tune) ||
           isIn(spec, Perspective::Record);
}

void DockLayout::arrange(Perspective perspective) {
    m_withheld.forget();
    for (const PanelSpec& spec : m_specs) {
        m_docks.value(spec.id)->toggleView(isIn(spec, perspective));
    }
    // Of panels behind each other the first of the list is in front.
    for (auto spec = m_specs.rbegin(); spec != m_specs.rend(); ++spec) {
        if (isIn(*spec, perspective)) {
            m_docks.value(spec->id)->setAsCurrentTab();
        }
    }
    m_withheld.close();
    if (m_isDeviceOpen) {
        leaveStartPage();
    }
    m_sizes.share(*m_manager);
}

void DockLayout::leaveStartPage() {
    ads::CDockWidget* devices = m_docks.value(QStringLiteral("devices"));
    ads::CDockWidget* monitor = m_docks.value(QStringLiteral("monitor"));
    const ads::CDockAreaWidget* area = devices == nullptr ? nullptr : devices->dockAreaWidget();
    if (area != nullptr && !devices->isClosed() && !monitor->isClosed() &&
        area->currentDockWidget() == devices && area == monitor->dockAreaWidget()) {
        monitor->setAsCurrentTab();
    }
}

void DockLayout::setMainOnly(bool isOnly) {
    if (isOnly == isMainOnly() || m_docks.isEmpty()) {
        return;
    }
    if (isOnly) {
        m_beforeMainOnly = shownArrangement();
        const QString main = shownMain(m_perspective);
        unfold(main);
        for (ads::CDockWidget* dock : m_docks) {
            if (dock->objectName() != main && !dock->isClosed()) {
                dock->toggleView(false);
            }
        }
    } else {
        m_withheld.forget();
        m_manager->restoreState(std::exchange(m_beforeMainOnly, {}), ArrangementVersion);
        m_withheld.close();
        m_sizes.growCentre(*m_manager);
    }
    focusCentre();
    mainOnlyChanged();
}

void DockLayout::setDeviceOpen(bool isOpen) {
    if (std::exchange(m_isDeviceOpen, isOpen) != isOpen && isOpen) {
        leaveStartPage();
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
    if (const ads::CDockAreaWidget* centre = m_sizes.areaOf(PanelArea::Centre)) {
        focusFirst(*centre->currentDockWidget()->widget());
    }
}

/// Where the panel says, else to its first control.
void DockLayout::focusFirst(QWidget& content) {
    QWidget* panel = &content;
    if (QWidget* wanted = panel->focusProxy(); wanted != nullptr && wanted->isVisible()) {
        wanted->setFocus(Qt::OtherFocusReason);
        return;
    }
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
    const QString main = shownMain(perspective);
    if (perspective == m_perspective && m_docks.contains(main)) {
        if (m_docks.value(main)->isClosed()) { // closed, or lost with its own window
            raise(main);
        }
    }
    focusCentre();
}

void DockLayout::setPerspective(Perspective perspective) {
    if (perspective == m_perspective || !isOffered(perspective)) {
        return;
    }
    if (m_docks.isEmpty()) {
        m_perspective = perspective;
        perspectiveChanged();
        return;
    }
    setMainOnly(false);
    QWidget* focused =
        m_manager->isAncestorOf(QApplication::focusWidget()) ? QApplication::focusWidget() : nullptr;
    m_arrangements[perspectiveId(m_perspective)] = shownArrangement();
    m_perspective = perspective;
    if (!restoreKept()) {
        arrange(perspective);
    }
    m_sizes.growCentre(*m_manager);
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
    m_withheld.forget();
    if (!fault && m_manager->restoreState(kept, ArrangementVersion)) {
        m_withheld.close();
        return true;
    }
    const QString aside = unreadName(m_arrangements, id);
    m_arrangements.insert(aside, m_arrangements.take(id));
    arrangementUnread(m_perspective, fault.value_or(ArrangementFault::Damaged), aside);
    return false;
}

void DockLayout::reset() {
    setMainOnly(false);
    for (const Perspective perspective : AllPerspectives) { // not what could not be shown
        m_arrangements.remove(perspectiveId(perspective));
    }
    m_manager->restoreState(m_first, ArrangementVersion);
    arrange(m_perspective);
}

QByteArray DockLayout::shownArrangement() const {
    if (isMainOnly()) {
        return m_beforeMainOnly;
    }
    return m_withheld.opened(m_manager->saveState(ArrangementVersion));
}

void DockLayout::setAbsent(const QSet<QString>& absent) {
    QWidget* focused =
        m_manager->isAncestorOf(QApplication::focusWidget()) ? QApplication::focusWidget() : nullptr;
    if (!m_withheld.setAbsent(absent)) {
        return;
    }
    if (!isOffered(m_perspective)) {
        setPerspective(Perspective::Monitor);
    }
    keepFocus(focused);
    offerChanged();
}

bool DockLayout::isOffered(Perspective perspective) const {
    const QStringList panels = mainPanels(perspective);
    return std::any_of(panels.begin(), panels.end(),
                       [this](const QString& panel) { return isOffered(panel); });
}

/// Of a perspective with several main panels the one that this device has.
QString DockLayout::shownMain(Perspective perspective) const {
    const QStringList panels = mainPanels(perspective);
    const auto offered =
        std::find_if(panels.begin(), panels.end(), [this](const QString& panel) { return isOffered(panel); });
    return offered != panels.end() ? *offered : panels.front();
}

void DockLayout::raise(const QString& panel) {
    ads::CDockWidget* dock = m_docks.value(panel);
    if (dock == nullptr || !isOffered(panel)) {
        return;
    }
    unfold(panel);
    dock->setAsCurrentTab();
    dock->raise();
    focusFirst(*dock->widget());
}

/// An area that was closed since the panels were arranged has no size of its own yet.
void DockLayout::unfold(const QString& panel) {
    ads::CDockWidget* dock = m_docks.value(panel);
    if (dock == nullptr || !isOffered(panel) || !dock->isClosed()) {
        return;
    }
    const ads::CDockAreaWidget* area = dock->dockAreaWidget();
    const bool isAreaNew = area == nullptr || area->isHidden();
    dock->toggleView(true);
    if (isAreaNew && !dock->isFloating()) {
        m_sizes.share(*m_manager);
    }
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
    m_arrangements[perspectiveId(m_perspective)] = shownArrangement();
    return m_arrangements;
}

/// Not through setPerspective(): that would keep what is on the screen now over what is to be shown.
void DockLayout::setArrangements(const QHash<QString, QByteArray>& arrangements,
                                 std::optional<Perspective> perspective) {
    QWidget* focused =
        m_manager->isAncestorOf(QApplication::focusWidget()) ? QApplication::focusWidget() : nullptr;
    setMainOnly(false);
    const bool isOther = perspective && *perspective != m_perspective && isOffered(*perspective);
    m_perspective = isOther ? *perspective : m_perspective;
    m_arrangements = arrangements;
    const bool isKept = !m_arrangements.value(perspectiveId(m_perspective)).isEmpty();
    if (!restoreKept() && (isKept || isOther)) {
        arrange(m_perspective);
    }
    m_sizes.growCentre(*m_manager);
    if (isOther) {
        keepFocus(focused);
        perspectiveChanged();
    }
}

} // namespace halbench::app
