#pragma once

#include "control/base/result.h"

#include <cstddef>
#include <span>
#include <vector>

namespace halbench::control {

/// Rows [begin, end) that follow each other evenly, each with a finite value.
struct Stretch {
    std::size_t begin = 0;
    std::size_t end = 0;

    std::size_t rows() const { return end - begin; }
};

/// A signal cut where a transform must not reach across.
struct UniformSegments {
    double period_s = 0.0;         ///< mean distance of neighbouring rows
    std::vector<Stretch> pieces;   ///< in the order of time
    std::size_t gaps = 0;          ///< places where rows are missing
    std::size_t missingValues = 0; ///< rows whose value is not finite

    /// Rows of the longest piece; 0 without one.
    std::size_t longest() const;
};

/// A step of more than one and a half usual (median) steps is a gap and a value that is not finite a break;
/// any other step must be within a tenth of the usual one. As many times as values. Errors: InvalidInput
/// (time that does not rise); Refused (fewer than two rows, uneven time), naming the row.
Result<UniformSegments> findUniformSegments(std::span<const double> time_s, std::span<const double> values);

} // namespace halbench::control
