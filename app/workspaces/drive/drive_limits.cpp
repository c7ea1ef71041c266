#include "app/workspaces/drive/drive_limits.h"

#include "app/workbench/display_quantity.h"
#include "app/workbench/drive_ability.h"
#include "app/workspaces/parts/panel_parts.h"
#include "widgets/controls/number_label.h"
#include "widgets/controls/quantity_edit.h"
#include "widgets/language/phrasebook.h"
#include "widgets/theme/theme_style.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QPointer>
#include <QSignalBlocker>

#include <cmath>
#include <utility>

namespace halbench::app {

DriveLimits::DriveLimits(Workbench& bench, const DriveControl& control, QWidget* parent)
    : QWidget(parent), m_bench(bench), m_control(control) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(widgets::GridStep_px);
    grid->setColumnStretch(0, 1);
    const Row rows[] = {
        {"limit.current", "", tr("Current"),
         tr("Maximum current. A larger command in current mode stops the device"), &DriveLimits::current_A},
        {"limit.temperature", "", tr("Hottest coil"), tr("Device stops when a coil is hotter"),
         &DriveLimits::temperature_degC},
        {"window.position", "window.position_enabled", tr("Excursion"),
         tr("Device stops at this distance from the arming position"), &DriveLimits::excursion_rad},
        {"window.speed", "window.speed_enabled", tr("Speed"), tr("Device stops above this speed"),
         &DriveLimits::speed_rad_s},
    };
    for (const Row& row : rows) {
        addRow(row);
    }
    connect(&m_bench, &Workbench::valuesChanged, this, &DriveLimits::onValues);
    connect(&m_control, &DriveControl::changed, this, &DriveLimits::followAxis);
    connect(&m_bench, &Workbench::displayUnitsChanged, this, &DriveLimits::onValues);
    onValues();
}

void DriveLimits::addRow(Row row) {
    auto* grid = static_cast<QGridLayout*>(layout());
    const int line = grid->rowCount();
    if (row.switchParameter.empty()) {
        grid->addWidget(new QLabel(row.title, this), line, 0);
    } else {
        row.enabled = new QCheckBox(row.title, this);
        row.enabled->setToolTip(row.toolTip + QLatin1Char('\n') + tr("Off: not monitored (Space)"));
        grid->addWidget(row.enabled, line, 0);
        connect(row.enabled, &QCheckBox::clicked, this,
                [this, name = row.switchParameter](bool isOn) { write(name, isOn ? 1.0 : 0.0); });
    }
    row.live = new widgets::NumberLabel(this);
    row.live->setAccessibleName(tr("%1 now").arg(row.title));
    row.limit = makeNumberField({tr("Limit of %1").arg(row.title), row.toolTip}, this);
    grid->addWidget(row.live, line, 1);
    grid->addWidget(new QLabel(QStringLiteral("\u2264"), this), line, 2);
    grid->addWidget(row.limit, line, 3);
    const std::size_t index = m_rows.size();
    // Only Enter writes: leaving the field must not move a limit, it takes the text back.
    connect(row.limit, &widgets::QuantityEdit::entered, this, [this, index] { onEntered(m_rows[index]); });
    connect(row.limit, &widgets::QuantityEdit::editingFinished, this, [this, index] {
        if (!m_rows[index].limit->hasFocus()) {
            showValue(m_rows[index]);
        }
    });
    connect(row.limit, &widgets::QuantityEdit::refused, this, [this, index](const QString& text) {
        Q_EMIT failed(tr("'%1' is not a valid limit. Nothing was written.").arg(text.trimmed()),
                      m_rows[index].limit->problemOf(text));
    });
    m_rows.push_back(row);
}

void DriveLimits::onEntered(const Row& row) {
    const std::optional<double> known = m_bench.deviceValue(row.parameter);
    const double value = row.limit->value() / row.factor;
    // Enter without a change writes nothing; what is shown is rounded.
    if (known && std::fabs(value - *known) * row.factor > 0.5 * std::pow(10.0, -row.limit->decimals())) {
        write(row.parameter, value);
    }
}

/// The windows of the axis that is moved; a row that the device does not have is not shown.
void DriveLimits::followAxis() {
    const devices::AxisSpec& axis = m_control.axis();
    if (std::exchange(m_axis, axis.id) != axis.id) {
        const devices::Catalogue& catalogue = m_bench.session().catalogue();
        m_rows[PositionRow].parameter = parameterOfRole(catalogue, axis.roles.positionWindow);
        m_rows[SpeedRow].parameter = parameterOfRole(catalogue, axis.roles.speedWindow);
        onValues();
    }
    refreshEnabled();
}

