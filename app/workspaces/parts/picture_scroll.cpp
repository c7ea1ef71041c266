#include "app/workspaces/parts/picture_scroll.h"

#include "app/workspaces/parts/panel_parts.h"
#include "widgets/controls/verdict_view.h"
#include "widgets/figure/figure_view.h"
#include "widgets/theme/theme_style.h"

#include <QEvent>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>

namespace halbench::app {

PictureScroll::PictureScroll(widgets::VerdictView& verdict, QWidget* parent)
    : QWidget(parent), m_picture(new widgets::FigureView) {
    m_picture->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored); // eventFilter() says
    auto* content = new QWidget;
    auto* below = new QVBoxLayout(content);
    below->setContentsMargins(0, 0, 0, 0);
    below->setSpacing(widgets::GridStep_px);
    below->addWidget(m_picture, 1);
    verdict.moveRemarks(*below);
    m_scroll = makeScrollArea(content);
    m_scroll->viewport()->installEventFilter(this);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_scroll);
}

bool PictureScroll::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) {
        const int words_px = 2 * fontMetrics().lineSpacing() + 2 * widgets::GridStep_px;
        m_picture->setMinimumHeight(std::max(0, m_scroll->viewport()->height() - words_px));
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace halbench::app
