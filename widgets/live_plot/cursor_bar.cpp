#include "widgets/live_plot/cursor_bar.h"

#include "widgets/language/display_units.h"
#include "widgets/language/time_decimals.h"
#include "widgets/live_plot/axes/time_field.h"
#include "widgets/live_plot/axes/value_range.h"
#include "widgets/theme/theme_style.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>

#include <cmath>
#include <utility>

namespace halbench::widgets {
namespace {

constexpr int StepsOfSpan = 1000;
constexpr int ReciprocalDigits = 6;
constexpr int NameCharacters = 9;
constexpr int LongestName = 40;

} // namespace

CursorBar::CursorBar(QWidget* parent)
    : QWidget(parent), m_menu(new QToolButton(this)), m_name(new QLineEdit(this)),
      m_distance(new QLabel(this)), m_refusal(new QLabel(this)), m_list(new QMenu(m_menu)) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 4, 8, 4);
    layout->setSpacing(8);
    addPairFields();
    addTimeField(0);
    addTimeField(1);
    m_distance->setAccessibleName(tr("Distance of the cursors"));
    setRole(*m_refusal, Role::Bad);
    layout->addWidget(m_distance);
    layout->addWidget(m_refusal);
    layout->addStretch();
}

void CursorBar::addPairFields() {
    m_menu->setAccessibleName(tr("Active pair"));
    m_menu->setPopupMode(QToolButton::InstantPopup);
    m_menu->setMenu(m_list);
    m_list->setToolTipsVisible(true);
    connect(m_list, &QMenu::aboutToShow, this, &CursorBar::fillMenu);
    m_name->setObjectName(QStringLiteral("name"));
    m_name->setAccessibleName(tr("Name of the cursor pair"));
    m_name->setToolTip(tr("Name of the active pair; named pairs are saved in the project (F2)"));
    m_name->setMaxLength(LongestName);
    m_name->setFixedWidth(fontMetrics().averageCharWidth() * (NameCharacters + 4));
    m_name->hide();
    connect(m_name, &QLineEdit::editingFinished, this, &CursorBar::finishName);
    layout()->addWidget(m_menu);
    layout()->addWidget(m_name);
}

/// The pairs, the one that measures ticked, and what can be done with them.
void CursorBar::fillMenu() {
    m_list->clear();
    auto* group = new QActionGroup(m_list);
    for (std::size_t i = 0; i < m_pairs.list().size(); ++i) {
        QAction* pair = m_list->addAction(m_pairs.list()[i].name);
        pair->setCheckable(true);
        pair->setChecked(i == m_pairs.chosen());
        group->addAction(pair);
        connect(pair, &QAction::triggered, this, [this, i] { Q_EMIT pairChosen(static_cast<int>(i)); });
    }
    m_list->addSeparator();
    m_list->addActions(m_actions);
}

void CursorBar::addTimeField(int index) {
    const QString name = index == 0 ? QStringLiteral("A") : QStringLiteral("B");
    auto* field = new TimeField(this);
    field->setAccessibleName(tr("Time of cursor %1").arg(name));
    field->setToolTip(
        tr("Time of cursor %1: type it, drag the line, or press %1 and the arrow keys").arg(name));
    connect(field, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
            [this, index](double time_s) { Q_EMIT cursorTyped(index, time_s); });
    auto* label = new QLabel(name, this);
    label->setBuddy(field);
    layout()->addWidget(label);
    layout()->addWidget(field);
    m_fields[index] = field;
}

void CursorBar::setTheme(const Theme& theme) {
    QPalette colours = palette();
    colours.setColor(QPalette::Window, theme.panel);
    colours.setColor(QPalette::WindowText, theme.text);
    setPalette(colours);
    setAutoFillBackground(true);
}

void CursorBar::setPairActions(const QList<QAction*>& actions) {
    m_actions = actions;
    fillMenu();
}

void CursorBar::setPairs(const CursorPairs& pairs) {
    m_pairs = pairs;
    const QString& name = pairs.name();
    m_menu->setText(!pairs.areKept()                    ? tr("Cursor pair")
                    : name.size() <= NameCharacters + 1 ? name
                                                        : name.left(NameCharacters) + QChar(0x2026));
    m_menu->setToolTip(
        tr("Active pair: %1. N adds a pair, P selects the next, F2 names it; the others are faint")
            .arg(name));
    m_refusal->clear();
    m_distance->show();
    showTimes(pairs.cursors());
}

void CursorBar::showTimes(const CursorPair& cursors) {
    for (int i = 0; i < 2; ++i) {
        if (!m_fields[i]->hasFocus() || m_fields[i]->value() != cursors.at(i)) {
            const QSignalBlocker blocker(m_fields[i]);
            m_fields[i]->setValue(cursors.at(i));
        }
    }
    const double distance_s = cursors.b_s - cursors.a_s;
    const QString reciprocal =
        distance_s == 0.0 ? QStringLiteral("–") : numberText(std::abs(1.0 / distance_s), ReciprocalDigits);
    m_distance->setText(
        tr("Δt %1 s    1/Δt %2 Hz").arg(timeDistanceText(distance_s, m_decimals), reciprocal));
}

void CursorBar::setResolution(double span_s, std::optional<double> period_s) {
    const int decimals = timeDecimals(span_s, period_s);
    for (TimeField* field : m_fields) {
        field->setShown(decimals, niceStep(span_s, StepsOfSpan));
    }
    if (std::exchange(m_decimals, decimals) != decimals) {
        showTimes(m_pairs.cursors());
    }
}

void CursorBar::editName() {
    m_before = QApplication::focusWidget();
    m_name->setText(m_pairs.name());
    m_name->show();
    m_name->setFocus(Qt::ShortcutFocusReason);
    m_name->selectAll();
}

/// Enter, or the focus went elsewhere; hiding the field ends it once more.
void CursorBar::finishName() {
    if (m_name->isHidden()) {
        return;
    }
    const bool isEntered = m_name->hasFocus();
    m_name->hide();
    if (isEntered && m_before != nullptr) {
        m_before->setFocus();
    }
    if (m_name->text() != m_pairs.name()) {
        Q_EMIT nameTyped(m_name->text());
    }
}

void CursorBar::refuseName(const QString& reason) {
    m_distance->hide(); // there is no room for both
    m_refusal->setText(reason);
}

QString CursorBar::distanceText() const {
    return m_distance->text();
}

} // namespace halbench::widgets
