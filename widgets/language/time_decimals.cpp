#include "widgets/language/time_decimals.h"

#include "widgets/language/display_units.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace halbench::widgets {
namespace {

constexpr int FewestDecimals = 4;
constexpr int MostDecimals = 9;
constexpr int SignificantDigits = 5;
constexpr double OfSpan_ratio = 1e-3;
constexpr double OfPeriod_ratio = 0.1;

/// The smallest number of decimals with which a step as fine as this is written.
int decimalsFor(double step_s) {
    // A step of 1e-5 must not become 6 decimals because its logarithm is -4.9999999999.
    constexpr double Rounding = 1e-9;
    return static_cast<int>(std::ceil(-std::log10(step_s) - Rounding));
}

} // namespace

int timeDecimals(double span_s, std::optional<double> period_s) {
    int decimals = FewestDecimals;
    if (span_s > 0.0) {
        decimals = std::max(decimals, decimalsFor(OfSpan_ratio * span_s));
    }
    if (period_s && *period_s > 0.0) {
        decimals = std::max(decimals, decimalsFor(OfPeriod_ratio * *period_s));
    }
    return std::min(decimals, MostDecimals);
}

QString timeDistanceText(double distance_s, int decimals) {
    if (distance_s != 0.0 && std::isfinite(distance_s)) {
        const int ahead = static_cast<int>(std::floor(std::log10(std::abs(distance_s)))) + 1;
        decimals = std::clamp(SignificantDigits - ahead, decimals, std::max(decimals, MostDecimals + 3));
    }
    return fixedText(distance_s, decimals);
}

int typedDecimals(const QString& text) {
    static const QRegularExpression fraction(QStringLiteral("^\\s*[-+]?[0-9]*[.,]([0-9]+)"));
    const QRegularExpressionMatch match = fraction.match(text);
    return match.hasMatch() ? match.capturedLength(1) : 0;
}

} // namespace halbench::widgets
