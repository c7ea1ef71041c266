#include "app/workspaces/parts/side_columns.h"

#include "widgets/theme/theme_style.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include <algorithm>

namespace halbench::app {
namespace {

// In characters, so that a larger font gives wider columns.
constexpr int LeastColumn = 52;
constexpr int MostColumn = 92;
constexpr int Gap_px = 2 * widgets::GroupSpacing_px;

} // namespace

int columnsIn(int width_px, int least_px, int parts) {
    const int fitting = (width_px + Gap_px) / std::max(least_px + Gap_px, 1);
    return std::clamp(fitting, 1, std::max(parts, 1));
}

SideColumns::SideColumns(QWidget* parent) : QWidget(parent), m_row(new QHBoxLayout(this)) {
    m_row->setContentsMargins(0, 0, 0, 0);
    m_row->setSpacing(Gap_px);
}

void SideColumns::addPart(QWidget& part, int share) {
    m_parts.push_back({&part, share});
    m_columns = 0; // arranged anew
    fit();
}

QSize SideColumns::minimumSizeHint() const {
    int widest_px = 0;
    for (const Part& part : m_parts) {
        widest_px = std::max(widest_px, part.widget->minimumSizeHint().width());
    }
    return {widest_px, m_row->minimumSize().height()};
}

/// The widgets stay, only the layouts that hold them are new.
void SideColumns::arrange(int columns) {
    while (QLayoutItem* old = m_row->takeAt(0)) {
        while (QLayoutItem* part = old->layout()->takeAt(0)) {
            delete part;
        }
        delete old;
    }
    m_columns = columns;
    for (int i = 0; i < columns; ++i) {
        auto* column = new QVBoxLayout;
        column->setSpacing(widgets::GroupSpacing_px);
        m_row->addLayout(column, m_parts[static_cast<std::size_t>(i)].share);
    }
    for (int i = 0; i < static_cast<int>(m_parts.size()); ++i) {
        m_row->itemAt(std::min(i, columns - 1))
            ->layout()
            ->addWidget(m_parts[static_cast<std::size_t>(i)].widget);
    }
    for (int i = 0; i < columns; ++i) {
        static_cast<QVBoxLayout*>(m_row->itemAt(i)->layout())->addStretch(1);
    }
}

void SideColumns::fit() {
    const int character_px = fontMetrics().averageCharWidth();
    const int columns = columnsIn(width(), LeastColumn * character_px, static_cast<int>(m_parts.size()));
    if (columns != m_columns) {
        arrange(columns);
    }
    const int most_px = columns * MostColumn * character_px + (columns - 1) * Gap_px;
    m_row->setContentsMargins(0, 0, std::max(0, width() - most_px), 0);
}

void SideColumns::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fit();
}

void SideColumns::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange) {
        fit();
    }
}

} // namespace halbench::app
