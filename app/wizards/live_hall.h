#pragma once

#include "control/base/sample_block.h"
#include "widgets/figure/figure.h"

#include <cstddef>
#include <mutex>
#include <vector>

namespace halbench::app {

/// What the Hall sensors read while a calibration runs, for the eye: the ellipse whose centre, axes and tilt
/// are looked for (resources/help/identification.md section 6). Thread: take() on the procedure's, the others
/// on any.
class LiveHall {
public:
    struct Point {
        double hall_a_T = 0.0;
        double hall_b_T = 0.0;
    };
    static constexpr std::size_t MostPoints = 1200;

    /// Rows of any stream count as time; those with hall.a and hall.b as points too.
    void take(const SampleBlock& block);

    std::vector<Point> points() const; ///< at most the last MostPoints
    double elapsed_s() const;          ///< device time between the first row and the last

private:
    mutable std::mutex m_mutex; ///< guards all below
    std::vector<Point> m_points;
    std::size_t m_oldest = 0;
    double m_first_s = 0.0;
    double m_last_s = 0.0;
    bool m_hasRows = false;
};

/// Hall B over Hall A. The axes reach from the start as far as the largest field, so that nothing jumps.
widgets::Figure liveHallFigure(const std::vector<LiveHall::Point>& points, double largest_T);

} // namespace halbench::app
