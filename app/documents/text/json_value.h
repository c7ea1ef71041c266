#pragma once

#include "control/base/result.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace halbench::app {

struct JsonMember;

/// One JSON value. Members keep the order in which they were set, so that equal results give equal bytes.
/// A number that is not finite has no place in JSON: writing it is an error (our bug), never a silent null;
/// what is legitimately absent or unbounded is set with finiteOrNull().
class JsonValue {
public:
    using Array = std::vector<JsonValue>;
    using Object = std::vector<JsonMember>;

    JsonValue();
    JsonValue(std::nullptr_t);
    JsonValue(bool value);
    JsonValue(int value);
    JsonValue(std::int64_t value);
    JsonValue(std::uint64_t value);
    JsonValue(double value);
    JsonValue(const char* value);
    JsonValue(std::string_view value);
    JsonValue(std::string value);
    template <typename T>
    JsonValue(const std::optional<T>& value) : JsonValue(value ? JsonValue(*value) : JsonValue()) {}
    template <typename T>
    JsonValue(const std::vector<T>& values) : JsonValue(Array(values.begin(), values.end()), Tag{}) {}
    // Outside the class, because a member's type is complete only after it.
    JsonValue(const JsonValue& other);
    JsonValue(JsonValue&& other) noexcept;
    JsonValue& operator=(const JsonValue& other);
    JsonValue& operator=(JsonValue&& other) noexcept;
    ~JsonValue();

    static JsonValue array();
    static JsonValue object();

    bool isNull() const { return std::holds_alternative<std::monostate>(m_value); }
    bool isBoolean() const { return std::holds_alternative<bool>(m_value); }
    bool isNumber() const {
        return std::holds_alternative<double>(m_value) || std::holds_alternative<std::int64_t>(m_value);
    }
    bool isText() const { return std::holds_alternative<std::string>(m_value); }
    bool isArray() const { return std::holds_alternative<Array>(m_value); }
    bool isObject() const { return std::holds_alternative<Object>(m_value); }

    bool boolean() const { return std::get<bool>(m_value); }
    std::optional<std::int64_t> integer() const;
    /// A number that was set as an integer, beyond what a double can hold; else nullptr.
    const std::int64_t* exactInteger() const { return std::get_if<std::int64_t>(&m_value); }
    double number() const;
    const std::string& text() const { return std::get<std::string>(m_value); }
    const Array& items() const { return std::get<Array>(m_value); }
    const Object& members() const { return std::get<Object>(m_value); }

    /// Sets a member of an object (replacing one of the same name); returns itself for chaining.
    JsonValue& set(std::string key, JsonValue value);
    /// Appends to an array.
    JsonValue& push(JsonValue value);
    /// The member of this name, or nullptr (also when this is no object).
    const JsonValue* find(std::string_view key) const;

private:
    struct Tag {};
    JsonValue(Array items, Tag);

    std::variant<std::monostate, bool, std::int64_t, double, std::string, Array, Object> m_value;
};

struct JsonMember {
    std::string key;
    JsonValue value;
};

/// null for an infinite or undefined number: an infinite margin is "none", not a number.
JsonValue finiteOrNull(double value);
JsonValue finiteOrNull(const std::optional<double>& value);
/// null for a text that says nothing.
JsonValue textOrNull(const std::string& text);

/// UTF-8, two spaces of indentation, LF, a final newline; numbers in the shortest form that reads back
/// exactly. Error: Internal, naming the path of a number that is not finite.
Result<std::string> toJsonText(const JsonValue& value);

/// `origin` names the text in messages. Errors: InvalidInput with line and column.
Result<JsonValue> parseJson(const std::string& text, const std::string& origin);

} // namespace halbench::app
