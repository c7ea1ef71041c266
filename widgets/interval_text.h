#pragma once

#include <QString>

#include <optional>
#include <utility>

namespace halbench::widgets {

/// An estimate as it is said: never without its interval.
struct IntervalWords {
    double value = 0.0;
    std::optional<std::pair<double, double>> interval; ///< low, high; absent: the data do not hold the value
    QString unit;                                      ///< as shown
    int level_percent = 95;
};

/// "2.05e-3 ± 0.04e-3 N·m·s/rad (95 %)"; "1.2 (0.9 to 2.1) A (95 %)" where the sides differ by more than a
/// tenth of the width; "not identified" without an interval. The interval decides the digits: two when they
/// are 10 to 35, else one, as the Particle Data Group rounds. The value is written to the same place.
QString intervalText(const IntervalWords& words);

} // namespace halbench::widgets
