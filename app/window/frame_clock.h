#pragma once

#include <QTimer>

class QWidget;

namespace halbench::app {

/// The one timer of all that moves in a window: 30 frames a second, five while the window is minimised and
/// nobody sees them. Samples are taken at every frame, so that none is lost and values stay fresh.
class FrameClock : public QTimer {
    Q_OBJECT
public:
    /// Watches `window`, which owns it.
    explicit FrameClock(QWidget& window);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget& m_window;
};

} // namespace halbench::app
