#pragma once

#include "widgets/figure/figure.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace halbench::widgets {

/// The usual pictures of identification and tuning as figures.

/// Points with their fit line above, residuals below. Points that the fit left out are hollow.
struct RegressionContent {
    std::string title;
    Axis x;
    Axis y;
    struct Point {
        double x = 0.0;
        double y = 0.0;
        double residual = 0.0; ///< measured minus fit, in the unit of y
        bool isUsed = true;
    };
    std::vector<Point> points;
    std::vector<Curve> fits; ///< e.g. one line per direction
};
Figure regressionFigure(const RegressionContent& content);

/// Magnitude [dB] over phase [deg] against frequency [Hz], logarithmic.
struct BodeContent {
    std::string title;
    struct Response {
        std::string label;
        std::vector<double> frequency_Hz;
        std::vector<double> magnitude_dB;
        std::vector<double> phase_deg;
        CurveStyle style = CurveStyle::Line;
        std::optional<int> colour; ///< as of a Curve
    };
    std::vector<Response> responses;
    std::vector<ReferenceLine> magnitudeLines; ///< e.g. 0 dB
    std::vector<ReferenceLine> phaseLines;     ///< e.g. -180 deg
};
Figure bodeFigure(const BodeContent& content);

/// Joint confidence region of two estimates: {p: (p - centre)' C^-1 (p - centre) <= quantile}.
struct EllipseContent {
    std::string title;
    Axis x;
    Axis y;
    std::array<double, 2> centre{};
    std::array<std::array<double, 2>, 2> covariance{};
    struct Level {
        std::string label;     ///< e.g. "95 % joint"
        double quantile = 0.0; ///< e.g. 2 F(0.95; 2, n - 2)
    };
    std::vector<Level> levels;
    std::vector<Curve> marks; ///< e.g. a given or published value as a point
};
Figure ellipseFigure(const EllipseContent& content);

} // namespace halbench::widgets
