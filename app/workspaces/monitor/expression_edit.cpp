#include "app/workspaces/monitor/expression_edit.h"

#include "widgets/live_plot/live_plot_spec.h"

#include <QAbstractItemView>
#include <QCompleter>
#include <QDropEvent>
#include <QKeyEvent>
#include <QMimeData>

namespace halbench::app {

namespace {

constexpr int TextRole = Qt::UserRole;
constexpr int MostRows = 10;

bool isPartOfWord(QChar sign) {
    return sign.isLetterOrNumber() || sign == QLatin1Char('.') || sign == QLatin1Char('_');
}

} // namespace

ExpressionEdit::ExpressionEdit(QWidget* parent) : QLineEdit(parent), m_completer(new QCompleter(this)) {
    m_completer->setModel(&m_words);
    m_completer->setWidget(this);
    m_completer->setCaseSensitivity(Qt::CaseInsensitive);
    m_completer->setFilterMode(Qt::MatchContains);
    m_completer->setMaxVisibleItems(MostRows);
    connect(m_completer, QOverload<const QModelIndex&>::of(&QCompleter::activated), this,
            [this](const QModelIndex& row) { insertWord(row.data(TextRole).toString()); });
    connect(this, &QLineEdit::textEdited, this, &ExpressionEdit::offer);
}

void ExpressionEdit::setWords(const std::vector<ExpressionWord>& words) {
    m_words.clear();
    for (const ExpressionWord& word : words) {
        auto* item = new QStandardItem(
            word.text == word.title ? word.text : QStringLiteral("%1   %2").arg(word.text, word.title));
        item->setData(word.text, TextRole);
        m_words.appendRow(item);
    }
}

int ExpressionEdit::wordStart() const {
    int start = cursorPosition();
    while (start > 0 && isPartOfWord(text().at(start - 1))) {
        --start;
    }
    return start;
}

QStringList ExpressionEdit::offered() const {
    QStringList texts;
    const QAbstractItemModel& found = *m_completer->completionModel();
    for (int row = 0; row < found.rowCount(); ++row) {
        texts << found.index(row, 0).data(TextRole).toString();
    }
    return texts;
}

void ExpressionEdit::offer() {
    const int start = wordStart();
    const QString word = text().mid(start, cursorPosition() - start);
    // A number is no name, and of a whole name nothing is left to say.
    const bool isName = !word.isEmpty() && word.at(0).isLetter();
    m_completer->setCompletionPrefix(word);
    if (!isName || offered().isEmpty() || offered() == QStringList(word)) {
        m_completer->popup()->hide();
        return;
    }
    m_completer->complete();
}

void ExpressionEdit::insertWord(const QString& word) {
    const int start = wordStart();
    QString changed = text();
    changed.replace(start, cursorPosition() - start, word);
    setText(changed);
    setCursorPosition(start + word.size());
}

/// With the list open, Enter takes from it; the expression is entered by the next.
void ExpressionEdit::keyPressEvent(QKeyEvent* event) {
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (isEnter && m_completer->popup()->isVisible() && m_completer->popup()->currentIndex().isValid()) {
        event->ignore();
        return;
    }
    QLineEdit::keyPressEvent(event);
}

void ExpressionEdit::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasFormat(QLatin1String(widgets::SignalsMimeType))) {
        event->acceptProposedAction();
        return;
    }
    QLineEdit::dragEnterEvent(event);
}

void ExpressionEdit::dropEvent(QDropEvent* event) {
    const QByteArray names = event->mimeData()->data(QLatin1String(widgets::SignalsMimeType));
    if (names.isEmpty()) {
        QLineEdit::dropEvent(event);
        return;
    }
    insert(QString::fromUtf8(names).split(QLatin1Char('\n')).join(QStringLiteral(" + ")));
    event->acceptProposedAction();
}

} // namespace halbench::app
