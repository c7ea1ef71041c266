#include "app/actuators/planar/crosstalk_fit.h"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>

namespace halbench::app {
namespace {

constexpr double Flowing_A = 1e-3;
constexpr std::size_t Before = 8; // rows without current
constexpr int Terms = 6;          // cubic, current, its second integral

bool isAlone(const models::CoilCurrents_A& current_A, int coil) {
    const double own = std::abs(current_A(coil));
    return own > Flowing_A && current_A.cwiseAbs().sum() - own < Flowing_A;
}

struct Rows {
    std::size_t first = 0, last = 0;
};

// From shortly before the first to the last row of the longest stretch in which only this coil carries
// current; the zeros between its pulses belong to it.
Rows burstOf(const std::vector<ChipSample>& samples, int coil) {
    Rows longest, present;
    bool isOpen = false;
    for (std::size_t n = 0; n < samples.size(); ++n) {
        if (isAlone(samples[n].current_A, coil)) {
            present.first = isOpen ? present.first : n;
            present.last = n;
            isOpen = true;
        } else if (samples[n].current_A.cwiseAbs().maxCoeff() > Flowing_A || n > present.last + Before) {
            isOpen = false;
        }
        if (isOpen && present.last - present.first > longest.last - longest.first) {
            longest = present;
        }
    }
    longest.first -= std::min(longest.first, Before);
    return longest;
}

} // namespace

Result<Eigen::Matrix<double, models::FieldCount, models::CoilCount>>
fitCrosstalk_T_per_A(const PlatenMotion& pulses) {
    constexpr std::size_t FewestRows = 30;
    Eigen::Matrix<double, models::FieldCount, models::CoilCount> crosstalk;
    for (int coil = 0; coil < models::CoilCount; ++coil) {
        const Rows rows = burstOf(pulses.samples, coil);
        const std::size_t count = rows.last - rows.first + 1;
        if (count < FewestRows) {
            return failure(ErrorCode::Refused, fmt::format("coil {} carried no pulses of current", coil + 1),
                           "Check its amplifier and the link.");
        }
        const auto height = static_cast<Eigen::Index>(count);
        Eigen::MatrixXd terms(height, Terms);
        Eigen::MatrixXd readings(height, models::FieldCount);
        double speed = 0.0, place = 0.0;
        for (Eigen::Index i = 0; i < height; ++i) {
            const ChipSample& sample = pulses.samples[rows.first + static_cast<std::size_t>(i)];
            const double t = 2.0 * static_cast<double>(i) / static_cast<double>(height) - 1.0;
            const double current_A = sample.current_A(coil); // flowed during the tick before
            place += speed + 0.5 * current_A;
            speed += current_A;
            terms.row(i) << 1.0, t, t * t, t * t * t, current_A, place;
            readings.row(i) = sample.reading_T.transpose();
        }
        const Eigen::MatrixXd shares = terms.colPivHouseholderQr().solve(readings);
        crosstalk.col(coil) = shares.row(4).transpose();
    }
    return crosstalk;
}

} // namespace halbench::app
