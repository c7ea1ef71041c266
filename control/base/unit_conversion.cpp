#include "control/base/unit_conversion.h"

#include "control/base/units.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>

namespace halbench {

namespace {

enum Dimension : std::size_t { Metre, Kilogram, Second, Ampere, KelvinDegree, Radian, Celsius, Decibel };
using Powers = std::array<int, 8>;

/// SI value = value * factor / divisor.
struct Scaled {
    double factor = 1.0;
    double divisor = 1.0;
    Powers powers{};
};

struct Atom {
    std::string_view name;
    Scaled unit;
    bool takesPrefix = true;
};

constexpr Powers dimension(int metre, int kilogram, int second, int ampere) {
    return {metre, kilogram, second, ampere, 0, 0, 0, 0};
}
constexpr Powers angle(int second = 0) {
    return {0, 0, second, 0, 0, 1, 0, 0};
}

constexpr std::array Atoms = {
    Atom{"m", {1.0, 1.0, dimension(1, 0, 0, 0)}},
    Atom{"g", {1.0, 1e3, dimension(0, 1, 0, 0)}},
    Atom{"s", {1.0, 1.0, dimension(0, 0, 1, 0)}},
    Atom{"sec", {1.0, 1.0, dimension(0, 0, 1, 0)}, false},
    Atom{"min", {60.0, 1.0, dimension(0, 0, 1, 0)}, false},
    Atom{"A", {1.0, 1.0, dimension(0, 0, 0, 1)}},
    Atom{"V", {1.0, 1.0, dimension(2, 1, -3, -1)}},
    Atom{"W", {1.0, 1.0, dimension(2, 1, -3, 0)}},
    Atom{"J", {1.0, 1.0, dimension(2, 1, -2, 0)}},
    Atom{"N", {1.0, 1.0, dimension(1, 1, -2, 0)}},
    Atom{"T", {1.0, 1.0, dimension(0, 1, -2, -1)}},
    Atom{"G", {1.0, 1e4, dimension(0, 1, -2, -1)}},
    Atom{"Gs", {1.0, 1e4, dimension(0, 1, -2, -1)}, false},
    Atom{"Ohm", {1.0, 1.0, dimension(2, 1, -3, -2)}},
    Atom{"H", {1.0, 1.0, dimension(2, 1, -2, -2)}},
    Atom{"K", {1.0, 1.0, {0, 0, 0, 0, 1, 0, 0, 0}}},
    Atom{"degC", {1.0, 1.0, {0, 0, 0, 0, 0, 0, 1, 0}}, false},
    Atom{"rad", {1.0, 1.0, angle()}},
    Atom{"deg", {Pi, 180.0, angle()}},
    Atom{"gon", {Pi, 200.0, angle()}},
    Atom{"arcmin", {Pi, 10800.0, angle()}, false},
    Atom{"arcsec", {Pi, 648000.0, angle()}, false},
    Atom{"rev", {2.0 * Pi, 1.0, angle()}},
    Atom{"turn", {2.0 * Pi, 1.0, angle()}, false},
    Atom{"rpm", {Pi, 30.0, angle(-1)}},
    Atom{"rps", {2.0 * Pi, 1.0, angle(-1)}, false},
    Atom{"Hz", {2.0 * Pi, 1.0, angle(-1)}},
    Atom{"dB", {1.0, 1.0, {0, 0, 0, 0, 0, 0, 0, 1}}, false},
    Atom{"%", {1.0, 100.0, {}}, false},
};

struct Prefix {
    char letter;
    double factor;
    double divisor;
};
constexpr std::array Prefixes = {Prefix{'n', 1.0, 1e9}, Prefix{'u', 1.0, 1e6}, Prefix{'m', 1.0, 1e3},
                                 Prefix{'c', 1.0, 1e2}, Prefix{'k', 1e3, 1.0}, Prefix{'M', 1e6, 1.0}};

/// How else a part of a unit is written; beyond ASCII in UTF-8.
struct Spelling {
    std::string_view written;
    std::string_view meant;
};
constexpr std::array Symbols = {
    Spelling{"\xC2\xB0\x43", "degC"},
    Spelling{"\xC2\xB0\x46", "degF"}, // degree sign
    Spelling{"\xC2\xB0", "deg"},
    Spelling{"\xC2\xB5", "u"}, // micro sign
    Spelling{"\xCE\xBC", "u"},
    Spelling{"\xCE\xA9", "Ohm"}, // Greek mu, Omega
    Spelling{"\xC2\xB7", "*"},
    Spelling{"\xE2\x8B\x85", "*"}, // middle dot, dot operator
    Spelling{"\xC2\xB2", "^2"},
    Spelling{"\xC2\xB3", "^3"}, // superscripts
    Spelling{"\xE2\x81\xBB", "^-"},
    Spelling{"\xC2\xB9", "1"}, // superscript minus and one
    Spelling{"^-^", "^-"},
    Spelling{"_per_", "/"},
    Spelling{"U/min", "rpm"},
    Spelling{"r/min", "rpm"},
    Spelling{"**", "^"},
    Spelling{" ", "*"},
};
constexpr std::array Words = {
    Spelling{"degree", "deg"},  Spelling{"degrees", "deg"}, Spelling{"radian", "rad"},
    Spelling{"radians", "rad"}, Spelling{"revs", "rev"},    Spelling{"turns", "turn"},
    Spelling{"ohm", "Ohm"},     Spelling{"Gauss", "G"},     Spelling{"gauss", "G"},
    Spelling{"percent", "%"},
};
/// Products without a sign between; a power belongs to the last factor.
constexpr std::array Products = {
    Spelling{"Nm", "N*m"},   Spelling{"mNm", "mN*m"},  Spelling{"uNm", "uN*m"}, Spelling{"Ncm", "N*cm"},
    Spelling{"Nmm", "N*mm"}, Spelling{"Nms", "N*m*s"}, Spelling{"As", "A*s"},   Spelling{"mAs", "mA*s"},
    Spelling{"Vs", "V*s"},   Spelling{"kgm", "kg*m"},  Spelling{"gcm", "g*cm"}, Spelling{"kgcm", "kg*cm"},
};

bool isDigit(char character) {
    return character >= '0' && character <= '9';
}

void multiply(Scaled& product, const Scaled& by, int power) {
    for (int i = 0; i < std::abs(power); ++i) {
        product.factor *= power > 0 ? by.factor : by.divisor;
        product.divisor *= power > 0 ? by.divisor : by.factor;
    }
    for (std::size_t i = 0; i < product.powers.size(); ++i) {
        product.powers[i] += by.powers[i] * power;
    }
}

std::optional<Scaled> atomOf(std::string_view name) {
    for (const Spelling& word : Words) {
        name = name == word.written ? word.meant : name;
    }
    for (const Atom& atom : Atoms) {
        if (atom.name == name) {
            return atom.unit;
        }
    }
    for (const Prefix& prefix : Prefixes) {
        for (const Atom& atom : Atoms) {
            if (atom.takesPrefix && name[0] == prefix.letter && name.substr(1) == atom.name) {
                Scaled unit = atom.unit;
                unit.factor *= prefix.factor;
                unit.divisor *= prefix.divisor;
                return unit;
            }
        }
    }
    return std::nullopt;
}

/// Reads product := factor (('*' | '/') factor)*, factor := name ['^' power] | '(' product ')' ['^' power].
class Parser {
public:
    explicit Parser(std::string_view text) : m_text(text) {}

