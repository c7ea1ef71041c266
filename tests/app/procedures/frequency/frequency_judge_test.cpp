#include "app/procedures/frequency/frequency_judge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace halbench::app {
namespace {

FrequencyResult coherentPoints() {
    FrequencyResult result;
    result.points.resize(20);
    for (FrequencyResultPoint& point : result.points) {
        point.isUsed = true;
        point.measured.frequency_rad_s = 10.0;
    }
    return result;
}

// A frictionless rotor's damping comes out on either side of zero: noise is no fault of the motor.
TEST(FrequencyIdentification, dampingIsRefusedWhereItIsClearlyNegativeOnly) {
    struct Case {
        double value_per_s;
        std::pair<double, double> interval95;
        Verdict verdict;
    };
    FrequencyResult result = coherentPoints();
    for (const Case& one :
         {Case{1.0, {0.5, 1.5}, Verdict::Good}, Case{0.0, {0.0, 0.4}, Verdict::Good},           // 4 %
          Case{0.1, {0.0, 0.6}, Verdict::Doubtful}, Case{-0.3, {-1.4, 0.8}, Verdict::Doubtful}, // 6, 8 %
          Case{-0.004, {-0.006, -0.002}, Verdict::Good},                                        // 0.04 %
          Case{-1.0, {-1.5, -0.5}, Verdict::Refused}}) {
        control::FrequencyFit fit;
        fit.accelerationGain.value = 30.0;
        fit.accelerationGain.interval95 = std::pair(29.0, 31.0);
        fit.dampingRate.value = one.value_per_s;
        fit.dampingRate.interval95 = one.interval95;
        result.fit = fit;
        const DataQuality quality = judgeFrequency(result);
        const auto found =
            std::find_if(quality.findings.begin(), quality.findings.end(),
                         [](const Finding& finding) { return finding.code == "damping_below_zero"; });
        EXPECT_EQ(found != quality.findings.end(), one.verdict != Verdict::Good) << one.value_per_s;
        EXPECT_EQ(quality.verdict == Verdict::Refused, one.verdict == Verdict::Refused) << one.value_per_s;
    }
}

// phi/J of a rotor that the current drives backwards, and one that may be nothing.
TEST(FrequencyIdentification, aTorqueConstantThatIsNotPositiveIsNeverGood) {
    struct Case {
        double value;
        std::pair<double, double> interval95;
        const char* code;
        Verdict verdict;
    };
    FrequencyResult result = coherentPoints();
    for (const Case& one : {Case{-26.0, {-27.0, -25.0}, "sign_reversed", Verdict::Refused},
                            Case{-1.0, {-3.0, 1.0}, "sign_reversed", Verdict::Refused},
                            Case{0.0, {-1.0, 1.0}, "sign_reversed", Verdict::Refused},
                            Case{26.0, {-1.0, 53.0}, "interval_reaches_zero", Verdict::Doubtful},
                            Case{2.0, {0.0, 4.0}, "interval_reaches_zero", Verdict::Doubtful}}) {
        control::FrequencyFit fit;
        fit.accelerationGain.value = one.value;
        fit.accelerationGain.interval95 = one.interval95;
        fit.dampingRate.value = 2.2;
        fit.dampingRate.interval95 = std::pair(2.0, 2.4);
        result.fit = fit;
        const DataQuality quality = judgeFrequency(result);
        EXPECT_EQ(quality.verdict, one.verdict) << one.value;
        EXPECT_TRUE(std::any_of(quality.findings.begin(), quality.findings.end(),
                                [&](const Finding& finding) { return finding.code == one.code; }))
            << one.value;
    }
}

} // namespace
} // namespace halbench::app
