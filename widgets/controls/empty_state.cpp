#include "widgets/controls/empty_state.h"

#include "widgets/theme/icons.h"

#include <QEvent>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace halbench::widgets {

EmptyState::EmptyState(QWidget* parent)
    : QWidget(parent), m_symbol(new QLabel(this)), m_title(new QLabel(this)), m_purpose(new QLabel(this)),
      m_action(new QPushButton(this)) {
    m_title->setProperty("heading", true);
    m_purpose->setWordWrap(true);
    setRole(*m_purpose, Role::Muted);
    setRole(*m_action, Role::Primary);
    for (QLabel* label : {m_symbol, m_title, m_purpose}) {
        label->setAlignment(Qt::AlignCenter);
    }
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(GroupSpacing_px, GroupSpacing_px, GroupSpacing_px, GroupSpacing_px);
    column->setSpacing(PanelMargin_px);
    column->addStretch(1);
    column->addWidget(m_symbol);
    column->addWidget(m_title);
    column->addWidget(m_purpose);
    column->addWidget(m_action, 0, Qt::AlignHCenter);
    column->addStretch(2);
    m_action->hide();
    m_symbol->hide();
    connect(m_action, &QPushButton::clicked, this, &EmptyState::actionTriggered);
}

void EmptyState::setWords(const QString& title, const QString& purpose, const QString& actionText,
                          const QString& shortcut) {
    m_title->setText(title);
    m_purpose->setText(purpose);
    m_action->setText(actionText);
    m_action->setAccessibleName(actionText);
    m_action->setToolTip(shortcut.isEmpty() ? actionText : tr("%1 (%2)").arg(actionText, shortcut));
    m_action->setVisible(!actionText.isEmpty());
    setAccessibleName(title);
    setAccessibleDescription(purpose);
}

void EmptyState::setIconName(const QString& name) {
    m_icon = name;
    refresh();
}

void EmptyState::refresh() {
    m_symbol->setPixmap(themedIcon(m_icon, Role::Muted).pixmap(24, 24));
    m_symbol->setVisible(!m_icon.isEmpty());
}

void EmptyState::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::StyleChange && !m_icon.isEmpty()) {
        refresh();
    }
}

} // namespace halbench::widgets
