#include "app/workspaces/drive/jog_row.h"

#include "app/workspaces/parts/number_check.h"
#include "app/workspaces/parts/panel_parts.h"
#include "control/base/units.h"
#include "widgets/controls/quantity_edit.h"
#include "widgets/language/phrasebook.h"
#include "widgets/theme/theme_style.h"

#include <QEvent>
#include <QHBoxLayout>

#include <utility>

namespace halbench::app {

namespace {

constexpr double Speed_rad_s = degreesToRadians(45.0); ///< that jogging begins with

} // namespace

HoldButton::HoldButton(const QString& text, QWidget* parent) : QPushButton(text, parent) {
    setAutoDefault(false);
    connect(this, &QPushButton::pressed, this, &HoldButton::begin);
    connect(this, &QPushButton::released, this, &HoldButton::end);
}

void HoldButton::begin() {
    m_isHeld = true;
    Q_EMIT held();
}

void HoldButton::end() {
    if (std::exchange(m_isHeld, false)) {
        setDown(false);
        Q_EMIT letGo();
    }
}

void HoldButton::focusOutEvent(QFocusEvent* event) {
    QPushButton::focusOutEvent(event);
    end();
}

void HoldButton::hideEvent(QHideEvent* event) {
    QPushButton::hideEvent(event);
    end();
}

void HoldButton::changeEvent(QEvent* event) {
    QPushButton::changeEvent(event);
    if ((event->type() == QEvent::EnabledChange && !isEnabled()) ||
        (event->type() == QEvent::ActivationChange && !isActiveWindow())) {
        end();
    }
}

JogRow::JogRow(QWidget* parent) : QWidget(parent) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(widgets::GridStep_px);
    row->addWidget(addButton(tr("\u2212 Back"), tr("Moves backward while it is held (hold Space)"), -1.0));
    m_rate = makeNumberField({}, this);
    m_check = new NumberCheck(*m_rate);
    connect(m_check, &NumberCheck::refused, this, &JogRow::refused);
    row->addWidget(m_rate, 1);
    row->addWidget(addButton(tr("Forward +"), tr("Moves forward while it is held (hold Space)"), 1.0));
    setAngular(true);
}

HoldButton* JogRow::addButton(const QString& text, const QString& toolTip, double sign) {
    auto* button = new HoldButton(text, this);
    button->setToolTip(toolTip);
    button->setAccessibleDescription(toolTip);
    connect(button, &HoldButton::held, this, [this, sign] { start(sign); });
    connect(button, &HoldButton::letGo, this, &JogRow::jogStopped);
    return button;
}

void JogRow::setAngular(bool isAngular) {
    if (isAngular == m_isAngular) {
        return; // keeps the speed that was chosen
    }
    m_isAngular = isAngular;
    dress();
    m_rate->setValue(isAngular ? Speed_rad_s * displayQuantity("rad/s", m_units).factor : 0.5);
}

void JogRow::setUnits(const DisplayUnits& units) {
    const double factor = displayQuantity("rad/s", m_units).factor;
    m_units = units;
    if (*m_isAngular) {
        const double speed_rad_s = m_rate->value() / factor;
        dress();
        m_rate->setValue(speed_rad_s * displayQuantity("rad/s", m_units).factor);
    }
}

double JogRow::speed_rad_s() const {
    return *m_isAngular ? m_rate->value() / displayQuantity("rad/s", m_units).factor : Speed_rad_s;
}

void JogRow::dress() {
    if (!*m_isAngular) {
        dressNumberField(*m_rate, {tr("Jog current"), tr("The current while a button is held"),
                                   QStringLiteral("A"), 3, 0.01, 4.0, 0.1});
        return;
    }
    const DisplayQuantity shown = displayQuantity("rad/s", m_units);
    dressNumberField(*m_rate,
                     {tr("Jog speed"), tr("How fast it moves while a button is held"), shown.unit,
                      shown.decimals + 1, degreesToRadians(0.1) * shown.factor,
                      degreesToRadians(3600.0) * shown.factor, shownStep(shown, degreesToRadians(10.0))});
}

void JogRow::start(double sign) {
    const Result<double> rate = m_check->take();
    if (!rate) {
        Q_EMIT refused(widgets::inWords(rate.error().message), widgets::inWords(rate.error().hint));
        return;
    }
    Q_EMIT jogStarted(sign * (*m_isAngular ? *rate / displayQuantity("rad/s", m_units).factor : *rate));
}

} // namespace halbench::app
