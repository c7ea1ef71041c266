#pragma once

#include <QString>

#include <string>

namespace halbench::app {

/// How measured values of one SI unit are shown to people: shown value = factor x SI value.
struct DisplayQuantity {
    QString quantity; ///< e.g. "angle"; empty when the unit is not ours
    QString unit;     ///< e.g. "°"
    double factor = 1.0;
    int decimals = 3;
    double typical = 1.0; ///< largest value usually seen, as shown: decides the width of a live number
};

/// The one table of units shown in plots, live numbers and the controls for driving: degrees, r/min, mT, A,
/// °C. A unit that is not in it is shown as it is.
DisplayQuantity displayQuantity(const std::string& symbol);

/// A signal in words ("Hall A"); the name itself when there are none.
QString signalWords(const std::string& name);

} // namespace halbench::app
