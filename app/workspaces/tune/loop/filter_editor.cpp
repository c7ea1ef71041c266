#include "app/workspaces/tune/loop/filter_editor.h"

#include "app/documents/filtered_gains.h"
#include "app/workspaces/parts/figure_units.h"
#include "control/base/units.h"
#include "widgets/controls/optional_number_edit.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme_style.h"

#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace halbench::app {
namespace {

using control::LoopFilter;

using control::MostFilters;
constexpr double LargestFrequency = 1e6;

/// What a filter is at first: one that a usual loop hardly feels.
LoopFilter firstOf(int kind) {
    const LoopFilter filters[] = {control::LeadFilter{50.0, 20.0}, control::LagFilter{2.0, 2.0},
                                  control::NotchFilter{150.0, 0.3, 0.5}, control::LowPassFilter{250.0, 1},
                                  control::SectionFilter{{0.8, 0.8, 0.0, 0.8, 0.0}}};
    return filters[kind];
}

bool isFrequency(const LoopFilter& filter, std::size_t figure) {
    return figure == 0 && !std::holds_alternative<control::SectionFilter>(filter);
}

widgets::NumberLimits limitsOf(const LoopFilter& filter, std::size_t figure) {
    constexpr double MostPhase_deg = 89.0;
    if (std::holds_alternative<control::SectionFilter>(filter)) {
        constexpr double Most = 1000.0; // of the board's parameters
        const bool isOfDenominator = figure > 2;
        return isOfDenominator ? widgets::NumberLimits{0.0, 4.0, true}
                               : widgets::NumberLimits{-Most, Most, true};
    }
    if (isFrequency(filter, figure)) {
        return {0.0, LargestFrequency, false};
    }
    const widgets::NumberLimits limits[] = {
        {-MostPhase_deg, MostPhase_deg, true}, {1.0, 1e6, false}, {0.0, 1.0, true}, {1.0, 2.0, true}};
    const bool isWidth = figure == 2;
    return isWidth ? widgets::NumberLimits{0.0, 10.0, false} : limits[filter.index()];
}

} // namespace

FilterEditor::FilterEditor(QWidget* parent)
    : QWidget(parent), m_toggle(new QToolButton(this)), m_body(new QWidget(this)), m_note(new QLabel(m_body)),
      m_list(new QVBoxLayout), m_add(new QPushButton(m_body)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(widgets::GridStep_px);
    column->addWidget(m_toggle, 0, Qt::AlignLeft);
    column->addWidget(m_body);
    auto* inner = new QVBoxLayout(m_body);
    inner->setContentsMargins(0, 0, 0, 0);
    inner->setSpacing(widgets::GridStep_px);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(widgets::PanelMargin_px);
    grid->setVerticalSpacing(widgets::GridStep_px);
    grid->setColumnStretch(1, 1);
    inner->addWidget(m_note);
    inner->addLayout(grid);
    inner->addLayout(m_list);
    inner->addWidget(m_add, 0, Qt::AlignLeft);
    m_list->setSpacing(widgets::GridStep_px);
    m_note->setWordWrap(true);
    widgets::setRole(*m_note, widgets::Role::Muted);
    m_toggle->setCheckable(true);
    m_toggle->setAutoRaise(true);
    m_toggle->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_toggle->setIcon(widgets::themedIcon(QStringLiteral("filter")));
    m_add->setIcon(widgets::themedIcon(QStringLiteral("add")));
    int line = 0;
    for (Field* field : {&m_b, &m_c, &m_time}) {
        *field = addField(*grid, line++);
        connect(field->edit, &widgets::OptionalNumberEdit::valueChanged, this, [this, field] {
            const auto value = field->edit->value();
            if (value && field == &m_time) {
                m_shaping.gains.filter_s = *value;
            } else if (value) {
                (field == &m_b ? m_shaping.proportionalWeight : m_shaping.derivativeWeight) = *value;
            }
            Q_EMIT edited(tr("Edit %1").arg(field->edit->accessibleName()), true);
        });
    }
    m_b.edit->setLimits({0.0, 1.0, true});
    m_c.edit->setLimits({0.0, 1.0, true});
    m_time.edit->setLimits({0.0, 1e3, true});
    m_b.edit->setObjectName(QStringLiteral("weight.b"));
    m_c.edit->setObjectName(QStringLiteral("weight.c"));
    m_time.edit->setObjectName(QStringLiteral("filter.time"));
    connect(m_toggle, &QToolButton::toggled, this, &FilterEditor::expand);
    connect(m_toggle, &QToolButton::clicked, this, &FilterEditor::bringIntoSight);
    connect(m_add, &QPushButton::clicked, this, [this] {
        addFilter(firstOf(static_cast<int>(LoopFilter(control::LowPassFilter{}).index())));
        m_rows.back().kind->setFocus(Qt::OtherFocusReason);
        bringIntoSight();
        Q_EMIT edited(tr("Add a filter"), false);
    });
    sayWords();
    showAll();
    expand(false);
}

