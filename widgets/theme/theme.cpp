#include "widgets/theme/theme.h"

#include <QByteArray>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <utility>

// The macro declares a function of the global namespace.
static void registerThemes() {
    Q_INIT_RESOURCE(themes);
}

namespace halbench::widgets {
namespace {

struct Role {
    const char* key;
    QColor Theme::*colour;
};

constexpr std::array Roles = {
    Role{"window", &Theme::window},
    Role{"panel", &Theme::panel},
    Role{"raised", &Theme::raised},
    Role{"text", &Theme::text},
    Role{"muted", &Theme::muted},
    Role{"disabled", &Theme::disabled},
    Role{"line", &Theme::line},
    Role{"accent", &Theme::accent},
    Role{"plot_background", &Theme::plotBackground},
    Role{"plot_grid", &Theme::plotGrid},
    Role{"plot_axis", &Theme::plotAxis},
    Role{"good", &Theme::good},
    Role{"warn", &Theme::warn},
    Role{"bad", &Theme::bad},
    Role{"simulated", &Theme::simulated},
    Role{"armed", &Theme::armed},
    Role{"stop", &Theme::stop},
    Role{"stop_text", &Theme::stopText},
};

QColor colourOf(const QJsonValue& value) {
    const QString text = value.toString();
    return text.startsWith(QLatin1Char('#')) ? QColor(text) : QColor();
}

} // namespace

Result<Theme> loadTheme(const std::string& name) {
    registerThemes();
    QFile file(QStringLiteral(":/themes/%1.json").arg(QString::fromStdString(name)));
    if (!file.open(QIODevice::ReadOnly)) {
        return failure(ErrorCode::UnknownName, "There is no theme '" + name + "'.", "Use light or dark.");
    }
    return parseTheme(file.readAll().toStdString());
}

Result<Theme> parseTheme(const std::string& json) {
    const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(json));
    if (!document.isObject()) {
        return failure(ErrorCode::InvalidInput, "The theme is not a JSON object.");
    }
    const QJsonObject object = document.object();
    Theme theme;
    theme.name = object.value(QStringLiteral("name")).toString().toStdString();
    for (const Role& role : Roles) {
        theme.*role.colour = colourOf(object.value(QLatin1String(role.key)));
        if (!(theme.*role.colour).isValid()) {
            return failure(ErrorCode::InvalidInput,
                           std::string("The theme has no colour for '") + role.key + "'.",
                           "Write it as #RRGGBB.");
        }
    }
    const QJsonArray curves = object.value(QStringLiteral("curves")).toArray();
    for (std::size_t i = 0; i < theme.curves.size(); ++i) {
        theme.curves[i] = colourOf(curves.at(static_cast<int>(i)));
        if (!theme.curves[i].isValid()) {
            return failure(ErrorCode::InvalidInput, "The theme needs eight curve colours.",
                           "Write them as #RRGGBB.");
        }
    }
    return theme;
}

} // namespace halbench::widgets
