#include "app/workspaces/tune/loop/gain_editor.h"

#include "app/figures/parameter_units.h"
#include "widgets/controls/optional_number_edit.h"
#include "widgets/language/phrasebook.h"
#include "widgets/theme/icons.h"

#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QToolButton>

#include <cmath>
#include <limits>
#include <map>

namespace halbench::app {
namespace {

constexpr double LargestGain = 1e9;
constexpr int FormCount = 3; ///< of control::PidForm
/// The first three rows.
enum GainRow : std::size_t { Proportional, Integral, Derivative };

} // namespace

GainEditor::GainEditor(QWidget* parent)
    : QWidget(parent), m_grid(new QGridLayout(this)), m_form(new QComboBox(this)), m_note(new QLabel(this)),
      m_unit(new QComboBox(this)), m_extras(new QToolButton(this)) {
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setHorizontalSpacing(widgets::PanelMargin_px);
    m_grid->setVerticalSpacing(widgets::GridStep_px);
    m_grid->setColumnStretch(1, 1);
    m_grid->addWidget(m_form, 0, 0);
    m_grid->addWidget(m_unit, 0, 1, 1, 2);
    for (int i = 0; i < FormCount; ++i) {
        m_form->addItem(QString());
    }
    m_note->setWordWrap(true);
    m_note->hide();
    m_unit->addItem(QStringLiteral("A/rad"));
    m_unit->addItem(QStringLiteral("A/\u00b0"));
    const auto values = lawParameters(control::PositionLaw{});
    for (const ParameterValue& value : values) {
        if (value.name.rfind("gain.", 0) == 0) {
            addRow(value, false);
        }
    }
    m_grid->addWidget(m_note, m_grid->rowCount(), 0, 1, 3);
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
    connect(m_form, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &GainEditor::refreshForm);
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
        if (!changed.isExtra && form() != control::PidForm::Parallel) {
            takeTimes();
        } else if (changed.edit->value()) {
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

control::PidForm GainEditor::form() const {
    return static_cast<control::PidForm>(m_form->currentIndex());
}

control::PidGains GainEditor::parallelGains() const {
    control::PidGains gains;
    gains.proportional = m_rows[Proportional].value.value;
    gains.integral = m_rows[Integral].value.value;
    gains.derivative = m_rows[Derivative].value.value;
    return gains;
}

void GainEditor::refreshNumbers() {
    m_noGains.reset();
    for (const Row& row : m_rows) {
        row.edit->setValue(row.value.value * unitOf(row).factor);
        row.unit->setText(unitOf(row).text);
    }
    if (form() != control::PidForm::Parallel && !showTimes(form())) {
        m_form->setCurrentIndex(static_cast<int>(control::PidForm::Parallel)); // which every law has
    }
}

/// What was said of a form that is not shown stands until another one is chosen.
void GainEditor::refreshForm() {
    const control::PidForm chosen = form();
    const bool isAfterRefusal = chosen == control::PidForm::Parallel && !m_note->text().isEmpty();
    if (!isAfterRefusal) {
        m_note->clear();
    }
    refreshNumbers();
    sayNames();
    m_note->setVisible(!m_note->text().isEmpty());
}

/// K, T_i and T_d; no integral action is an empty T_i. Whether these gains have that form.
bool GainEditor::showTimes(control::PidForm form) {
    const auto timed = control::convert(parallelGains(), form, control::GainUnit::PerRadian);
    if (!timed) {
        m_note->setText(widgets::inWords(timed.error().message));
        return false;
    }
    const bool isIntegrating = std::isfinite(timed->integral);
    m_rows[Proportional].edit->setValue(timed->proportional * unitOf(m_rows[Proportional]).factor);
    m_rows[Integral].edit->setValue(isIntegrating ? std::optional(timed->integral) : std::nullopt);
    m_rows[Derivative].edit->setValue(timed->derivative);
    for (const std::size_t row : {Integral, Derivative}) {
        m_rows[row].unit->setText(QStringLiteral("s"));
    }
    return true;
}

/// What is written there is the controller; the board's gains follow.
void GainEditor::takeTimes() {
    const auto& K = m_rows[Proportional].edit->value();
    const auto& derivative = m_rows[Derivative].edit->value();
    if (!K || !derivative || !m_rows[Integral].edit->isValid()) {
        return; // law() says which is missing
    }
    control::PidGains timed;
    timed.form = form();
    timed.proportional = *K / unitOf(m_rows[Proportional]).factor;
    timed.integral = m_rows[Integral].edit->value().value_or(std::numeric_limits<double>::infinity());
    timed.derivative = *derivative;
    const auto gains = control::convert(timed, control::PidForm::Parallel, control::GainUnit::PerRadian);
    m_noGains = gains ? std::nullopt : std::optional(gains.error());
    if (gains) {
        m_rows[Proportional].value.value = gains->proportional;
        m_rows[Integral].value.value = gains->integral;
        m_rows[Derivative].value.value = gains->derivative;
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
    const bool isTimed = form() != control::PidForm::Parallel;
    if (m_noGains) {
        return failure(*m_noGains);
    }
    for (const Row& row : m_rows) {
        const bool mayBeEmpty = isTimed && &row == &m_rows[Integral] && row.edit->isValid();
        if (!row.edit->value() && !mayBeEmpty) {
            const QString problem = row.edit->isValid() ? tr("missing number") : row.edit->problem();
            return failure(ErrorCode::InvalidInput,
                           tr("%1: %2").arg(row.edit->accessibleName(), problem).toStdString(),
                           tr("Enter zero or a positive number").toStdString());
        }
        values[row.value.name] = row.value.value;
    }
    return lawFromParameters(values);
}

void GainEditor::sayNames() {
    const bool isTimed = form() != control::PidForm::Parallel;
    const std::pair<const char*, QString> names[] = {
        {"gain.kp", isTimed ? tr("Gain K") : tr("Proportional K_P")},
        {"gain.ki", isTimed ? tr("Integral time T_i") : tr("Integral K_I")},
        {"gain.kd", isTimed ? tr("Derivative time T_d") : tr("Derivative K_D")},
        {"feedforward.inertia", tr("Feed-forward of inertia")},
        {"feedforward.viscous", tr("Feed-forward of damping")},
        {"feedforward.coulomb", tr("Feed-forward of friction")},
        {"feedforward.coulomb_speed", tr("Full friction feed-forward from")},
        {"stiction.current", tr("Friction assist")},
        {"stiction.threshold", tr("Friction assist from an error of")},
        {"stiction.speed", tr("Friction assist below a speed of")}};
    for (const Row& row : m_rows) {
        for (const auto& [key, text] : names) {
            if (row.value.name == key) {
                row.name->setText(text);
                row.edit->setAccessibleName(text);
                row.edit->setExplanation(tr("%1 of the device").arg(QString::fromStdString(row.value.name)));
            }
        }
    }
    if (isTimed) {
        m_rows[Integral].edit->setExplanation(tr("Empty: no integral action"));
        m_rows[Proportional].edit->setExplanation({});
        m_rows[Derivative].edit->setExplanation({});
    }
}

void GainEditor::refreshWords() {
    sayNames();
    const QString forms[FormCount] = {tr("Parallel form"), tr("Standard form"), tr("Series form")};
    for (int i = 0; i < FormCount; ++i) {
        m_form->setItemText(i, forms[i]);
    }
    m_form->setAccessibleName(tr("Form of the gains"));
    m_form->setToolTip(tr("Parallel: K_P + K_I/s + K_D s. Standard: K (1 + 1/(T_i s) + T_d s). Series: K (1 "
                          "+ 1/(T_i s))(1 + T_d s). Device and files use the parallel form"));
    m_unit->setAccessibleName(tr("Unit of the gains"));
    m_unit->setToolTip(tr("1 A/° = 57.3 A/rad. Files and device use A/rad"));
    m_extras->setText(tr("Feed-forward and friction assist"));
    m_extras->setToolTip(tr("Show the feed-forward gains"));
    m_extras->setAccessibleName(m_extras->text());
}

void GainEditor::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refreshWords();
    }
}

} // namespace halbench::app
