#include "app/workspaces/drive/reference_form.h"

#include "app/workspaces/drive/path_form.h"
#include "app/workspaces/drive/reference_fields.h"
#include "app/workspaces/parts/number_check.h"
#include "app/workspaces/parts/panel_parts.h"
#include "control/base/assert.h"
#include "control/base/units.h"
#include "widgets/controls/quantity_edit.h"
#include "widgets/language/display_units.h"
#include "widgets/language/number_text.h"
#include "widgets/theme/theme_style.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>
#include <string>

namespace halbench::app {

namespace {

constexpr std::size_t MostPlateaus = 32;

} // namespace

ReferenceForm::ReferenceForm(QWidget* parent) : QWidget(parent) {
    m_rows = new QFormLayout(this);
    m_rows->setContentsMargins(0, 0, 0, 0);
    m_rows->setSpacing(widgets::GridStep_px);
    m_shape = new QComboBox(this);
    m_shape->setAccessibleName(tr("Shape of the reference"));
    m_shape->setToolTip(tr("Generator signal added to the set-point"));
    m_rows->addRow(tr("Shape"), m_shape);
    for (const ReferenceFieldSpec& spec : referenceFields()) {
        addNumber(spec.field);
    }
    m_currents = new QLineEdit(QStringLiteral("1.6; 2; 2.4; 2.8"), this);
    m_currents->setAccessibleName(tr("Currents of the plateaus in ampere"));
    m_currents->setToolTip(tr("Up to 32 currents in A, separated by spaces or semicolons"));
    label(m_currents, tr("Currents (A)"));
    m_path = new PathForm(this);
    connect(m_path, &PathForm::changed, this, &ReferenceForm::changed);
    connect(m_path, &PathForm::refused, this, &ReferenceForm::refused);
    fillShapes();
    refresh();
    connect(m_shape, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &ReferenceForm::refresh);
    connect(m_currents, &QLineEdit::textChanged, this, &ReferenceForm::changed);
}

void ReferenceForm::addNumber(Field field) {
    auto* box = makeNumberField({}, this);
    m_numbers[field] = box;
    m_checks[field] = new NumberCheck(*box);
    connect(m_checks.at(field), &NumberCheck::refused, this, &ReferenceForm::refused);
    label(box, titleOf(field));
    connect(box, QOverload<double>::of(&widgets::QuantityEdit::valueChanged), this, &ReferenceForm::changed);
}

void ReferenceForm::fillShapes() {
    const QSignalBlocker quiet(m_shape);
    const int before = m_shape->currentIndex();
    const QVariant chosen = m_shape->currentData();
    m_shape->clear();
    const int shapes = isPosition() ? PlateausShape - 1 : PlateausShape;
    for (int code = 1; code <= shapes; ++code) {
        m_shape->addItem(tr(referenceShape(code).title), code);
    }
    for (const MoveReference::Shape path : m_paths) {
        if (isPosition()) {
            m_shape->addItem(pathTitle(path), static_cast<int>(path));
        }
    }
    m_shape->setCurrentIndex(std::max(m_shape->findData(chosen), 0));
    for (const ReferenceFieldSpec& spec : referenceFields()) {
        widgets::QuantityEdit* box = m_numbers.at(spec.field);
        const QSignalBlocker quietBox(box);
        dress(spec.field);
        if (before < 0 || isAngular(spec.field)) {
            const ReferenceRange& range = isPosition() ? spec.angle : spec.current;
            const bool isInDegrees = isPosition() && isAngular(spec.field);
            const double initial = isInDegrees ? perDegree(m_axis) * range.initial : range.initial;
            box->setValue(initial * shownAs(spec.field).factor);
        }
    }
}

/// As shown by the field; only angles and speeds depend on what the user prefers.
DisplayQuantity ReferenceForm::shownAs(Field field) const {
    const ReferenceFieldSpec& spec = referenceField(field);
    if (isPosition() && isAngular(field)) {
        // "rad" or "rad/s" of the table
        return displayQuantity(m_axis.positionUnit + std::string(spec.angleUnit).substr(3), m_units);
    }
    const QString unit = QString::fromUtf8(isPosition() ? spec.angleUnit : spec.currentUnit);
    return {{}, unit, 1.0, (isPosition() ? spec.angle : spec.current).decimals, 1.0};
}

QString ReferenceForm::titleOf(Field field) const {
    const ReferenceFieldSpec& spec = referenceField(field);
    return tr(isPosition() || spec.currentTitle == nullptr ? spec.title : spec.currentTitle);
}

void ReferenceForm::dress(Field field) {
    const ReferenceFieldSpec& spec = referenceField(field);
    const DisplayQuantity shown = shownAs(field);
    ReferenceRange range = isPosition() ? spec.angle : spec.current;
    if (isPosition() && isAngular(field)) {
        const double degree = perDegree(m_axis);
        range = {degree * range.min * shown.factor, degree * range.max * shown.factor, 0.0,
                 shownStep(shown, degree * range.step), shown.decimals};
    }
    m_labels.at(m_numbers.at(field))->setText(titleOf(field));
    dressNumberField(*m_numbers.at(field), {titleOf(field), tr(spec.help), shown.unit, range.decimals,
                                            range.min, range.max, range.step});
}

void ReferenceForm::setPaths(const std::vector<MoveReference::Shape>& paths) {
    if (paths != m_paths) {
        m_paths = paths;
        fillShapes();
        refresh();
    }
}

void ReferenceForm::setUnits(const DisplayUnits& units) {
    if (units == m_units) {
        return;
    }
    m_path->setUnits(units);
    std::map<Field, double> values;
    for (const ReferenceFieldSpec& spec : referenceFields()) {
        values[spec.field] = m_numbers.at(spec.field)->value() / shownAs(spec.field).factor;
    }
    m_units = units;
    for (const auto& [field, value] : values) {
        const QSignalBlocker quiet(m_numbers.at(field));
        dress(field);
        m_numbers.at(field)->setValue(value * shownAs(field).factor);
    }
    Q_EMIT changed();
}

void ReferenceForm::setMode(devices::BoardMode mode, const devices::AxisSpec& axis) {
    const bool wasPosition = isPosition();
    const bool isOtherAxis = axis.id != m_axis.id || axis.positionUnit != m_axis.positionUnit;
    m_mode = mode;
    m_axis = axis;
    if (wasPosition != isPosition() || isOtherAxis) {
        fillShapes();
        refresh();
    }
}

int ReferenceForm::shape() const {
    return std::max(m_shape->currentData().toInt(), 1);
}

void ReferenceForm::label(QWidget* field, const QString& title) {
    m_labels[field] = new QLabel(title, this);
    m_labels[field]->setBuddy(field);
}

/// Only the rows of the shape are laid out: a hidden row would leave its gap.
void ReferenceForm::refresh() {
    while (m_rows->rowCount() > 1) {
        const QFormLayout::TakeRowResult row = m_rows->takeRow(1);
        delete row.labelItem;
        delete row.fieldItem;
    }
    const auto show = [this](QWidget* field, bool isShown) {
        if (isShown) {
            m_rows->addRow(m_labels.at(field), field);
        }
        field->setVisible(isShown);
        m_labels.at(field)->setVisible(isShown);
    };
    for (const ReferenceFieldSpec& spec : referenceFields()) {
        show(m_numbers.at(spec.field), !isPath() && hasField(shape(), spec.field));
    }
    show(m_currents, shape() == PlateausShape);
    m_path->setVisible(isPath());
    if (isPath()) {
        m_path->setShape(static_cast<MoveReference::Shape>(shape()));
        m_rows->addRow(m_path);
    }
    Q_EMIT changed();
}

double ReferenceForm::valueOf(Field field) const {
    if (isPath() || !hasField(shape(), field)) {
        return 0.0;
    }
    return m_numbers.at(field)->value() / shownAs(field).factor;
}

/// In the current modes its angles are currents; the board's generator does not know the difference.
MoveReference ReferenceForm::reference() const {
    MoveReference reference;
    reference.shape = static_cast<MoveReference::Shape>(shape());
    reference.amplitude = valueOf(Field::Amplitude);
    reference.rate = valueOf(Field::Rate);
    reference.frequency_Hz = valueOf(Field::Frequency);
    reference.frequencyEnd_Hz = valueOf(Field::FrequencyEnd);
    reference.period_s = std::max(valueOf(Field::Period), 0.001);
    reference.count = std::max(static_cast<int>(valueOf(Field::Count)), 1);
    reference.base = valueOf(Field::Base);
    reference.seed = static_cast<std::uint32_t>(valueOf(Field::Seed));
    return reference;
}

Result<std::vector<double>> ReferenceForm::plateaus_A() const {
    std::vector<double> currents_A;
    const QStringList words = m_currents->text()
                                  .replace(QLatin1Char(';'), QLatin1Char(' '))
                                  .simplified()
                                  .split(QLatin1Char(' '), Qt::SkipEmptyParts);
    for (const QString& word : words) {
        const std::optional<double> current_A = widgets::parseNumber(word);
        if (!current_A) {
            return failure(ErrorCode::InvalidInput,
                           tr("'%1' is not a valid current.").arg(word).toStdString(),
                           (widgets::numberProblem(word) + QLatin1Char(' ') +
                            tr("Enter currents in A, e.g. 1.6; 2; 2.4."))
                               .toStdString());
        }
        currents_A.push_back(*current_A);
    }
    if (currents_A.empty() || currents_A.size() > MostPlateaus) {
        return failure(ErrorCode::OutOfRange,
                       tr("%1 plateaus entered.").arg(static_cast<int>(currents_A.size())).toStdString(),
                       tr("Allowed: 1 to 32.").toStdString());
    }
    return currents_A;
}

Result<std::vector<ParameterValue>> ReferenceForm::plateauValues() const {
    const Result<std::vector<double>> currents_A = plateaus_A();
    if (!currents_A) {
        return failure(currents_A.error());
    }
    std::vector<ParameterValue> values{{"reference.shape", PlateausShape},
                                       {"reference.base", 0.0},
                                       {"plateau.dwell", valueOf(Field::Dwell)},
                                       {"plateau.count", static_cast<double>(currents_A->size())}};
    for (std::size_t i = 0; i < currents_A->size(); ++i) {
        values.push_back({"plateau.current_" + std::to_string(i + 1), (*currents_A)[i]});
    }
    return values;
}

Result<std::vector<ParameterValue>> ReferenceForm::takeValues() {
    HB_ASSERT(!isPath());
    for (const auto& [field, check] : m_checks) {
        if (!hasField(shape(), field)) {
            continue;
        }
        if (const Result<double> taken = check->take(); !taken) {
            return failure(taken.error());
        }
    }
    if (shape() == PlateausShape) {
        return plateauValues();
    }
    const MoveReference wanted = reference();
    if (auto complete = checkMoveReference(wanted); !complete) {
        return failure(complete.error());
    }
    const double duration_s = valueOf(Field::Duration);
    std::vector<ParameterValue> values = generatorParameters(wanted, duration_s, m_axis.generator);
    for (ParameterValue& value : values) {
        if (value.name == m_axis.generator + ".duration") {
            value.value = std::max(duration_s, 0.001); // by hand it ends when it says so
        }
    }
    return values;
}

double ReferenceForm::peak() const {
    if (isPath()) {
        const Result<MoveReference> wanted = m_path->reference();
        return wanted ? referenceExcursion(*wanted, 0.0) : 0.0;
    }
    if (shape() == PlateausShape) {
        const Result<std::vector<double>> currents_A = plateaus_A();
        double peak_A = 0.0;
        for (const double current_A : currents_A ? *currents_A : std::vector<double>()) {
            peak_A = std::max(peak_A, std::fabs(current_A));
        }
        return peak_A;
    }
    const double base = valueOf(Field::Base);
    MoveReference wanted = reference();
    if (!isPosition()) {
        wanted.base = 0.0;
    }
    const double time_s = shape() == static_cast<int>(MoveReference::Shape::Staircase)
                              ? wanted.period_s * wanted.count
                              : valueOf(Field::Duration);
    return referenceExcursion(wanted, time_s) + (isPosition() ? 0.0 : std::fabs(base));
}

} // namespace halbench::app
