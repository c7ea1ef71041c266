#pragma once

#include "control/base/parameter_spec.h"
#include "widgets/language/display_units.h"

#include <QString>

#include <string>

namespace halbench::app {

enum class SpeedUnit { TurnsPerMinute, DegreesPerSecond, RadiansPerSecond };

enum class FrequencyUnit { Hertz, RadiansPerSecond };

/// Units that the user prefers to read; fields of the same unit follow.
struct DisplayUnits {
    widgets::AngleUnit angle = widgets::AngleUnit::Degree;
    SpeedUnit speed = SpeedUnit::TurnsPerMinute;
    FrequencyUnit frequency = FrequencyUnit::Hertz; ///< of the frequency axes of loops

    bool operator==(const DisplayUnits&) const = default;
};

/// How measured values of one SI unit are shown to people: shown value = factor x SI value.
struct DisplayQuantity {
    QString quantity; ///< e.g. "angle"; empty when the unit is not ours
    QString unit;     ///< e.g. "°"
    double factor = 1.0;
    int decimals = 3;
    double typical = 1.0; ///< largest value usually seen, as shown: decides the width of a live number
};

/// The one table of units shown in plots, live numbers and the controls for driving: angles and speeds as the
/// user prefers, mT, A, °C. A unit that is not in it is shown as it is; 1 is
/// that of a ratio.
DisplayQuantity displayQuantity(const std::string& symbol, const DisplayUnits& units);

/// The same of a signal: one without a unit that also goes below zero and stays within ±1, e.g. a part of a
/// quaternion, is a ratio and no state, and so is a sum of squares.
DisplayQuantity signalQuantity(const SignalSpec& spec, const DisplayUnits& units);

/// A power of ten near this step in SI, for a field that shows the quantity.
double shownStep(const DisplayQuantity& shown, double step);

/// An angle with its unit as the user prefers it: "8.21°", "0.143 rad".
QString angleText(double angle_rad, const DisplayUnits& units, int significantDigits = 3);

/// A speed with its unit as the user prefers it: "286 r/min", "30 rad/s".
QString speedText(double speed_rad_s, const DisplayUnits& units, int significantDigits = 3);

/// A signal in words ("Hall A"); the name itself when there are none.
QString signalWords(const std::string& name);

} // namespace halbench::app
