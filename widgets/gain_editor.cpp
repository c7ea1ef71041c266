#include "widgets/gain_editor.h"

#include "widgets/quantity_edit.h"
#include "widgets/theme_style.h"

#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>

#include <cmath>

namespace halbench::widgets {
namespace {

constexpr std::array<const char*, 3> Units = {"A/rad", "A/(rad*s)", "A*s/rad"};
constexpr std::array<const char*, 3> Symbols = {"K<sub>P</sub>", "K<sub>I</sub>", "K<sub>D</sub>"};
constexpr int DigitsBelowLimit = 6; ///< 1000 has three decimals

int decimalsFor(double limit) {
    const int whole = limit > 0.0 ? static_cast<int>(std::floor(std::log10(limit))) : 0;
    return qBound(0, DigitsBelowLimit - whole, DigitsBelowLimit + 2);
}

std::array<double, 3> valuesOf(const control::PidGains& gains) {
    return {gains.proportional, gains.integral, gains.derivative};
}

Result<std::array<double, 3>> parallelPerRadian(const control::PidGains& gains) {
    const auto converted = control::convert(gains, control::PidForm::Parallel, control::GainUnit::PerRadian);
    if (!converted) {
        return failure(converted.error());
    }
    return valuesOf(*converted);
}

QString changeText(double before, double after) {
    if (before == 0.0) {
        return GainEditor::tr("new");
    }
    const double ratio = after / before;
    if (ratio >= 3.0 || ratio < 1.0 / 3.0) {
        return QStringLiteral("× ") + numberText(ratio, 3);
    }
    const double change_percent = (ratio - 1.0) * 100.0;
    return (change_percent > 0.0 ? QStringLiteral("+") : QString()) + numberText(change_percent, 3) +
           QStringLiteral(" %");
}

} // namespace

GainEditor::GainEditor(QWidget* parent)
    : QWidget(parent), m_form(new QLabel(this)), m_editedHeading(new QLabel(this)),
      m_deviceHeading(new QLabel(this)), m_unit(new QComboBox(this)) {
    m_unit->addItems({QString(), QString()});
    layOut();
    for (std::size_t i = 0; i < Gains; ++i) {
        connect(m_rows[i].edit, &QuantityEdit::edited, this, [this, i](double shown) { onEdited(i, shown); });
    }
    connect(m_unit, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
        setAngleUnit(index == 0 ? AngleUnit::Radian : AngleUnit::Degree);
        Q_EMIT angleUnitChanged(m_angleUnit);
    });
    setLimits({});
    retranslate();
}

void GainEditor::layOut() {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(GroupSpacing_px);
    grid->setVerticalSpacing(PanelMargin_px);
    m_form->setTextFormat(Qt::RichText);
    grid->addWidget(m_form, 0, 0, 1, 3);
    grid->addWidget(m_unit, 0, 3);
    grid->addWidget(m_editedHeading, 1, 1, Qt::AlignRight);
    grid->addWidget(m_deviceHeading, 1, 2, Qt::AlignRight);
    setRole(*m_editedHeading, Role::Muted);
    setRole(*m_deviceHeading, Role::Muted);
    for (std::size_t i = 0; i < Gains; ++i) {
        Row& row = m_rows[i];
        row = {new QLabel(this), new QuantityEdit(this), new QLabel(this), new QLabel(this)};
        row.name->setTextFormat(Qt::RichText);
        row.name->setText(QLatin1String(Symbols[i]));
        row.name->setBuddy(row.edit);
        row.device->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        row.device->setFont(tabularFont(font()));
        setRole(*row.change, Role::Muted);
        const int line = static_cast<int>(i) + 2;
        grid->addWidget(row.name, line, 0);
        grid->addWidget(row.edit, line, 1);
        grid->addWidget(row.device, line, 2);
        grid->addWidget(row.change, line, 3);
    }
    grid->setColumnStretch(1, 1);
}

DisplayUnit GainEditor::unitOf(std::size_t gain) const {
    return displayUnit(Units[gain], m_angleUnit);
}

