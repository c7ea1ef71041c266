#include "app/documents/text/json_value.h"

#include "app/documents/text/numbers.h"
#include "control/base/assert.h"

#include <cmath>

namespace halbench::app {

JsonValue::JsonValue() = default;
JsonValue::JsonValue(std::nullptr_t) {}
JsonValue::JsonValue(bool value) : m_value(value) {}
JsonValue::JsonValue(int value) : m_value(static_cast<std::int64_t>(value)) {}
JsonValue::JsonValue(std::int64_t value) : m_value(value) {}
JsonValue::JsonValue(std::uint64_t value) : m_value(static_cast<std::int64_t>(value)) {}
JsonValue::JsonValue(double value) : m_value(value) {}
JsonValue::JsonValue(const char* value) : m_value(std::string(value)) {}
JsonValue::JsonValue(std::string_view value) : m_value(std::string(value)) {}
JsonValue::JsonValue(std::string value) : m_value(std::move(value)) {}

JsonValue::JsonValue(Array items, Tag) : m_value(std::move(items)) {}
JsonValue::JsonValue(const JsonValue& other) = default;
JsonValue::JsonValue(JsonValue&& other) noexcept = default;
JsonValue& JsonValue::operator=(const JsonValue& other) = default;
JsonValue& JsonValue::operator=(JsonValue&& other) noexcept = default;
JsonValue::~JsonValue() = default;

JsonValue JsonValue::array() {
    return JsonValue(Array{}, Tag{});
}

JsonValue JsonValue::object() {
    JsonValue value;
    value.m_value = Object{};
    return value;
}

std::optional<std::int64_t> JsonValue::integer() const {
    if (const std::int64_t* whole = std::get_if<std::int64_t>(&m_value)) {
        return *whole;
    }
    const double* real = std::get_if<double>(&m_value);
    if (real != nullptr && std::abs(*real) < 9.0e15 && *real == std::floor(*real)) {
        return static_cast<std::int64_t>(*real);
    }
    return std::nullopt;
}

double JsonValue::number() const {
    if (const std::int64_t* whole = std::get_if<std::int64_t>(&m_value)) {
        return static_cast<double>(*whole);
    }
    return std::get<double>(m_value);
}

JsonValue& JsonValue::set(std::string key, JsonValue value) {
    HB_ASSERT(isObject());
    Object& object = std::get<Object>(m_value);
    for (JsonMember& member : object) {
        if (member.key == key) {
            member.value = std::move(value);
            return *this;
        }
    }
    object.push_back({std::move(key), std::move(value)});
    return *this;
}

JsonValue& JsonValue::push(JsonValue value) {
    HB_ASSERT(isArray());
    std::get<Array>(m_value).push_back(std::move(value));
    return *this;
}

const JsonValue* JsonValue::find(std::string_view key) const {
    const Object* object = std::get_if<Object>(&m_value);
    if (object == nullptr) {
        return nullptr;
    }
    for (const JsonMember& member : *object) {
        if (member.key == key) {
            return &member.value;
        }
    }
    return nullptr;
}

JsonValue finiteOrNull(double value) {
    return std::isfinite(value) ? JsonValue(value) : JsonValue();
}

JsonValue finiteOrNull(const std::optional<double>& value) {
    return value ? finiteOrNull(*value) : JsonValue();
}

JsonValue textOrNull(const std::string& text) {
    return text.empty() ? JsonValue() : JsonValue(text);
}

namespace {

void writeText(const std::string& text, std::string& out) {
    out += '"';
    for (const char character : text) {
        const unsigned char octet = static_cast<unsigned char>(character);
        if (character == '"' || character == '\\') {
            out += '\\';
            out += character;
        } else if (character == '\n') {
            out += "\\n";
        } else if (octet < 0x20) {
            constexpr std::string_view Digits = "0123456789abcdef";
            out += "\\u00";
            out += Digits[octet >> 4];
            out += Digits[octet & 15];
        } else {
            out += character;
        }
    }
    out += '"';
}

/// Writes a tree depth first and remembers the path to the first number that cannot be written.
class Writer {
public:
    void write(const JsonValue& value, int depth) {
        if (value.isNull()) {
            text += "null";
        } else if (value.isBoolean()) {
            text += value.boolean() ? "true" : "false";
        } else if (value.isNumber()) {
            writeNumber(value);
        } else if (value.isText()) {
            writeText(value.text(), text);
        } else if (value.isArray()) {
            writeArray(value.items(), depth);
        } else {
            writeObject(value.members(), depth);
        }
    }

    std::string text;
    std::string badPath;

private:
    void writeNumber(const JsonValue& value) {
        if (const std::int64_t* whole = value.exactInteger()) {
            text += std::to_string(*whole);
            return;
        }
        if (!std::isfinite(value.number())) {
            badPath = badPath.empty() ? m_path : badPath;
            return;
        }
        text += formatNumber(value.number());
    }

    /// Arrays of plain values stay on one line: they are points and matrices.
    void writeArray(const JsonValue::Array& items, int depth) {
        bool isFlat = true;
        for (const JsonValue& item : items) {
            isFlat = isFlat && !item.isObject() && !item.isArray();
        }
        const std::string gap =
            isFlat ? "" : "\n" + std::string(static_cast<std::size_t>(depth) * 2 + 2, ' ');
        text += '[';
        for (std::size_t index = 0; index < items.size(); ++index) {
            text += index == 0 ? "" : isFlat ? ", " : ",";
            text += gap;
            descend("[" + std::to_string(index) + "]", items[index], depth);
        }
        closeWith(']', isFlat || items.empty(), depth);
    }

    void writeObject(const JsonValue::Object& members, int depth) {
        text += '{';
        for (std::size_t index = 0; index < members.size(); ++index) {
            text += index == 0 ? "\n" : ",\n";
            text.append(static_cast<std::size_t>(depth) * 2 + 2, ' ');
            writeText(members[index].key, text);
            text += ": ";
            descend("." + members[index].key, members[index].value, depth);
        }
        closeWith('}', members.empty(), depth);
    }

    void descend(const std::string& step, const JsonValue& value, int depth) {
        const std::size_t length = m_path.size();
        m_path += step;
        write(value, depth + 1);
        m_path.resize(length);
    }

    void closeWith(char bracket, bool isOnSameLine, int depth) {
        if (!isOnSameLine) {
            text += '\n';
            text.append(static_cast<std::size_t>(depth) * 2, ' ');
        }
        text += bracket;
    }

    std::string m_path;
};

} // namespace

Result<std::string> toJsonText(const JsonValue& value) {
    Writer writer;
    writer.write(value, 0);
    if (!writer.badPath.empty()) {
        return failure(ErrorCode::Internal,
                       "the result holds a value that is not a finite number at '" + writer.badPath + "'",
                       "report this with the command line used");
    }
    writer.text += '\n';
    return writer.text;
}

} // namespace halbench::app
