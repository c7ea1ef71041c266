#include "app/documents/text/json_value.h"
#include "app/documents/text/text_place.h"

#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>

#include <fmt/format.h>

namespace halbench::app {

namespace {

JsonValue fromQt(const QJsonValue& value) {
    switch (value.type()) {
    case QJsonValue::Bool:
        return JsonValue(value.toBool());
    case QJsonValue::Double:
        return JsonValue(value.toDouble());
    case QJsonValue::String:
        return JsonValue(value.toString().toStdString());
    case QJsonValue::Array: {
        JsonValue result = JsonValue::array();
        const QJsonArray items = value.toArray();
        for (const QJsonValue item : items) {
            result.push(fromQt(item));
        }
        return result;
    }
    case QJsonValue::Object: {
        JsonValue result = JsonValue::object();
        const QJsonObject members = value.toObject();
        for (auto member = members.begin(); member != members.end(); ++member) {
            result.set(member.key().toStdString(), fromQt(member.value()));
        }
        return result;
    }
    default:
        return {};
    }
}

} // namespace

Result<JsonValue> parseJson(const std::string& text, const std::string& origin) {
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(text), &error);
    if (error.error != QJsonParseError::NoError) {
        const TextPlace place = placeOfOffset(text, static_cast<std::size_t>(error.offset));
        return failure(ErrorCode::InvalidInput,
                       fmt::format("{}:{}:{}: not valid JSON: {}", origin, place.line, place.column,
                                   error.errorString().toStdString()),
                       "correct the file or write it again with --out");
    }
    if (document.isArray()) {
        return fromQt(QJsonValue(document.array()));
    }
    return fromQt(QJsonValue(document.object()));
}

} // namespace halbench::app
