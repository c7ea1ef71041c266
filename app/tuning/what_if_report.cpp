#include "app/tuning/what_if_report.h"

#include "app/documents/document_units.h"
#include "app/documents/filtered_gains.h"
#include "app/documents/result_header.h"
#include "app/documents/text/numbers.h"
#include "app/documents/text/result_text.h"
#include "app/procedures/base/measured_timing.h"
#include "app/procedures/tune/position_law_parameters.h"
#include "app/procedures/tune/tune.h"
#include "app/tuning/loop_conditions.h"
#include "control/base/units.h"
#include "devices/formats/recording_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace halbench::app {

namespace {

using Values = std::map<std::string, double>;

Result<Values> valuesOf(const devices::RecordingMeta& meta, const std::string& path) {
    Values values;
    for (std::size_t i = 0; i < meta.parameters.size(); ++i) {
        const devices::RecordingMeta::ParameterNote& note = meta.parameters[i];
        const Result<double> value =
            inDueUnit(note.name, note.value, note.unit,
                      fmt::format("{}: \"parameters[{}]", devices::metaPathOf(path), i));
        if (!value) {
            return failure(value.error());
        }
        values[note.name] = *value;
    }
    return values;
}

bool isOfLaw(const std::string& name) {
    return name.starts_with("gain.") || name.starts_with("filter.") || name.starts_with("feedforward.") ||
           name.starts_with("stiction.");
}

constexpr const char* GiveRanFile = "give them: --ran GAINS.json";

Result<LoopLaw> recordedLaw(const devices::RecordedFile& file, const Values& values, const std::string& path,
                            double period_s) {
    const auto law = loopLawFromParameters(values, period_s);
    if (!law) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("{}: the gains during the recording are not in its .meta.json file", path),
                       GiveRanFile);
    }
    for (const devices::RecordingMeta::ParameterChange& change : file.meta.changes) {
        if (isOfLaw(change.name)) {
            return failure(ErrorCode::InvalidInput,
                           fmt::format("{}: {} was changed at {:.3g} s of the recording", path, change.name,
                                       change.time_s),
                           "record a move with constant gains");
        }
    }
    return law;
}

void takeConditions(LoopConditions& conditions, const Values& values) {
    if (const auto found = values.find("delay.samples"); found != values.end()) {
        conditions.timing.delay_samples = static_cast<int>(std::lround(found->second));
    }
    if (const auto found = values.find("limit.current"); found != values.end()) {
        conditions.currentLimit_A = found->second;
    }
}

JsonValue figuresOf(const MotionFigures& figures) {
    JsonValue body = JsonValue::object();
    body.set("rms_error_rad", finiteOrNull(figures.rmsError_rad));
    body.set("final_error_rad", finiteOrNull(figures.finalError_rad));
    return body.set("overshoot_rad", finiteOrNull(figures.overshoot_rad));
}

double widest_rad(const MotionEnvelope& band) {
    double widest = 0.0;
    for (std::size_t i = 0; i < band.time_s.size(); ++i) {
        widest = std::max(widest, 0.5 * (band.angle_rad.p95[i] - band.angle_rad.p5[i]));
    }
    return widest;
}

MotionFigures recordedFigures(const WhatIfReport& report) {
    const RecordedMove& move = report.basis.config.move;
    return motionFigures(move.reference_rad, move.position_rad);
}

MotionFigures predictedFigures(const WhatIfReport& report) {
    return motionFigures(report.basis.config.move.reference_rad, report.predicted->angle_rad);
}

JsonValue predictedBody(const WhatIfReport& report) {
    if (!report.predicted) {
        return {};
    }
    JsonValue body = figuresOf(predictedFigures(report));
    body.set("widest_band_rad", finiteOrNull(widest_rad(*report.predicted->band)));
    return body.set("amplification_ratio", finiteOrNull(report.predicted->amplification_ratio));
}

} // namespace

