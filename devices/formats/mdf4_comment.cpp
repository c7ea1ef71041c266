#include "devices/formats/mdf4_comment.h"

#include <QtCore/QXmlStreamReader>
#include <QtCore/QXmlStreamWriter>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace halbench::devices::mdf4 {

namespace {

constexpr const char* Namespace = "http://www.asam.net/mdf/v4";

/// XML has no place for control characters and half surrogates.
QString xmlText(const std::string& text) {
    QString clean = QString::fromStdString(text);
    for (QChar& character : clean) {
        const bool isControl =
            character.unicode() < 0x20 && character != QLatin1Char('\n') && character != QLatin1Char('\t');
        if (isControl || character.unicode() >= 0xFFFE) {
            character = QChar::ReplacementCharacter;
        }
    }
    return clean;
}

/// One comment while it is written: root, <TX>, then <common_properties>.
class CommentWriter {
public:
    CommentWriter(const char* root, const std::string& text) : m_writer(&m_xml) {
        m_writer.writeStartElement(QLatin1String(root));
        m_writer.writeAttribute(QStringLiteral("xmlns"), QLatin1String(Namespace));
        element("TX", text);
    }
    void element(const char* name, const std::string& text) {
        m_writer.writeTextElement(QLatin1String(name), xmlText(text));
    }
    void begin(const char* element) { m_writer.writeStartElement(QLatin1String(element)); }
    void beginTree(const char* name) {
        begin("tree");
        m_writer.writeAttribute(QStringLiteral("name"), QLatin1String(name));
    }
    void property(const std::string& name, const std::string& text, const std::string& unit = {}) {
        if (text.empty()) {
            return;
        }
        begin("e");
        m_writer.writeAttribute(QStringLiteral("name"), xmlText(name));
        if (!unit.empty()) {
            m_writer.writeAttribute(QStringLiteral("unit"), xmlText(unit));
        }
        m_writer.writeCharacters(xmlText(text));
        end();
    }
    void end() { m_writer.writeEndElement(); }
    std::string finish() {
        m_writer.writeEndDocument(); // closes what is open
        return m_xml.toStdString();
    }

private:
    QString m_xml;
    QXmlStreamWriter m_writer;
};

struct Property {
    std::string tree; ///< empty: directly in <common_properties>
    std::string name;
    std::string unit;
    std::string text;
};

std::string attribute(const QXmlStreamReader& reader, const char* name) {
    return reader.attributes().value(QLatin1String(name)).toString().toStdString();
}

/// Calls `use` with every <e>.
Result<void> forEachProperty(std::string_view xml, const std::function<void(Property)>& use) {
    QXmlStreamReader reader(QByteArray::fromRawData(xml.data(), static_cast<int>(xml.size())));
    std::string tree;
    while (!reader.atEnd()) {
        const QXmlStreamReader::TokenType token = reader.readNext();
        if (token == QXmlStreamReader::DTD) {
            reader.raiseError(QStringLiteral("a document type is declared"));
        } else if (reader.name() == QLatin1String("tree")) {
            tree = token == QXmlStreamReader::StartElement ? attribute(reader, "name") : std::string();
        } else if (token == QXmlStreamReader::StartElement && reader.name() == QLatin1String("e")) {
            Property property{tree, attribute(reader, "name"), attribute(reader, "unit"), {}};
            property.text = reader.readElementText(QXmlStreamReader::SkipChildElements).toStdString();
            use(std::move(property));
        }
    }
    if (reader.hasError()) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("line {}: {}", reader.lineNumber(), reader.errorString().toStdString()));
    }
    return {};
}

double numberOf(const std::string& text) {
    const double number = QByteArray::fromStdString(text).toDouble(); // the C locale, 0 when it is none
    return std::isfinite(number) ? number : 0.0;
}

void takeHeaderProperty(const Property& property, RecordingMeta& meta) {
    const std::pair<const char*, std::string*> texts[] = {
        {"device.model", &meta.device.model},
        {"device.id", &meta.device.id},
        {"device.firmware", &meta.device.firmware},
        {"device.description_firmware", &meta.device.otherFirmware},
        {"software", &meta.software},
        {"notes", &meta.notes},
        {"started", &meta.started}};
    if (property.tree == "parameters") {
        meta.parameters.push_back({property.name, numberOf(property.text), property.unit});
    } else if (property.tree == "overrides") {
        meta.device.overrides.emplace_back(property.name, property.text);
    } else if (property.tree == "tags") {
        meta.tags.push_back(property.text);
    } else if (property.tree == "rates") {
        meta.rates.push_back({numberOf(property.name), numberOf(property.text)});
    } else if (property.name == "dropped_rows") {
        meta.droppedRows = static_cast<std::uint64_t>(std::max(0.0, numberOf(property.text)));
    } else if (property.name == "device.simulated") {
        meta.device.isSimulated = property.text == "true";
    } else if (property.name == "period") {
        meta.period_s = numberOf(property.text);
    }
    for (const auto& [name, text] : texts) {
        if (property.tree.empty() && property.name == name) {
            *text = property.text;
        }
    }
}

} // namespace

