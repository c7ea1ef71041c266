#pragma once

#include "app/procedures/tune/loop_uncertainty.h"
#include "widgets/figure/figure.h"

#include <optional>
#include <string>
#include <vector>

namespace halbench::app {

/// Another design that is drawn beside; the loop must live while the picture is made.
struct NamedLoop {
    std::string name;
    const AnalysisResult* loop;
};

/// A loop with the look that it has in every picture.
struct LoopCurve {
    const AnalysisResult* loop;
    std::string label; ///< empty for one that is alone
    widgets::CurveStyle style;
    int colour;
};

/// Where nine tenths of the motors lie: an area of the proposed loop's colour. `scale` multiplies its values.
widgets::Curve bandCurve(const std::vector<double>& x, const control::Band& band, double xScale = 1.0,
                         double yScale = 1.0);

/// Curve role of what belongs to a picture and to no loop: unit circle, margins, measured points.
constexpr int MarkColour = 6;

/// The proposed loop, the one before it, the others; the arguments must live as long as the answer.
std::vector<LoopCurve> loopCurves(const AnalysisResult& predicted,
                                  const std::optional<AnalysisResult>& present,
                                  const std::vector<NamedLoop>& others);

} // namespace halbench::app
