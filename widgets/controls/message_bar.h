#pragma once

#include <QFrame>
#include <QString>

class QBoxLayout;
class QLabel;
class QPushButton;
class QToolButton;

namespace halbench::widgets {

class ElidedLabel;

enum class Severity { Information, Success, Warning, Error };

/// Message in place: one sentence, the remedy, and the remedy as a button if there is one.
struct Message {
    Severity severity = Severity::Information;
    QString text;
    QString remedy;
    QString actionText;    ///< empty: no button
    bool isOneRow = false; ///< for a state that lasts: cut to one row, the whole is in the tooltip
};

/// Shows one message in place; hidden while there is none.
class MessageBar : public QFrame {
    Q_OBJECT
public:
    explicit MessageBar(QWidget* parent = nullptr);

    void showMessage(const Message& message);
    void clear();
    const Message& message() const { return m_message; }

Q_SIGNALS:
    void actionTriggered();
    void dismissed();

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void leaveFocus();
    void refresh();
    void arrange();

    Message m_message;
    QLabel* m_symbol = nullptr;
    QLabel* m_words = nullptr;
    ElidedLabel* m_line = nullptr; ///< in their place for one row
    QBoxLayout* m_body = nullptr;  ///< words and action, side by side where there is room
    QPushButton* m_action = nullptr;
    QToolButton* m_close = nullptr;
};

} // namespace halbench::widgets
