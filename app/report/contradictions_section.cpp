#include "app/report/step_sections.h"

#include <array>

namespace halbench::app {
namespace {

struct Contradiction {
    const char* said;
    const char* follows;
    const char* decision;
};

constexpr std::array Published = {
    Contradiction{"Maximum torque 0.044 N·m at 4 A.",
                  "The torque constant gives 0.0572 N·m; 270 r/min alone needs 0.0553 N·m.",
                  "1.43e-2 N·m/A is used; 0.044 counts as inconsistent."},
    Contradiction{"4 A turn the rotor at 270 r/min.", "4 A give 284.9 r/min; 270 r/min need 3.866 A.",
                  "Treated as rounding."},
    Contradiction{"Damping 0.06 at 15 rad/s leads to K_I = 0.1 A/(rad·s).", "It leads to 3.776 A/(rad·s).",
                  "The design computes 3.776; 0.1 is a preset."},
    Contradiction{"Gains in A/rad give steps of 0.32° and rest within 0.64°.",
                  "10 A/rad leave a friction band of 8.21°; a step of 0.32° does not move the rotor.",
                  "Most likely the gain was in A/deg; both exist as presets."},
    Contradiction{
        "The field of the coils at the sensors is negligible at low speed.",
        "0.0159 rad/A feed the current back into the angle; uncompensated, K_P must stay below 62.8 A/rad.",
        "The stray field is subtracted before the angle is decoded."},
    Contradiction{"157 mT with an outer diameter of 76.4 mm, uniform within 3 %.",
                  "Real bars of 38.1 mm reach about 119 mT at the sensors; the field varies by 17 %.",
                  "157 mT is a parameter of the device; a remanence above 1.5 T is flagged."},
};

} // namespace

std::optional<ReportSection> contradictionsSection(const std::string& deviceModel) {
    if (deviceModel != "htm") {
        return std::nullopt;
    }
    ReportTable table;
    table.columns = {
        {"what is published"}, {"what follows from its own numbers"}, {"what this program does"}};
    for (const Contradiction& entry : Published) {
        table.rows.push_back({{entry.said}, {entry.follows}, {entry.decision}});
    }
    return ReportSection{
        "Published figures that contradict each other",
        {ReportParagraph{"Compare results with the published ones with these in mind."}, table}};
}

} // namespace halbench::app
