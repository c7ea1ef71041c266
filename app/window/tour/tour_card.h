#pragma once

#include <QFrame>

class QLabel;
class QPushButton;

namespace halbench::app {

/// The card of the tour: a title, a text, where in the tour it is, and three buttons. It is part of the
/// window and holds up nothing. Tab stays among its buttons, the arrow keys go back and on, Esc leaves;
/// Shift+F1 leads out of it and back. An Esc that has something to stop has stopped it before the card sees
/// the key.
class TourCard : public QFrame {
    Q_OBJECT

public:
    explicit TourCard(QWidget* window);

    struct Words {
        QString title;
        QString text;
        int step = 0; ///< from 0
        int steps = 0;
    };
    void setWords(const Words& words);
    /// The focus, on the button that goes on.
    void takeFocus();
    QSize sizeIn(const QSize& room) const;

Q_SIGNALS:
    void backRequested();
    void nextRequested();
    void leaveRequested();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    bool focusNextPrevChild(bool isNext) override;

private:
    bool takeKey(int key);

    QLabel* m_title = nullptr;
    QLabel* m_text = nullptr;
    QLabel* m_position = nullptr;
    QPushButton* m_back = nullptr;
    QPushButton* m_next = nullptr;
    QPushButton* m_leave = nullptr;
};

} // namespace halbench::app
