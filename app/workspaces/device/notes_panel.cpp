#include "app/workspaces/device/notes_panel.h"

#include "app/workbench/workbench.h"

#include <QPlainTextEdit>
#include <QVBoxLayout>

namespace halbench::app {

NotesPanel::NotesPanel(Workbench&, QWidget* parent) : QWidget(parent) {
    m_text = new QPlainTextEdit(this);
    m_text->setAccessibleName(tr("Notes"));
    m_text->setToolTip(tr("Notes on this motor; saved with the project"));
    m_text->setPlaceholderText(tr("Notes on this motor; saved with the project."));
    m_text->setTabChangesFocus(true);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_text);
    setFocusProxy(m_text);
}

QString NotesPanel::notes() const {
    return m_text->toPlainText();
}

void NotesPanel::setNotes(const QString& notes) {
    if (notes != this->notes()) {
        m_text->setPlainText(notes);
    }
}

} // namespace halbench::app
