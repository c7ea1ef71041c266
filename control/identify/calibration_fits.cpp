#include "control/identify/calibration_fits.h"

#include "control/base/assert.h"
#include "control/identify/least_squares.h"

#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

// Squared misfit of the travel after a start at `start_s`, resting level subtracted before.
double misfit(std::span<const double> time_s, std::span<const double> travel, double start_s) {
    const auto rows = static_cast<Eigen::Index>(time_s.size());
    Eigen::MatrixXd design = Eigen::MatrixXd::Zero(rows, 2);
    Eigen::VectorXd observed(rows);
    for (Eigen::Index i = 0; i < rows; ++i) {
        const double tau = std::max(time_s[static_cast<std::size_t>(i)] - start_s, 0.0);
        design.row(i) << 0.5 * tau * tau, tau * tau * tau / 6.0;
        observed(i) = travel[static_cast<std::size_t>(i)];
    }
    const auto fit = fitLinear(design, observed);
    return fit ? fit->residuals.squaredNorm() : observed.squaredNorm();
}

} // namespace

Result<StrayFit> fitStray(std::span<const StrayRecord> records) {
    std::vector<double> current;
    std::vector<double> field;
    for (const StrayRecord& record : records) {
        HB_ASSERT(record.hallA_T.size() == record.currentA_A.size());
        HB_ASSERT(record.hallB_T.size() == record.currentB_A.size());
        if (record.hallA_T.empty()) {
            continue;
        }
        // The mean of each channel takes its resting field out.
        for (const auto& [hall, own] : {std::pair(&record.hallA_T, &record.currentA_A),
                                        std::pair(&record.hallB_T, &record.currentB_A)}) {
            const double meanField = mean(*hall);
            const double meanCurrent = mean(*own);
            for (std::size_t i = 0; i < hall->size(); ++i) {
                field.push_back((*hall)[i] - meanField);
                current.push_back((*own)[i] - meanCurrent);
            }
        }
    }
    const auto rows = static_cast<Eigen::Index>(current.size());
    const Eigen::MatrixXd design = Eigen::Map<const Eigen::VectorXd>(current.data(), rows);
    const auto fit = fitLinear(design, Eigen::Map<const Eigen::VectorXd>(field.data(), rows));
    if (!fit) {
        return failure(ErrorCode::Refused, "the d-axis current does not change", "step it with both signs");
    }
    StrayFit result;
    result.coefficient_T_per_A = fit->coefficients(0);
    result.freedom = std::max(fit->freedom - 2 * static_cast<int>(records.size()), 1);
    const double variance = fit->residuals.squaredNorm() / result.freedom;
    result.error_T_per_A = std::sqrt(variance * fit->unscaled(0, 0));
    result.residualRms_T = std::sqrt(variance);
    return result;
}

Result<Breakaway> findBreakaway(std::span<const double> time_s, std::span<const double> angle_rad,
                                std::span<const double> current_A, double moving_rad) {
    HB_ASSERT(time_s.size() == angle_rad.size() && time_s.size() == current_A.size());
    constexpr std::size_t RestSamples = 10;
    if (time_s.size() < 2 * RestSamples) {
        return failure(ErrorCode::Refused, "the ramp is too short", "record from the start of the ramp");
    }
    const double rest = mean(angle_rad.subspan(0, RestSamples));
    std::vector<double> travel;
    std::size_t end = time_s.size();
    std::size_t moving = time_s.size();
    constexpr double EnoughTravel_rad = 0.6;
    for (std::size_t i = 0; i < time_s.size(); ++i) {
        travel.push_back(angle_rad[i] - rest);
        if (moving == time_s.size() && std::fabs(travel[i]) > moving_rad) {
            moving = i;
        }
        if (std::fabs(travel[i]) > EnoughTravel_rad) {
            end = i + 1;
            break;
        }
    }
    if (moving == time_s.size() || moving <= RestSamples) {
        return failure(ErrorCode::Refused, "the rotor did not break away during the ramp",
                       "use a higher current, from rest");
    }
    double best_s = time_s[moving];
    double least = -1.0;
    constexpr double Step_s = 1e-3;
    constexpr double LongestFuse_s = 0.6;
    const auto used = std::span(travel).first(end);
    for (double start_s = std::max(time_s[moving] - LongestFuse_s, time_s.front()); start_s < time_s[moving];
         start_s += Step_s) {
        const double now = misfit(time_s.first(end), used, start_s);
        if (least < 0.0 || now < least) {
            least = now;
            best_s = start_s;
        }
    }
    const auto after =
        static_cast<std::size_t>(std::upper_bound(time_s.begin(), time_s.end(), best_s) - time_s.begin());
    const std::size_t before = after > 0 ? after - 1 : 0;
    const double span_s = time_s[after] - time_s[before];
    const double part = span_s > 0.0 ? (best_s - time_s[before]) / span_s : 0.0;
    return Breakaway{best_s, current_A[before] + part * (current_A[after] - current_A[before])};
}

} // namespace halbench::control
