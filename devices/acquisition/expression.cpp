#include "devices/acquisition/expression.h"

#include "control/base/unit_algebra.h"
#include "control/base/units.h"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

namespace halbench::devices {

namespace {

/// Names of signals have dots ("hall.a").
constexpr const char* NameLetters = "0123456789_abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ.";
constexpr std::string_view NoFirstLetters = "0123456789.";
constexpr std::size_t MostLetters = 1000;
constexpr const char* Known =
    "operators are + - * / ^ and comparisons, functions sin, cos, atan2, sqrt, abs, exp, ln, min, max";

/// Without the space that the parser puts behind the text.
std::string tokenOf(const mu::ParserError& error) {
    const std::string& token = error.GetToken();
    return token.substr(0, token.find_last_not_of(' ') + 1);
}

Error mistakeAt(std::size_t column, const mu::ParserError& error) {
    switch (error.GetCode()) {
    case mu::ecEMPTY_EXPRESSION:
    case mu::ecUNEXPECTED_EOF:
        return {ErrorCode::InvalidInput, fmt::format("column {} of the expression: unexpected end", column),
                Known};
    case mu::ecMISSING_PARENS:
        return {ErrorCode::InvalidInput, fmt::format("column {} of the expression: missing )", column),
                "close every ("};
    case mu::ecMISSING_ELSE_CLAUSE:
        return {ErrorCode::InvalidInput, fmt::format("column {} of the expression: missing :", column),
                "every ? needs a :"};
    case mu::ecTOO_MANY_PARAMS:
        return {ErrorCode::InvalidInput,
                fmt::format("column {} of the expression: too many arguments for {}", column, tokenOf(error)),
                Known};
    case mu::ecTOO_FEW_PARAMS:
        return {ErrorCode::InvalidInput,
                fmt::format("column {} of the expression: too few arguments for {}", column, tokenOf(error)),
                Known};
    default:
        return {ErrorCode::InvalidInput,
                fmt::format("column {} of the expression: unexpected '{}'", column, tokenOf(error)), Known};
    }
}

/// Counted from 1 as the user sees letters: those beyond ASCII have several octets (UTF-8).
std::size_t columnAt(const std::string& text, std::size_t octet) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(octet, text.size()));
    return 1 + static_cast<std::size_t>(std::count_if(text.begin(), end, [](char one) {
               return (static_cast<unsigned char>(one) & 0xC0U) != 0x80U;
           }));
}

/// At most directly behind the text, where the parser counts a space of its own. Of a choice without its end
/// the parser does not say where it begins.
Error mistake(const mu::ParserError& error, const std::string& text) {
    const std::size_t octet = error.GetCode() == mu::ecMISSING_ELSE_CLAUSE
                                  ? text.rfind('?')
                                  : static_cast<std::size_t>(std::max(error.GetPos(), 0));
    return mistakeAt(columnAt(text, octet), error);
}

/// Column of an "=" that compares nothing: it would be an assignment.
std::optional<std::size_t> assignmentIn(const std::string& text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool isSecond = i > 0 && std::string_view("=<>!").find(text[i - 1]) != std::string_view::npos;
        const bool isFirst = i + 1 < text.size() && text[i + 1] == '=';
        if (text[i] == '=' && !isSecond && !isFirst) {
            return columnAt(text, i);
        }
    }
    return std::nullopt;
}

} // namespace

class Expression::Parser : public mu::Parser {
public:
    explicit Parser(const std::string& text) {
        DefineNameChars(NameLetters);
        DefineConst("pi", Pi);
        SetExpr(text);
    }
};

Expression::Expression(std::string text, std::vector<std::string> names)
    : m_text(std::move(text)), m_names(std::move(names)), m_values(m_names.size()) {}

Expression::~Expression() = default;

bool Expression::isName(const std::string& name) {
    return !name.empty() && name.find_first_not_of(NameLetters) == std::string::npos &&
           NoFirstLetters.find(name.front()) == std::string_view::npos;
}

Result<std::unique_ptr<Expression>> Expression::read(const std::string& text) {
    if (const auto column = assignmentIn(text)) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("column {} of the expression: = is not an operator", *column),
                       "use == to compare");
    }
    if (text.size() > MostLetters) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("the expression has more than {} characters", MostLetters),
                       "split it: a derived signal may use the derived signals before it");
    }
    try {
        auto parser = std::make_unique<Parser>(text);
        std::vector<std::string> names;
        for (const auto& [name, unused] : parser->GetUsedVar()) {
            names.push_back(name);
        }
        std::unique_ptr<Expression> expression(new Expression(text, std::move(names)));
        for (std::size_t i = 0; i < expression->m_names.size(); ++i) {
            parser->DefineVar(expression->m_names[i], &expression->m_values[i]);
        }
        parser->Eval(); // what only shows now: the number of arguments, a missing operator
        if (parser->GetNumResults() > 1) {
            return failure(ErrorCode::InvalidInput, "the expression has several results",
                           "use one result; the comma separates function arguments");
        }
        expression->m_parser = std::move(parser);
        return expression;
    } catch (const mu::ParserError& error) {
        return failure(mistake(error, text));
    }
}

/// As a whole word: "current" stands in "current.a" but is another name.
std::size_t Expression::columnOf(const std::string& name) const {
    const std::string_view letters = NameLetters;
    for (std::size_t at = m_text.find(name); at != std::string::npos; at = m_text.find(name, at + 1)) {
        const std::size_t end = at + name.size();
        const bool isLonger = (at > 0 && letters.find(m_text[at - 1]) != std::string_view::npos) ||
                              (end < m_text.size() && letters.find(m_text[end]) != std::string_view::npos);
        if (!isLonger) {
            return columnAt(m_text, at);
        }
    }
    return 1;
}

double Expression::value(const std::vector<double>& values) {
    std::copy(values.begin(), values.end(), m_values.begin());
    try {
        const double result = m_parser->Eval();
        return std::isfinite(result) ? result : std::numeric_limits<double>::quiet_NaN();
    } catch (const mu::ParserError&) { // a function outside its range
        return std::numeric_limits<double>::quiet_NaN();
    }
}

std::optional<std::string> Expression::unit(const std::vector<std::string>& units) {
    return unitOf([this](const std::vector<double>& arguments) { return value(arguments); }, units);
}

} // namespace halbench::devices