FilterEditor::Field FilterEditor::addField(QGridLayout& grid, int line) {
    const Field field{new QLabel(m_body), new widgets::OptionalNumberEdit(m_body), new QLabel(m_body)};
    field.name->setBuddy(field.edit);
    widgets::setRole(*field.unit, widgets::Role::Muted);
    grid.addWidget(field.name, line, 0);
    grid.addWidget(field.edit, line, 1);
    grid.addWidget(field.unit, line, 2);
    return field;
}

void FilterEditor::addFilter(const LoopFilter& filter) {
    Filter row;
    row.box = new QWidget(m_body);
    row.kind = new QComboBox(row.box);
    row.remove = new QToolButton(row.box);
    row.grid = new QGridLayout(row.box);
    row.grid->setContentsMargins(0, 0, 0, 0);
    row.grid->setHorizontalSpacing(widgets::PanelMargin_px);
    row.grid->setVerticalSpacing(widgets::GridStep_px);
    row.grid->setColumnStretch(1, 1);
    row.grid->addWidget(row.kind, 0, 0, 1, 2);
    row.grid->addWidget(row.remove, 0, 2);
    row.remove->setAutoRaise(true);
    row.remove->setIcon(widgets::themedIcon(QStringLiteral("remove")));
    row.filter = filter;
    for (std::size_t i = 0; i < std::variant_size_v<LoopFilter>; ++i) {
        row.kind->addItem(QString());
    }
    row.kind->setCurrentIndex(static_cast<int>(filter.index()));
    QWidget* box = row.box;
    connect(row.kind, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
            [this, box](int kind) { chooseKind(box, kind); });
    connect(row.remove, &QToolButton::clicked, this, [this, box] { removeFilter(box); });
    m_list->addWidget(box);
    box->show(); // at once: who added it goes on in it
    m_rows.push_back(std::move(row));
    buildFields(m_rows.back());
    sayFilter(m_rows.size() - 1);
    m_add->setEnabled(m_rows.size() < MostFilters);
}

void FilterEditor::buildFields(Filter& row) {
    for (const Field& field : row.fields) {
        for (QWidget* part : std::initializer_list<QWidget*>{field.name, field.edit, field.unit}) {
            part->hide();
            part->setObjectName({}); // until it is gone, others are called so
            part->deleteLater();
        }
    }
    row.fields.clear();
    QWidget* box = row.box;
    for (std::size_t i = 0; i < figuresOf(row.filter).size(); ++i) {
        const Field field = addField(*row.grid, static_cast<int>(i) + 1);
        field.edit->setLimits(limitsOf(row.filter, i));
        row.fields.push_back(field);
        for (QWidget* part : std::initializer_list<QWidget*>{field.name, field.edit, field.unit}) {
            part->show();
        }
        connect(field.edit, &widgets::OptionalNumberEdit::valueChanged, this,
                [this, box, i] { takeFigure(box, i); });
        Q_EMIT fieldAdded(field.edit);
    }
    showFigures(row);
}

FilterEditor::Filter* FilterEditor::rowOf(const QWidget* box) {
    const auto found =
        std::find_if(m_rows.begin(), m_rows.end(), [box](const Filter& row) { return row.box == box; });
    return found == m_rows.end() ? nullptr : &*found;
}

/// At the frequency that it had.
void FilterEditor::chooseKind(QWidget* box, int kind) {
    Filter& row = *rowOf(box);
    std::vector<double> figures = figuresOf(firstOf(kind));
    figures.front() = figuresOf(row.filter).front();
    row.filter = filterOf(static_cast<std::size_t>(kind), figures);
    buildFields(row);
    sayFilter(static_cast<std::size_t>(&row - m_rows.data()));
    Q_EMIT edited(tr("Type of filter %1").arg(&row - m_rows.data() + 1), false);
}

void FilterEditor::takeFigure(QWidget* box, std::size_t figure) {
    Filter& row = *rowOf(box);
    const widgets::OptionalNumberEdit& edit = *row.fields[figure].edit;
    if (const auto value = edit.value()) {
        std::vector<double> figures = figuresOf(row.filter);
        figures[figure] = *value / factorOf(row.filter, figure);
        row.filter = filterOf(row.filter.index(), figures);
    }
    Q_EMIT edited(tr("Edit %1").arg(edit.accessibleName()), true);
}

