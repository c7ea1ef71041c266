#include "app/actuators/htm/motor_contradictions.h"

#include <array>

namespace halbench::app {
namespace {

constexpr std::array Published = {
    Contradiction{"Maximum torque 0.044 N·m at 4 A.",
                  "The torque constant gives 0.0572 N·m; 270 r/min alone needs 0.0553 N·m.",
                  "1.43e-2 N·m/A is used; 0.044 counts as inconsistent."},
    Contradiction{"4 A turn the rotor at 270 r/min.", "4 A give 284.9 r/min; 270 r/min need 3.866 A.",
                  "Treated as rounding."},
    Contradiction{"One count of the converter is 0.36 mT at 80 °C.", "0.3664 mT.",
                  "Computed with the sensors' temperature."},
    Contradiction{"Damping 0.06 at 15 rad/s leads to K_I = 0.1 A/(rad·s).", "It leads to 3.776 A/(rad·s).",
                  "The design computes 3.776; 0.1 is a preset."},
    Contradiction{
        "i[k] = 10 e[k] - 10 e[k-1] + i[k-1].",
        "Rounding 9.999 to 10 removes the integrator; with a clamped memory a step of 100° stops at 28°.",
        "The positional form runs; the literal ones are for demonstration."},
    Contradiction{"Gains in A/rad give steps of 0.32° and rest within 0.64°.",
                  "10 A/rad leave a friction band of 8.21°; a step of 0.32° does not move the rotor.",
                  "Most likely the gain was in A/deg; both exist as presets."},
    Contradiction{"A ramp and sines are tracked within 0.64°.",
                  "Stability keeps K_P below 17.27 A/rad; a proportional loop then lags at least 7.2°.",
                  "The published gains show their honest error; the recommended law stays below 0.64°."},
    Contradiction{
        "The field of the coils at the sensors is negligible at low speed.",
        "0.0159 rad/A feed the current back into the angle; uncompensated, K_P must stay below 62.8 A/rad.",
        "The stray field is subtracted before the angle is decoded."},
    Contradiction{"157 mT with an outer diameter of 76.4 mm, uniform within 3 %.",
                  "Real bars of 38.1 mm reach about 119 mT at the sensors; the field varies by 17 %.",
                  "157 mT is a parameter of the device; a remanence above 1.5 T is flagged."},
    Contradiction{"53 % fill factor at a pitch of about 0.7 mm.",
                  "That pitch would be 66 %; 53 % is a pitch of 0.784 mm.", "The window of 53 % is used."},
    Contradiction{"152 µH for one phase.", "Two coils of 105 turns in series have 0.5 to 0.6 mH.",
                  "152 µH is kept: it moves only the amplifier's poles above 600 Hz."},
    Contradiction{"R10 = 1.0 Ω, 10 W.", "16 W at 4 A in one resistor.",
                  "Taken as two in parallel, 4 W each, as the formula has it."},
    Contradiction{"Lock times of 1.5, 1.9 and 3.7 s.", "They depend on a threshold that is not stated.",
                  "A lock time is always given with its threshold."},
    Contradiction{"Figure 12 without its amplitude.",
                  "Gain and phase at 1 Hz depend on it: 1.249 and -15.6° at 45°.",
                  "45° is assumed and can be changed."},
};

} // namespace

std::span<const Contradiction> motorContradictions() {
    return Published;
}

} // namespace halbench::app
