#include "app/workspaces/tune/axes/axis_gain_editor.h"

#include "control/base/unit_text.h"
#include "widgets/controls/optional_number_edit.h"
#include "widgets/theme/theme_style.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>

namespace halbench::app {

AxisGainEditor::AxisGainEditor(QWidget* parent) : QWidget(parent) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(widgets::PanelMargin_px);
    grid->setVerticalSpacing(widgets::GridStep_px);
    grid->setColumnStretch(1, 1);
    for (int i = 0; i < Fields; ++i) {
        Row& row = m_rows[static_cast<std::size_t>(i)];
        row = {new QLabel(this), new widgets::OptionalNumberEdit(this), new QLabel(this)};
        widgets::setRole(*row.unit, widgets::Role::Muted);
        row.name->setBuddy(row.edit);
        row.edit->setLimits(i == ReferenceWeight || i == DerivativeWeight
                                ? widgets::NumberLimits{0.0, 1.0, true}
                                : widgets::NumberLimits{0.0, 1e9, true});
        grid->addWidget(row.name, i, 0);
        grid->addWidget(row.edit, i, 1);
        grid->addWidget(row.unit, i, 2);
        connect(row.edit, &widgets::OptionalNumberEdit::valueChanged, this, &AxisGainEditor::edited);
    }
    refreshWords();
}

void AxisGainEditor::setLaw(const LoopLaw& law, const LoopAxis& axis) {
    m_law = law;
    m_axis = axis;
    const control::FilteredLaw whole = asFiltered(law);
    const std::array<double, Fields> values = {
        law.law.gains.proportional, law.law.gains.integral, law.law.gains.derivative,
        whole.proportionalWeight,   whole.derivativeWeight, 1e3 * whole.gains.filter_s.value_or(0.0)};
    for (std::size_t i = 0; i < values.size(); ++i) {
        m_rows[i].edit->setValue(values[i]);
    }
    refreshWords();
}

Result<LoopLaw> AxisGainEditor::law() const {
    std::array<double, Fields> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
        const widgets::OptionalNumberEdit& edit = *m_rows[i].edit;
        if (!edit.value()) {
            return failure(ErrorCode::InvalidInput,
                           tr("%1: %2")
                               .arg(edit.accessibleName(), edit.isValid() ? tr("is missing") : edit.problem())
                               .toStdString(),
                           tr("Enter a number").toStdString());
        }
        values[i] = *edit.value();
    }
    LoopLaw law = m_law;
    control::PidGains& gains = law.law.gains;
    gains.proportional = values[Proportional];
    gains.integral = values[Integral];
    gains.derivative = values[Derivative];
    control::FilteredLaw whole = asFiltered(law);
    whole.gains = gains;
    if (values[Filter] > 0.0) {
        whole.gains.filter_s = 1e-3 * values[Filter];
    } else {
        whole.gains.filter_s.reset();
    }
    whole.proportionalWeight = values[ReferenceWeight];
    whole.derivativeWeight = values[DerivativeWeight];
    law.filtered.reset();
    if (!control::isBoardLaw(whole)) {
        law.filtered = std::move(whole);
    }
    return law;
}

void AxisGainEditor::refreshWords() {
    const std::string perPosition = m_axis.effortUnit + "/" + m_axis.positionUnit;
    const auto shown = [](const std::string& unit) { return QString::fromStdString(unitText(unit)); };
    const QString units[] = {shown(perPosition),
                             shown(m_axis.effortUnit + "/(" + m_axis.positionUnit + "*s)"),
                             shown(m_axis.effortUnit + "*s/" + m_axis.positionUnit),
                             {},
                             {},
                             QStringLiteral("ms")};
    const QString names[] = {QStringLiteral("K_P"), QStringLiteral("K_I"), QStringLiteral("K_D"),
                             tr("Weight b"),        tr("Weight c"),        tr("Filter T_f")};
    const QString helps[] = {tr("Proportional gain"),
                             tr("Integral gain"),
                             tr("Derivative gain"),
                             tr("Set-point weight b of the proportional part"),
                             tr("Set-point weight c of the derivative part"),
                             tr("Time constant of the derivative's filter")};
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        m_rows[i].name->setText(names[i]);
        m_rows[i].unit->setText(units[i]);
        m_rows[i].edit->setAccessibleName(helps[i]);
        m_rows[i].edit->setExplanation(helps[i]);
    }
}

void AxisGainEditor::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refreshWords();
    }
}

} // namespace halbench::app
