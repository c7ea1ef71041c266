#include "app/documents/result_documents.h"
#include "app/documents/text/output_file.h"
#include "app/headless/recording_file.h"
#include "app/procedures/tune/tune.h"
#include "app/tuning/what_if_report.h"
#include "tests/app/procedures/simulated_motor.h"
#include "tests/app/procedures/uncertain_motor.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <algorithm>

namespace halbench::app {
namespace {

/// A move with the published gains in a file as `move --out` writes it.
class WhatIfReportTest : public ::testing::Test {
protected:
    void SetUp() override {
        const auto device = openMotor("seed=3");
        const MoveResult result = moved(*device, move("step,amplitude_deg=28.6479", 1.5));
        ASSERT_TRUE(
            writeRecording(path("move.csv"), result.recording, *device, {"1970-01-01T00:00:00Z", {}, {}}));
    }

    std::string path(const char* name) const { return m_folder.filePath(name).toStdString(); }

    static control::PositionLaw recommended() {
        return *control::designLaw("recommended", {1.23e-3 / 5.5e-4, 26.0, 2.05e-2 / 1.43e-2}, {}, {});
    }
    WhatIfReport report(const MotorEstimate& motor) const {
        const auto ran = readRanMove(path("move.csv"), {}, {});
        EXPECT_TRUE(ran) << ran.error().message;
        const auto answer = reportWhatIf(*ran, motor, recommended(), {1000, 1});
        EXPECT_TRUE(answer) << answer.error().message;
        return *answer;
    }

    QTemporaryDir m_folder;
};

TEST_F(WhatIfReportTest, theGainsThatRanStandBesideTheRecording) {
    const auto ran = readRanMove(path("move.csv"), {}, {});
    ASSERT_TRUE(ran) << ran.error().message;
    EXPECT_EQ(ran->law.law.gains.proportional, 10.0);
    EXPECT_NEAR(ran->law.law.gains.integral, 0.1, 1e-7);
    EXPECT_EQ(ran->conditions.currentLimit_A, 4.0);
    EXPECT_EQ(ran->move.rows(), 1501U);
}

TEST_F(WhatIfReportTest, withoutThemTheyHaveToBeGiven) {
    std::remove(path("move.meta.json").c_str());
    const auto unknown = readRanMove(path("move.csv"), {}, {});
    ASSERT_FALSE(unknown);
    EXPECT_NE(unknown.error().hint.find("--ran"), std::string::npos);
    TuneConfig config;
    config.method = "published";
    const auto gains = runTune(uncertainMotor(0.02), config);
    ASSERT_TRUE(gains);
    ResultHeader header;
    header.schema = "halbench.gains/1";
    ASSERT_TRUE(writeFile(path("gains.json"), *toJsonText(gainsDocument(header, *gains))));
    const auto ran = readRanMove(path("move.csv"), path("gains.json"), {});
    ASSERT_TRUE(ran) << ran.error().message;
    EXPECT_EQ(ran->law.law.gains.proportional, 10.0);
}

TEST_F(WhatIfReportTest, predictsWithItsBandOrSaysWhyNot) {
    const WhatIfReport good = report(uncertainMotor(0.02));
    ASSERT_TRUE(good.predicted && good.predicted->band);
    const JsonValue body = whatIfBody(good);
    EXPECT_TRUE(body.find("explained")->boolean());
    EXPECT_LT(body.find("predicted")->find("overshoot_rad")->number(),
              body.find("recorded")->find("overshoot_rad")->number());
    EXPECT_NE(whatIfText(good).find("the same move with these gains"), std::string::npos);
    const std::string table = whatIfTable(good);
    EXPECT_EQ(table.substr(0, table.find('\n')),
              "time_s,reference_rad,recorded_rad,predicted_rad,p5_rad,p95_rad,current_A");
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 302); // 1.5 s by 5 ms, both ends, and the head

    const WhatIfReport withheld = report(uncertainMotor(0.02, {}, 1.65e-3));
    EXPECT_TRUE(withheld.withheld);
    EXPECT_EQ(withheld.quality.verdict, Verdict::Refused);
    EXPECT_TRUE(whatIfBody(withheld).find("predicted")->isNull());
    EXPECT_NE(whatIfText(withheld).find("WITHHELD"), std::string::npos);
    EXPECT_EQ(whatIfTable(withheld).find("predicted"), std::string::npos);
}

} // namespace
} // namespace halbench::app
