#include "app/window/tour/tour_card.h"

#include "app/workspaces/parts/panel_parts.h"
#include "widgets/theme/theme_style.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace halbench::app {
namespace {

constexpr int Width = 58; ///< characters

} // namespace

TourCard::TourCard(QWidget* window) : QFrame(window) {
    setAccessibleName(tr("Five-minute tour"));
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(widgets::GroupSpacing_px, widgets::GroupSpacing_px, widgets::GroupSpacing_px,
                               widgets::GroupSpacing_px);
    column->setSpacing(widgets::PanelMargin_px);
    m_title = new QLabel(this);
    QFont bold = m_title->font();
    bold.setBold(true);
    m_title->setFont(bold);
    m_text = new QLabel(this);
    m_text->setWordWrap(true);
    m_position = new QLabel(this);
    widgets::setRole(*m_position, widgets::Role::Muted);
    auto* head = new QHBoxLayout;
    head->addWidget(m_title, 1);
    head->addWidget(m_position);
    QLabel* keys = makeNote(this);
    keys->setText(tr("Shift+F1 switches between tour and panel."));
    m_leave = makeButton({tr("Leave the tour"), tr("Leave the tour (Esc)"), {}}, this);
    m_back = makeButton({tr("Back"), tr("Previous step (Left)"), {}}, this);
    m_next = makeButton({tr("Next"), tr("Next step (Right)"), {}}, this);
    widgets::setRole(*m_next, widgets::Role::Primary);
    auto* row = new QHBoxLayout;
    row->addWidget(m_leave);
    row->addStretch(1);
    row->addWidget(m_back);
    row->addWidget(m_next);
    column->addLayout(head);
    column->addWidget(m_text);
    column->addStretch(1);
    column->addWidget(keys);
    column->addLayout(row);
    for (QPushButton* button : {m_leave, m_back, m_next}) {
        button->installEventFilter(this);
    }
    connect(m_back, &QPushButton::clicked, this, &TourCard::backRequested);
    connect(m_next, &QPushButton::clicked, this, &TourCard::nextRequested);
    connect(m_leave, &QPushButton::clicked, this, &TourCard::leaveRequested);
    hide();
}

void TourCard::setWords(const Words& words) {
    m_title->setText(words.title);
    m_text->setText(words.text);
    m_position->setText(tr("Step %1 of %2").arg(words.step + 1).arg(words.steps));
    setAccessibleDescription(words.title + QStringLiteral(". ") + words.text);
    m_next->setText(words.step + 1 < words.steps ? tr("Next") : tr("Finish"));
    m_next->setAccessibleDescription(accessibleDescription()); // read out when the focus comes
    const bool hadFocus = m_back->hasFocus();
    m_back->setEnabled(words.step > 0);
    if (hadFocus && !m_back->isEnabled()) {
        takeFocus();
    }
}

void TourCard::takeFocus() {
    m_next->setFocus(Qt::OtherFocusReason);
}

QSize TourCard::sizeIn(const QSize& room) const {
    const int width_px = std::min(room.width(), Width * fontMetrics().averageCharWidth());
    return {width_px, std::min(room.height(), heightForWidth(width_px))};
}

/// The keys of the card, wherever in it the focus is: a button would take the arrows for itself.
bool TourCard::takeKey(int key) {
    switch (key) {
    case Qt::Key_Escape:
        Q_EMIT leaveRequested();
        return true;
    case Qt::Key_Left:
    case Qt::Key_Up:
        if (m_back->isEnabled()) {
            Q_EMIT backRequested();
        }
        return true;
    case Qt::Key_Right:
    case Qt::Key_Down:
        Q_EMIT nextRequested();
        return true;
    default:
        return false;
    }
}

void TourCard::keyPressEvent(QKeyEvent* event) {
    if (!takeKey(event->key())) {
        QFrame::keyPressEvent(event);
    }
}

bool TourCard::eventFilter(QObject* watched, QEvent* event) {
    return event->type() == QEvent::KeyPress && takeKey(static_cast<QKeyEvent*>(event)->key())
               ? true
               : QFrame::eventFilter(watched, event);
}

/// Beyond the card the next control may be one that arms or starts something.
bool TourCard::focusNextPrevChild(bool isNext) {
    QList<QPushButton*> stops{m_leave, m_back, m_next};
    stops.erase(
        std::remove_if(stops.begin(), stops.end(), [](const auto* stop) { return !stop->isEnabled(); }),
        stops.end());
    const auto now =
        std::find_if(stops.begin(), stops.end(), [](const auto* stop) { return stop->hasFocus(); });
    const int count = static_cast<int>(stops.size());
    const int at = now == stops.end() ? 0 : static_cast<int>(now - stops.begin()) + (isNext ? 1 : count - 1);
    stops[at % count]->setFocus(isNext ? Qt::TabFocusReason : Qt::BacktabFocusReason);
    return true;
}

} // namespace halbench::app
