#pragma once

#include "control/base/result.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace halbench::devices {

/// An expression of names, numbers, operators and functions, read once and computed for every row. Names may
/// have dots. Belongs to one thread.
class Expression {
public:
    ~Expression();

    /// Letters, digits, dots and underscores; begins with a letter or an underscore.
    static bool isName(const std::string& name);

    /// Errors: InvalidInput with the column of the mistake, counted from 1.
    static Result<std::unique_ptr<Expression>> read(const std::string& text);

    const std::vector<std::string>& names() const { return m_names; } ///< in alphabetical order
    /// Where a name stands first, counted from 1.
    std::size_t columnOf(const std::string& name) const;

    /// With values for the names, in their order; NaN where the result is no finite number.
    double value(const std::vector<double>& values);

    /// Of the value, when it follows from the units of the names (control/base/unit_algebra.h).
    std::optional<std::string> unit(const std::vector<std::string>& units);

private:
    class Parser;

    Expression(std::string text, std::vector<std::string> names);

    std::string m_text;
    std::vector<std::string> m_names;
    std::vector<double> m_values; ///< the parser points to them
    std::unique_ptr<Parser> m_parser;
};

} // namespace halbench::devices
