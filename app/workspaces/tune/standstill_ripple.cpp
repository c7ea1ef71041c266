#include "app/workspaces/tune/standstill_ripple.h"

#include "widgets/language/display_units.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

constexpr double RestShare_ratio = 0.2; ///< of the recording, at its end
constexpr double Trimmed_ratio = 0.05;  ///< at either end of the sorted samples
constexpr double Quiet_A = 0.02;        ///< less than that nobody sees in the picture
constexpr double Explained_ratio =
    2.0; ///< trimming, quantised angles and a few hundred samples are not exact

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::StandstillRippleWords)
};

std::optional<double> ripple(const Recording& recording, const char* signal) {
    std::vector<double> samples = recording.layout ? recording.column(signal) : std::vector<double>{};
    const auto rest = static_cast<std::ptrdiff_t>(RestShare_ratio * static_cast<double>(samples.size()));
    constexpr std::ptrdiff_t Fewest = 20;
    if (rest < Fewest) {
        return std::nullopt;
    }
    samples.erase(samples.begin(), samples.end() - rest);
    std::sort(samples.begin(), samples.end());
    const auto cut = static_cast<std::ptrdiff_t>(Trimmed_ratio * static_cast<double>(rest));
    const auto count = static_cast<double>(rest - 2 * cut);
    double mean = 0.0;
    for (auto each = samples.begin() + cut; each != samples.end() - cut; ++each) {
        mean += *each / count;
    }
    double variance = 0.0;
    for (auto each = samples.begin() + cut; each != samples.end() - cut; ++each) {
        variance += (*each - mean) * (*each - mean) / count;
    }
    return std::sqrt(variance);
}

} // namespace

std::optional<StandstillRipple> standstillRipple(const Recording& recording, const control::PidGains& gains,
                                                 double period_s) {
    const auto current_A = ripple(recording, "current_command");
    const auto angle_rad = ripple(recording, "position");
    if (!current_A || !angle_rad) {
        return std::nullopt;
    }
    const double derivative = gains.derivative / period_s;
    return StandstillRipple{*current_A, *angle_rad,
                            *angle_rad * std::hypot(gains.proportional + derivative, derivative)};
}

QString rippleWords(const StandstillRipple& ripple, const DisplayUnits& units) {
    if (ripple.current_A < Quiet_A) {
        return {};
    }
    const QString current = widgets::numberText(ripple.current_A, 2);
    const QString angle = angleText(ripple.angle_rad, units, 2);
    return ripple.current_A <= Explained_ratio * ripple.explained_A
               ? Words::tr("current ripple at standstill about %1 A: noise of the measured angle (%2) "
                           "multiplied by these gains")
                     .arg(current, angle)
               : Words::tr("current ripple at standstill about %1 A, more than angle noise (%2) explains: "
                           "possible hunting; reduce K_D or K_P")
                     .arg(current, angle);
}

} // namespace halbench::app
