#pragma once

#include "control/identify/frequency_estimate.h"

namespace halbench::control {

/// Samples of a loop that turns steadily and is excited by the same sweep of frequencies again and again,
/// with a rest after each in which it settles. The sweeps need not follow each other at exact times.
struct SweptRows {
    double period_s = 0.01;
    std::size_t rowsPerSweep = 0;    ///< N: a sweep with its rest
    std::size_t restRows = 0;        ///< at the end of each sweep, settled: what disturbs is seen alone there
    std::vector<std::size_t> starts; ///< first row of each, ascending and apart
    double turn_rad_s = 0.0;         ///< slope of the reference outside of the sweeps
    double lowest_rad_s = 0.0;       ///< of the frequencies that are swept
    double highest_rad_s = 0.0;
    int points = 20;                   ///< that are wanted between them, at most
    std::span<const double> reference; ///< r, where the excitation enters: the instrument
    std::span<const double> input;     ///< u of the plant
    std::span<const double> output;    ///< y of the plant
};

/// The estimate of frequency_estimate.h where nothing is periodic: each sweep begins and ends in the same
/// steady motion, so that its transform needs no window. A sweep leaves the reference shifted by some D; r
/// and y stay there, which adds D/(1 - 1/z) to the transforms of both. Neighbouring lines z_k of one point
/// are brought together by the shape of a free inertia under held current, H = (z + 1)/(z - 1)^2:
///
///     G(z_c) = sum Y_pk (H(z_c)/H(z_k)) conj(R_pk) / sum U_pk conj(R_pk)
///
/// over all sweeps p and lines k of the point. Offset, slow drift and what repeats with the turn are fitted
/// to the rests, where nothing is excited, and taken out everywhere. `averages` counts sweeps times lines.
/// Help: resources/help/htm-theory.md 7.6. Errors: as estimatePlant().
Result<std::vector<PlantPoint>> estimateSweptPlant(const SweptRows& rows);

} // namespace halbench::control