Result<RanMove> readRanMove(const std::string& recordingPath, const std::string& ranFile,
                            const LoopConditions& conditions) {
    const Result<devices::RecordedFile> file = devices::readRecordingFile(recordingPath);
    if (!file) {
        return failure(file.error());
    }
    auto move = recordedMove(file->recording);
    if (!move) {
        return failure(move.error().code, recordingPath + ": " + move.error().message, move.error().hint);
    }
    const Result<Values> values = valuesOf(file->meta, recordingPath);
    if (!values) {
        return failure(values.error());
    }
    RanMove ran{*std::move(move), {}, conditions};
    if (ranFile.empty()) {
        const auto law = recordedLaw(*file, *values, recordingPath, conditions.timing.period_s);
        if (!law) {
            return failure(law.error());
        }
        ran.law = *law;
    } else {
        const Result<GainsFile> gains = readFilteredGains(ranFile);
        if (!gains) {
            return failure(gains.error());
        }
        if (!isSamePeriod(gains->timing.period_s, conditions.timing.period_s)) {
            return failure(ErrorCode::InvalidInput,
                           ranFile + ": the recorded gains have another sampling period",
                           "compare gains of the same device");
        }
        ran.law = gains->loopLaw();
        ran.conditions.timing = gains->timing;
    }
    takeConditions(ran.conditions, *values);
    return ran;
}

bool needsRanFile(const Error& error) {
    return error.hint == GiveRanFile;
}

Result<WhatIfReport> reportWhatIf(const RanMove& ran, const MotorEstimate& motor, const LoopLaw& law,
                                  const UncertaintyDraws& draws) {
    auto basis = prepareWhatIf({ran.move, ran.law, ran.conditions, motor, draws});
    if (!basis) {
        return failure(basis.error());
    }
    WhatIfReport report{*std::move(basis), {}, {}, {}};
    report.quality = report.basis.quality;
    auto predicted = whatIfWithBand(report.basis, law);
    if (predicted) {
        report.quality = predicted->quality;
        report.predicted = *std::move(predicted);
        return report;
    }
    report.withheld = predicted.error();
    if (report.quality.verdict != Verdict::Refused) { // else it stands among the findings already
        report.quality.verdict = Verdict::Refused;
        report.quality.findings.push_back(
            {"what_if_withheld", predicted.error().message, predicted.error().hint});
    }
    return report;
}

JsonValue whatIfBody(const WhatIfReport& report) {
    JsonValue body = JsonValue::object();
    body.set("explained", report.basis.quality.verdict != Verdict::Refused);
    body.set("outside_ratio", finiteOrNull(report.basis.outside_ratio));
    body.set("widening_ratio", finiteOrNull(report.basis.widening_ratio));
    body.set("duration_s", 1e-3 * static_cast<double>(report.basis.config.move.rows() - 1));
    body.set("recorded", figuresOf(recordedFigures(report)));
    body.set("predicted", predictedBody(report));
    return body.set("data_quality", toJson(report.quality));
}

std::string whatIfText(const WhatIfReport& report) {
    std::string text = figureLines("recorded move", figuresOf(recordedFigures(report)));
    text += fmt::format("{:.0f} % of it lie outside the band of the gains that ran\n",
                        100.0 * report.basis.outside_ratio);
    text += report.predicted ? figureLines("the same move with these gains", predictedBody(report))
                             : std::string("WITHHELD: what these gains would make of it\n");
    return text + findingLines(report.quality);
}

std::string whatIfTable(const WhatIfReport& report) {
    std::string text = "time_s,reference_rad,recorded_rad";
    text += report.predicted ? ",predicted_rad,p5_rad,p95_rad,current_A\n" : "\n";
    const RecordedMove& move = report.basis.config.move;
    const std::vector<double>& time_s = report.basis.explained.time_s;
    for (std::size_t i = 0; i < time_s.size(); ++i) {
        const std::size_t row = i * MotionEnvelopeStride;
        text += formatNumber(time_s[i]) + "," + formatNumber(move.reference_rad[row]) + "," +
                formatNumber(move.position_rad[row]);
        if (report.predicted) {
            const WhatIf& predicted = *report.predicted;
            for (const double value : {predicted.angle_rad[row], predicted.band->angle_rad.p5[i],
                                       predicted.band->angle_rad.p95[i], predicted.current_A[row]}) {
                text += "," + formatNumber(value);
            }
        }
        text += '\n';
    }
    return text;
}

} // namespace halbench::app
