#include "app/report/report_blocks.h"
#include "app/report/step_sections.h"
#include "control/base/unit_text.h"

namespace halbench::app {

ReportSection motorSection(const std::string& heading, const MotorAnalysis& result) {
    ReportSection section{heading, {}};
    section.blocks.emplace_back(ReportQuality{result.quality});
    std::vector<ReportQuantity> quantities;
    for (const ComputedFigure& figure : result.figures) {
        quantities.push_back({figure.words, figure.value, unitText(figure.unit)});
    }
    section.blocks.emplace_back(quantityTable("Computed from the parts of the motor", quantities));
    return section;
}

} // namespace halbench::app