/// A procedure has windows of its own and puts back those it found: nobody changes them under it.
void DriveLimits::refreshEnabled() {
    const bool isFree = m_control.isAvailable();
    for (const Row& row : m_rows) {
        const bool isKnown = m_bench.session().catalogue().findParameter(row.parameter) != nullptr &&
                             m_bench.deviceValue(row.parameter);
        row.limit->setEnabled(isKnown && isFree);
        if (row.enabled != nullptr) {
            row.enabled->setEnabled(m_bench.deviceValue(row.switchParameter).has_value() && isFree);
        }
    }
}

void DriveLimits::onValues() {
    refreshEnabled();
    for (Row& row : m_rows) {
        if (row.enabled != nullptr) {
            const QSignalBlocker quiet(row.enabled);
            row.enabled->setChecked(m_bench.deviceValue(row.switchParameter).value_or(0.0) > 0.5);
        }
        if (!row.limit->hasFocus()) {
            showValue(row);
        }
    }
}

void DriveLimits::showValue(Row& row) {
    const ParameterSpec* spec = m_bench.session().catalogue().findParameter(row.parameter);
    const std::optional<double> value = m_bench.deviceValue(row.parameter);
    if (spec == nullptr || !value) {
        return;
    }
    const DisplayQuantity shown = displayQuantity(spec->unit, m_bench.displayUnits());
    row.factor = shown.factor;
    const QSignalBlocker quiet(row.limit);
    dressNumberField(*row.limit,
                     {tr("Limit of %1").arg(row.title),
                      row.toolTip + QLatin1Char('\n') +
                          tr("Enter writes it. Lost at power-off unless saved to the device"),
                      shown.unit, shown.decimals, spec->min * shown.factor, spec->max * shown.factor, 1.0});
    row.limit->setValue(*value * shown.factor);
    row.live->setFormat({shown.decimals, shown.unit, 0.0, shown.typical});
}

void DriveLimits::write(const std::string& parameter, double value) {
    m_bench.writeValues({{parameter, value}}, [self = QPointer(this)](const Result<void>& written) {
        if (self && !written) {
            Q_EMIT self->failed(widgets::inWords(written.error().message),
                                widgets::inWords(written.error().hint));
        }
    });
}

std::optional<double> DriveLimits::magnitude(const std::string& role) const {
    const auto latest = m_bench.history().latest(signalOfRole(m_bench.session().catalogue(), role));
    return latest ? std::optional(std::fabs(latest->value)) : std::nullopt;
}

/// The largest magnitude of the signals whose roles begin so.
std::optional<double> DriveLimits::largest(const char* rolePrefix) const {
    std::optional<double> found;
    for (const SignalSpec& spec : m_bench.session().catalogue().signals) {
        const auto latest =
            spec.role.starts_with(rolePrefix) ? m_bench.history().latest(spec.name) : std::nullopt;
        if (latest) {
            found = std::fmax(found.value_or(0.0), std::fabs(latest->value));
        }
    }
    return found;
}

/// Of the command where the effort of the axis is a current, else of the coils.
std::optional<double> DriveLimits::current_A() const {
    const devices::AxisSpec& axis = m_control.axis();
    return axis.effortUnit == "A" ? magnitude(axis.roles.effort) : largest("current.");
}

std::optional<double> DriveLimits::temperature_degC() const {
    return largest("coil_temperature.");
}

std::optional<double> DriveLimits::excursion_rad() const {
    const auto latest = m_bench.history().latest(
        signalOfRole(m_bench.session().catalogue(), m_control.axis().roles.position));
    const std::optional<double> origin_rad = m_control.origin_rad();
    if (!latest || !origin_rad || !m_control.isArmed()) {
        return std::nullopt;
    }
    return std::fabs(latest->value - *origin_rad);
}

void DriveLimits::refreshLive() {
    const bool isStale = m_bench.freshness().isStale();
    for (const Row& row : m_rows) {
        const std::optional<double> value = (this->*row.measured)();
        if (value) {
            row.live->setValue(*value * row.factor);
        } else {
            row.live->clear();
        }
        row.live->setStale(isStale);
    }
}

} // namespace halbench::app