void GainEditor::setLimits(const GainLimits& limits) {
    m_limits = {limits.proportional_A_per_rad, limits.integral_A_per_rad_s, limits.derivative_As_per_rad};
    refreshFormats();
}

void GainEditor::setAngleUnit(AngleUnit unit) {
    m_angleUnit = unit;
    m_unit->setCurrentIndex(unit == AngleUnit::Radian ? 0 : 1);
    refreshFormats();
}

Result<void> GainEditor::setDeviceGains(const control::PidGains& gains) {
    const auto values = parallelPerRadian(gains);
    if (!values) {
        return failure(values.error());
    }
    m_device = *values;
    refreshComparison();
    return {};
}

Result<void> GainEditor::setEditedGains(const control::PidGains& gains) {
    const auto values = parallelPerRadian(gains);
    if (!values) {
        return failure(values.error());
    }
    m_edited = *values;
    refreshFormats();
    return {};
}

void GainEditor::clearDeviceGains() {
    m_device.reset();
    refreshComparison();
}

control::PidGains GainEditor::editedGains() const {
    control::PidGains gains;
    gains.proportional = m_edited[0];
    gains.integral = m_edited[1];
    gains.derivative = m_edited[2];
    return gains;
}

bool GainEditor::isChanged() const {
    for (std::size_t i = 0; i < Gains; ++i) {
        if (!m_device || !areSameOnBoard((*m_device)[i], m_edited[i])) {
            return true;
        }
    }
    return false;
}

void GainEditor::onEdited(std::size_t gain, double shown) {
    m_edited[gain] = shown / unitOf(gain).factor;
    refreshComparison();
    Q_EMIT edited();
}

void GainEditor::refreshFormats() {
    for (std::size_t i = 0; i < Gains; ++i) {
        const DisplayUnit unit = unitOf(i);
        const double limit = m_limits[i] * unit.factor;
        const double step = std::pow(10.0, std::floor(std::log10(limit)) - 3.0);
        m_rows[i].edit->setFormat({unit.text, 0.0, limit, step, decimalsFor(limit)});
        // What is shown is rounded; the exact value stays in m_edited until the user changes it.
        m_rows[i].edit->setQuantity(m_edited[i] * unit.factor);
    }
    refreshComparison();
}

void GainEditor::refreshComparison() {
    for (std::size_t i = 0; i < Gains; ++i) {
        const DisplayUnit unit = unitOf(i);
        Row& row = m_rows[i];
        row.device->setText(m_device ? row.edit->textFromValue((*m_device)[i] * unit.factor)
                                     : QStringLiteral("—"));
        const bool isSame = m_device && areSameOnBoard((*m_device)[i], m_edited[i]);
        row.change->setText(isSame || !m_device ? QString() : changeText((*m_device)[i], m_edited[i]));
        setRole(*row.change, isSame ? Role::Muted : Role::Primary);
    }
}

void GainEditor::retranslate() {
    m_form->setText(tr("Parallel form: u = K<sub>P</sub> e + K<sub>I</sub> ∫e dt + K<sub>D</sub> de/dt"));
    m_editedHeading->setText(tr("Edited"));
    m_deviceHeading->setText(tr("Device"));
    m_unit->setItemText(0, tr("A/rad"));
    m_unit->setItemText(1, tr("A/deg"));
    m_unit->setToolTip(tr("Angle unit of the gains shown here; 10 A/deg = 573 A/rad"));
    m_unit->setAccessibleName(tr("Angle unit of the gains"));
    const std::array<QString, Gains> names = {tr("Proportional gain"), tr("Integral gain"),
                                              tr("Derivative gain")};
    for (std::size_t i = 0; i < Gains; ++i) {
        m_rows[i].edit->setAccessibleName(names[i]);
        m_rows[i].name->setToolTip(names[i]);
    }
    refreshComparison();
}

void GainEditor::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
}

} // namespace halbench::widgets
