#include "devices/acquisition/derived_signals.h"

#include "devices/acquisition/expression.h"
#include "devices/recording/recording_csv.h"

#include <fmt/format.h>

#include <algorithm>

namespace halbench::devices {

namespace {

using Columns = std::vector<StreamLayout::Column>;

constexpr const char* Constant = "pi";

std::string trimmed(const std::string& text) {
    const std::size_t begin = text.find_first_not_of(" \t");
    return begin == std::string::npos ? std::string()
                                      : text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

Columns::const_iterator findColumn(const Columns& known, const std::string& name) {
    return std::find_if(known.begin(), known.end(),
                        [&](const StreamLayout::Column& column) { return column.name == name; });
}

Error taken(const std::string& name) {
    return {ErrorCode::InvalidInput, fmt::format("the name '{}' is taken", name), "choose another name"};
}

/// Recordings tell signals apart by their columns: hall.a and hall_a, both in T, are one.
bool isColumnTaken(const std::string& column, const Columns& known) {
    return column == csvColumnName("time", "s") ||
           std::any_of(known.begin(), known.end(), [&](const StreamLayout::Column& one) {
               return csvColumnName(one.name, one.unit) == column;
           });
}

Result<void> checkName(const std::string& name, const Columns& known) {
    if (!Expression::isName(name)) {
        return failure(ErrorCode::InvalidInput, fmt::format("'{}' is not a valid signal name", name),
                       "use letters, digits, dots and underscores; begin with a letter or underscore");
    }
    if (findColumn(known, name) != known.end() || name == Constant) {
        return failure(taken(name));
    }
    return {};
}

/// Units of the sources, in their order.
Result<std::vector<std::string>> sourceUnits(const Expression& expression, const Columns& known) {
    if (expression.names().empty()) {
        return failure(ErrorCode::InvalidInput, "the expression contains no signal",
                       "use signal names as in recordings, e.g. current.a");
    }
    std::vector<std::string> units;
    for (const std::string& name : expression.names()) {
        const auto found = findColumn(known, name);
        if (found == known.end()) {
            return failure(ErrorCode::InvalidInput,
                           fmt::format("column {} of the expression: unknown signal '{}'",
                                       expression.columnOf(name), name),
                           "use signal names as in recordings, e.g. current.a");
        }
        units.push_back(found->unit);
    }
    return units;
}

} // namespace

Result<DerivedSignal> parseDerivedSignal(const std::string& text) {
    const std::size_t equals = text.find('=');
    std::string name = trimmed(text.substr(0, equals));
    DerivedSignal derived;
    if (const std::size_t bracket = name.find('['); bracket != std::string::npos && name.back() == ']') {
        derived.unit = trimmed(name.substr(bracket + 1, name.size() - bracket - 2));
        name = trimmed(name.substr(0, bracket));
    }
    derived.name = name;
    derived.expression = equals == std::string::npos ? std::string() : trimmed(text.substr(equals + 1));
    if (derived.name.empty() || derived.expression.empty()) {
        return failure(ErrorCode::InvalidInput, fmt::format("'{}' defines no signal", text),
                       "write NAME = EXPRESSION or NAME [UNIT] = EXPRESSION");
    }
    return derived;
}

Result<Derivation> deriveSignal(const DerivedSignal& derived, const Columns& known) {
    if (const Result<void> name = checkName(derived.name, known); !name) {
        return failure(name.error());
    }
    Result<std::unique_ptr<Expression>> expression = Expression::read(derived.expression);
    if (!expression) {
        return failure(expression.error());
    }
    const Result<std::vector<std::string>> units = sourceUnits(**expression, known);
    if (!units) {
        return failure(units.error());
    }
    const std::optional<std::string> unit =
        derived.unit.empty() ? (*expression)->unit(*units) : std::optional(derived.unit);
    if (!unit) {
        return failure(ErrorCode::InvalidInput, "the unit of the expression cannot be determined",
                       "give the unit of the result, 1 for a number; terms of a sum need equal units");
    }
    if (isColumnTaken(csvColumnName(derived.name, *unit), known)) {
        return failure(taken(derived.name));
    }
    return Derivation{(*expression)->names(), *unit};
}

/// One expression with the places of its variables in a block.
struct DerivedSignals::Formula {
    DerivedSignal derived;
    std::unique_ptr<Expression> expression;
    std::vector<double> values;
    std::vector<std::size_t> columns;

