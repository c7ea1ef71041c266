#include "app/window/tour/tour.h"

#include "app/window/docks/dock_layout.h"
#include "app/window/tour/tour_card.h"
#include "app/window/tour/tour_frame.h"
#include "app/window/tour/tour_place.h"
#include "widgets/controls/stop_button.h"

#include <QAction>
#include <QApplication>
#include <QEvent>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <qtadvanceddocking/DockAreaWidget.h>
#include <qtadvanceddocking/DockWidget.h>

#include <algorithm>
#include <utility>

namespace halbench::app {

Tour::Tour(QMainWindow& window, DockLayout& docks, DeviceSession& session)
    : QObject(&window), m_window(window), m_docks(docks), m_session(session), m_card(new TourCard(&window)),
      m_frame(new TourFrame(&window)) {
    connect(m_card, &TourCard::nextRequested, this, &Tour::next);
    connect(m_card, &TourCard::backRequested, this, &Tour::back);
    connect(m_card, &TourCard::leaveRequested, this, &Tour::leave);
    connect(&m_docks, &DockLayout::offerChanged, this, &Tour::follow);
    connect(&m_docks, &DockLayout::perspectiveChanged, this, &Tour::place);
    connect(&m_session, &DeviceSession::stateChanged, this, &Tour::follow);
}

void Tour::addTo(QMenu& menu) {
    m_menu = &menu;
    QAction* action = menu.addAction(tr("Five-minute &tour"), this, &Tour::startOrSwitch);
    action->setShortcut(QKeySequence(QStringLiteral("Shift+F1")));
}

std::vector<TourStep> Tour::offeredSteps() const {
    const SessionState state = m_session.state();
    const bool isConnected = state == SessionState::Connected || state == SessionState::Reconnecting;
    std::vector<TourStep> steps = tourSteps();
    const auto isLeftOut = [&](const TourStep& step) {
        return (!step.panel.isEmpty() && !m_docks.isOffered(step.panel)) ||
               (step.isDoneConnected && isConnected);
    };
    steps.erase(std::remove_if(steps.begin(), steps.end(), isLeftOut), steps.end());
    return steps;
}

void Tour::start() {
    m_steps = offeredSteps();
    m_isRunning = true;
    m_docks.setMainOnly(false);
    m_window.installEventFilter(this);
    show(0);
}

void Tour::startOrSwitch() {
    if (!m_isRunning) {
        start();
    } else if (m_card->isAncestorOf(QApplication::focusWidget()) && !step().panel.isEmpty()) {
        m_docks.raise(step().panel); // with the focus
    } else {
        m_window.activateWindow();
        m_card->takeFocus();
    }
}

/// The panel comes to the front without the focus, which stays in the card: the next key acts there.
void Tour::show(std::size_t number) {
    m_now = number;
    if (step().perspective) {
        m_docks.setPerspective(*step().perspective);
    }
    if (!step().panel.isEmpty()) {
        m_docks.unfold(step().panel);
        ads::CDockWidget* dock = m_docks.docks().value(step().panel);
        dock->setAsCurrentTab();
        dock->raise();
    }
    setWords();
    m_card->show();
    m_card->takeFocus();
    place();
}

void Tour::setWords() {
    m_card->setWords({step().title, step().text, static_cast<int>(m_now), static_cast<int>(m_steps.size())});
}

void Tour::next() {
    if (m_now + 1 < m_steps.size()) {
        show(m_now + 1);
    } else {
        leave();
    }
}

void Tour::back() {
    if (m_now > 0) {
        show(m_now - 1);
    }
}

/// The focus goes where no key does anything: not to the next control, which may arm or start something.
void Tour::leave() {
    if (!m_isRunning) {
        return;
    }
    m_isRunning = false;
    m_window.removeEventFilter(this);
    watch(nullptr);
    if (m_card->isAncestorOf(QApplication::focusWidget())) {
        m_docks.widget()->setFocus(Qt::OtherFocusReason);
    }
    m_card->hide();
    if (m_frame) {
        m_frame->surround(m_window, {});
    }
}

/// Another device has other steps; the one that is shown stays if it is still among them.
void Tour::follow() {
    std::vector<TourStep> steps = m_isRunning ? offeredSteps() : std::vector<TourStep>();
    if (!m_isRunning || steps == m_steps) {
        return;
    }
    const TourStep shown = step();
    const auto same = std::find(steps.begin(), steps.end(), shown);
    const std::size_t now = same == steps.end() ? std::min(m_now, steps.size() - 1)
                                                : static_cast<std::size_t>(same - steps.begin());
    m_steps = std::move(steps);
    if (m_steps[now] == shown) { // only its number changes: the user may be at work elsewhere
        m_now = now;
        setWords();
        place();
    } else {
        show(now);
    }
}

QWidget* Tour::target() const {
    if (step().panel.isEmpty()) {
        return m_window.menuBar();
    }
    const ads::CDockWidget* dock = m_docks.docks().value(step().panel);
    if (dock->isClosed()) {
        return nullptr;
    }
    return step().part.isEmpty() ? dock->dockAreaWidget() : dock->findChild<QWidget*>(step().part);
}

/// Of the docks; those that need more room than the window has scroll in it. In the window.
QRect Tour::room() const {
    const QWidget* seen = m_docks.widget()->parentWidget();
    return {seen->mapTo(&m_window, QPoint()), seen->size()};
}

/// What of it can be seen, in its window.
QRect Tour::targetPlace(const QWidget& target) const {
    if (step().panel.isEmpty()) {
        const QRect title =
            m_menu == nullptr ? QRect() : m_window.menuBar()->actionGeometry(m_menu->menuAction());
        return {target.mapTo(&m_window, title.topLeft()), title.size()};
    }
    constexpr int Air_px = 6; // the line beside the words of a part, not over them
    const int air_px = step().part.isEmpty() ? 0 : Air_px;
    const QRect whole = QRect(target.mapTo(target.window(), QPoint()), target.size())
                            .marginsAdded({air_px, air_px, air_px, air_px});
    return target.window() == &m_window ? whole & room() : whole;
}

void Tour::watch(QWidget* target) {
    if (m_target != target) {
        if (m_target) {
            m_target->removeEventFilter(this);
        }
        m_target = target;
        if (m_target) {
            m_target->installEventFilter(this);
        }
    }
}

void Tour::place() {
    if (!m_isRunning) {
        return;
    }
    QWidget* shown = target();
    watch(shown);
    const bool isShown = shown != nullptr && shown->isVisible();
    const QRect place = isShown ? targetPlace(*shown) : QRect();
    QRect stop;
    for (const auto* button : m_window.findChildren<widgets::StopButton*>()) {
        if (button->isVisible() && button->window() == &m_window) {
            stop |= QRect(button->mapTo(&m_window, QPoint()), button->size());
        }
    }
    m_card->setGeometry(cardPlace(room(), isShown && shown->window() == &m_window ? place : QRect(), stop,
                                  m_card->sizeIn(room().size())));
    if (!m_frame) {
        m_frame = new TourFrame(&m_window);
    }
    m_frame->surround(isShown ? *shown->window() : static_cast<QWidget&>(m_window), place);
    m_card->raise();
}

/// What is pointed at moves with the window and with what is docked beside it.
bool Tour::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
    case QEvent::Resize:
    case QEvent::Move:
    case QEvent::Show:
    case QEvent::Hide:
        QMetaObject::invokeMethod(this, &Tour::place, Qt::QueuedConnection); // after the layout
        break;
    default:
        break;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace halbench::app
