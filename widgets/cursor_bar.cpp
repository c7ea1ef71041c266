#include "widgets/cursor_bar.h"

#include "widgets/display_units.h"
#include "widgets/theme_style.h"

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>

#include <cmath>

namespace halbench::widgets {
namespace {

constexpr double Farthest_s = 1e7;
constexpr int Decimals = 4; ///< 0.1 ms: finer than any stream's period
constexpr double Step_s = 0.01;
constexpr int NameCharacters = 10;
constexpr int LongestName = 40;

} // namespace

CursorBar::CursorBar(QWidget* parent)
    : QWidget(parent), m_menu(new QToolButton(this)), m_choice(new QComboBox(this)),
      m_name(new QLineEdit(this)), m_distance(new QLabel(this)), m_refusal(new QLabel(this)) {
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
    m_menu->setText(tr("Cursor pair"));
    m_menu->setToolTip(tr("Further pairs of cursors: N adds one, P chooses the next, F2 names it"));
    m_menu->setPopupMode(QToolButton::InstantPopup);
    m_choice->setAccessibleName(tr("Pair that measures"));
    m_choice->setToolTip(tr("The pair that measures; the others are drawn faint (P, Shift+P)"));
    m_choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_choice->setMinimumContentsLength(NameCharacters / 2);
    m_choice->hide();
    m_name->setObjectName(QStringLiteral("name"));
    m_name->setAccessibleName(tr("Name of the cursor pair"));
    m_name->setToolTip(tr("Name of the pair that measures; a pair with a name is kept in the project (F2)"));
    m_name->setMaxLength(LongestName);
    m_name->setFixedWidth(fontMetrics().averageCharWidth() * (NameCharacters + 2));
    connect(m_choice, QOverload<int>::of(&QComboBox::activated), this, &CursorBar::pairChosen);
    connect(m_name, &QLineEdit::editingFinished, this, [this] {
        if (m_name->text() != m_shownName) {
            Q_EMIT nameTyped(m_name->text());
        }
    });
    for (QWidget* field :
         {static_cast<QWidget*>(m_menu), static_cast<QWidget*>(m_choice), static_cast<QWidget*>(m_name)}) {
        layout()->addWidget(field);
    }
}

void CursorBar::addTimeField(int index) {
    const QString name = index == 0 ? QStringLiteral("A") : QStringLiteral("B");
    auto* field = new QDoubleSpinBox(this);
    field->setRange(-Farthest_s, Farthest_s);
    field->setDecimals(Decimals);
    field->setSingleStep(Step_s);
    field->setSuffix(QStringLiteral(" s"));
    field->setKeyboardTracking(false);
    field->setAlignment(Qt::AlignRight);
    field->setAccessibleName(tr("Time of cursor %1").arg(name));
    field->setToolTip(
        tr("Time of cursor %1: type it, drag the line, or press %1 and move it with the arrow keys")
            .arg(name));
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
    auto* menu = new QMenu(m_menu);
    menu->setToolTipsVisible(true);
    menu->addActions(actions);
    m_menu->setMenu(menu);
}

void CursorBar::setPairs(const CursorPairs& pairs) {
    QStringList names;
    for (const NamedPair& pair : pairs.list()) {
        names << pair.name;
    }
    {
        const QSignalBlocker blocker(m_choice);
        m_choice->clear();
        m_choice->addItems(names);
        m_choice->setCurrentIndex(static_cast<int>(pairs.chosen()));
    }
    m_choice->setVisible(names.size() > 1);
    if (m_shownName != pairs.name() || !m_name->hasFocus()) { // what is being typed stays
        m_shownName = pairs.name();
        m_name->setText(m_shownName);
    }
    m_refusal->clear();
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
        distance_s == 0.0 ? QStringLiteral("–") : numberText(std::abs(1.0 / distance_s), 4);
    m_distance->setText(tr("Δt %1 s    1/Δt %2 Hz").arg(fixedText(distance_s, Decimals), reciprocal));
}

void CursorBar::editName() {
    m_name->setFocus(Qt::ShortcutFocusReason);
    m_name->selectAll();
}

void CursorBar::refuseName(const QString& reason) {
    m_name->setText(m_shownName);
    m_refusal->setText(reason);
}

QString CursorBar::distanceText() const {
    return m_distance->text();
}

} // namespace halbench::widgets
