#pragma once

#include "widgets/theme/theme.h"

#include <QFont>
#include <QLocale>
#include <QPalette>

#include <functional>

class QApplication;
class QWidget;

namespace halbench::widgets {

/// What a control means; decides its colour through the theme, never the control itself.
enum class Role { None, Stop, Armed, Simulated, Warn, Bad, Good, Muted, Primary };

/// Everything is a multiple of this many device-independent pixels.
constexpr int GridStep_px = 4;
constexpr int PanelMargin_px = 2 * GridStep_px;
constexpr int GroupSpacing_px = 3 * GridStep_px;

/// How the program is dressed besides its colours.
struct Dress {
    QLocale locale = QLocale::c(); ///< chooses the face for Chinese and Korean words
    double fontSize_pt = 9.5;
};

/// Sets style, palette, font and the one style sheet of the application; may be called again at any time.
/// Widgets learn of it through QEvent::StyleChange. Main thread only.
void applyTheme(QApplication& application, const Theme& theme, const Dress& dress = {});

/// The same but for the style sheet, and then the sheet: widgets made between the two are dressed once, while
/// under a sheet each move of a widget under construction dresses all that is in it anew.
void applyThemeWithoutSheet(QApplication& application, const Theme& theme, const Dress& dress = {});
void applySheet(QApplication& application);

/// Builds widgets for an application that runs: its sheet is taken off and put on again when all are there.
void buildUndressed(QApplication& application, const std::function<void()>& build);

/// The theme last applied; the light one before that.
Theme currentTheme();

QPalette paletteOf(const Theme& theme);

/// DejaVu Sans with the Noto face of the language behind it (Han characters differ between languages).
QFont applicationFont(const Dress& dress);

/// The font with digits of equal width: itself when its digits are, else the system's fixed font.
QFont tabularFont(const QFont& font);

/// Takes a foreign widget's own style sheet away, so that the application's dresses it.
void clearOwnSheet(QWidget& widget);

/// Gives the widget a role and dresses it anew.
void setRole(QWidget& widget, Role role);
Role roleOf(const QWidget& widget);

/// The colour of words and symbols in that role.
QColor roleColour(const Theme& theme, Role role);

/// The theme's surface or word colour that reads best on this background.
QColor readableOn(const Theme& theme, const QColor& background);

/// Contrast ratio of WCAG 2.1, 1 to 21.
double contrastRatio(const QColor& one, const QColor& other);

/// Part-way from one colour to the other; share 0 is the first.
QColor mixed(const QColor& one, const QColor& other, double share);

} // namespace halbench::widgets

Q_DECLARE_METATYPE(halbench::widgets::Theme)
