#include "app/window/tour/tour_frame.h"

#include "widgets/theme/theme_style.h"

#include <QPainter>

namespace halbench::app {
namespace {

constexpr int Line_px = 3;

} // namespace

TourFrame::TourFrame(QWidget* window) : QWidget(window) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    hide();
}

void TourFrame::surround(QWidget& window, const QRect& target) {
    // Hidden, too: a floating panel that it was drawn on may be deleted.
    if (parentWidget() != &window) {
        setParent(&window);
    }
    const QRect shown = target & window.rect();
    if (shown.isEmpty()) {
        hide();
        return;
    }
    setGeometry(shown);
    setMask(QRegion(rect()) - QRegion(rect().marginsRemoved({Line_px, Line_px, Line_px, Line_px})));
    raise();
    show();
}

void TourFrame::paintEvent(QPaintEvent*) {
    QPainter(this).fillRect(rect(), widgets::currentTheme().accent);
}

} // namespace halbench::app
