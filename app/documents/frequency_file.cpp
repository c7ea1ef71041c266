#include "app/documents/frequency_file.h"

#include "app/documents/document_parts.h"
#include "app/documents/document_units.h"
#include "app/documents/text/output_file.h"

#include <fmt/format.h>

namespace halbench::app {

namespace {

constexpr const char* Schema = "halbench.frequency/1";

/// A point that is complete, not zero and above the one before.
std::optional<MeasuredPlant::Point> pointOf(const JsonValue& entry, double above_Hz) {
    const JsonValue* plant = member(&entry, "plant");
    const auto frequency_Hz = numberIn(&entry, "frequency_hz");
    const auto re = numberIn(plant, "re");
    const auto im = numberIn(plant, "im");
    if (!frequency_Hz || !re || !im || !(*frequency_Hz > above_Hz) || (*re == 0.0 && *im == 0.0)) {
        return std::nullopt;
    }
    return MeasuredPlant::Point{
        *frequency_Hz, {*re, *im}, isTrueIn(&entry, "used"), numberIn(&entry, "coherence")};
}

} // namespace

Result<FrequencyFile> parseFrequency(const std::string& text, const std::string& origin) {
    const Result<JsonValue> root = parseDocument(text, origin);
    if (!root) {
        return failure(root.error());
    }
    if (textIn(&*root, "schema") != Schema) {
        return failure(ErrorCode::InvalidInput, origin + ": schema: is not " + Schema,
                       "make the file with 'halbench identify DEVICE --frequency --out'");
    }
    FrequencyFile file{headerOf(*root), {}};
    if (qualityOf(member(&*root, "data_quality")).verdict == Verdict::Refused) {
        return failure(ErrorCode::Refused, origin + ": this response was rejected",
                       "check its findings, then measure again");
    }
    const auto period_s = numberIn(&*root, "sample_period_s");
    if (!period_s || !(*period_s > 0.0)) {
        return failure(ErrorCode::InvalidInput, origin + ": sample_period_s: must be more than zero",
                       "make the file with 'halbench identify DEVICE --frequency --out'");
    }
    file.plant.period_s = *period_s;
    file.plant.leastCoherence = numberIn(member(&*root, "excitation"), "least_coherence");
    double last_Hz = 0.0;
    for (const JsonValue& entry : itemsIn(&*root, "points")) {
        const auto point = pointOf(entry, last_Hz);
        if (!point || !(2.0 * point->frequency_Hz * *period_s < 1.0)) {
            return failure(ErrorCode::InvalidInput,
                           fmt::format("{}: points[{}]: needs a plant, and a frequency above the previous "
                                       "one and below half the rate",
                                       origin, file.plant.points.size()),
                           "make the file with 'halbench identify DEVICE --frequency --out'");
        }
        last_Hz = point->frequency_Hz;
        file.plant.points.push_back(*point);
    }
    if (file.plant.points.empty()) {
        return failure(ErrorCode::InvalidInput, origin + ": points: the list is empty",
                       "make the file with 'halbench identify DEVICE --frequency --out'");
    }
    return file;
}

Result<FrequencyFile> readFrequencyFile(const std::string& path) {
    const Result<std::string> text = readFile(path);
    if (!text) {
        return failure(text.error());
    }
    return parseFrequency(*text, path);
}

} // namespace halbench::app
