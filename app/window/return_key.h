#pragma once

#include <QObject>

class QKeyEvent;

namespace halbench::app {

/// Return and Enter do on the button that has the focus what Space does there, in every panel and window of
/// the program: down with the key, clicked when it is let go, held while it is held, and nothing by its
/// repetition. So Arm asks for the same consent by either key, and a jog lasts as long as the key is down.
/// Dialogs keep their default button, STOP its own way with the key: it does not wait until it is let go.
class ReturnKey : public QObject {
    Q_OBJECT

public:
    explicit ReturnKey(QObject* parent);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace halbench::app