std::string headerComment(const RecordingMeta& meta) {
    CommentWriter comment("HDcomment", fmt::format("recording of {} {}", meta.device.model, meta.device.id));
    comment.begin("common_properties");
    comment.property("device.model", meta.device.model);
    comment.property("device.id", meta.device.id);
    comment.property("device.firmware", meta.device.firmware);
    if (!meta.device.otherFirmware.empty()) {
        comment.property("device.description_firmware", meta.device.otherFirmware);
    }
    comment.property("device.simulated", meta.device.isSimulated ? "true" : "false");
    comment.property("software", meta.software);
    comment.property("started", meta.started);
    comment.property("period", fmt::format("{}", meta.period_s), "s");
    comment.property("notes", meta.notes);
    if (meta.droppedRows > 0) {
        comment.property("dropped_rows", fmt::format("{}", meta.droppedRows));
    }
    if (!meta.rates.empty()) {
        comment.beginTree("rates"); // from this time on, this distance of rows
        for (const RateChange& rate : meta.rates) {
            comment.property(fmt::format("{}", rate.time_s), fmt::format("{}", rate.period_s), "s");
        }
        comment.end();
    }
    if (!meta.tags.empty()) {
        comment.beginTree("tags");
        for (const std::string& tag : meta.tags) {
            comment.property("tag", tag);
        }
        comment.end();
    }
    if (!meta.device.overrides.empty()) {
        comment.beginTree("overrides");
        for (const auto& [name, value] : meta.device.overrides) {
            comment.property(name, value);
        }
        comment.end();
    }
    if (!meta.parameters.empty()) {
        comment.beginTree("parameters");
        for (const RecordingMeta::ParameterNote& note : meta.parameters) {
            comment.property(note.name, fmt::format("{}", note.value), note.unit);
        }
        comment.end();
    }
    return comment.finish();
}

std::string historyComment() {
    CommentWriter comment("FHcomment", "written by Halbench");
    comment.element("tool_id", "Halbench");
    comment.element("tool_vendor", "Halbench maintainers");
    comment.element("tool_version", HALBENCH_VERSION);
    return comment.finish();
}

std::string channelComment(const std::string& role, const std::string& signal,
                           const std::string& expression) {
    CommentWriter comment("CNcomment", role);
    comment.begin("common_properties");
    comment.property("role", role);
    comment.property("signal", signal);
    if (!expression.empty()) {
        comment.property("expression", expression);
    }
    return comment.finish();
}

std::string changeComment(const RecordingMeta::ParameterChange& change) {
    CommentWriter comment("EVcomment", "a parameter was changed");
    comment.begin("common_properties");
    comment.property("parameter", change.name);
    comment.property("value", fmt::format("{}", change.value));
    return comment.finish();
}

Result<void> readHeaderComment(std::string_view xml, RecordingMeta& meta) {
    return forEachProperty(xml, [&](const Property& property) { takeHeaderProperty(property, meta); });
}

Result<ChannelNote> readChannelComment(std::string_view xml) {
    ChannelNote note;
    const Result<void> done = forEachProperty(xml, [&](const Property& property) {
        if (property.name == "role" || property.name == "signal") {
            (property.name == "role" ? note.role : note.signal) = property.text;
        } else if (property.name == "expression") {
            note.expression = property.text;
        }
    });
    return done ? Result<ChannelNote>(std::move(note)) : failure(done.error());
}

Result<std::optional<RecordingMeta::ParameterChange>> readEventComment(std::string_view xml) {
    std::optional<RecordingMeta::ParameterChange> change;
    double value = 0.0;
    const Result<void> done = forEachProperty(xml, [&](const Property& property) {
        if (property.name == "parameter") {
            change = RecordingMeta::ParameterChange{0.0, property.text, 0.0};
        } else if (property.name == "value") {
            value = numberOf(property.text);
        }
    });
    if (!done) {
        return failure(done.error());
    }
    if (change) {
        change->value = value;
    }
    return change;
}

} // namespace halbench::devices::mdf4
