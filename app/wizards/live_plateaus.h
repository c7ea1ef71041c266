#pragma once

#include "control/base/sample_block.h"
#include "widgets/figure/figure.h"

#include <cstddef>
#include <mutex>
#include <vector>

namespace halbench::app {

/// Plateaus of a sweep as they are completed, for the eye while the sweep runs. What counts in the end is the
/// fit of the procedure, which uses all of the motion (resources/help/identification.md).
/// Thread: take() on the procedure's, the others on any.
class LivePlateaus {
public:
    struct Point {
        double current_A = 0.0;
        double speed_rad_s = 0.0;
    };

    /// Rows of a stream with columns speed, current_command and reference.segment; others are left alone.
    void take(const SampleBlock& block);

    std::vector<Point> points() const;
    double elapsed_s() const; ///< device time between the first row and the last

private:
    struct Row {
        double time_s;
        double speed_rad_s;
    };
    void finishSegment();

    mutable std::mutex m_mutex; ///< guards all below
    std::vector<Point> m_points;
    std::vector<Row> m_segment; ///< rows of the running one
    double m_marker = -1.0;
    double m_current_A = 0.0;
    double m_first_s = 0.0;
    double m_last_s = 0.0;
    bool m_hasRows = false;
};

/// Points with a straight line through those of each direction that has two currents or more. The axes reach
/// from the start as far as the sweep goes, so that nothing jumps.
widgets::Figure livePlateauFigure(const std::vector<LivePlateaus::Point>& points, double largest_A,
                                  double largest_rad_s);

} // namespace halbench::app