    std::optional<Scaled> whole() {
        const std::optional<Scaled> unit = product(0);
        return m_at == m_text.size() ? unit : std::nullopt;
    }

private:
    static constexpr int MostParentheses = 8;
    static constexpr int MostPower = 6;

    std::optional<Scaled> product(int depth) {
        Scaled result;
        int sign = 1;
        for (;;) {
            const std::optional<Scaled> next = factor(depth);
            if (!next) {
                return std::nullopt;
            }
            multiply(result, *next, sign);
            if (m_at == m_text.size() || (m_text[m_at] != '*' && m_text[m_at] != '/')) {
                return result;
            }
            sign = m_text[m_at++] == '/' ? -1 : 1;
        }
    }

    std::optional<Scaled> factor(int depth) {
        if (m_at < m_text.size() && m_text[m_at] == '(') {
            ++m_at;
            const std::optional<Scaled> inner = depth < MostParentheses ? product(depth + 1) : std::nullopt;
            if (!inner || m_at == m_text.size() || m_text[m_at++] != ')') {
                return std::nullopt;
            }
            return raised(*inner);
        }
        const std::size_t begin = m_at;
        m_at = std::min(m_text.find_first_of("*/()^-0123456789", begin), m_text.size());
        if (m_at == begin && m_at < m_text.size() && m_text[m_at] == '1') {
            ++m_at;
            return Scaled(); // "1/s"
        }
        const std::string_view name = m_text.substr(begin, m_at - begin);
        if (name.empty()) {
            return std::nullopt;
        }
        for (const Spelling& spelling : Products) {
            if (name == spelling.written) {
                return productWritten(spelling.meant);
            }
        }
        const std::optional<Scaled> atom = atomOf(name);
        return atom ? raised(*atom) : std::nullopt;
    }

