#include "app/workspaces/parts/page_chooser.h"

#include "control/base/assert.h"
#include "widgets/theme/theme_style.h"

#include <QAbstractButton>
#include <QButtonGroup>
#include <QEvent>
#include <QHBoxLayout>
#include <QPushButton>
#include <QResizeEvent>
#include <QSplitter>
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
    m_content.push_back({page, button, {}});
    button->setChecked(m_content.size() == 1);
    placeButtons();
}

PageChooser::Page& PageChooser::pageOf(QWidget* content) {
    const auto found = std::find_if(m_content.begin(), m_content.end(),
                                    [&](const Page& page) { return page.content == content; });
    HB_ASSERT(found != m_content.end());
    return *found;
}

bool PageChooser::isBeside(const Page& page) const {
    return m_pair.isTogether && page.content == m_pair.second;
}

void PageChooser::setTitle(QWidget* page, const QString& title, const QString& toolTip) {
    pageOf(page).title = title;
    pageOf(page).button->setToolTip(toolTip);
    refreshTitles();
}

void PageChooser::refreshTitles() {
    for (const Page& page : m_content) {
        const bool isPair = m_pair.isTogether && page.content == m_pair.first;
        const QString title =
            isPair ? QStringLiteral("%1, %2").arg(page.title, pageOf(m_pair.second).title) : page.title;
        page.button->setText(title);
        page.button->setAccessibleName(title);
    }
    placeButtons();
}

void PageChooser::setPageEnabled(QWidget* page, bool isEnabled) {
    pageOf(page).button->setEnabled(isEnabled);
}

void PageChooser::setCurrent(QWidget* page) {
    pageOf(isBeside(pageOf(page)) ? m_pair.first : page).button->setChecked(true);
}

void PageChooser::focusCurrent() {
    if (QAbstractButton* button = m_group->checkedButton()) {
        button->setFocus(Qt::OtherFocusReason);
    }
}

void PageChooser::pairWhenWide(QWidget* first, QWidget* second, int least_px) {
    m_pair = {first, second, new QSplitter(Qt::Horizontal), new QWidget, least_px, false};
    m_pair.splitter->setChildrenCollapsible(false);
    auto* column = new QVBoxLayout(m_pair.box);
    column->setContentsMargins(0, 0, 0, 0);
    const int current = m_pages->currentIndex();
    const auto replace = [this](QWidget* content, QWidget* place) {
        const int index = m_pages->indexOf(content);
        m_pages->removeWidget(content);
        m_pages->insertWidget(index, place);
        content->show(); // a stack hides what leaves it
    };
    replace(first, m_pair.splitter);
    replace(second, m_pair.box);
    m_pair.splitter->addWidget(first);
    column->addWidget(second);
    m_pages->setCurrentIndex(current);
    placePair();
}

void PageChooser::placePair() {
    const bool isTogether = m_pair.splitter != nullptr && width() >= m_pair.least_px;
    if (isTogether == m_pair.isTogether) {
        return;
    }
    m_pair.isTogether = isTogether;
    if (isTogether) {
        if (pageOf(m_pair.second).button->isChecked()) {
            pageOf(m_pair.first).button->setChecked(true);
        }
        m_pair.splitter->addWidget(m_pair.second);
        m_pair.splitter->setSizes({width() / 2, width() / 2});
    } else {
        m_pair.box->layout()->addWidget(m_pair.second);
    }
    m_pair.second->show();
    pageOf(m_pair.second).button->setVisible(!isTogether);
    refreshTitles();
}

/// Of the pages one at a time.
int PageChooser::narrowest_px() const {
    int widest_px = 0;
    for (const Page& page : m_content) {
        widest_px = std::max(widest_px, page.content->minimumSizeHint().width());
    }
    return widest_px;
}

/// As wide as its widest title: the layout's own wish is the row as it is now, which would never break.
QSize PageChooser::minimumSizeHint() const {
    // Side by side asks for nothing: a chooser that becomes narrow shows one page again.
    int widest_px = m_pair.isTogether ? narrowest_px() : m_pages->minimumSizeHint().width();
    for (const Page& page : m_content) {
        const bool isOfPair = m_pair.isTogether && (page.content == m_pair.first || isBeside(page));
        widest_px = std::max(widest_px, isOfPair ? 0 : page.button->sizeHint().width());
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
    for (const Page& page : m_content) {
        QPushButton* button = page.button;
        if (isBeside(page)) {
            continue;
        }
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
        placePair();
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
