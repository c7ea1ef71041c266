#include "app/procedures/base/doubtful_source.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>

namespace halbench::app {
namespace {

std::string codesOf(const DataQuality& quality) {
    std::vector<std::string> codes;
    for (const Finding& finding : quality.findings) {
        codes.push_back(finding.code);
    }
    return codes.empty() ? "no finding gives the cause" : fmt::format("{}", fmt::join(codes, ", "));
}

} // namespace

std::vector<Finding> doubtsOfModel(const DataQuality& quality) {
    if (quality.verdict == Verdict::Good) {
        return {};
    }
    return {{"doubtful_model",
             fmt::format("the model used for the assessment is doubtful: {}", codesOf(quality)),
             "check the findings of the model, then identify again"}};
}

std::vector<Finding> doubtsOfCalibration(const DataQuality& quality) {
    if (quality.verdict == Verdict::Good) {
        return {};
    }
    return {{"doubtful_calibration",
             fmt::format("the calibration used for the assessment is doubtful: {}", codesOf(quality)),
             "check the findings of the calibration, then calibrate again"}};
}

std::vector<Finding> doubtsOfRelay(const DataQuality& quality) {
    if (quality.verdict == Verdict::Good) {
        return {};
    }
    return {{"doubtful_relay",
             fmt::format("the relay experiment for these gains is doubtful: {}", codesOf(quality)),
             "check the findings of the experiment, then measure again"}};
}

void addDoubts(DataQuality& quality, const std::vector<Finding>& doubts) {
    if (!doubts.empty()) {
        quality.verdict = std::max(quality.verdict, Verdict::Doubtful);
        quality.findings.insert(quality.findings.end(), doubts.begin(), doubts.end());
    }
}

void addVerification(DataQuality& quality, const DataQuality& verification) {
    if (verification.verdict == Verdict::Good) {
        return;
    }
    quality.verdict = std::max(quality.verdict, Verdict::Doubtful);
    for (const Finding& finding : verification.findings) {
        if (std::find(quality.findings.begin(), quality.findings.end(), finding) == quality.findings.end()) {
            quality.findings.push_back(finding);
        }
    }
}

} // namespace halbench::app