    std::optional<Scaled> productWritten(std::string_view factors) {
        const std::size_t last = factors.rfind('*');
        std::optional<Scaled> before = Parser(factors.substr(0, last)).whole();
        const std::optional<Scaled> end = raised(*atomOf(factors.substr(last + 1)));
        if (before && end) {
            multiply(*before, *end, 1);
        }
        return end ? before : std::nullopt;
    }

    std::optional<Scaled> raised(const Scaled& unit) {
        if (m_at < m_text.size() && m_text[m_at] == '^') {
            ++m_at;
        } else if (m_at == m_text.size() || (!isDigit(m_text[m_at]) && m_text[m_at] != '-')) {
            return unit;
        }
        const int sign = m_at < m_text.size() && m_text[m_at] == '-' ? -1 : 1;
        m_at += sign < 0 ? 1 : 0;
        if (m_at == m_text.size() || !isDigit(m_text[m_at]) || m_text[m_at] - '0' > MostPower) {
            return std::nullopt;
        }
        Scaled power;
        multiply(power, unit, sign * (m_text[m_at++] - '0'));
        return power;
    }

    std::string_view m_text;
    std::size_t m_at = 0;
};

std::string plainText(std::string_view written) {
    std::string text(written);
    for (const Spelling& symbol : Symbols) {
        for (std::size_t at = text.find(symbol.written); at != std::string::npos;
             at = text.find(symbol.written, at + symbol.meant.size())) {
            text.replace(at, symbol.written.size(), symbol.meant);
        }
    }
    return text;
}

std::optional<Scaled> readUnit(const std::string& text) {
    return text.empty() || text == "-" ? std::optional(Scaled()) : Parser(text).whole();
}

/// Of what stands on a zero of its own.
std::optional<UnitConversion> toCelsius(const std::string& text) {
    if (text == "K") {
        return UnitConversion{1.0, 1.0, -273.15};
    }
    if (text == "degF") {
        return UnitConversion{5.0, 9.0, -160.0 / 9.0};
    }
    return std::nullopt;
}

bool isSameDimension(Powers from, const Powers& to) {
    // "N*m" is per radian; "1/s^2" cannot be of anything but radians, "1/s" and "1/min" may be of turns.
    const bool isOfAngle = to[Kilogram] != 0 || std::abs(to[Second]) >= 2;
    const bool mayLeaveAngleOut = isOfAngle && (from[Radian] == 0 || to[Radian] == 0);
    from[Radian] = mayLeaveAngleOut ? to[Radian] : from[Radian];
    return from == to;
}

} // namespace

std::optional<UnitConversion> conversionBetween(std::string_view from, std::string_view to) {
    if (from == to) {
        return UnitConversion{};
    }
    const std::string source = plainText(from);
    const std::string target = plainText(to);
    if (target == "degC" && toCelsius(source)) {
        return toCelsius(source);
    }
    const std::optional<Scaled> one = readUnit(source);
    const std::optional<Scaled> other = readUnit(target);
    if (!one || !other || !isSameDimension(one->powers, other->powers)) {
        return std::nullopt;
    }
    return UnitConversion{one->factor * other->divisor, one->divisor * other->factor, 0.0};
}

bool isReadableUnit(std::string_view text) {
    const std::string plain = plainText(text);
    return toCelsius(plain) || readUnit(plain);
}

} // namespace halbench
