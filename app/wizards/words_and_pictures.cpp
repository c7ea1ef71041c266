#include "app/wizards/words_and_pictures.h"

#include "widgets/controls/estimate_table.h"
#include "widgets/theme/theme_style.h"

#include <QScrollArea>
#include <QStyle>

#include <algorithm>

namespace halbench::app {

namespace {

constexpr double MostWords_ratio = 0.6; ///< of the width; the pictures get the rest

} // namespace

WordsAndPictures::WordsAndPictures(QWidget* words, const widgets::EstimateTable* table, QWidget* pictures,
                                   QWidget* parent)
    : QSplitter(Qt::Horizontal, parent), m_table(table) {
    auto* scroll = new QScrollArea(this);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidget(words);
    setChildrenCollapsible(false);
    addWidget(scroll);
    addWidget(pictures);
    setStretchFactor(1, 1);
}

void WordsAndPictures::setWordsName(const QString& accessibleName) {
    widget(0)->setAccessibleName(accessibleName);
}

void WordsAndPictures::shareAnew() {
    m_isShared = false;
    if (isVisible()) {
        share();
    }
}

void WordsAndPictures::share() {
    m_isShared = true;
    const int table_px = m_table->neededWidth() + 2 * widgets::PanelMargin_px +
                         style()->pixelMetric(QStyle::PM_ScrollBarExtent);
    const int words_px = std::min(table_px, static_cast<int>(MostWords_ratio * width()));
    setSizes({words_px, std::max(1, width() - words_px - handleWidth())});
}

/// A page that was never shown has no width to share before.
void WordsAndPictures::resizeEvent(QResizeEvent* event) {
    QSplitter::resizeEvent(event);
    if (!m_isShared) {
        share();
    }
}

} // namespace halbench::app
