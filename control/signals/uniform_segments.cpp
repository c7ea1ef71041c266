#include "control/signals/uniform_segments.h"

#include "control/base/assert.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

constexpr double GapFactor = 1.5;
// Rounding of the time stamps explains a small part of a period; more is a rate that is not constant.
constexpr double UnevenRatio = 0.1;

Result<double> usualStep(std::span<const double> time_s) {
    std::vector<double> steps(time_s.size() - 1);
    for (std::size_t row = 0; row < steps.size(); ++row) {
        steps[row] = time_s[row + 1] - time_s[row];
        if (!(steps[row] > 0.0) || !std::isfinite(steps[row])) {
            return failure(ErrorCode::InvalidInput,
                           fmt::format("time does not increase from row {} to row {}", row + 1, row + 2),
                           "sort the rows by time");
        }
    }
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>((steps.size() - 1) / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return *middle;
}

tl::unexpected<Error> unevenTime(std::size_t row, double step_s, double usual_s) {
    return failure(
        ErrorCode::Refused,
        fmt::format("uneven sampling: {:.6g} s before row {}, usually {:.6g} s", step_s, row + 1, usual_s),
        "a spectrum needs a constant sample rate; resample the signal first");
}

/// Appends rows one after the other and cuts where it is told to.
class Cutter {
public:
    explicit Cutter(UniformSegments& result) : m_result(result) {}

    void cut(std::size_t row) {
        if (m_begin < row) {
            m_result.pieces.push_back({m_begin, row});
        }
        m_begin = row;
    }
    void leaveOut(std::size_t row) {
        cut(row);
        m_begin = row + 1;
    }

private:
    UniformSegments& m_result;
    std::size_t m_begin = 0;
};

} // namespace

std::size_t UniformSegments::longest() const {
    std::size_t rows = 0;
    for (const Stretch& piece : pieces) {
        rows = std::max(rows, piece.rows());
    }
    return rows;
}

Result<UniformSegments> findUniformSegments(std::span<const double> time_s, std::span<const double> values) {
    HB_ASSERT(time_s.size() == values.size());
    if (time_s.size() < 2) {
        return failure(ErrorCode::Refused,
                       fmt::format("{} rows are too few for a sample rate", time_s.size()),
                       "use a recording with more rows");
    }
    const Result<double> usual_s = usualStep(time_s);
    if (!usual_s) {
        return failure(usual_s.error());
    }
    UniformSegments result;
    Cutter cutter(result);
    double neighbours_s = 0.0;
    std::size_t neighbours = 0;
    for (std::size_t row = 0; row < values.size(); ++row) {
        const double step_s = row > 0 ? time_s[row] - time_s[row - 1] : *usual_s;
        if (step_s > GapFactor * *usual_s) {
            ++result.gaps;
            cutter.cut(row);
        } else if (std::fabs(step_s - *usual_s) > UnevenRatio * *usual_s) {
            return unevenTime(row, step_s, *usual_s);
        } else if (row > 0) {
            neighbours_s += step_s;
            ++neighbours;
        }
        if (!std::isfinite(values[row])) {
            ++result.missingValues;
            cutter.leaveOut(row);
        }
    }
    cutter.cut(values.size());
    HB_ASSERT(neighbours > 0); // the median step is one of them
    result.period_s = neighbours_s / static_cast<double>(neighbours);
    return result;
}

} // namespace halbench::control
