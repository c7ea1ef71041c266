#pragma once

#include <QLineEdit>
#include <QStandardItemModel>

#include <vector>

class QCompleter;

namespace halbench::app {

/// A word that an expression may contain.
struct ExpressionWord {
    QString text;  ///< as it is written: "hall.a", "sqrt("
    QString title; ///< as it is shown elsewhere: "Hall A", "square root"
};

/// Field of an expression. While a word is typed it lists those that contain it in either name; signals that
/// are dropped on it are inserted. Thread: GUI.
class ExpressionEdit : public QLineEdit {
    Q_OBJECT

public:
    explicit ExpressionEdit(QWidget* parent = nullptr);

    void setWords(const std::vector<ExpressionWord>& words);
    /// What is offered for the word before the cursor now.
    QStringList offered() const;
    /// In place of the word before the cursor.
    void insertWord(const QString& text);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    int wordStart() const;
    void offer();

    QStandardItemModel m_words;
    QCompleter* m_completer = nullptr;
};

} // namespace halbench::app
