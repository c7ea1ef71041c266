#include "widgets/controls/floating_rows.h"

#include "widgets/theme/theme_style.h"

#include <QEvent>
#include <QVBoxLayout>

#include <algorithm>

namespace halbench::widgets {
namespace {

/// Wider, a line is hard to read, and the buttons at the left would be covered.
constexpr int MostCharacters = 110;
constexpr int FewestCharacters = 60;
constexpr double MostOfWidth_ratio = 0.55;

} // namespace

FloatingRows::FloatingRows(QWidget& below, Qt::Edge edge, QWidget* parent)
    : QWidget(parent), m_below(below), m_edge(edge), m_column(new QVBoxLayout(this)) {
    m_column->setContentsMargins(0, 0, 0, 0);
    m_column->setSpacing(GridStep_px);
    m_below.installEventFilter(this);
    hide();
}

void FloatingRows::addRow(QWidget& row) {
    row.setParent(this); // what was hidden on purpose stays so
    row.setAutoFillBackground(true);
    m_column->addWidget(&row);
    row.installEventFilter(this);
    for (QWidget* part : row.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        part->installEventFilter(this);
    }
    place();
}

/// A row whose words became longer, or that became visible.
bool FloatingRows::event(QEvent* event) {
    const bool isDone = QWidget::event(event);
    if (event->type() == QEvent::LayoutRequest) {
        place();
    }
    return isDone;
}

/// Also of the parts of a row: one that is there all the time shows and hides what is in it, and while
/// nothing floats no request of its layout comes up here.
bool FloatingRows::eventFilter(QObject* watched, QEvent* event) {
    const QEvent::Type type = event->type();
    if (watched == &m_below) {
        if (type == QEvent::Resize || type == QEvent::Move || type == QEvent::Show) {
            place();
        }
    } else if (type == QEvent::ShowToParent || type == QEvent::HideToParent) {
        auto* part = static_cast<QWidget*>(watched);
        (part->parentWidget() == this ? part : part->parentWidget())->updateGeometry();
        place();
    } else if (type == QEvent::LayoutRequest) {
        place(); // the row's own layout has seen it before: its height is that of its words now
    }
    return QWidget::eventFilter(watched, event);
}

void FloatingRows::place() {
    const QSize room = m_below.size() - QSize(2 * PanelMargin_px, 2 * PanelMargin_px);
    const int character_px = fontMetrics().averageCharWidth();
    const int width_px =
        std::min(room.width(), std::clamp(static_cast<int>(MostOfWidth_ratio * room.width()),
                                          FewestCharacters * character_px, MostCharacters * character_px));
    const int wanted_px =
        m_column->hasHeightForWidth() ? m_column->heightForWidth(width_px) : m_column->sizeHint().height();
    if (wanted_px <= 0) { // no row is in sight
        hide();
        return;
    }
    const int height_px = std::min(room.height(), wanted_px);
    const int top_px = m_edge == Qt::TopEdge ? PanelMargin_px : m_below.height() - PanelMargin_px - height_px;
    const QPoint corner =
        m_below.mapTo(parentWidget(), QPoint(m_below.width() - PanelMargin_px - width_px, top_px));
    setGeometry(QRect(corner, QSize(width_px, height_px)));
    show();
    raise();
}

} // namespace halbench::widgets
