#pragma once

#include <QApplication>

class QKeyEvent;

namespace halbench::app {

/// The application that a window needs. It sees every key before any event filter: one that is installed
/// later comes before those there are, as that of a drag does, and may swallow the key.
class WindowApplication : public QApplication {
    Q_OBJECT

public:
    using QApplication::QApplication;
    bool notify(QObject* receiver, QEvent* event) override;

Q_SIGNALS:
    void keyComing(const QKeyEvent& event); ///< its offer to shortcuts or its press, for each receiver
};

} // namespace halbench::app
