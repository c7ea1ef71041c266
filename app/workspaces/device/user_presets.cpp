#include "app/workspaces/device/user_presets.h"

#include "app/documents/presets.h"
#include "widgets/language/phrasebook.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QSaveFile>
#include <QStandardPaths>

#include <fmt/format.h>

namespace halbench::app {

namespace {

constexpr qint64 LargestFile = 1 << 20;
constexpr const char* SchemaName = "halbench.preset/";
constexpr int SchemaVersion = 1;

QString folderOf(const std::string& model, const QString& folder) {
    return QDir(folder).filePath(QString::fromStdString(model));
}

Result<std::string> readFile(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return failure(
            ErrorCode::FileSystem,
            fmt::format("cannot read '{}': {}", path.toStdString(), file.errorString().toStdString()),
            "choose another preset");
    }
    if (file.size() > LargestFile) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("'{}' is too large for a preset", path.toStdString()),
                       "choose a preset file");
    }
    return file.readAll().toStdString();
}

/// A newer program may mean something else by the same words.
Result<void> checkVersion(const std::string& text, const QString& path) {
    const QString schema = QJsonDocument::fromJson(QByteArray::fromStdString(text))
                               .object()
                               .value(QLatin1String("schema"))
                               .toString();
    const QString prefix = QLatin1String(SchemaName);
    if (schema.startsWith(prefix) && schema.mid(prefix.size()).toInt() > SchemaVersion) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("'{}' was written by a newer Halbench ({})", path.toStdString(),
                                   schema.toStdString()),
                       "open it with the newer version, or install that version");
    }
    return {};
}

} // namespace

QString userPresetFolder() {
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/presets");
}

std::vector<PresetChoice> presetChoices(const std::string& model, const QString& folder) {
    std::vector<PresetChoice> choices;
    for (const std::string& name : presetNames()) {
        if (const Result<Preset> preset = findPreset(model, name)) {
            choices.push_back({widgets::inWords(preset->title), {}, name});
        }
    }
    const QDir own(folderOf(model, folder));
    for (const QString& file : own.entryList({QStringLiteral("*.json")}, QDir::Files, QDir::Name)) {
        const QString name = QFileInfo(file).completeBaseName();
        choices.push_back({name, own.filePath(file), name.toStdString()});
    }
    return choices;
}

Result<Preset> loadPreset(const std::string& model, const PresetChoice& choice) {
    if (choice.path.isEmpty()) {
        return findPreset(model, choice.name);
    }
    const Result<std::string> text = readFile(choice.path);
    if (!text) {
        return failure(text.error());
    }
    if (Result<void> known = checkVersion(*text, choice.path); !known) {
        return failure(known.error());
    }
    Result<Preset> preset = parsePreset(*text, choice.path.toStdString());
    if (preset && preset->model != model) {
        return failure(
            ErrorCode::InvalidInput,
            fmt::format("'{}' is for a device of model '{}'", choice.path.toStdString(), preset->model),
            fmt::format("this device is of model '{}'", model));
    }
    return preset;
}

Result<QString> saveUserPreset(const Preset& preset, const QString& folder) {
    static const QRegularExpression legal(QStringLiteral("^[\\w][\\w .-]{0,63}$"),
                                          QRegularExpression::UseUnicodePropertiesOption);
    const QString name = QString::fromStdString(preset.name);
    if (!legal.match(name).hasMatch()) {
        return failure(ErrorCode::Usage, fmt::format("'{}' cannot be the name of a preset", preset.name),
                       "use letters, digits, spaces, points and hyphens");
    }
    QJsonObject values;
    for (const ParameterValue& value : preset.values) {
        values.insert(QString::fromStdString(value.name), value.value);
    }
    const QJsonObject root{{"schema", QString::fromLatin1(SchemaName) + QString::number(SchemaVersion)},
                           {"model", QString::fromStdString(preset.model)},
                           {"name", name},
                           {"title", QString::fromStdString(preset.title)},
                           {"source", QString::fromStdString(preset.source)},
                           {"parameters", values}};
    const QString path = QDir(folderOf(preset.model, folder)).filePath(name + QStringLiteral(".json"));
    QSaveFile file(path);
    const bool isWritten = QDir().mkpath(QFileInfo(path).path()) && file.open(QIODevice::WriteOnly) &&
                           file.write(QJsonDocument(root).toJson()) > 0 && file.commit();
    if (!isWritten) {
        return failure(
            ErrorCode::FileSystem,
            fmt::format("cannot write '{}': {}", path.toStdString(), file.errorString().toStdString()),
            "check the folder and the space on the disk");
    }
    return path;
}

} // namespace halbench::app
