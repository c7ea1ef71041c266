#include "app/analyses/spherical/orientation_quality.h"

#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

namespace halbench::app {

namespace {

using models::OrientationVerdict;

/// Half of the published workspace: a cone as wide says nothing about the shaft.
constexpr double UselessCone_rad = 0.25 * Pi;
/// Errors of the tensor, over its size, that an uncertain stray field may make: up to the first the errors of
/// the orientation are small angles, beyond the second the start of the fit lies near another pose.
constexpr double SmallTensorError_ratio = 0.1;
constexpr double LargeTensorError_ratio = 0.3;
/// The additive model explains its own readings to their noise, those of an exact device to a tenth and
/// worse.
constexpr double MisfitLimit_ratio = 0.05;

template <typename Note>
void noteSaturation(const Orientation& work, Note note) {
    std::string names;
    for (const std::size_t channel : work.readings.saturated) {
        names += (names.empty() ? "" : ", ") + work.readings.names[channel];
    }
    const double saturation_mT = 1e3 * *work.readings.saturation_T;
    if (work.readings.saturated.size() == 1) {
        note(
            Verdict::Doubtful, "perhaps_clipped",
            fmt::format("{} rests at the largest reading, {:.4g} mT: it may be clipped and is left out there",
                        names, saturation_mT),
            "give the range of the sensors with --range-mT");
    } else {
        note(Verdict::Doubtful, "saturated",
             fmt::format("{} are saturated at {:.4g} mT: they are left out there", names, saturation_mT),
             "use sensors with a larger range or a larger radius, or give the range with --range-mT");
    }
}

/// Poses that the truth contradicts: no residual shows a sign or a frame that is wrong for all readings
/// alike.
template <typename Note>
void noteTruth(const Orientation& work, Note note) {
    const auto error = ofPoses(work, [](const OrientedPose& pose) { return pose.error_rad; });
    const auto wrong = static_cast<std::size_t>(
        std::count_if(error.begin(), error.end(), [](double e) { return e > BranchLimit_rad; }));
    if (wrong == 0) {
        return;
    }
    // Estimators of the additive model are there to be compared; that they are wrong is what is looked at.
    const bool areMost = work.isTensor() && 2 * wrong > error.size();
    const bool areReversed = std::abs(percentile(error, 0.5) - 0.5 * Pi) < BranchLimit_rad;
    note(areMost ? Verdict::Refused : Verdict::Doubtful, "disagrees_with_truth",
         fmt::format("{} of {} poses differ from the true ones by more than {:.0f} degrees", wrong,
                     error.size(), radiansToDegrees(BranchLimit_rad)),
         areReversed
             ? "half a turn of the field lies between them: check the sign of the readings"
             : "check placement, frames, radius and the names of the readings and of the true angles");
}

/// Estimates that say less than they seem to.
template <typename Note>
void noteUncertain(const Orientation& work, Note note) {
    const double cone_rad =
        percentile(ofPoses(work, [](const OrientedPose& pose) { return pose.cone_rad; }), 0.5);
    if (cone_rad > BranchLimit_rad) {
        note(cone_rad > UselessCone_rad ? Verdict::Refused : Verdict::Doubtful, "orientation_uncertain",
             fmt::format("the 95 % cone of the shaft is {:.0f} degrees wide to each side",
                         radiansToDegrees(cone_rad)),
             "calibrate the sensors, or use another placement");
    }
    if (work.tensorError_ratio > SmallTensorError_ratio) {
        note(work.tensorError_ratio > LargeTensorError_ratio ? Verdict::Refused : Verdict::Doubtful,
             "stray_field_not_separable",
             fmt::format("errors of the sensors become {:.0f} % of the rotor's field where a stray field is "
                         "estimated too",
                         1e2 * work.tensorError_ratio),
             "calibrate the sensors first, or leave --stray out");
    }
    const double misfit_ratio =
        percentile(ofPoses(work, [](const OrientedPose& pose) { return pose.misfit_ratio; }), 0.5);
    if (misfit_ratio > MisfitLimit_ratio) {
        note(
            Verdict::Doubtful, "additive_model_does_not_fit",
            fmt::format("the additive model leaves {:.0f} % of the readings unexplained", 1e2 * misfit_ratio),
            "check placement and radius, or use the estimator 'refined' for a real device");
    }
}

/// Remedy of the reason that most poses have.
std::string hintOf(models::UncertaintyGap gap) {
    switch (gap) {
    case models::UncertaintyGap::Singular:
        return "see 'cone95_missing'; use '--rule all', or the estimator 'closed-fitted'";
    case models::UncertaintyGap::NotSettled:
        return "see 'cone95_missing'; raise --projection-steps, lower --projection-stop-T2, or use '--rule "
               "all'";
    case models::UncertaintyGap::None:
    case models::UncertaintyGap::Misfit:
        break;
    }
    return "see 'cone95_missing'; give the true --noise-uT, or use the estimator 'refined' for a real device";
}

/// Poses whose cone would be a guess.
template <typename Note>
void noteMissingCones(const Orientation& work, Note note) {
    const auto with = [&work](models::UncertaintyGap gap) {
        return std::count_if(work.poses.begin(), work.poses.end(),
                             [gap](const OrientedPose& pose) { return pose.gap == gap; });
    };
    using models::UncertaintyGap;
    const std::array gaps = {UncertaintyGap::Singular, UncertaintyGap::NotSettled, UncertaintyGap::Misfit};
    const UncertaintyGap gap = *std::max_element(
        gaps.begin(), gaps.end(), [&with](auto one, auto other) { return with(one) < with(other); });
    const auto missing = static_cast<std::ptrdiff_t>(work.poses.size()) - with(UncertaintyGap::None);
    if (missing > 0) {
        note(Verdict::Doubtful, "cone_not_available",
             fmt::format("{} of {} poses have no cone and no intervals: {} where the readings used are "
                         "singular, {} where the search did not settle, {} that the additive model does not "
                         "explain",
                         missing, work.poses.size(), with(UncertaintyGap::Singular),
                         with(UncertaintyGap::NotSettled), with(UncertaintyGap::Misfit)),
             hintOf(gap));
    }
}

} // namespace

double percentile(std::vector<double> values, double ratio) {
    if (values.empty()) {
        return Missing;
    }
    const auto place = static_cast<std::size_t>(ratio * static_cast<double>(values.size() - 1) + 0.5);
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(place), values.end());
    return values[place];
}

