#pragma once

#include <optional>
#include <string>
#include <vector>

namespace halbench::app {

/// One curve of a picture, or points that are not joined.
struct AnalysisCurve {
    std::string name; ///< in the legend; empty: not there
    std::vector<double> x;
    std::vector<double> y;
    bool isPoints = false;
};

struct AnalysisScale {
    std::string quantity;
    std::string unit;
    bool isLogarithmic = false;
};

/// Curves over the horizontal axis of the plot.
struct AnalysisPanel {
    AnalysisScale y;
    std::vector<AnalysisCurve> curves;
    std::optional<double> limit = {}; ///< a line across, "threshold"
};

/// A picture of a result for the report of a run.
struct AnalysisPlot {
    std::string title;
    AnalysisScale x;
    std::vector<AnalysisPanel> panels;
    std::string caption = {};
    bool isEqualScale = false; ///< a unit is as long on both axes of the one panel
};

} // namespace halbench::app
