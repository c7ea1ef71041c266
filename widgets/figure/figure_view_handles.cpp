// What is moved in a figure on the screen.
#include "widgets/figure/figure_view.h"
#include "widgets/theme/theme_style.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QStringList>

#include <cmath>
#include <utility>

namespace halbench::widgets {
namespace {

Qt::CursorShape cursorOf(FigureHandle::Way way) {
    return way == FigureHandle::Way::Horizontal ? Qt::SizeHorCursor
           : way == FigureHandle::Way::Vertical ? Qt::SizeVerCursor
                                                : Qt::SizeAllCursor;
}

} // namespace

void FigureView::setHandles(std::vector<FigureHandle> handles) {
    if (handles == m_handles) {
        return;
    }
    m_handles = std::move(handles);
    const int count = static_cast<int>(m_handles.size());
    if (m_grip && m_grip->handle >= count) {
        letGo();
    }
    if (m_under && *m_under >= count) {
        showUnder(std::nullopt);
    }
    refreshWords();
    update();
}

std::optional<QPoint> FigureView::handlePlace(int handle) const {
    if (isEmpty() || handle < 0 || handle >= static_cast<int>(m_handles.size())) {
        return std::nullopt;
    }
    const auto shown = arranged();
    const auto place =
        placeOfHandle(shown->figure, shown->layout, m_handles[static_cast<std::size_t>(handle)]);
    return place ? std::optional((*place * scale()).toPoint()) : std::nullopt;
}

std::optional<int> FigureView::handleUnder(const QPoint& at) const {
    if (m_handles.empty()) {
        return std::nullopt;
    }
    const auto shown = arranged();
    const auto found = handleAt(shown->figure, shown->layout, m_handles, QPointF(at) / scale());
    return found ? std::optional(static_cast<int>(*found)) : std::nullopt;
}

void FigureView::showUnder(std::optional<int> handle) {
    if (handle == m_under) {
        return;
    }
    m_under = handle;
    if (handle) {
        const FigureHandle& under = m_handles[static_cast<std::size_t>(*handle)];
        setCursor(cursorOf(under.way));
        setToolTip(tr("Drag: %1").arg(under.name));
    } else {
        unsetCursor();
        setToolTip({});
    }
    update();
}

QString FigureView::handleWords() const {
    QStringList names;
    for (const FigureHandle& handle : m_handles) {
        if (!names.contains(handle.name)) {
            names << handle.name;
        }
    }
    return names.isEmpty()
               ? QString()
               : QLatin1Char(' ') +
                     tr("Ctrl and the arrow keys move: %1.").arg(names.join(QStringLiteral(", ")));
}

void FigureView::drawHandles(QPainter& painter, const Figure& figure, const FigureLayout& layout) const {
    for (std::size_t i = 0; i < m_handles.size(); ++i) {
        const auto place = placeOfHandle(figure, layout, m_handles[i]);
        const int at = static_cast<int>(i);
        if (place) {
            drawHandle(painter, *place, m_under == at || (m_grip && m_grip->handle == at), currentTheme());
        }
    }
}

void FigureView::mousePressEvent(QMouseEvent* event) {
    const auto handle = event->button() == Qt::LeftButton ? handleUnder(event->pos()) : std::nullopt;
    if (!handle) {
        if (event->button() == Qt::LeftButton) {
            pinAt(event->pos());
        }
        QWidget::mousePressEvent(event);
        return;
    }
    const auto shown = arranged();
    const QPointF place =
        *placeOfHandle(shown->figure, shown->layout, m_handles[static_cast<std::size_t>(*handle)]);
    probe(std::nullopt);
    m_isPinned = false;
    m_grip = Grip{*handle, place - QPointF(event->pos()) / scale(), shown};
    Q_EMIT handleTaken(*handle);
}

void FigureView::mouseMoveEvent(QMouseEvent* event) {
    if (m_grip && (event->buttons() & Qt::LeftButton) == 0) {
        letGo(); // it was released where nobody told
    }
    if (m_grip) {
        const std::size_t panel = m_handles[static_cast<std::size_t>(m_grip->handle)].panel;
        const QPointF at = QPointF(event->pos()) / scale() + m_grip->offset;
        const QPointF value = valuesAt(m_grip->drawn->figure, m_grip->drawn->layout, panel, at);
        if (std::isfinite(value.x()) && std::isfinite(value.y())) {
            Q_EMIT handleMoved(m_grip->handle, value.x(), value.y());
        }
        return;
    }
    showUnder(handleUnder(event->pos()));
    probeAt(event->pos());
}

void FigureView::mouseReleaseEvent(QMouseEvent* event) {
    if (m_grip && event->button() == Qt::LeftButton) {
        letGo();
        return;
    }
    QWidget::mouseReleaseEvent(event);
}

void FigureView::letGo() {
    const int handle = m_grip->handle;
    m_grip.reset();
    update();
    Q_EMIT handleReleased(handle);
}

/// Whether the key moved a handle: along the first that goes this way.
bool FigureView::step(const QKeyEvent& event) {
    const bool isAcross = event.key() == Qt::Key_Left || event.key() == Qt::Key_Right;
    const bool isUpright = event.key() == Qt::Key_Up || event.key() == Qt::Key_Down;
    if (m_grip || event.modifiers() != Qt::ControlModifier || (!isAcross && !isUpright)) {
        return false;
    }
    const auto other = isAcross ? FigureHandle::Way::Vertical : FigureHandle::Way::Horizontal;
    const int steps = event.key() == Qt::Key_Right || event.key() == Qt::Key_Up ? 1 : -1;
    for (std::size_t i = 0; i < m_handles.size(); ++i) {
        if (m_handles[i].way != other) {
            Q_EMIT handleStepped(static_cast<int>(i), steps);
            return true;
        }
    }
    return false;
}

} // namespace halbench::widgets
