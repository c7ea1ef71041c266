#include "app/workspaces/drive/path_form.h"

#include "app/procedures/excite/travel_reference.h"
#include "app/workspaces/parts/number_check.h"
#include "app/workspaces/parts/panel_parts.h"
#include "control/base/units.h"
#include "widgets/controls/quantity_edit.h"
#include "widgets/language/number_text.h"
#include "widgets/language/phrasebook.h"
#include "widgets/theme/theme_style.h"

#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

namespace halbench::app {

namespace {

using Shape = MoveReference::Shape;
using Quantity = MoveReference::Quantity;

/// Words of a setting in the form, its first value and its step in SI.
struct Appearance {
    ReferenceSetting setting;
    const char* title;
    double initial;
    double step;
};

constexpr Appearance Appearances[] = {
    {{"radius", Quantity::Length}, QT_TRANSLATE_NOOP("halbench::app::PathForm", "Radius"), 1e-3, 1e-4},
    {{"turns", Quantity::Length}, QT_TRANSLATE_NOOP("halbench::app::PathForm", "Turns"), 1.0, 1.0},
    {{"width", Quantity::Length}, QT_TRANSLATE_NOOP("halbench::app::PathForm", "Line length"), 2e-3, 1e-4},
    {{"lines", Quantity::Length}, QT_TRANSLATE_NOOP("halbench::app::PathForm", "Lines"), 5.0, 1.0},
    {{"pitch", Quantity::Length}, QT_TRANSLATE_NOOP("halbench::app::PathForm", "Line spacing"), 2e-4, 1e-5},
    {{"angle", Quantity::Length},
     QT_TRANSLATE_NOOP("halbench::app::PathForm", "Angle"),
     0.5 * Pi,
     Pi / 180.0},
    {{"heading", Quantity::Length}, QT_TRANSLATE_NOOP("halbench::app::PathForm", "Heading"), 0.0, Pi / 180.0},
    {{"length", Quantity::Length}, QT_TRANSLATE_NOOP("halbench::app::PathForm", "Length"), 2e-3, 1e-4},
    {{"dwell", Quantity::Length}, QT_TRANSLATE_NOOP("halbench::app::PathForm", "Dwell"), 0.5, 0.1},
    {{"rate", Quantity::Length}, QT_TRANSLATE_NOOP("halbench::app::PathForm", "Speed"), 0.01, 1e-3},
    {{"acceleration", Quantity::Length},
     QT_TRANSLATE_NOOP("halbench::app::PathForm", "Acceleration"),
     0.5,
     0.1},
    {{"jerk", Quantity::Length}, QT_TRANSLATE_NOOP("halbench::app::PathForm", "Jerk"), 20.0, 1.0},
    {{"rate", Quantity::Angle}, QT_TRANSLATE_NOOP("halbench::app::PathForm", "Rotation speed"), 0.1, 0.01},
    {{"acceleration", Quantity::Angle},
     QT_TRANSLATE_NOOP("halbench::app::PathForm", "Rotation accel."),
     1.0,
     0.1},
    {{"jerk", Quantity::Angle}, QT_TRANSLATE_NOOP("halbench::app::PathForm", "Rotation jerk"), 50.0, 1.0},
};

struct Title {
    Shape shape;
    const char* words;
};

constexpr Title Titles[] = {
    {Shape::Circle, QT_TRANSLATE_NOOP("halbench::app::PathForm", "Circle")},
    {Shape::Raster, QT_TRANSLATE_NOOP("halbench::app::PathForm", "Raster")},
    {Shape::Arc, QT_TRANSLATE_NOOP("halbench::app::PathForm", "Arc")},
    {Shape::Line, QT_TRANSLATE_NOOP("halbench::app::PathForm", "Line")},
    {Shape::Table, QT_TRANSLATE_NOOP("halbench::app::PathForm", "Table of poses")},
};

bool isJerk(const ReferenceSetting& setting) {
    return setting.stem == "jerk";
}

/// A sentence of the user's language from one without its capital.
QString sentence(std::string_view help) {
    const QString words = widgets::inWords(std::string(help));
    return words.left(1).toUpper() + words.mid(1);
}

} // namespace

std::vector<Shape> offeredPaths(const devices::Catalogue& catalogue) {
    std::vector<Shape> shapes;
    if (pathAxes(catalogue)) {
        shapes = {Shape::Circle, Shape::Raster, Shape::Arc, Shape::Line};
    }
    if (catalogue.findParameter("table.number") != nullptr) {
        shapes.push_back(Shape::Table);
    }
    return shapes;
}

QString pathTitle(Shape shape) {
    const auto* title = std::find_if(std::begin(Titles), std::end(Titles),
                                     [shape](const Title& each) { return each.shape == shape; });
    return title == std::end(Titles) ? QString() : PathForm::tr(title->words);
}

PathForm::PathForm(QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    m_layout = new QFormLayout;
    m_layout->setSpacing(widgets::GridStep_px);
    for (const Appearance& appearance : Appearances) {
        addRow(appearance.setting);
    }
    buildFile();
    m_note = makeNote(this);
    column->addLayout(m_layout);
    column->addWidget(m_note);
    layOut();
}

void PathForm::addRow(const ReferenceSetting& setting) {
    const auto* appearance = std::find_if(std::begin(Appearances), std::end(Appearances),
                                          [&](const Appearance& each) { return each.setting == setting; });
    auto* field = makeNumberField({}, this);
    auto* label = new QLabel(tr(appearance->title), this);
    label->setBuddy(field);
    Row row{setting, settingSpec(setting), field, new NumberCheck(*field), label};
    dress(row);
    const QSignalBlocker quiet(field);
    field->setValue(appearance->initial * displayQuantity(row.spec.unit, m_units).factor);
    m_rows.push_back(row);
    connect(row.check, &NumberCheck::refused, this, &PathForm::refused);
    connect(field, QOverload<double>::of(&widgets::QuantityEdit::valueChanged), this, &PathForm::say);
}

void PathForm::buildFile() {
    m_fileRow = new QWidget(this);
    auto* row = new QVBoxLayout(m_fileRow); // a name beside a button would not be seen
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(widgets::GridStep_px);
    m_file = new QLineEdit(m_fileRow);
    m_file->setReadOnly(true);
    m_file->setPlaceholderText(tr("No file"));
    m_file->setAccessibleName(tr("Table of poses"));
    m_file->setToolTip(tr("File that the motion follows"));
    auto* choose =
        makeButton({tr("Choose file…"), tr("CSV with columns like time_s, x_mm, phi_mrad"), {}}, m_fileRow);
    row->addWidget(m_file);
    row->addWidget(choose);
    m_fileLabel = new QLabel(tr("File"), this);
    m_fileLabel->setBuddy(choose);
    connect(choose, &QPushButton::clicked, this, &PathForm::fileWanted);
}

void PathForm::dress(Row& row) const {
    const auto* appearance =
        std::find_if(std::begin(Appearances), std::end(Appearances),
                     [&](const Appearance& each) { return each.setting == row.setting; });
    const DisplayQuantity shown = displayQuantity(row.spec.unit, m_units);
    QString help = sentence(row.spec.help);
    help = isJerk(row.setting) ? tr("%1; 0: no limit").arg(help) : help;
    dressNumberField(*row.field,
                     {tr(appearance->title), help, shown.unit, row.spec.isWhole ? 0 : shown.decimals,
                      row.spec.min * shown.factor, row.spec.max * shown.factor,
                      row.spec.isWhole ? 1.0 : shownStep(shown, appearance->step)});
}

void PathForm::setUnits(const DisplayUnits& units) {
    if (units == m_units) {
        return;
    }
    const DisplayUnits before = m_units;
    m_units = units;
    for (Row& row : m_rows) {
        const QSignalBlocker quiet(row.field);
        const double value = row.field->value() / displayQuantity(row.spec.unit, before).factor;
        dress(row);
        row.field->setValue(value * displayQuantity(row.spec.unit, m_units).factor);
    }
    say();
}

void PathForm::setShape(Shape shape) {
    m_shape = shape;
    layOut();
}

/// Only the rows of the shape are laid out: a hidden row would leave its gap.
void PathForm::layOut() {
    while (m_layout->rowCount() > 0) {
        const QFormLayout::TakeRowResult row = m_layout->takeRow(0);
        delete row.labelItem;
        delete row.fieldItem;
    }
    const bool isTable = m_shape == Shape::Table;
    if (isTable) {
        m_layout->addRow(m_fileLabel, m_fileRow);
    }
    m_fileLabel->setVisible(isTable);
    m_fileRow->setVisible(isTable);
    const std::vector<ReferenceSetting> wanted = settingsOf(m_shape);
    for (Row& row : m_rows) {
        const bool isShown = std::find(wanted.begin(), wanted.end(), row.setting) != wanted.end();
        row.field->setVisible(isShown);
        row.label->setVisible(isShown);
    }
    for (const ReferenceSetting& setting : wanted) {
        Row& row = rowOf(setting);
        m_layout->addRow(row.label, row.field);
    }
    say();
}

PathForm::Row& PathForm::rowOf(const ReferenceSetting& setting) {
    return *std::find_if(m_rows.begin(), m_rows.end(),
                         [&](const Row& row) { return row.setting == setting; });
}

const PathForm::Row& PathForm::rowOf(const ReferenceSetting& setting) const {
    return *std::find_if(m_rows.begin(), m_rows.end(),
                         [&](const Row& row) { return row.setting == setting; });
}

void PathForm::setTable(const QString& path, Result<PoseTable> table) {
    m_file->setText(QFileInfo(path).fileName());
    m_file->setToolTip(path);
    m_table = std::move(table);
    say();
}

/// A dwell is for tables without times, and no jerk limit is no key.
Result<void> PathForm::setIn(MoveReference& reference, const Row& row) const {
    const double value = row.field->value() / displayQuantity(row.spec.unit, m_units).factor;
    const bool hasTimes = m_table && *m_table && !(*m_table)->time_s.empty();
    if ((isJerk(row.setting) && value == 0.0) || (row.setting.stem == "dwell" && hasTimes)) {
        return {};
    }
    return setMoveReference(reference, row.spec.key, value);
}

Result<MoveReference> PathForm::reference() const {
    MoveReference reference;
    reference.shape = m_shape;
    if (m_shape == Shape::Table) {
        if (!m_table) {
            return failure(ErrorCode::InvalidInput, tr("No table of poses is chosen.").toStdString(),
                           tr("Choose a CSV file.").toStdString());
        }
        if (!*m_table) {
            return failure(m_table->error());
        }
        reference.file = (*m_table)->origin;
    }
    for (const ReferenceSetting& setting : settingsOf(m_shape)) {
        if (auto set = setIn(reference, rowOf(setting)); !set) {
            return failure(set.error());
        }
    }
    if (auto complete = checkMoveReference(reference); !complete) {
        return failure(complete.error());
    }
    if (m_shape == Shape::Table) {
        if (auto attached = attachTable(reference, **m_table); !attached) {
            return failure(attached.error());
        }
    }
    return reference;
}

Result<MoveReference> PathForm::take() {
    for (const ReferenceSetting& setting : settingsOf(m_shape)) {
        if (const Result<double> taken = rowOf(setting).check->take(); !taken) {
            return failure(taken.error());
        }
    }
    return reference();
}

/// What would be done, before it is done; or why it cannot be.
void PathForm::say() {
    const Result<MoveReference> wanted = reference();
    if (wanted) {
        const double time_s = travelTime_s(*wanted).value_or(0.0);
        m_note->setText(tr("Travel time: %1 s").arg(widgets::fixedText(time_s, 3)));
    } else {
        m_note->setText(widgets::inWords(wanted.error().message));
    }
    m_note->setToolTip(wanted ? QString() : widgets::inWords(wanted.error().hint));
    const bool isQuiet = wanted || (m_shape == Shape::Table && !m_table);
    showRole(*m_note, isQuiet ? widgets::Role::Muted : widgets::Role::Bad);
    Q_EMIT changed();
}

} // namespace halbench::app
