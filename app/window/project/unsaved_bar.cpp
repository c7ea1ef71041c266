#include "app/window/project/unsaved_bar.h"

#include "widgets/controls/message_bar.h"
#include "widgets/language/phrasebook.h"
#include "widgets/theme/theme_style.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

namespace halbench::app {

UnsavedBar::UnsavedBar(QWidget* parent)
    : QWidget(parent), m_message(new widgets::MessageBar(this)), m_again(new QPushButton(this)),
      m_saveAs(new QPushButton(this)), m_discard(new QPushButton(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(widgets::GridStep_px);
    column->addWidget(m_message);
    auto* row = new QHBoxLayout;
    row->setContentsMargins(widgets::PanelMargin_px, 0, widgets::PanelMargin_px, widgets::GridStep_px);
    for (QPushButton* button : {m_again, m_saveAs, m_discard}) {
        row->addWidget(button);
    }
    row->addStretch(1);
    column->addLayout(row);
    connect(m_again, &QPushButton::clicked, this, &UnsavedBar::tryAgainRequested);
    connect(m_saveAs, &QPushButton::clicked, this, &UnsavedBar::saveAsRequested);
    connect(m_discard, &QPushButton::clicked, this, &UnsavedBar::discardRequested);
    connect(m_message, &widgets::MessageBar::dismissed, this, [this] {
        hide();
        stayRequested();
    });
    refreshWords();
    hide();
}

void UnsavedBar::showError(const Error& error) {
    m_message->showMessage(
        {widgets::Severity::Error,
         tr("The project stays open because saving failed: %1").arg(widgets::inWords(error.message)),
         widgets::inWords(error.hint),
         {}});
    show();
    m_again->setFocus(Qt::OtherFocusReason);
}

void UnsavedBar::refreshWords() {
    const auto say = [](QPushButton& button, const QString& text, const QString& help) {
        button.setText(text);
        button.setAccessibleName(text);
        button.setToolTip(help);
    };
    say(*m_again, tr("Try again"), tr("Try to save again, then continue"));
    say(*m_saveAs, tr("Save project as…"), tr("Save to another place, then continue"));
    say(*m_discard, tr("Discard"), tr("Continue; unsaved changes are lost"));
}

void UnsavedBar::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refreshWords();
    }
}

} // namespace halbench::app
