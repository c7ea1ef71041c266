#include "devices/recording/recording_meta.h"

#include "devices/recording/recording_csv.h"

#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>

#include <fmt/format.h>

#include <cmath>

namespace halbench::devices {

namespace {

constexpr const char* Schema = "halbench.recording-meta/1";
constexpr std::string_view FirmwareWarning = "the board ran firmware '";

QString textOf(const std::string& text) {
    return QString::fromStdString(text);
}

std::string stringOf(const QJsonObject& object, const char* key) {
    return object.value(QLatin1String(key)).toString().toStdString();
}

double numberOf(const QJsonObject& object, const char* key) {
    return object.value(QLatin1String(key)).toDouble(0.0);
}

QJsonValue countOf(std::uint64_t count) {
    return QJsonValue(static_cast<qint64>(count));
}

std::uint64_t countOf(const QJsonObject& object, const char* key) {
    const double number = numberOf(object, key);
    return number >= 0.0 && number < 1e15 ? static_cast<std::uint64_t>(number) : 0;
}

QJsonObject deviceJson(const DeviceInfo& device) {
    QJsonObject overrides;
    for (const auto& [key, value] : device.overrides) {
        overrides.insert(textOf(key), textOf(value));
    }
    QJsonObject object{{"model", textOf(device.model)},
                       {"id", textOf(device.id)},
                       {"firmware", textOf(device.firmware)},
                       {"simulated", device.isSimulated},
                       {"overrides", overrides}};
    if (!device.otherFirmware.empty()) {
        object.insert("description_firmware", textOf(device.otherFirmware));
    }
    return object;
}

/// As results have it: what is read by a description of another firmware may be anything.
QJsonObject qualityJson(const DeviceInfo& device) {
    const QJsonObject finding{{"code", "other_firmware"},
                              {"message", textOf(otherFirmwareWarning(device))},
                              {"hint", OtherFirmwareHint}};
    return {{"verdict", "doubtful"}, {"findings", QJsonArray{finding}}};
}

DeviceInfo deviceOf(const QJsonObject& object) {
    DeviceInfo device;
    device.model = stringOf(object, "model");
    device.id = stringOf(object, "id");
    device.firmware = stringOf(object, "firmware");
    device.otherFirmware = stringOf(object, "description_firmware");
    device.isSimulated = object.value(QLatin1String("simulated")).toBool();
    const QJsonObject overrides = object.value(QLatin1String("overrides")).toObject();
    for (auto entry = overrides.begin(); entry != overrides.end(); ++entry) {
        device.overrides.emplace_back(entry.key().toStdString(), entry.value().toString().toStdString());
    }
    return device;
}

/// A list of objects made by `make` from each item.
template <typename Item, typename Make>
QJsonArray arrayOf(const std::vector<Item>& items, Make make) {
    QJsonArray array;
    for (const Item& item : items) {
        array.append(make(item));
    }
    return array;
}

template <typename Make>
auto listOf(const QJsonObject& object, const char* key, Make make) {
    std::vector<decltype(make(QJsonObject()))> list;
    const QJsonArray array = object.value(QLatin1String(key)).toArray();
    for (const QJsonValue value : array) {
        list.push_back(make(value.toObject()));
    }
    return list;
}

/// What most recordings do not have is left out, not empty.
void addOptional(const RecordingMeta& meta, QJsonObject& root) {
    if (meta.droppedRows > 0) {
        root.insert("dropped_rows", countOf(meta.droppedRows));
    }
    if (!meta.rates.empty()) {
        root.insert("rates", arrayOf(meta.rates, [](const RateChange& rate) {
                        return QJsonObject{{"time_s", rate.time_s}, {"period_s", rate.period_s}};
                    }));
    }
    if (!meta.tags.empty()) {
        QJsonArray tags;
        for (const std::string& tag : meta.tags) {
            tags.append(textOf(tag));
        }
        root.insert("tags", tags);
    }
    if (!meta.notes.empty()) {
        root.insert("notes", textOf(meta.notes));
    }
    if (!meta.automaticName.empty()) {
        root.insert("automatic_name", textOf(meta.automaticName));
    }
}

void takeOptional(const QJsonObject& root, RecordingMeta& meta) {
    meta.droppedRows = countOf(root, "dropped_rows");
    meta.rates = listOf(root, "rates", [](const QJsonObject& object) {
        return RateChange{numberOf(object, "time_s"), numberOf(object, "period_s")};
    });
    const QJsonArray tags = root.value(QLatin1String("tags")).toArray();
    for (const QJsonValue tag : tags) {
        meta.tags.push_back(tag.toString().toStdString());
    }
    meta.notes = stringOf(root, "notes");
    meta.automaticName = stringOf(root, "automatic_name");
}

} // namespace

std::string otherFirmwareWarning(const DeviceInfo& device) {
    return fmt::format(
        "the board ran firmware '{}', but its description was of '{}': names may have led to wrong values",
        device.firmware, device.otherFirmware);
}

bool isFirmwareWarning(const std::string& warning) {
    return warning.starts_with(FirmwareWarning);
}

std::vector<RecordingMeta::ParameterNote> parameterNotes(Device& device) {
    std::vector<RecordingMeta::ParameterNote> notes;
    std::vector<std::string> names;
    for (const ParameterSpec& spec : device.catalogue().parameters) {
        names.push_back(spec.name);
    }
    const Result<std::vector<double>> values = device.readParameters(names);
    for (std::size_t i = 0; values && i < names.size(); ++i) {
        notes.push_back({names[i], (*values)[i], device.catalogue().parameters[i].unit});
    }
    return notes;
}

RecordingMeta describeRecording(Device& device, const StreamLayout& layout, const std::string& started) {
    RecordingMeta meta;
    meta.device = device.info();
    meta.started = started;
    meta.software = HALBENCH_VERSION;
    meta.period_s = layout.period_s;
    for (const StreamLayout::Column& column : layout.columns) {
        const SignalSpec* spec = device.catalogue().findSignal(column.name);
        meta.signals.push_back({column.name, csvColumnName(column.name, column.unit), column.unit,
                                spec != nullptr ? spec->role : std::string()});
    }
    meta.parameters = parameterNotes(device);
    return meta;
}

void nameColumnsOf(const StreamLayout& layout, RecordingMeta& meta) {
    const std::vector<std::string> names = csvColumnNames(layout);
    std::vector<bool> isNamed(meta.signals.size(), false);
    for (std::size_t i = 0; i < names.size(); ++i) {
        for (std::size_t note = 0; note < meta.signals.size(); ++note) {
            const bool isOfColumn = !isNamed[note] && meta.signals[note].name == layout.columns[i].name &&
                                    meta.signals[note].unit == layout.columns[i].unit;
            if (isOfColumn) {
                meta.signals[note].column = names[i];
                isNamed[note] = true;
                break;
            }
        }
    }
}

std::string toMetaJson(const RecordingMeta& meta) {
    QJsonObject root{
        {"schema", Schema},
        {"halbench", textOf(meta.software)},
        {"device", deviceJson(meta.device)},
        {"started", textOf(meta.started)},
        {"period_s", meta.period_s},
        {"rows", countOf(meta.rows)},
        {"sha256", textOf(meta.sha256)},
        {"signals", arrayOf(meta.signals,
                            [](const RecordingMeta::SignalNote& note) {
                                QJsonObject signal{{"name", textOf(note.name)},
                                                   {"column", textOf(note.column)},
                                                   {"unit", textOf(note.unit)},
                                                   {"role", textOf(note.role)}};
                                if (!note.expression.empty()) {
                                    signal.insert("expression", textOf(note.expression));
                                }
                                return signal;
                            })},
        {"parameters", arrayOf(meta.parameters,
                               [](const RecordingMeta::ParameterNote& note) {
                                   return QJsonObject{{"name", textOf(note.name)},
                                                      {"value", note.value},
                                                      {"unit", textOf(note.unit)}};
                               })},
        {"changes", arrayOf(meta.changes,
                            [](const RecordingMeta::ParameterChange& change) {
                                return QJsonObject{{"time_s", change.time_s},
                                                   {"name", textOf(change.name)},
                                                   {"value", change.value}};
                            })},
        {"markers", arrayOf(meta.markers,
                            [](const RecordingMeta::Marker& marker) {
                                return QJsonObject{{"time_s", marker.time_s}, {"text", textOf(marker.text)}};
                            })},
        {"gaps", arrayOf(meta.gaps, [](const RecordingMeta::Gap& gap) {
             return QJsonObject{{"time_s", gap.time_s}, {"lost_rows", countOf(gap.lostRows)}};
         })}};
    addOptional(meta, root);
    if (!meta.device.otherFirmware.empty()) {
        root.insert("data_quality", qualityJson(meta.device));
    }
    return QJsonDocument(root).toJson(QJsonDocument::Indented).toStdString();
}

Result<RecordingMeta> parseMetaJson(const std::string& text, const std::string& origin) {
    QJsonParseError error;
    const QJsonObject root = QJsonDocument::fromJson(QByteArray::fromStdString(text), &error).object();
    if (error.error != QJsonParseError::NoError) {
        return failure(
            ErrorCode::InvalidInput,
            fmt::format("{}: byte {}: {}", origin, error.offset, error.errorString().toStdString()),
            "remove the .meta.json file to read the data without it");
    }
    if (stringOf(root, "schema") != Schema) {
        return failure(ErrorCode::InvalidInput, fmt::format("{}: \"schema\" is not \"{}\"", origin, Schema),
                       "remove the .meta.json file to read the data without it");
    }
    RecordingMeta meta;
    meta.device = deviceOf(root.value(QLatin1String("device")).toObject());
    meta.started = stringOf(root, "started");
    meta.software = stringOf(root, "halbench");
    meta.period_s = numberOf(root, "period_s");
    takeOptional(root, meta);
    meta.rows = countOf(root, "rows");
    meta.sha256 = stringOf(root, "sha256");
    meta.signals = listOf(root, "signals", [](const QJsonObject& object) {
        return RecordingMeta::SignalNote{stringOf(object, "name"), stringOf(object, "column"),
                                         stringOf(object, "unit"), stringOf(object, "role"),
                                         stringOf(object, "expression")};
    });
    meta.parameters = listOf(root, "parameters", [](const QJsonObject& object) {
        return RecordingMeta::ParameterNote{stringOf(object, "name"), numberOf(object, "value"),
                                            stringOf(object, "unit")};
    });
    meta.changes = listOf(root, "changes", [](const QJsonObject& object) {
        return RecordingMeta::ParameterChange{numberOf(object, "time_s"), stringOf(object, "name"),
                                              numberOf(object, "value")};
    });
    meta.markers = listOf(root, "markers", [](const QJsonObject& object) {
        return RecordingMeta::Marker{numberOf(object, "time_s"), stringOf(object, "text")};
    });
    meta.gaps = listOf(root, "gaps", [](const QJsonObject& object) {
        return RecordingMeta::Gap{numberOf(object, "time_s"), countOf(object, "lost_rows")};
    });
    return meta;
}

std::string metaPathOf(const std::string& csvPath) {
    constexpr std::string_view Extension = ".csv";
    std::string stem = csvPath;
    if (stem.size() > Extension.size() &&
        stem.compare(stem.size() - Extension.size(), Extension.size(), Extension) == 0) {
        stem.resize(stem.size() - Extension.size());
    }
    return stem + ".meta.json";
}

} // namespace halbench::devices
