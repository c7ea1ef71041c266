#include "app/window/focus_fallback.h"

#include <QAbstractButton>
#include <QApplication>
#include <QFocusEvent>
#include <QStackedWidget>
#include <QTimer>
#include <QWidget>

#include <algorithm>

namespace halbench::app {

namespace {

constexpr std::size_t MostRemembered = 32;

/// Whether keys can be meant for it: it and all that it stands in are shown and enabled.
bool isUsable(const QWidget& widget) {
    for (const QWidget* part = &widget; part != nullptr; part = part->parentWidget()) {
        if (part->isHidden() || !part->isEnabled()) {
            return false;
        }
        if (part->isWindow()) {
            return true;
        }
    }
    return true;
}

QWidget* usableContainer(const QWidget& widget) {
    for (QWidget* part = widget.parentWidget(); part != nullptr; part = part->parentWidget()) {
        if (isUsable(*part) && part->focusProxy() == nullptr) {
            return part;
        }
    }
    return nullptr;
}

bool isButton(const QWidget& widget) {
    return qobject_cast<const QAbstractButton*>(&widget) != nullptr;
}

} // namespace

FocusFallback::FocusFallback(QWidget& home, QObject* parent) : QObject(parent), m_home(&home) {
    qApp->installEventFilter(this);
    connect(qApp, &QApplication::focusChanged, this, &FocusFallback::onFocusChanged);
}

FocusFallback::~FocusFallback() {
    qApp->removeEventFilter(this);
}

bool FocusFallback::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn) {
        m_isByWindow = static_cast<QFocusEvent*>(event)->reason() == Qt::ActiveWindowFocusReason;
    } else if (event->type() == QEvent::Hide && watched->isWidgetType()) {
        leave(static_cast<const QWidget&>(*watched));
    }
    return QObject::eventFilter(watched, event);
}

/// Qt looks for the next widget before it hides what is inside, and may leave the focus there.
void FocusFallback::leave(const QWidget& hidden) {
    const QWidget* focus = QApplication::focusWidget();
    if (focus == nullptr || (focus != &hidden && !hidden.isAncestorOf(focus))) {
        return;
    }
    QWidget* place = hidden.isWindow() ? placeAfter(hidden) : placeFor(focus, *focus->window());
    if (place == nullptr || !isUsable(*place)) {
        return;
    }
    if (hidden.isWindow()) {
        place->activateWindow();
    }
    place->setFocus();
    if (auto* pages = qobject_cast<QStackedWidget*>(hidden.parentWidget())) {
        holdUntilPage(*pages, *place);
    }
}

/// A stack hides the page that goes, gives the focus to the first widget of the one that comes, and then says
/// that it has changed.
void FocusFallback::holdUntilPage(QStackedWidget& pages, QWidget& place) {
    m_held = &place;
    auto* hold = new QObject(this);
    const auto end = [this, hold] {
        m_held.clear();
        hold->deleteLater();
    };
    connect(&pages, &QStackedWidget::currentChanged, hold, end);
    QTimer::singleShot(0, hold, end);
}

void FocusFallback::onFocusChanged(QWidget* old, QWidget* now) {
    if (now == nullptr) {
        return;
    }
    if (m_held && now != m_held && isButton(*now)) {
        m_held->setFocus();
        return;
    }
    const bool isLeft = old != nullptr && old->window() == now->window() && !isUsable(*old);
    const bool isDropped = m_isByWindow && isButton(*now) && !isKnown(*now);
    m_isByWindow = false;
    if (isLeft || isDropped) {
        if (QWidget* place = placeFor(isLeft ? old : nullptr, *now->window());
            place != nullptr && place != now) {
            place->setFocus();
            return;
        }
    }
    remember(*now);
}

void FocusFallback::remember(QWidget& widget) {
    m_recent.erase(std::remove_if(m_recent.begin(), m_recent.end(),
                                  [&](const QPointer<QWidget>& one) { return !one || one == &widget; }),
                   m_recent.end());
    m_recent.emplace_back(&widget);
    if (m_recent.size() > MostRemembered) {
        m_recent.erase(m_recent.begin());
    }
}

/// Whether it had the focus when its window had it last.
bool FocusFallback::isKnown(const QWidget& widget) const {
    const auto last = std::find_if(m_recent.rbegin(), m_recent.rend(), [&](const QPointer<QWidget>& one) {
        return one && one->window() == widget.window();
    });
    return last != m_recent.rend() && *last == &widget;
}

/// Of a dialog: where the user was in the window it belongs to.
QWidget* FocusFallback::placeAfter(const QWidget& window) const {
    const QWidget* owner = window.parentWidget() != nullptr ? window.parentWidget()->window() : m_home.data();
    QWidget* place = owner != nullptr ? placeFor(nullptr, *owner->window()) : nullptr;
    return place != nullptr && isUsable(*place) ? place : m_home.data();
}

QWidget* FocusFallback::placeFor(const QWidget* left, const QWidget& window) const {
    QWidget* container = left == nullptr ? nullptr : usableContainer(*left);
    for (auto one = m_recent.rbegin(); one != m_recent.rend(); ++one) {
        if (*one && (*one)->window() == &window && isUsable(**one) && !isButton(**one) &&
            (container == nullptr || container->isAncestorOf(*one))) {
            return *one;
        }
    }
    if (container != nullptr) {
        return container;
    }
    return m_home && m_home->window() == &window ? m_home.data() : nullptr;
}

} // namespace halbench::app
