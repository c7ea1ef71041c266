#include "widgets/live_plot/marker_bar.h"

#include "widgets/theme/icons.h"
#include "widgets/theme/theme_style.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>

namespace halbench::widgets {
namespace {

constexpr int LongestNote = 200;
constexpr int LongestEntry = 60; ///< characters of the list

} // namespace

MarkerBar::MarkerBar(QWidget* parent)
    : QWidget(parent), m_menu(new QToolButton(this)), m_list(new QMenu(m_menu)), m_time(new QLabel(this)),
      m_note(new QLineEdit(this)), m_remove(new QToolButton(this)), m_close(new QToolButton(this)) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(PanelMargin_px, GridStep_px, PanelMargin_px, GridStep_px);
    layout->setSpacing(PanelMargin_px);
    m_menu->setAccessibleName(tr("List of markers"));
    m_menu->setPopupMode(QToolButton::InstantPopup);
    m_menu->setMenu(m_list);
    connect(m_list, &QMenu::aboutToShow, this, &MarkerBar::fillMenu);
    m_time->setFont(tabularFont(m_time->font()));
    m_time->setAccessibleName(tr("Time of the selected marker"));
    m_note->setObjectName(QStringLiteral("note"));
    m_note->setAccessibleName(tr("Note of the selected marker"));
    m_note->setPlaceholderText(tr("note"));
    m_note->setToolTip(tr("Text of the marker; Enter saves it, Esc cancels"));
    m_note->setMaxLength(LongestNote);
    m_note->installEventFilter(this);
    m_close->setIcon(themedIcon(QStringLiteral("close")));
    m_close->setAccessibleName(tr("Close the marker's row"));
    m_close->setToolTip(tr("Deselect the marker"));
    connect(m_close, &QToolButton::clicked, this, &MarkerBar::accepted);
    layout->addWidget(m_menu);
    layout->addWidget(m_time);
    layout->addWidget(m_note, 1);
    layout->addWidget(m_remove);
    layout->addWidget(m_close);
}

void MarkerBar::setTheme(const Theme& theme) {
    QPalette colours = palette();
    colours.setColor(QPalette::Window, theme.panel);
    colours.setColor(QPalette::WindowText, theme.text);
    setPalette(colours);
    setAutoFillBackground(true);
}

void MarkerBar::setActions(const QList<QAction*>& actions, QAction& remove) {
    m_actions = actions;
    m_remove->setDefaultAction(&remove);
    m_remove->setAccessibleName(remove.text());
    fillMenu();
}

/// The markers by time, the chosen one ticked, and what can be done with them.
void MarkerBar::fillMenu() {
    m_list->clear();
    auto* group = new QActionGroup(m_list);
    for (const std::size_t i : inTime(m_markers)) {
        const QString words = markerWords(m_markers[i], m_span_s);
        QString shown = words.size() > LongestEntry ? words.left(LongestEntry - 1) + QChar(0x2026) : words;
        QAction* marker = m_list->addAction(shown.replace(QLatin1Char('&'), QLatin1String("&&")));
        marker->setCheckable(true);
        marker->setChecked(m_chosen == i);
        group->addAction(marker);
        connect(marker, &QAction::triggered, this, [this, i] { Q_EMIT markerChosen(static_cast<int>(i)); });
    }
    m_list->addSeparator();
    m_list->addActions(m_actions);
}

void MarkerBar::setMarkers(const std::vector<PlotMarker>& markers, std::optional<std::size_t> chosen,
                           double span_s) {
    m_markers = markers;
    m_chosen = chosen;
    m_span_s = span_s;
    m_menu->setText(tr("%n marker(s)", nullptr, static_cast<int>(markers.size())));
    m_menu->setToolTip(tr("All markers by time (Ctrl+J); J selects the next one"));
    if (!chosen) {
        return;
    }
    const PlotMarker& marker = markers[*chosen];
    m_time->setText(markerWords({marker.time_s, {}}, span_s).trimmed());
    if (m_note->text() != marker.text) {
        const QSignalBlocker quiet(m_note);
        m_note->setText(marker.text);
    }
}

void MarkerBar::editNote() {
    if (QApplication::focusWidget() != m_note) {
        m_before = QApplication::focusWidget();
    }
    m_note->setFocus(Qt::ShortcutFocusReason);
    m_note->selectAll();
}

void MarkerBar::showList() {
    m_list->popup(m_menu->mapToGlobal(QPoint(0, m_menu->height())));
}

void MarkerBar::giveFocusBack() {
    if (m_before != nullptr) {
        m_before->setFocus();
    }
}

bool MarkerBar::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_note && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Escape) {
            noteKey(key);
            return true;
        }
    } else if (watched == m_note && event->type() == QEvent::FocusOut &&
               static_cast<QFocusEvent*>(event)->reason() != Qt::PopupFocusReason) {
        finishNote();
    }
    return QWidget::eventFilter(watched, event);
}

void MarkerBar::noteKey(int key) {
    if (key == Qt::Key_Escape) {
        m_note->setText(m_chosen ? m_markers[*m_chosen].text : QString());
        giveFocusBack();
        Q_EMIT cancelled();
        return;
    }
    finishNote();
    giveFocusBack();
    Q_EMIT accepted();
}

void MarkerBar::finishNote() {
    if (m_chosen && m_note->text() != m_markers[*m_chosen].text) {
        Q_EMIT noteTyped(m_note->text());
    }
}

} // namespace halbench::widgets
