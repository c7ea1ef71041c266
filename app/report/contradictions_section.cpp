#include "app/actuators/actuator.h"
#include "app/report/step_sections.h"

namespace halbench::app {

std::optional<ReportSection> contradictionsSection(const std::string& deviceModel) {
    const Actuator& actuator = actuatorOf(deviceModel);
    if (actuator.model != deviceModel || actuator.contradictions.empty()) {
        return std::nullopt;
    }
    ReportTable table;
    table.columns = {
        {"what is published"}, {"what follows from its own numbers"}, {"what this program does"}};
    for (const Contradiction& entry : actuator.contradictions) {
        table.rows.push_back({{entry.said}, {entry.follows}, {entry.decision}});
    }
    return ReportSection{
        "Published figures that contradict each other",
        {ReportParagraph{"Compare results with the published ones with these in mind."}, table}};
}

} // namespace halbench::app
