#include "app/workspaces/gain_editor.h"

#include "app/report/parameter_units.h"
#include "widgets/icons.h"
#include "widgets/optional_number_edit.h"

#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QToolButton>

#include <map>

namespace halbench::app {
namespace {

constexpr double LargestGain = 1e9;

} // namespace

GainEditor::GainEditor(QWidget* parent)
    : QWidget(parent), m_grid(new QGridLayout(this)), m_form(new QLabel(this)), m_unit(new QComboBox(this)),
      m_extras(new QToolButton(this)) {
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setHorizontalSpacing(widgets::PanelMargin_px);
    m_grid->setVerticalSpacing(widgets::GridStep_px);
    m_grid->setColumnStretch(1, 1);
    m_grid->addWidget(m_form, 0, 0);
    m_grid->addWidget(m_unit, 0, 1, 1, 2);
    m_unit->addItem(QStringLiteral("A/rad"));
    m_unit->addItem(QStringLiteral("A/\u00b0"));
    const auto values = lawParameters(control::PositionLaw{});
    for (const ParameterValue& value : values) {
        if (value.name.rfind("gain.", 0) == 0) {
            addRow(value, false);
        }
    }
    m_extras->setCheckable(true);
    m_extras->setAutoRaise(true);
    m_extras->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_extras->setIcon(widgets::themedIcon(QStringLiteral("settings")));
    m_grid->addWidget(m_extras, m_grid->rowCount(), 0, 1, 3);
    for (const ParameterValue& value : values) {
        if (value.name.rfind("gain.", 0) != 0) {
            addRow(value, true);
        }
    }
    connect(m_unit, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &GainEditor::refreshNumbers);
    connect(m_extras, &QToolButton::toggled, this, &GainEditor::showExtras);
    refreshWords();
    refreshNumbers();
    showExtras(false);
}

void GainEditor::addRow(const ParameterValue& value, bool isExtra) {
    const Row row{new QLabel(this), new widgets::OptionalNumberEdit(this), new QLabel(this), value, isExtra};
    row.edit->setLimits({0.0, LargestGain, true});
    row.edit->setObjectName(QString::fromStdString(value.name));
    row.name->setBuddy(row.edit);
    widgets::setRole(*row.unit, widgets::Role::Muted);
    const int line = m_grid->rowCount();
    m_grid->addWidget(row.name, line, 0);
    m_grid->addWidget(row.edit, line, 1);
    m_grid->addWidget(row.unit, line, 2);
    const std::size_t index = m_rows.size();
    m_rows.push_back(row);
    connect(row.edit, &widgets::OptionalNumberEdit::valueChanged, this, [this, index] {
        Row& changed = m_rows[index];
        if (changed.edit->value()) {
            changed.value.value = *changed.edit->value() / unitOf(changed).factor;
        }
        Q_EMIT edited();
    });
}

widgets::DisplayUnit GainEditor::unitOf(const Row& row) const {
    return widgets::displayUnit(parameterUnit(row.value.name), m_unit->currentIndex() == 0
                                                                   ? widgets::AngleUnit::Radian
                                                                   : widgets::AngleUnit::Degree);
}

void GainEditor::setAngleUnit(widgets::AngleUnit unit) {
    m_unit->setCurrentIndex(unit == widgets::AngleUnit::Radian ? 0 : 1);
}

void GainEditor::refreshNumbers() {
    for (const Row& row : m_rows) {
        row.edit->setValue(row.value.value * unitOf(row).factor);
        row.unit->setText(unitOf(row).text);
    }
}

void GainEditor::showExtras(bool isShown) {
    for (const Row& row : m_rows) {
        for (QWidget* part : std::initializer_list<QWidget*>{row.name, row.edit, row.unit}) {
            part->setVisible(!row.isExtra || isShown);
        }
    }
}

void GainEditor::setLaw(const control::PositionLaw& law) {
    const auto values = lawParameters(law);
    for (Row& row : m_rows) {
        for (const ParameterValue& value : values) {
            row.value.value = value.name == row.value.name ? value.value : row.value.value;
        }
    }
    refreshNumbers();
}

Result<control::PositionLaw> GainEditor::law() const {
    std::map<std::string, double> values;
    for (const Row& row : m_rows) {
        if (!row.edit->value()) {
            const QString problem = row.edit->isValid() ? tr("a number is missing") : row.edit->problem();
            return failure(ErrorCode::InvalidInput,
                           tr("%1: %2").arg(row.edit->accessibleName(), problem).toStdString(),
                           tr("Write a number of zero or more").toStdString());
        }
        values[row.value.name] = row.value.value;
    }
    return lawFromParameters(values);
}

void GainEditor::refreshWords() {
    const std::pair<const char*, QString> names[] = {
        {"gain.kp", tr("Proportional K_P")},
        {"gain.ki", tr("Integral K_I")},
        {"gain.kd", tr("Derivative K_D")},
        {"feedforward.inertia", tr("Feed-forward of inertia")},
        {"feedforward.viscous", tr("Feed-forward of damping")},
        {"feedforward.coulomb", tr("Feed-forward of friction")},
        {"feedforward.coulomb_speed", tr("... in full from speed")},
        {"stiction.current", tr("Friction assist")},
        {"stiction.threshold", tr("... from an error of")},
        {"stiction.speed", tr("... below a reference speed of")}};
    for (const Row& row : m_rows) {
        for (const auto& [key, text] : names) {
            if (row.value.name == key) {
                row.name->setText(text);
                row.edit->setAccessibleName(text);
                row.edit->setExplanation(tr("%1 of the board").arg(QString::fromStdString(row.value.name)));
            }
        }
    }
    m_form->setText(tr("Parallel form, per"));
    m_unit->setAccessibleName(tr("Unit of the gains"));
    m_unit->setToolTip(tr("A/rad and A/\u00b0 differ by 57.3; files and the board use A/rad"));
    m_extras->setText(tr("Feed-forward and friction assist"));
    m_extras->setToolTip(tr("Show the gains that act on the reference"));
    m_extras->setAccessibleName(m_extras->text());
}

void GainEditor::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refreshWords();
    }
}

} // namespace halbench::app
