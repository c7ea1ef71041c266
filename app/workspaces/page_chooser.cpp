#include "app/workspaces/page_chooser.h"

#include "widgets/theme_style.h"

#include <QButtonGroup>
#include <QEvent>
#include <QHBoxLayout>
#include <QPushButton>
#include <QResizeEvent>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace halbench::app {

PageChooser::PageChooser(QWidget* parent)
    : QWidget(parent), m_pages(new QStackedWidget(this)), m_rows(new QVBoxLayout),
      m_group(new QButtonGroup(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(widgets::PanelMargin_px);
    m_rows->setSpacing(widgets::GridStep_px);
    column->addLayout(m_rows);
    column->addWidget(m_pages, 1);
    connect(m_group, &QButtonGroup::idToggled, this, [this](int id, bool isOn) {
        if (isOn) {
            m_pages->setCurrentIndex(id);
        }
    });
}

void PageChooser::addPage(QWidget* page) {
    auto* button = new QPushButton(this);
    button->setCheckable(true);
    button->setAutoDefault(false);
    m_group->addButton(button, m_pages->addWidget(page));
    m_buttons.push_back(button);
    button->setChecked(m_buttons.size() == 1);
    placeButtons();
}

QPushButton* PageChooser::buttonOf(QWidget* page) const {
    return m_buttons.at(static_cast<std::size_t>(m_pages->indexOf(page)));
}

void PageChooser::setTitle(QWidget* page, const QString& title, const QString& toolTip) {
    QPushButton* button = buttonOf(page);
    button->setText(title);
    button->setAccessibleName(title);
    button->setToolTip(toolTip);
    placeButtons();
}

void PageChooser::setPageEnabled(QWidget* page, bool isEnabled) {
    buttonOf(page)->setEnabled(isEnabled);
}

void PageChooser::setCurrent(QWidget* page) {
    buttonOf(page)->setChecked(true);
}

/// As wide as its widest title: the layout's own wish is the row as it is now, which would never break.
QSize PageChooser::minimumSizeHint() const {
    int widest_px = m_pages->minimumSizeHint().width();
    for (const QPushButton* button : m_buttons) {
        widest_px = std::max(widest_px, button->sizeHint().width());
    }
    return {widest_px, QWidget::minimumSizeHint().height()};
}

/// Each row takes as many as it has room for.
void PageChooser::placeButtons() {
    while (QLayoutItem* row = m_rows->takeAt(0)) {
        delete row; // without its buttons: they are children of this
    }
    QHBoxLayout* row = nullptr;
    int left_px = 0;
    for (QPushButton* button : m_buttons) {
        const int width_px = button->sizeHint().width();
        if (row == nullptr || width_px > left_px) {
            row = new QHBoxLayout;
            row->setSpacing(widgets::GridStep_px);
            m_rows->addLayout(row);
            left_px = width();
        }
        row->addWidget(button);
        left_px -= width_px + widgets::GridStep_px;
    }
}

void PageChooser::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (event->oldSize().width() != event->size().width()) {
        placeButtons();
    }
}

void PageChooser::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::StyleChange || event->type() == QEvent::FontChange) {
        placeButtons();
    }
}

} // namespace halbench::app
