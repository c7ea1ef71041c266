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

constexpr double FirstSpeed_deg_s = 45.0; ///< that jogging begins with

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
    row->addWidget(addButton(tr("\u2212 Back"), tr("Moves backward while held (hold Space)"), -1.0));
    m_rate = makeNumberField({}, this);
    m_check = new NumberCheck(*m_rate);
    connect(m_check, &NumberCheck::refused, this, &JogRow::refused);
    row->addWidget(m_rate, 1);
    row->addWidget(addButton(tr("Forward +"), tr("Moves forward while held (hold Space)"), 1.0));
    setQuantity(true, {});
}

HoldButton* JogRow::addButton(const QString& text, const QString& toolTip, double sign) {
    auto* button = new HoldButton(text, this);
    button->setToolTip(toolTip);
    button->setAccessibleDescription(toolTip);
    connect(button, &HoldButton::held, this, [this, sign] { start(sign); });
    connect(button, &HoldButton::letGo, this, &JogRow::jogStopped);
    return button;
}

void JogRow::setQuantity(bool isSpeed, const devices::AxisSpec& axis) {
    if (isSpeed == m_isSpeed && axis.id == m_axis.id && axis.positionUnit == m_axis.positionUnit) {
        return; // keeps the speed that was chosen
    }
    m_isSpeed = isSpeed;
    m_axis = axis;
    dress();
    m_rate->setValue(isSpeed ? firstSpeed() * shownSpeed().factor : 0.5);
}

DisplayQuantity JogRow::shownSpeed() const {
    return displayQuantity(m_axis.positionUnit + "/s", m_units);
}

double JogRow::firstSpeed() const {
    return FirstSpeed_deg_s * perDegree(m_axis);
}

void JogRow::setUnits(const DisplayUnits& units) {
    const double factor = shownSpeed().factor;
    m_units = units;
    if (*m_isSpeed) {
        const double speed = m_rate->value() / factor;
        dress();
        m_rate->setValue(speed * shownSpeed().factor);
    }
}

double JogRow::speed() const {
    return *m_isSpeed ? m_rate->value() / shownSpeed().factor : firstSpeed();
}

void JogRow::dress() {
    if (!*m_isSpeed) {
        dressNumberField(*m_rate, {tr("Jog current"), tr("Current while a button is held"),
                                   QStringLiteral("A"), 3, 0.01, 4.0, 0.1});
        return;
    }
    const DisplayQuantity shown = shownSpeed();
    const double degree = perDegree(m_axis) * shown.factor;
    dressNumberField(*m_rate,
                     {tr("Jog speed"), tr("Speed while a button is held"), shown.unit, shown.decimals + 1,
                      0.1 * degree, 3600.0 * degree, shownStep(shown, 10.0 * perDegree(m_axis))});
}

void JogRow::start(double sign) {
    const Result<double> rate = m_check->take();
    if (!rate) {
        Q_EMIT refused(widgets::inWords(rate.error().message), widgets::inWords(rate.error().hint));
        return;
    }
    Q_EMIT jogStarted(sign * (*m_isSpeed ? *rate / shownSpeed().factor : *rate));
}

} // namespace halbench::app