    bool isIn(const StreamLayout& layout) const {
        return std::all_of(expression->names().begin(), expression->names().end(),
                           [&](const std::string& name) { return layout.indexOf(name) >= 0; });
    }

    void place(const StreamLayout& layout) {
        columns.clear();
        for (const std::string& name : expression->names()) {
            columns.push_back(static_cast<std::size_t>(layout.indexOf(name)));
        }
        values.resize(columns.size());
    }

    double value(const BlockColumns& shown, const SampleBlock& block, std::size_t row) {
        for (std::size_t i = 0; i < columns.size(); ++i) {
            values[i] = shown.value(block, row, columns[i]);
        }
        return expression->value(values);
    }
};

DerivedSignals::DerivedSignals() = default;
DerivedSignals::~DerivedSignals() = default;

void DerivedSignals::set(const std::vector<DerivedSignal>& list, const Columns& known) {
    m_formulas.clear();
    m_from.reset();
    for (const DerivedSignal& derived : list) {
        if (const Result<Derivation> derivation = deriveSignal(derived, known)) {
            auto formula = std::make_unique<Formula>();
            formula->derived = {derived.name, derived.expression, derivation->unit};
            formula->expression = *Expression::read(derived.expression);
            m_formulas.push_back(std::move(formula));
        }
    }
}

std::vector<DerivedSignals::Computed> DerivedSignals::computed() const {
    std::vector<Computed> all;
    for (const auto& formula : m_formulas) {
        all.push_back({formula->derived, formula->expression->names()});
    }
    return all;
}

std::shared_ptr<const StreamLayout> DerivedSignals::layoutWith(const StreamLayout& layout,
                                                               const std::vector<Formula*>& formulas) {
    auto extended = std::make_shared<StreamLayout>(layout);
    for (Formula* formula : formulas) {
        extended->columns.push_back({formula->derived.name, formula->derived.unit});
        formula->place(layout);
    }
    return extended;
}

void DerivedSignals::addTo(BlockColumns& columns, const SampleBlock& block) {
    std::vector<Formula*> formulas;
    for (const auto& formula : m_formulas) {
        if (formula->isIn(*block.layout)) {
            formulas.push_back(formula.get());
        }
    }
    if (formulas.empty()) {
        return;
    }
    if (m_from != block.layout) { // one layout of the result for all blocks of a stream
        m_to = layoutWith(*block.layout, formulas);
        m_from = block.layout;
    }
    columns.layout = m_to;
    for (Formula* formula : formulas) {
        std::vector<double>& values = columns.added.emplace_back();
        values.reserve(block.rows());
        for (std::size_t row = 0; row < block.rows(); ++row) {
            values.push_back(formula->value(columns, block, row));
        }
    }
}

namespace {

/// Row by row, the added columns behind those of the block.
std::vector<double> valuesOf(const SampleBlock& block, const BlockColumns& columns) {
    const std::vector<ColumnSource> sources = columns.sources(block);
    std::vector<double> values;
    values.reserve(block.rows() * sources.size());
    for (std::size_t row = 0; row < block.rows(); ++row) {
        for (const ColumnSource& source : sources) {
            values.push_back(source.values[row * source.stride]);
        }
    }
    return values;
}

} // namespace

Result<Recording> withDerived(Recording recording, const std::vector<DerivedSignal>& list) {
    Columns known = recording.layout->columns;
    for (const DerivedSignal& derived : list) { // each may use those before it
        const Result<Derivation> derivation = deriveSignal(derived, known);
        if (!derivation) {
            const Error& error = derivation.error();
            return failure(error.code, fmt::format("{}: {}", derived.name, error.message), error.hint);
        }
        DerivedSignals one;
        one.set({derived}, known);
        SampleBlock rows{recording.layout, std::move(recording.time_s), std::move(recording.values)};
        BlockColumns columns;
        one.addTo(columns, rows);
        recording.values = valuesOf(rows, columns);
        recording.time_s = std::move(rows.time_s);
        recording.layout = columns.layout;
        known = recording.layout->columns;
    }
    return recording;
}

} // namespace halbench::devices