DataQuality qualityOf(const Orientation& work) {
    DataQuality quality;
    const auto note = [&](Verdict verdict, const char* code, std::string message, std::string hint) {
        quality.verdict = std::max(quality.verdict, verdict);
        quality.findings.push_back({code, std::move(message), std::move(hint)});
    };
    const std::size_t rows = work.poses.size();
    const std::size_t determined = work.count(OrientationVerdict::Determined);
    const std::size_t reduced = work.count(OrientationVerdict::Reduced);
    if (determined + reduced == 0) {
        const bool isUnexplained = work.count(OrientationVerdict::NotConverged) > 0;
        note(Verdict::Refused, "no_pose", fmt::format("none of {} rows determines an orientation", rows),
             isUnexplained ? "no pose explains the readings: check placement, frames, harmonics and units, "
                             "calibrate, or give the true --noise-uT"
                           : "give at least four channels that are neither missing nor clipped, in tesla");
    } else if (determined + reduced < rows) {
        note(Verdict::Doubtful, "poses_without_orientation",
             fmt::format("{} of {} rows have no orientation: {} ambiguous, {} without enough channels or "
                         "field, {} that no pose explains",
                         rows - determined - reduced, rows, work.count(OrientationVerdict::Ambiguous),
                         work.count(OrientationVerdict::NotDetermined),
                         work.count(OrientationVerdict::NotConverged)),
             "see 'problems'");
    }
    if (const std::size_t wrong = work.count(OrientationVerdict::NotConverged);
        determined + reduced > 0 && 2 * wrong > rows) {
        note(Verdict::Refused, "model_does_not_fit",
             fmt::format("no pose explains {} of {} rows: the others fit by chance", wrong, rows),
             "check placement, frames, harmonics and units, calibrate, or give the true --noise-uT");
    }
    if (reduced > 0) {
        note(Verdict::Doubtful, "reduced_integrity",
             fmt::format("{} poses come from too few channels to test them", reduced),
             "use a sensor with a larger range or another placement");
    }
    for (std::size_t i = 0; i < models::ChannelCount; ++i) {
        const OrientationReadings& readings = work.readings;
        if (readings.missing[i] + readings.clipped[i] + readings.leftOut[i] > 0) {
            note(Verdict::Good, "channel_left_out",
                 fmt::format("{}: {} values missing, {} clipped{}", readings.names[i], readings.missing[i],
                             readings.clipped[i],
                             readings.leftOut[i] > 0
                                 ? fmt::format(", {} left out by the board", readings.leftOut[i])
                                 : ""),
                 "they are left out of the estimate");
        }
    }
    if (work.readings.saturation_T) {
        noteSaturation(work, note);
    }
    noteUncertain(work, note);
    noteMissingCones(work, note);
    noteTruth(work, note);
    const auto chi = ofPoses(work, [](const OrientedPose& pose) {
        return pose.hasUncertainty && pose.estimate.freedom > 0
                   ? pose.estimate.chiSquare / pose.estimate.freedom
                   : Missing;
    });
    const double typical = percentile(chi, 0.5);
    if (typical > 5.0) {
        note(Verdict::Doubtful, "residual_too_large",
             fmt::format(
                 "the residuals are {:.1f} times the stated noise: the model does not fit the readings",
                 std::sqrt(typical)),
             "check placement, frames and harmonics, calibrate, or give the true --noise-uT");
    }
    return quality;
}

} // namespace halbench::app
