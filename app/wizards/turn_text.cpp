#include "app/wizards/turn_text.h"

#include "widgets/controls/progress_row.h"
#include "widgets/language/display_units.h"

#include <QCoreApplication>

#include <cmath>

namespace halbench::app {
namespace {

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::TurnText)
};

} // namespace

QString turnText(double turn_rad_s, double turns, double duration_s) {
    const double speed_rad_s = std::abs(turn_rad_s); // in the unit of the form that asks for it
    return (turn_rad_s < 0.0
                ? Words::tr("The rotor will turn in reverse at %1 rad/s, about %2 turns, for %3 minutes of "
                            "device time.")
                : Words::tr(
                      "The rotor will turn forward at %1 rad/s, about %2 turns, for %3 minutes of device "
                      "time."))
        .arg(widgets::fixedText(speed_rad_s, 1), widgets::fixedText(turns, 0),
             widgets::durationText(duration_s));
}

} // namespace halbench::app