void FilterEditor::removeFilter(QWidget* box) {
    const auto at = static_cast<std::size_t>(rowOf(box) - m_rows.data());
    dropFilter(at);
    QWidget* next =
        m_rows.empty() ? static_cast<QWidget*>(m_add) : m_rows[std::min(at, m_rows.size() - 1)].kind;
    next->setFocus(Qt::OtherFocusReason);
    Q_EMIT edited(tr("Remove a filter"), false);
}

void FilterEditor::dropFilter(std::size_t at) {
    m_rows[at].box->hide();
    m_rows[at].box->deleteLater();
    m_rows.erase(m_rows.begin() + static_cast<std::ptrdiff_t>(at));
    m_add->setEnabled(m_rows.size() < MostFilters);
    sayWords(); // the others have other numbers
}

double FilterEditor::factorOf(const LoopFilter& filter, std::size_t figure) const {
    return isFrequency(filter, figure) ? frequencyFactor(m_unit) / (2.0 * Pi) : 1.0;
}

void FilterEditor::showFigures(Filter& row) {
    const std::vector<double> figures = figuresOf(row.filter);
    for (std::size_t i = 0; i < figures.size(); ++i) {
        row.fields[i].edit->setValue(figures[i] * factorOf(row.filter, i));
    }
}

void FilterEditor::showAll() {
    m_b.edit->setValue(m_shaping.proportionalWeight);
    m_c.edit->setValue(m_shaping.derivativeWeight);
    m_time.edit->setValue(m_shaping.gains.filter_s.value_or(0.0));
    for (Filter& row : m_rows) {
        showFigures(row);
    }
}

void FilterEditor::setFrequencyUnit(FrequencyUnit unit) {
    m_unit = unit;
    sayWords();
    showAll();
}

void FilterEditor::setOffered(const std::optional<BoardLawSpec>& offered) {
    m_offered = offered;
    sayOffered();
}

void FilterEditor::setShaping(const std::optional<control::FilteredLaw>& filtered) {
    const control::FilteredLaw wanted = filtered.value_or(control::FilteredLaw{});
    m_shaping = wanted;
    while (m_rows.size() > wanted.filters.size()) {
        dropFilter(m_rows.size() - 1);
    }
    for (std::size_t i = 0; i < wanted.filters.size(); ++i) {
        if (i == m_rows.size()) {
            addFilter(wanted.filters[i]);
            continue;
        }
        Filter& row = m_rows[i];
        const bool isSameKind = row.filter.index() == wanted.filters[i].index();
        row.filter = wanted.filters[i];
        if (!isSameKind) {
            const QSignalBlocker quiet(row.kind);
            row.kind->setCurrentIndex(static_cast<int>(row.filter.index()));
            buildFields(row);
            sayFilter(i);
        }
    }
    showAll();
    if (filtered) {
        m_toggle->setChecked(true); // what counts is seen
    }
}

/// What was just opened or added, where its surroundings scroll; once it has its place.
void FilterEditor::bringIntoSight() {
    const auto scroll = [this] {
        QWidget* parent = parentWidget();
        while (parent != nullptr && qobject_cast<QScrollArea*>(parent) == nullptr) {
            parent = parent->parentWidget();
        }
        if (parent != nullptr && m_body->isVisible()) {
            static_cast<QScrollArea*>(parent)->ensureWidgetVisible(m_add);
        }
    };
    QMetaObject::invokeMethod(this, scroll, Qt::QueuedConnection);
}

Result<std::optional<control::FilteredLaw>> FilterEditor::filtered(const control::PidGains& gains) const {
    std::vector<const widgets::OptionalNumberEdit*> edits = {m_b.edit, m_c.edit, m_time.edit};
    control::FilteredLaw law = m_shaping;
    law.gains = gains;
    law.gains.filter_s = m_shaping.gains.filter_s;
    law.filters.clear();
    for (const Filter& row : m_rows) {
        law.filters.push_back(row.filter);
        for (const Field& field : row.fields) {
            edits.push_back(field.edit);
        }
    }
    for (const widgets::OptionalNumberEdit* edit : edits) {
        if (!edit->value()) {
            const QString problem = edit->isValid() ? tr("missing number") : edit->problem();
            return failure(ErrorCode::InvalidInput,
                           tr("%1: %2").arg(edit->accessibleName(), problem).toStdString(),
                           tr("Enter a number within the range").toStdString());
        }
    }
    return control::isBoardLaw(law) ? std::nullopt : std::optional(std::move(law));
}

void FilterEditor::expand(bool isShown) {
    m_body->setVisible(isShown);
}

} // namespace halbench::app
