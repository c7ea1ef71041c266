#include "widgets/controls/message_bar.h"

#include "widgets/controls/elided_label.h"
#include "widgets/theme/icons.h"

#include <QAccessible>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

namespace halbench::widgets {
namespace {

constexpr int LeastLine = 6; ///< characters of one row

Role roleOfSeverity(Severity severity) {
    switch (severity) {
    case Severity::Success:
        return Role::Good;
    case Severity::Warning:
        return Role::Warn;
    case Severity::Error:
        return Role::Bad;
    case Severity::Information:
        break;
    }
    return Role::Primary;
}

QString iconOfSeverity(Severity severity) {
    switch (severity) {
    case Severity::Success:
        return QStringLiteral("ok");
    case Severity::Warning:
        return QStringLiteral("warning");
    case Severity::Error:
        return QStringLiteral("error");
    case Severity::Information:
        break;
    }
    return QStringLiteral("info");
}

} // namespace

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent), m_symbol(new QLabel(this)), m_words(new QLabel(this)),
      m_line(new ElidedLabel(LeastLine, this)), m_action(new QPushButton(this)),
      m_close(new QToolButton(this)) {
    setProperty("surface", QStringLiteral("message"));
    m_words->setWordWrap(true);
    m_words->setTextFormat(Qt::PlainText);
    m_words->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_close->setAutoRaise(true);
    m_close->setIcon(themedIcon(QStringLiteral("close"), Role::Muted));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(PanelMargin_px, GridStep_px, GridStep_px, GridStep_px);
    row->setSpacing(PanelMargin_px);
    row->addWidget(m_symbol, 0, Qt::AlignVCenter);
    m_body = new QHBoxLayout;
    m_body->setSpacing(PanelMargin_px);
    m_body->addWidget(m_words, 1);
    m_body->addWidget(m_line, 1);
    m_body->addWidget(m_action);
    row->addLayout(m_body, 1);
    row->addWidget(m_close);
    connect(m_action, &QPushButton::clicked, this, &MessageBar::actionTriggered);
    connect(m_close, &QToolButton::clicked, this, [this] {
        clear();
        Q_EMIT dismissed();
    });
    refresh();
    hide();
}

void MessageBar::showMessage(const Message& message) {
    m_message = message;
    refresh();
    show();
    QAccessibleEvent alert(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
}

void MessageBar::clear() {
    m_message = {};
    leaveFocus();
    hide();
}

/// Qt would give it to the next control in the chain, which a further key then triggers unseen: Disconnect.
/// The place around the bar takes no keys.
void MessageBar::leaveFocus() {
    if (isAncestorOf(window()->focusWidget()) && parentWidget() != nullptr) {
        parentWidget()->setFocus(Qt::OtherFocusReason);
    }
}

void MessageBar::refresh() {
    const QString icon = iconOfSeverity(m_message.severity);
    m_symbol->setPixmap(themedIcon(icon, roleOfSeverity(m_message.severity)).pixmap(16, 16));
    const QString words =
        m_message.remedy.isEmpty() ? m_message.text : m_message.text + QLatin1Char('\n') + m_message.remedy;
    m_words->setText(words);
    m_words->setVisible(!m_message.isOneRow);
    m_line->setWords(m_message.text);
    m_line->setToolTip(words);
    m_line->setVisible(m_message.isOneRow);
    m_action->setText(m_message.actionText);
    m_action->setToolTip(m_message.remedy.isEmpty() ? m_message.actionText : m_message.remedy);
    m_action->setAccessibleName(m_message.actionText);
    if (m_message.actionText.isEmpty() && window()->focusWidget() == m_action) {
        leaveFocus();
    }
    m_action->setVisible(!m_message.actionText.isEmpty());
    m_close->setToolTip(tr("Dismiss this message (Delete)"));
    m_close->setAccessibleName(tr("Dismiss message"));
    setAccessibleName(m_message.severity == Severity::Error     ? tr("Error")
                      : m_message.severity == Severity::Warning ? tr("Warning")
                                                                : tr("Message"));
    setAccessibleDescription(words);
    setRole(*this, roleOfSeverity(m_message.severity));
    arrange();
}

void MessageBar::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::StyleChange) {
        refresh();
    }
}

void MessageBar::resizeEvent(QResizeEvent* event) {
    QFrame::resizeEvent(event);
    arrange();
}

void MessageBar::arrange() {
    constexpr int RoomyLine = 70; // characters beside which an action still fits
    const bool isNarrow = !m_message.isOneRow && width() < fontMetrics().averageCharWidth() * RoomyLine;
    m_body->setDirection(isNarrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

void MessageBar::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Delete) {
        m_close->click();
        return;
    }
    QFrame::keyPressEvent(event);
}

} // namespace halbench::widgets
