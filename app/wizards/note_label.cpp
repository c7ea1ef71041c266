#include "app/wizards/note_label.h"

#include "widgets/theme/theme_style.h"

#include <QCoreApplication>
#include <QLabel>
#include <QTextDocumentFragment>

namespace halbench::app {

namespace {

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::NoteLabel)
};

} // namespace

QLabel* noteLabel(QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setWordWrap(true);
    label->setTextFormat(Qt::RichText);
    label->setTextInteractionFlags(Qt::TextBrowserInteraction);
    widgets::setRole(*label, widgets::Role::Muted);
    return label;
}

void showNote(QLabel& label, const QString& text) {
    label.setText(text);
    label.setToolTip(Words::tr("Opens the help (Tab, Return)"));
    label.setAccessibleName(QTextDocumentFragment::fromHtml(text).toPlainText());
    label.setVisible(!text.isEmpty());
}

} // namespace halbench::app
