#include "devices/profile.h"

#include "devices/profile_axes.h"

#include <QtCore/QFile>
#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>

#include <fmt/format.h>

#include <array>
#include <cmath>

// Resources of a static library have to be named once; the macro must stand outside every namespace.
static void initialiseProfileResources() {
    Q_INIT_RESOURCE(device_profiles);
}

namespace halbench::devices {

namespace {

constexpr const char* Schema = "halbench.profile/1";
constexpr std::array KnownKeys = {"schema",          "model",      "title",     "signal_roles",
                                  "parameter_roles", "procedures", "constants", "default_signals",
                                  "calibration",     "defaults",   "axes"};

std::string text(const QString& string) {
    return string.toStdString();
}

/// Walks one profile document and remembers the first thing that is wrong.
class ProfileReader {
public:
    ProfileReader(QJsonObject root, std::string origin)
        : m_root(std::move(root)), m_origin(std::move(origin)) {}

    Result<Profile> read() {
        refuseUnknownKeys();
        Profile profile;
        if (stringValue("schema") != Schema) {
            fail("schema", fmt::format("must be \"{}\"", Schema));
        }
        profile.model = stringValue("model");
        if (profile.model.empty()) {
            fail("model", "must name the model");
        }
        profile.title = stringValue("title");
        profile.signalRoles = names("signal_roles");
        profile.parameterRoles = names("parameter_roles");
        profile.procedures = list("procedures");
        profile.constants = numbers("constants");
        profile.defaultSignals = list("default_signals");
        profile.calibration = list("calibration");
        profile.defaults = numbers("defaults");
        readAxes(profile);
        if (!m_error.message.empty()) {
            return failure(m_error);
        }
        return profile;
    }

private:
    void fail(const std::string& key, const std::string& what) {
        if (m_error.message.empty()) {
            m_error = {ErrorCode::InvalidInput, fmt::format("{}: \"{}\" {}", m_origin, key, what),
                       "compare with resources/devices/htm.json"};
        }
    }

    void refuseUnknownKeys() {
        for (const QString& key : m_root.keys()) {
            bool isKnown = false;
            for (const char* known : KnownKeys) {
                isKnown = isKnown || key == QLatin1String(known);
            }
            if (!isKnown) {
                fail(text(key), "is not a key of a profile");
            }
        }
    }

    std::string stringValue(const char* key) {
        const QJsonValue value = m_root.value(QLatin1String(key));
        if (!value.isUndefined() && !value.isString()) {
            fail(key, "must be a text");
        }
        return text(value.toString());
    }

    std::map<std::string, std::string> names(const char* key) {
        std::map<std::string, std::string> result;
        const QJsonObject object = objectValue(key);
        for (auto entry = object.begin(); entry != object.end(); ++entry) {
            if (!entry.value().isString()) {
                fail(fmt::format("{}.{}", key, text(entry.key())), "must be a text");
            }
            result[text(entry.key())] = text(entry.value().toString());
        }
        return result;
    }

    std::map<std::string, double> numbers(const char* key) {
        std::map<std::string, double> result;
        const QJsonObject object = objectValue(key);
        for (auto entry = object.begin(); entry != object.end(); ++entry) {
            if (!entry.value().isDouble()) {
                fail(fmt::format("{}.{}", key, text(entry.key())), "must be a number");
            }
            result[text(entry.key())] = entry.value().toDouble();
        }
        return result;
    }

    std::vector<std::string> list(const char* key) {
        std::vector<std::string> result;
        const QJsonValue value = m_root.value(QLatin1String(key));
        if (!value.isUndefined() && !value.isArray()) {
            fail(key, "must be a list of texts");
        }
        for (const QJsonValue entry : value.toArray()) {
            if (!entry.isString()) {
                fail(key, "must be a list of texts");
            }
            result.push_back(text(entry.toString()));
        }
        return result;
    }

    void readAxes(Profile& profile) {
        Result<std::vector<AxisSpec>> axes = axesFrom(m_root.value(QLatin1String("axes")), profile);
        if (axes) {
            profile.axes = *std::move(axes);
        } else {
            fail(axes.error().message, axes.error().hint);
        }
    }

    QJsonObject objectValue(const char* key) {
        const QJsonValue value = m_root.value(QLatin1String(key));
        if (!value.isUndefined() && !value.isObject()) {
            fail(key, "must be an object");
        }
        return value.toObject();
    }

    QJsonObject m_root;
    std::string m_origin;
    Error m_error{ErrorCode::InvalidInput, {}, {}};
};

template <typename Spec>
Spec* findByName(std::vector<Spec>& specs, const std::string& name) {
    for (Spec& spec : specs) {
        if (spec.name == name) {
            return &spec;
        }
    }
    return nullptr;
}

} // namespace

Result<Profile> parseProfile(const std::string& json, const std::string& origin) {
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(json), &error);
    if (error.error != QJsonParseError::NoError) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("{}: byte {}: {}", origin, error.offset, text(error.errorString())),
                       "correct the JSON");
    }
    if (!document.isObject()) {
        return failure(ErrorCode::InvalidInput, fmt::format("{}: a profile is one JSON object", origin),
                       "compare with resources/devices/htm.json");
    }
    return ProfileReader(document.object(), origin).read();
}

Result<std::optional<Profile>> findProfile(const std::string& model) {
    initialiseProfileResources();
    const std::string path = ":/devices/" + model + ".json";
    QFile file(QString::fromStdString(path));
    if (model.empty() || !file.open(QIODevice::ReadOnly)) {
        return std::optional<Profile>{};
    }
    Result<Profile> profile = parseProfile(file.readAll().toStdString(), path);
    if (!profile) {
        return failure(profile.error());
    }
    return std::optional<Profile>(*std::move(profile));
}

void applyProfile(const Profile& profile, Catalogue& catalogue) {
    for (const auto& [role, name] : profile.signalRoles) {
        if (SignalSpec* spec = findByName(catalogue.signals, name)) {
            spec->role = role;
        }
    }
    for (const auto& [role, name] : profile.parameterRoles) {
        if (ParameterSpec* spec = findByName(catalogue.parameters, name)) {
            spec->role = role;
        }
    }
    for (const auto& [name, value] : profile.defaults) {
        if (ParameterSpec* spec = findByName(catalogue.parameters, name)) {
            spec->defaultValue = value;
        }
    }
    for (const std::string& name : profile.calibration) {
        if (ParameterSpec* spec = findByName(catalogue.parameters, name)) {
            spec->isCalibration = true;
        }
    }
    catalogue.procedures = profile.procedures;
    catalogue.knownConstants = profile.constants;
    for (const AxisSpec& axis : profile.axes) {
        if (!catalogue.signalForRole(axis.roles.position).empty()) {
            catalogue.axes.push_back(axis);
        }
    }
    for (const std::string& name : profile.defaultSignals) {
        if (catalogue.findSignal(name) != nullptr) {
            catalogue.defaultSignals.push_back(name);
        }
    }
}

} // namespace halbench::devices
