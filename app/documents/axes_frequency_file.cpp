#include "app/documents/axes_frequency_file.h"

#include "app/documents/axes_frequency_documents.h"
#include "app/documents/document_limits.h"
#include "app/documents/document_parts.h"
#include "app/documents/text/output_file.h"
#include "control/base/units.h"
#include "control/law/board_law.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace halbench::app {
namespace {

constexpr const char* Remedy = "make the file with 'halbench identify DEVICE --frequency --out'";

tl::unexpected<Error> wrong(std::string message) {
    return failure(ErrorCode::InvalidInput, std::move(message), Remedy);
}

/// What ran while the loops were measured.
struct ReadAxis {
    AxisPlantFile file;
    control::SampledPositionLaw law;
};

std::optional<control::LawSection<double>> sectionOf(const JsonValue& entry) {
    control::LawSection<double> section;
    for (const auto& [key, value] : {std::pair{"b0", &section.b0},
                                     {"b1", &section.b1},
                                     {"b2", &section.b2},
                                     {"a1", &section.a1},
                                     {"a2", &section.a2}}) {
        const auto number = numberIn(&entry, key);
        if (!number) {
            return std::nullopt;
        }
        *value = *number;
    }
    return section;
}

bool readLaw(control::SampledPositionLaw& law, const JsonValue* gains) {
    const auto kp = numberIn(gains, "kp");
    const auto ki = numberIn(gains, "ki");
    const auto kd = numberIn(gains, "kd");
    const auto filter_s = numberIn(gains, "filter_s");
    if (!kp || !ki || !kd || !filter_s) {
        return false;
    }
    law.kp_A_per_rad = *kp;
    law.ki_A_per_rad_s = *ki;
    law.kd_As_per_rad = *kd;
    law.derivativeFilter_s = *filter_s;
    for (const JsonValue& entry : itemsIn(gains, "sections")) {
        const auto section = sectionOf(entry);
        if (!section) {
            return false;
        }
        law.sections.push_back(*section);
    }
    return true;
}

Result<ReadAxis> axisOf(const JsonValue& entry, const std::string& place, const std::string& origin) {
    ReadAxis axis;
    axis.file.axis = textIn(&entry, "axis");
    axis.file.positionUnit = textIn(&entry, "position_unit");
    axis.file.effortUnit = textIn(&entry, "effort_unit");
    if (axis.file.axis.empty() || axis.file.positionUnit.empty() || axis.file.effortUnit.empty()) {
        return wrong(fmt::format("{}: {}: needs axis, position_unit and effort_unit", origin, place));
    }
    if (!readLaw(axis.law, member(&entry, "gains"))) {
        return wrong(fmt::format("{}: {}: gains: needs kp, ki, kd and filter_s", origin, place));
    }
    return axis;
}

Result<std::vector<ReadAxis>> axesOf(const JsonValue& root, const std::string& origin) {
    const auto period_s = numberIn(&root, "sample_period_s");
    const auto delay = numberIn(&root, "delay_samples");
    if (!period_s || !(*period_s > 0.0) || !delay || *delay < 0.0) {
        return wrong(origin + ": sample_period_s, delay_samples: must be numbers, the first above zero");
    }
    std::vector<ReadAxis> axes;
    for (const JsonValue& entry : itemsIn(&root, "axes")) {
        auto axis = axisOf(entry, fmt::format("axes[{}]", axes.size()), origin);
        if (!axis) {
            return failure(axis.error());
        }
        axis->law.period_s = *period_s;
        axis->law.delaySamples = static_cast<int>(std::lround(*delay));
        axis->file.plant.period_s = *period_s;
        axis->file.plant.leastCoherence = numberIn(member(&root, "excitation"), "least_coherence");
        axes.push_back(*std::move(axis));
    }
    return axes.empty() ? Result<std::vector<ReadAxis>>(wrong(origin + ": axes: the list is empty"))
                        : Result<std::vector<ReadAxis>>(std::move(axes));
}

/// The open loop over the law that ran: a point of each axis. False where something is missing.
bool addPoint(std::vector<ReadAxis>& axes, const JsonValue& entry, double frequency_Hz) {
    const auto& loops = itemsIn(&entry, "loops");
    const auto& used = itemsIn(&entry, "used");
    const auto& coherence = itemsIn(&entry, "coherence");
    if (loops.size() != axes.size() || used.size() != axes.size() || coherence.size() != axes.size()) {
        return false;
    }
    const double w = 2.0 * Pi * frequency_Hz;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const auto re = numberIn(&loops[i], "re");
        const auto im = numberIn(&loops[i], "im");
        if (!re || !im || !used[i].isBoolean() || !coherence[i].isNumber()) {
            return false;
        }
        const control::SampledPositionLaw& law = axes[i].law;
        const std::complex<double> late = std::polar(1.0, -w * law.period_s * law.delaySamples);
        const std::complex<double> plant =
            std::complex<double>(*re, *im) / (late * control::feedbackResponse(law, w));
        if (std::isfinite(std::norm(plant)) && std::norm(plant) > 0.0) {
            axes[i].file.plant.points.push_back(
                {frequency_Hz, plant, used[i].boolean(), coherence[i].number()});
        }
    }
    return true;
}

