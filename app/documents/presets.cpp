#include "app/documents/presets.h"

#include "app/documents/text/json_value.h"

#include <QtCore/QDirIterator>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

// Resources of a static library have to be named once; the macro must stand outside every namespace.
static void initialisePresetResources() {
    Q_INIT_RESOURCE(presets);
}

namespace halbench::app {

std::vector<std::string> presetNames() {
    initialisePresetResources();
    std::vector<std::string> names;
    QDirIterator files(QStringLiteral(":/presets"), {QStringLiteral("*.json")}, QDir::Files,
                       QDirIterator::Subdirectories);
    while (files.hasNext()) {
        names.push_back(QFileInfo(files.next()).completeBaseName().toStdString());
    }
    std::sort(names.begin(), names.end(), [](const std::string& one, const std::string& other) {
        return std::tuple(one != "published", one) < std::tuple(other != "published", other);
    });
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

Result<Preset> findPreset(const std::string& model, const std::string& name) {
    initialisePresetResources();
    const std::string path = fmt::format(":/presets/{}/{}.json", model, name);
    QFile file(QString::fromStdString(path));
    if (!file.open(QIODevice::ReadOnly)) {
        return failure(ErrorCode::UnknownName,
                       fmt::format("there is no preset '{}' for a device of model '{}'", name, model),
                       fmt::format("htm has {}", fmt::join(presetNames(), ", ")));
    }
    return parsePreset(file.readAll().toStdString(), path);
}

Result<Preset> parsePreset(const std::string& text, const std::string& origin) {
    const Result<JsonValue> root = parseJson(text, origin);
    if (!root) {
        return failure(root.error());
    }
    const auto complaint = [&](const std::string& key, const std::string& what) {
        return failure(ErrorCode::InvalidInput, fmt::format("{}: \"{}\" {}", origin, key, what),
                       "compare with resources/presets/htm/published.json");
    };
    Preset preset;
    const std::pair<const char*, std::string*> texts[] = {{"model", &preset.model},
                                                          {"name", &preset.name},
                                                          {"title", &preset.title},
                                                          {"source", &preset.source}};
    for (const auto& [key, target] : texts) {
        const JsonValue* value = root->find(key);
        if (value == nullptr || !value->isText()) {
            return complaint(key, "must be a text");
        }
        *target = value->text();
    }
    const JsonValue* schema = root->find("schema");
    if (schema == nullptr || !schema->isText() || schema->text() != "halbench.preset/1") {
        return complaint("schema", "must be \"halbench.preset/1\"");
    }
    const JsonValue* parameters = root->find("parameters");
    if (parameters == nullptr || !parameters->isObject()) {
        return complaint("parameters", "must be an object of numbers");
    }
    for (const JsonMember& member : parameters->members()) {
        if (!member.value.isNumber()) {
            return complaint("parameters." + member.key, "must be a number");
        }
        preset.values.push_back({member.key, member.value.number()});
    }
    return preset;
}

} // namespace halbench::app
