#pragma once

#include "control/history/sample_history.h"

#include <string>
#include <vector>

namespace halbench::widgets {

/// Maps time and value to device pixels from the canvas' left and top edge; pixel i reaches from i to i + 1.
struct PixelMap {
    double begin_s = 0.0;   ///< time at the centre of pixel column 0
    double perSecond = 1.0; ///< columns a second
    double zero = 0.0;      ///< row of value zero
    double perValue = -1.0; ///< rows per unit of the signal
    int columns = 1;
    int rows = 1;

    double x(double time_s) const { return (time_s - begin_s) * perSecond + 0.5; }
    double y(double value) const;
    /// Time at a position in columns; 0 is the left edge of the first.
    double timeAt(double column) const { return begin_s + (column - 0.5) / perSecond; }
};

struct PixelPoint {
    double x = 0.0;
    double y = 0.0;
};

/// Rows that a curve covers in one column, without the thickness of its line.
struct PixelBox {
    int column = 0;
    double top = 0.0;
    double bottom = 0.0;
    bool isJoined = false; ///< with the box before
};

/// A curve of one frame in pixels: a line through its samples where they are sparse, else the extremes of
/// each column. A sample belongs to the column whose centre is nearest; neighbouring columns meet half of the
/// way, so that the line stays connected.
struct CurveShape {
    std::vector<std::vector<PixelPoint>> lines; ///< only the first `lineCount` are of this frame
    std::size_t lineCount = 0;
    std::vector<PixelBox> boxes;
    bool areSamplesMarked = false; ///< so sparse that each is shown as a dot

    std::vector<control::TimedValue> samples; ///< kept, so that frames do not allocate
    control::KeptColumns kept;                ///< of the frame before
};

/// `drawn`: nothing outside is shown. `dotDistance`: columns between samples from which on they are marked.
void shapeCurve(const control::SampleHistory& history, const std::string& signal, control::TimeRange drawn,
                const PixelMap& map, double dotDistance, CurveShape& shape);

} // namespace halbench::widgets
