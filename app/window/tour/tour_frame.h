#pragma once

#include <QWidget>

namespace halbench::app {

/// A line around what a step of the tour points at. It takes no mouse and no focus, and covers nothing but
/// its own line: what is inside is painted as ever.
class TourFrame : public QWidget {
    Q_OBJECT

public:
    explicit TourFrame(QWidget* window);

    /// In coordinates of `window`, the window of what is pointed at; an empty one hides the frame.
    void surround(QWidget& window, const QRect& target);

protected:
    void paintEvent(QPaintEvent* event) override;
};

} // namespace halbench::app
