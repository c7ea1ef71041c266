#include "app/documents/frequency_file.h"
#include "app/documents/result_documents.h"
#include "control/base/units.h"

#include <gtest/gtest.h>

namespace halbench::app {

namespace {

FrequencyResult result() {
    FrequencyResult result;
    for (const double frequency_Hz : {1.0, 2.0, 4.0}) {
        FrequencyResultPoint point;
        point.measured = {2.0 * Pi * frequency_Hz, {-1.0 / frequency_Hz, -0.1}, 0.01, 0.99, 8};
        point.radius = 0.02;
        point.openLoop = 10.0 * point.measured.value;
        point.openLoopRadius = 0.2;
        point.isUsed = frequency_Hz < 3.0;
        result.points.push_back(point);
    }
    return result;
}

std::string written(const FrequencyResult& result) {
    ResultHeader header;
    header.schema = "halbench.frequency/1";
    return *toJsonText(frequencyDocument(header, result));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

} // namespace

TEST(FrequencyFile, readsBackWhatWasWritten) {
    const auto file = parseFrequency(written(result()), "r.json");
    ASSERT_TRUE(file) << file.error().message;
    ASSERT_EQ(file->plant.points.size(), 3U);
    EXPECT_DOUBLE_EQ(file->plant.points[1].frequency_Hz, 2.0);
    EXPECT_DOUBLE_EQ(file->plant.points[1].value.real(), -0.5);
    EXPECT_DOUBLE_EQ(file->plant.points[1].value.imag(), -0.1);
    EXPECT_TRUE(file->plant.points[1].isUsed);
    EXPECT_FALSE(file->plant.points[2].isUsed);
    EXPECT_EQ(file->plant.points[2].coherence, 0.99);
    EXPECT_EQ(file->plant.leastCoherence, 0.9);
    EXPECT_EQ(file->plant.period_s, 0.01);
}

TEST(FrequencyFile, refusesWhatIsNoResponseAndNamesThePlace) {
    const std::string good = written(result());
    const auto place = [](const std::string& text) {
        const auto file = parseFrequency(text, "r.json");
        return file ? std::string() : file.error().message;
    };
    EXPECT_NE(place("{").find("r.json"), std::string::npos);
    EXPECT_NE(place(replaced(good, "halbench.frequency/1", "halbench.gains/1")).find("schema"),
              std::string::npos);
    EXPECT_NE(
        place(replaced(good, "\"sample_period_s\": 0.01", "\"sample_period_s\": 0")).find("sample_period"),
        std::string::npos);
    EXPECT_NE(place(replaced(good, "\"frequency_hz\": 2", "\"frequency_hz\": 0.5")).find("points[1]"),
              std::string::npos);
    EXPECT_NE(place(replaced(good, "\"frequency_hz\": 4", "\"frequency_hz\": 51")).find("points[2]"),
              std::string::npos);
    FrequencyResult empty = result();
    empty.points.clear();
    EXPECT_NE(place(written(empty)).find("points"), std::string::npos);
}

TEST(FrequencyFile, aRefusedResponseIsNotDrawn) {
    FrequencyResult refused = result();
    refused.quality.verdict = Verdict::Refused;
    const auto file = parseFrequency(written(refused), "r.json");
    ASSERT_FALSE(file);
    EXPECT_EQ(file.error().code, ErrorCode::Refused);
    EXPECT_EQ(readFrequencyFile("no-such-file.json").error().code, ErrorCode::FileSystem);
}

} // namespace halbench::app
