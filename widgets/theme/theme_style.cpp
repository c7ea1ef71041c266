#include "widgets/theme/theme_style.h"

#include "widgets/theme/theme_proxy.h"
#include "widgets/theme/theme_sheet.h"

#include <QApplication>
#include <QFontDatabase>
#include <QFontMetricsF>
#include <QStyle>
#include <QVariant>
#include <QWidget>

#include <array>
#include <cmath>

namespace halbench::widgets {
namespace {

constexpr const char* ThemeProperty = "halbench_theme";
constexpr const char* RoleProperty = "role";

struct RoleName {
    Role role;
    const char* name;
};
constexpr std::array RoleNames = {
    RoleName{Role::None, ""},           RoleName{Role::Stop, "stop"},
    RoleName{Role::Armed, "armed"},     RoleName{Role::Simulated, "simulated"},
    RoleName{Role::Warn, "warn"},       RoleName{Role::Bad, "bad"},
    RoleName{Role::Good, "good"},       RoleName{Role::Muted, "muted"},
    RoleName{Role::Primary, "primary"},
};

/// Relative luminance of WCAG 2.1.
double luminance(const QColor& colour) {
    const auto linear = [](double c) {
        return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
}

void setDisabledColours(QPalette& palette, const Theme& theme) {
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText,
                            QPalette::HighlightedText, QPalette::PlaceholderText, QPalette::Link}) {
        palette.setColor(QPalette::Disabled, role, theme.disabled);
    }
    palette.setColor(QPalette::Disabled, QPalette::Base, theme.window);
    palette.setColor(QPalette::Disabled, QPalette::Highlight, theme.line);
}

QString hanFaceOf(const QLocale& locale) {
    switch (locale.language()) {
    case QLocale::Korean:
        return QStringLiteral("Noto Sans CJK KR");
    case QLocale::Japanese:
        return QStringLiteral("Noto Sans CJK JP");
    default:
        return QStringLiteral("Noto Sans CJK SC");
    }
}

} // namespace

double contrastRatio(const QColor& one, const QColor& other) {
    const double a = luminance(one);
    const double b = luminance(other);
    return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

QColor mixed(const QColor& one, const QColor& other, double share) {
    const auto part = [share](double a, double b) { return a + (b - a) * share; };
    return QColor::fromRgbF(part(one.redF(), other.redF()), part(one.greenF(), other.greenF()),
                            part(one.blueF(), other.blueF()));
}

QColor readableOn(const Theme& theme, const QColor& background) {
    QColor best = theme.text;
    for (const QColor& colour : {theme.panel, theme.window, theme.stopText}) {
        if (contrastRatio(colour, background) > contrastRatio(best, background)) {
            best = colour;
        }
    }
    return best;
}

QColor roleColour(const Theme& theme, Role role) {
    switch (role) {
    case Role::Stop:
        return theme.stop;
    case Role::Armed:
        return theme.armed;
    case Role::Simulated:
        return theme.simulated;
    case Role::Warn:
        return theme.warn;
    case Role::Bad:
        return theme.bad;
    case Role::Good:
        return theme.good;
    case Role::Muted:
        return theme.muted;
    case Role::Primary:
        return theme.accent;
    case Role::None:
        break;
    }
    return theme.text;
}

QPalette paletteOf(const Theme& theme) {
    QPalette palette;
    const auto set = [&palette](QPalette::ColorRole role, const QColor& colour) {
        palette.setColor(QPalette::All, role, colour);
    };
    set(QPalette::Window, theme.window);
    set(QPalette::WindowText, theme.text);
    set(QPalette::Base, theme.panel);
    set(QPalette::AlternateBase, mixed(theme.panel, theme.raised, 0.5));
    set(QPalette::Text, theme.text);
    set(QPalette::PlaceholderText, theme.muted);
    set(QPalette::Button, theme.raised);
    set(QPalette::ButtonText, theme.text);
    set(QPalette::BrightText, theme.bad);
    set(QPalette::ToolTipBase, theme.raised);
    set(QPalette::ToolTipText, theme.text);
    set(QPalette::Link, theme.accent);
    set(QPalette::LinkVisited, theme.accent);
    set(QPalette::Highlight, theme.accent);
    set(QPalette::HighlightedText, readableOn(theme, theme.accent));
    set(QPalette::Light, theme.panel);
    set(QPalette::Midlight, theme.raised);
    set(QPalette::Mid, theme.line);
    set(QPalette::Dark, theme.line);
    set(QPalette::Shadow, theme.line);
    setDisabledColours(palette, theme);
    return palette;
}

QFont applicationFont(const Dress& dress) {
    QFont font;
    font.setFamilies({QStringLiteral("DejaVu Sans"), hanFaceOf(dress.locale)});
    font.setPointSizeF(dress.fontSize_pt);
    return font;
}

QFont tabularFont(const QFont& font) {
    const QFontMetricsF metrics(font);
    const double width = metrics.horizontalAdvance(QLatin1Char('0'));
    for (char digit = '1'; digit <= '9'; ++digit) {
        if (metrics.horizontalAdvance(QLatin1Char(digit)) != width) {
            QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
            fixed.setPointSizeF(font.pointSizeF());
            return fixed;
        }
    }
    return font;
}

void applyTheme(QApplication& application, const Theme& theme, const Dress& dress) {
    applyThemeWithoutSheet(application, theme, dress);
    applySheet(application);
}

void applyThemeWithoutSheet(QApplication& application, const Theme& theme, const Dress& dress) {
    application.setProperty(ThemeProperty, QVariant::fromValue(theme));
    application.setStyleSheet(QString());
    application.setStyle(new ThemeProxy(theme)); // the application owns it
    application.setFont(applicationFont(dress));
    application.setPalette(paletteOf(theme));
}

void applySheet(QApplication& application) {
    application.setStyleSheet(styleSheetOf(currentTheme(), QFontMetrics(application.font()).height()));
}

void buildUndressed(QApplication& application, const std::function<void()>& build) {
    const QString sheet = application.styleSheet();
    application.setStyleSheet({});
    build();
    application.setStyleSheet(sheet);
}

Theme currentTheme() {
    const QVariant applied = qApp->property(ThemeProperty);
    if (applied.isValid()) {
        return applied.value<Theme>();
    }
    static const Theme light = loadTheme("light").value(); // a style asks for every cell that it paints
    return light;
}

void clearOwnSheet(QWidget& widget) {
    widget.setStyleSheet({});
}

void setRole(QWidget& widget, Role role) {
    for (const RoleName& name : RoleNames) {
        if (name.role == role) {
            const QVariant value = QString::fromLatin1(name.name);
            if (widget.property(RoleProperty) == value) {
                return;
            }
            widget.setProperty(RoleProperty, value);
        }
    }
    widget.style()->unpolish(&widget);
    widget.style()->polish(&widget);
    widget.update();
}

Role roleOf(const QWidget& widget) {
    const QString text = widget.property(RoleProperty).toString();
    for (const RoleName& name : RoleNames) {
        if (text == QLatin1String(name.name)) {
            return name.role;
        }
    }
    return Role::None;
}

} // namespace halbench::widgets
