#pragma once

#include "app/documents/result_header.h"
#include "control/identify/joint_estimate.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace halbench::app {

/// The constants of the motor in the order of the tables, by their names in a document.
inline constexpr std::array HistoryParameters = {"viscous_damping", "coulomb_friction", "torque_constant",
                                                 "inertia"};

/// What one identification of a folder found; in SI.
struct ResultRow {
    std::string file; ///< its name in the folder
    ResultHeader header;
    std::array<control::Estimate, HistoryParameters.size()> values; ///< as HistoryParameters
};

/// The identifications (halbench.identification/1) of a folder, oldest first, those of one time by name;
/// other documents are passed over. For a thread of its own: a folder may be large, or far away.
std::vector<ResultRow> resultsIn(const std::string& folder);
/// From one document; nothing when it is no identification.
std::optional<ResultRow> resultOf(const std::string& file, const std::string& text);

/// How a value moved against an earlier one.
struct Drift {
    double ratio = 0.0;         ///< (new - old) / |old|
    bool isSignificant = false; ///< more than both intervals together explain
};
/// Nothing unless both were identified, and when the old one is zero. The change is significant when it is
/// larger than the 95 % half-width of a difference of two independent estimates, sqrt(h1^2 + h2^2).
std::optional<Drift> driftOf(const control::Estimate& before, const control::Estimate& now);

/// Against the first row of the same device (isSameDevice()) that identified the value.
std::optional<Drift> driftAt(const std::vector<ResultRow>& rows, std::size_t row, std::size_t parameter);

} // namespace halbench::app
