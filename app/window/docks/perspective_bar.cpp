#include "app/window/docks/perspective_bar.h"

#include "widgets/language/translated_text.h"
#include "widgets/theme/theme_style.h"

#include <QActionGroup>
#include <QHBoxLayout>
#include <QMenu>
#include <QToolButton>

namespace halbench::app {

namespace {

QString plainTitle(Perspective perspective) {
    return perspectiveTitle(perspective).replace(QLatin1String("&&"), QLatin1String("&"));
}

} // namespace

PerspectiveBar::PerspectiveBar(QWidget* parent)
    : QWidget(parent), m_choices(new QActionGroup(this)), m_buttons(new QWidget(this)),
      m_menu(new QToolButton(this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_buttons);
    row->addWidget(m_menu);
    auto* buttons = new QHBoxLayout(m_buttons);
    buttons->setContentsMargins(0, 0, 0, 0);
    buttons->setSpacing(widgets::GridStep_px / 2);
    for (const Perspective perspective : AllPerspectives) {
        addChoice(perspective);
    }
    auto* menu = new QMenu(m_menu);
    menu->addActions(m_choices->actions());
    m_menu->setMenu(menu);
    m_menu->setPopupMode(QToolButton::InstantPopup);
    m_menu->setFocusPolicy(Qt::StrongFocus);
    widgets::sayWords(*this, [this] { sayWords(); });
    setPerspective(Perspective::Monitor);
    setCollapsed(false);
}

void PerspectiveBar::addChoice(Perspective perspective) {
    QAction* action = m_choices->addAction(QString());
    action->setCheckable(true);
    action->setData(static_cast<int>(perspective));
    action->setShortcut(QKeySequence(QStringLiteral("Ctrl+%1").arg(m_choices->actions().size())));
    addAction(action); // its key works whatever is shown
    auto* button = new QToolButton(m_buttons);
    button->setDefaultAction(action);
    button->setFocusPolicy(Qt::StrongFocus);
    m_buttons->layout()->addWidget(button);
    connect(action, &QAction::triggered, this, [this, perspective] { chosen(perspective); });
}

void PerspectiveBar::sayWords() {
    for (QAction* action : m_choices->actions()) {
        const auto perspective = static_cast<Perspective>(action->data().toInt());
        action->setText(perspectiveTitle(perspective));
        action->setToolTip(
            tr("Layout for %1 (%2)")
                .arg(plainTitle(perspective), action->shortcut().toString(QKeySequence::NativeText)));
        for (QWidget* shown : action->associatedWidgets()) {
            if (qobject_cast<QToolButton*>(shown) != nullptr) {
                shown->setAccessibleName(tr("Perspective %1").arg(plainTitle(perspective)));
            }
        }
        if (action->isChecked()) {
            setPerspective(perspective);
        }
    }
    m_menu->setToolTip(tr("Layout for another task (Ctrl+1 to Ctrl+5)"));
}

void PerspectiveBar::setPerspective(Perspective perspective) {
    for (QAction* action : m_choices->actions()) {
        action->setChecked(action->data().toInt() == static_cast<int>(perspective));
    }
    m_menu->setText(perspectiveTitle(perspective) + QStringLiteral(" \u25be"));
    m_menu->setAccessibleName(tr("Perspective %1").arg(plainTitle(perspective)));
}

void PerspectiveBar::setOffered(Perspective perspective, bool isOffered) {
    for (QAction* action : m_choices->actions()) {
        if (action->data().toInt() != static_cast<int>(perspective)) {
            continue;
        }
        action->setVisible(isOffered);
        action->setEnabled(isOffered); // its key too
        for (QWidget* shown : action->associatedWidgets()) {
            if (qobject_cast<QToolButton*>(shown) != nullptr) {
                shown->setVisible(isOffered);
            }
        }
    }
    updateGeometry();
}

void PerspectiveBar::setCollapsed(bool isCollapsed) {
    m_buttons->setVisible(!isCollapsed);
    m_menu->setVisible(isCollapsed);
}

int PerspectiveBar::saved_px() const {
    return m_buttons->sizeHint().width() - m_menu->sizeHint().width();
}

} // namespace halbench::app
