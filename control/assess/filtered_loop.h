#pragma once

#include "control/assess/load_step.h"
#include "control/assess/loop_assessment.h"
#include "control/law/filtered_law.h"

#include <complex>
#include <functional>
#include <vector>

namespace halbench::control {

/// `linearStep` of a filtered law; the same numbers for the board's own.
Result<LoopStep> filteredStep(const PositionPlant& plant, const FilteredLaw& law, const LoopTiming& timing,
                              double amplitude_rad, double duration_s, int pointsPerSample = 10);

/// Where a load that stays leaves the angle of a stable loop: 0 with integral action, else what K_P and the
/// filters' gain for a constant make of it. Errors: of `checkedGains`.
Result<double> filteredRest_rad(const FilteredLaw& law, double period_s, double load_A);
/// `loadStep` of a filtered law, whose weights a load does not see; the same numbers for the board's own.
Result<LoadStep> filteredLoad(const PositionPlant& plant, const FilteredLaw& law, const LoopTiming& timing,
                              double load_A, double duration_s, int pointsPerSample = 10);

/// Poles of the closed loop in z, from states where the law has filters: of four slow or narrow ones beside
/// the integrators one polynomial tells too little. Errors: of the inputs.
Result<std::vector<std::complex<double>>> filteredPoles(const PositionPlant& plant, const FilteredLaw& law,
                                                        const LoopTiming& timing);
/// The largest modulus among them.
Result<double> filteredPoleRadius(const PositionPlant& plant, const FilteredLaw& law,
                                  const LoopTiming& timing);
/// The same of one law with many K_P, in A/rad, in the place of its own in parallel form: filters are put
/// together once. Errors: of the inputs; of what it returns: none for finite gains.
Result<std::function<Result<double>(double)>> filteredPoleRadiusOfProportional(const PositionPlant& plant,
                                                                               const FilteredLaw& law,
                                                                               const LoopTiming& timing);

/// The gain towards fast errors: the largest current that an error of 1 rad in a single sample makes, at once
/// or after filters; K_P + K_D/T on the board. Errors: of `checkedGains`.
Result<double> filteredFastGain_A_per_rad(const FilteredLaw& law, double period_s);
/// The limit of K_P with this K_D, these filters and K_I = 0. Errors: of the inputs.
Result<double> filteredProportionalLimit_A_per_rad(const PositionPlant& plant, const FilteredLaw& law,
                                                   const LoopTiming& timing);

/// `assessDesign` of a filtered law; the same numbers for the board's own. Errors: of the inputs; OutOfRange;
/// Refused, as of `assessDesign`.
Result<LoopAssessment> assessFilteredDesign(const PositionPlant& plant, const FilteredLaw& law,
                                            const LoopTiming& timing, double currentLimit_A,
                                            double duration_s = 2.0);

} // namespace halbench::control
