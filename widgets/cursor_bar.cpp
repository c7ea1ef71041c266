#include "widgets/cursor_bar.h"

#include "widgets/display_units.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>

#include <cmath>

namespace halbench::widgets {
namespace {

constexpr double Farthest_s = 1e7;
constexpr int Decimals = 4; ///< 0.1 ms: finer than any stream's period
constexpr double Step_s = 0.01;

} // namespace

CursorBar::CursorBar(QWidget* parent) : QWidget(parent), m_distance(new QLabel(this)) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 4, 8, 4);
    layout->setSpacing(8);
    for (int i = 0; i < 2; ++i) {
        const QString name = i == 0 ? QStringLiteral("A") : QStringLiteral("B");
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
                [this, i](double time_s) { Q_EMIT cursorTyped(i, time_s); });
        auto* label = new QLabel(name, this);
        label->setBuddy(field);
        layout->addWidget(label);
        layout->addWidget(field);
        m_fields[i] = field;
    }
    m_distance->setAccessibleName(tr("Distance of the cursors"));
    layout->addWidget(m_distance);
    layout->addStretch();
}

void CursorBar::setTheme(const Theme& theme) {
    QPalette colours = palette();
    colours.setColor(QPalette::Window, theme.panel);
    colours.setColor(QPalette::WindowText, theme.text);
    setPalette(colours);
    setAutoFillBackground(true);
}

void CursorBar::setCursors(const CursorPair& cursors) {
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

QString CursorBar::distanceText() const {
    return m_distance->text();
}

} // namespace halbench::widgets