Result<void> addPoints(std::vector<ReadAxis>& axes, const JsonValue& root, const std::string& origin) {
    const double period_s = axes.front().law.period_s;
    double last_Hz = 0.0;
    std::size_t index = 0;
    for (const JsonValue& entry : itemsIn(&root, "points")) {
        const double frequency_Hz = numberIn(&entry, "frequency_hz").value_or(0.0);
        if (!(frequency_Hz > last_Hz) || !(2.0 * frequency_Hz * period_s < 1.0)) {
            return wrong(fmt::format(
                "{}: points[{}]: needs a frequency above the previous one and below half the rate", origin,
                index));
        }
        if (!addPoint(axes, entry, frequency_Hz)) {
            return wrong(
                fmt::format("{}: points[{}]: needs loops, used and coherence of each axis", origin, index));
        }
        last_Hz = frequency_Hz;
        ++index;
    }
    return index > 0 ? Result<void>() : wrong(origin + ": points: the list is empty");
}

} // namespace

Result<AxesFrequencyFile> parseAxesFrequency(const std::string& text, const std::string& origin) {
    const Result<JsonValue> root = parseJson(text, origin);
    if (!root) {
        return failure(root.error());
    }
    if (textIn(&*root, "schema") != AxisFrequencySchema) {
        return failure(ErrorCode::InvalidInput, origin + ": schema: is not " + AxisFrequencySchema,
                       "measure the response of a device with several axes");
    }
    if (qualityOf(member(&*root, "data_quality")).verdict == Verdict::Refused) {
        return failure(ErrorCode::Refused, origin + ": this response was rejected",
                       "check its findings, then measure again");
    }
    if (const Result<void> possible = checkLimits(*root, origin); !possible) {
        return failure(possible.error());
    }
    auto axes = axesOf(*root, origin);
    if (!axes) {
        return failure(axes.error());
    }
    if (const auto added = addPoints(*axes, *root, origin); !added) {
        return failure(added.error());
    }
    AxesFrequencyFile file{headerOf(*root), {}};
    for (ReadAxis& axis : *axes) {
        file.axes.push_back(std::move(axis.file));
    }
    return file;
}

Result<AxesFrequencyFile> readAxesFrequencyFile(const std::string& path) {
    const Result<std::string> text = readFile(path);
    return text ? parseAxesFrequency(*text, path) : failure(text.error());
}

Result<std::map<std::string, MeasuredPlant>> plantsFor(const AxisModel& model,
                                                       const AxesFrequencyFile& file) {
    std::map<std::string, MeasuredPlant> plants;
    std::vector<std::string> measured, known;
    for (const AxisPlantFile& axis : file.axes) {
        measured.push_back(axis.axis);
    }
    for (const auto& axis : model.axes) {
        known.push_back(axis.axis);
        const auto found = std::find(measured.begin(), measured.end(), axis.axis);
        if (found == measured.end()) {
            continue;
        }
        const AxisPlantFile& own = file.axes[static_cast<std::size_t>(found - measured.begin())];
        if (own.positionUnit != axis.positionUnit || own.effortUnit != axis.effortUnit) {
            return failure(ErrorCode::InvalidInput,
                           fmt::format("axis {}: the response is in {}/({}), the model in {}/({})", axis.axis,
                                       own.positionUnit, own.effortUnit, axis.positionUnit, axis.effortUnit),
                           "measure the response on this kind of device");
        }
        plants.emplace(axis.axis, own.plant);
    }
    if (plants.empty()) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("the response is of axes {}, the model has {}", fmt::join(measured, ", "),
                                   fmt::join(known, ", ")),
                       "open the response of an axis of the model");
    }
    return plants;
}

} // namespace halbench::app
