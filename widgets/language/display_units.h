#pragma once

#include <QString>

#include <optional>
#include <string>

namespace halbench::widgets {

enum class AngleUnit { Radian, Degree };

/// How a value in an SI unit is shown: shown = value * factor.
struct DisplayUnit {
    QString text; ///< as people write it, e.g. "A/°"
    double factor = 1.0;
};

/// Units that count radians above or below the line turn with the angle unit; all others stay as they are.
DisplayUnit displayUnit(const std::string& symbol, AngleUnit angleUnit);

// The one notation of numbers on the screen: the user's decimal point, no group separators (what separates
// thousands here is a decimal point there), and for what is too small or too large for decimals an exponent
// without padding, "1.2e-5", as the fields read it, spreadsheets paste it and the report prints it.

/// At most that many significant digits.
QString numberText(double value, int significantDigits);
/// Always with an exponent.
QString exponentText(double value, int decimals);
QString countText(quint64 count);
/// "1.2e-05" -> "1.2e-5": the exponent's padding is noise.
QString tidyExponent(QString number);

/// A setting as it is shown: five significant digits, more where its whole part has more. Who edits it starts
/// from these; files and boards keep every digit of what is not edited.
QString settingText(double value);

/// So many decimals in the user's notation, without group separators and never "-0.0", which would flicker
/// beside "0.0"; a dash where there is no number.
QString fixedText(const std::optional<double>& value, int decimals);

/// A finite number in the user's notation or in the C one; the unit may stand behind it. Nothing is read as
/// thousands, and what could be meant as such is refused: "1,500" in English, "1.500" in German. The sign of
/// degrees in the unit may be spelled "deg", as in files.
std::optional<double> parseNumber(const QString& text, const QString& unitText = {});

/// Whether a board with single-precision numbers holds the same in both cases: 2^-23 relative.
bool areSameOnBoard(double one, double other);

} // namespace halbench::widgets
