#pragma once

#include <QWidget>

class QPlainTextEdit;

namespace halbench::app {

class Workbench;

/// The user's own words on this motor; kept in the project.
class NotesPanel : public QWidget {
    Q_OBJECT

public:
    explicit NotesPanel(Workbench& bench, QWidget* parent = nullptr);

    QString notes() const;
    void setNotes(const QString& notes);

private:
    QPlainTextEdit* m_text = nullptr;
};

} // namespace halbench::app
