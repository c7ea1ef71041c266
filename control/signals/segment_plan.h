#pragma once

#include "control/signals/spectrum.h"
#include "control/signals/uniform_segments.h"

namespace halbench::control {

/// Where the segments of a spectrum lie.
struct SegmentPlan {
    UniformSegments stretches;
    std::size_t rows = 0;  ///< of a segment
    std::size_t shift = 0; ///< from one segment to the next
    std::vector<std::size_t> begins;

    /// Segments of a stretch.
    std::size_t segmentsIn(const Stretch& stretch) const {
        return stretch.rows() < rows ? 0 : (stretch.rows() - rows) / shift + 1;
    }
    std::size_t usedRows() const;
};

/// `isAveraged`: without a segment's length, many are made. Errors: as spectrum().
Result<SegmentPlan> planSegments(const SignalView& signal, const SpectrumConfig& config, bool isAveraged);

} // namespace halbench::control
