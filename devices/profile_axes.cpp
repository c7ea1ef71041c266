#include "devices/profile_axes.h"

#include "control/base/units.h"

#include <QtCore/QJsonArray>
#include <QtCore/QJsonObject>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

namespace halbench::devices {
namespace {

using Roles = std::map<std::string, std::string>;

struct TextKey {
    const char* key;
    std::string AxisSpec::*text;
};
constexpr std::array Texts = {TextKey{"id", &AxisSpec::id}, TextKey{"title", &AxisSpec::title},
                              TextKey{"position_unit", &AxisSpec::positionUnit},
                              TextKey{"effort_unit", &AxisSpec::effortUnit},
                              TextKey{"generator", &AxisSpec::generator}};

struct NumberKey {
    const char* key;
    double AxisSpec::*number;
};
constexpr std::array Numbers = {NumberKey{"window_margin", &AxisSpec::windowMargin},
                                NumberKey{"settle_s", &AxisSpec::settle_s},
                                NumberKey{"reference_tolerance", &AxisSpec::referenceTolerance},
                                NumberKey{"end_tolerance", &AxisSpec::endTolerance}};
constexpr std::array OptionalNumbers = {NumberKey{"design_frequency_rad_s", &AxisSpec::designFrequency_rad_s},
                                        NumberKey{"test_step", &AxisSpec::testStep},
                                        NumberKey{"effort_limit", &AxisSpec::effortLimit}};

struct RoleKey {
    const char* key;
    std::string AxisRoles::*role;
    Roles Profile::*known;
    bool isOptional = false;
};
constexpr std::array RoleKeys = {
    RoleKey{"position", &AxisRoles::position, &Profile::signalRoles},
    RoleKey{"speed", &AxisRoles::speed, &Profile::signalRoles},
    RoleKey{"reference", &AxisRoles::reference, &Profile::signalRoles},
    RoleKey{"effort", &AxisRoles::effort, &Profile::signalRoles},
    RoleKey{"command", &AxisRoles::command, &Profile::signalRoles, true},
    RoleKey{"true_position", &AxisRoles::truePosition, &Profile::signalRoles},
    RoleKey{"position_window", &AxisRoles::positionWindow, &Profile::parameterRoles},
    RoleKey{"speed_window", &AxisRoles::speedWindow, &Profile::parameterRoles}};

/// Reads one axis and remembers the first thing that is wrong.
class AxisReader {
public:
    AxisReader(const QJsonValue& value, std::string place, const Profile& profile)
        : m_object(value.toObject()), m_place(std::move(place)), m_profile(profile) {
        if (!value.isObject()) {
            fail("", "must be an object");
        }
    }

    Result<AxisSpec> read() {
        AxisSpec axis;
        refuseUnknown(m_object, "", [](const std::string& key) {
            const auto isKey = [&key](const auto& known) { return key == known.key; };
            return key == "roles" || key == "turns_forever" ||
                   std::any_of(Texts.begin(), Texts.end(), isKey) ||
                   std::any_of(Numbers.begin(), Numbers.end(), isKey) ||
                   std::any_of(OptionalNumbers.begin(), OptionalNumbers.end(), isKey);
        });
        for (const TextKey& key : Texts) {
            axis.*key.text = textOf(m_object, key.key, "");
        }
        for (const NumberKey& key : Numbers) {
            axis.*key.number = positive(key.key);
        }
        for (const NumberKey& key : OptionalNumbers) {
            if (m_object.contains(QLatin1String(key.key))) {
                axis.*key.number = positive(key.key);
            }
        }
        const QJsonValue turns = m_object.value(QLatin1String("turns_forever"));
        if (!turns.isBool()) {
            fail(".turns_forever", "must be true or false");
        }
        axis.turnsForever = turns.toBool();
        checkUnits(axis);
        readRoles(axis.roles);
        return m_error.message.empty() ? Result<AxisSpec>(axis) : failure(m_error);
    }

private:
    void fail(const std::string& key, const std::string& what) {
        if (m_error.message.empty()) {
            m_error = {ErrorCode::InvalidInput, m_place + key, what};
        }
    }

    template <typename IsKnown>
    void refuseUnknown(const QJsonObject& object, const std::string& within, const IsKnown& isKnown) {
        for (const QString& key : object.keys()) {
            if (!isKnown(key.toStdString())) {
                fail(within + "." + key.toStdString(), "is not a key of an axis");
            }
        }
    }

    std::string textOf(const QJsonObject& object, const char* key, const std::string& within) {
        const std::string text = object.value(QLatin1String(key)).toString().toStdString();
        if (text.empty()) {
            fail(within + "." + key, "must be a text");
        }
        return text;
    }

    double positive(const char* key) {
        const double number = m_object.value(QLatin1String(key)).toDouble(-1.0);
        if (!(number > 0.0)) {
            fail(std::string(".") + key, "must be a positive number");
        }
        return number;
    }

    void checkUnits(const AxisSpec& axis) {
        if (axis.positionUnit != "rad" && axis.positionUnit != "m") {
            fail(".position_unit", "must be \"rad\" or \"m\"");
        }
        if (!findUnit(axis.effortUnit)) {
            fail(".effort_unit", "must be a unit of the program, e.g. \"N\"");
        }
    }

    void readRoles(AxisRoles& roles) {
        const QJsonObject object = m_object.value(QLatin1String("roles")).toObject();
        refuseUnknown(object, ".roles", [](const std::string& key) {
            return std::any_of(RoleKeys.begin(), RoleKeys.end(),
                               [&key](const RoleKey& known) { return key == known.key; });
        });
        for (const RoleKey& key : RoleKeys) {
            if (key.isOptional && !object.contains(QLatin1String(key.key))) {
                continue;
            }
            roles.*key.role = textOf(object, key.key, ".roles");
            if (!(m_profile.*key.known).contains(roles.*key.role)) {
                fail(fmt::format(".roles.{}", key.key), "must be a role of this profile");
            }
        }
    }

    QJsonObject m_object;
    std::string m_place;
    const Profile& m_profile;
    Error m_error{ErrorCode::InvalidInput, {}, {}};
};

} // namespace

Result<std::vector<AxisSpec>> axesFrom(const QJsonValue& value, const Profile& profile) {
    std::vector<AxisSpec> axes;
    if (!value.isUndefined() && !value.isArray()) {
        return failure(ErrorCode::InvalidInput, "axes", "must be a list of axes");
    }
    for (const QJsonValue entry : value.toArray()) {
        const std::string place = fmt::format("axes.{}", axes.size());
        const Result<AxisSpec> axis = AxisReader(entry, place, profile).read();
        if (!axis) {
            return failure(axis.error());
        }
        if (std::any_of(axes.begin(), axes.end(),
                        [&](const AxisSpec& other) { return other.id == axis->id; })) {
            return failure(ErrorCode::InvalidInput, place + ".id", "must differ from the other axes");
        }
        axes.push_back(*axis);
    }
    return axes;
}

} // namespace halbench::devices
