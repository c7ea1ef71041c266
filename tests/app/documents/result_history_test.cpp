#include "app/documents/result_history.h"

#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

std::string document(const std::string& started, const std::string& damping, const std::string& interval,
                     const std::string& device = "HB-17", const std::string& source = "identified") {
    return R"({"schema":"halbench.identification/1","started":")" + started + R"(","device":{"id":")" +
           device + R"(","model":"htm"},"data_quality":{"verdict":"good","findings":[]},)" +
           R"("parameters":{"viscous_damping":{"value":)" + damping + R"(,"ci95":)" + interval +
           R"(,"unit":"N*m*s/rad","source":")" + source + R"("},"inertia":{"value":null,"ci95":null}}})";
}

control::Estimate estimate(double value, double half) {
    return {value, std::pair(value - half, value + half), control::EstimateSource::Identified, "N*m"};
}

TEST(ResultHistory, anIdentificationGivesItsValuesWithIntervals) {
    const auto row = resultOf("m.json", document("2026-01-01T00:00:00Z", "2e-3", "[1.9e-3,2.1e-3]"));
    ASSERT_TRUE(row);
    EXPECT_EQ(row->header.device->id, "HB-17");
    EXPECT_EQ(row->header.quality.verdict, Verdict::Good);
    EXPECT_EQ(row->values[0].value, 2e-3);
    EXPECT_EQ(row->values[0].interval95->second, 2.1e-3);
    EXPECT_FALSE(row->values[1].value) << "not in the document";
    EXPECT_FALSE(row->values[3].value) << "not identifiable";
}

TEST(ResultHistory, otherDocumentsAreNoResults) {
    EXPECT_FALSE(resultOf("x", "{}"));
    EXPECT_FALSE(resultOf("x", "[1, 2"));
    EXPECT_FALSE(resultOf("x", "[1]"));
    EXPECT_FALSE(resultOf("x", R"({"schema":"halbench.gains/1"})"));
}

TEST(ResultHistory, driftIsSignificantBeyondBothIntervals) {
    const control::Estimate first = estimate(2.0, 0.3); // half-widths 0.3 and 0.4: together 0.5
    EXPECT_FALSE(driftOf(first, estimate(2.49, 0.4))->isSignificant);
    EXPECT_TRUE(driftOf(first, estimate(2.51, 0.4))->isSignificant);
    EXPECT_NEAR(driftOf(first, estimate(1.0, 0.4))->ratio, -0.5, 1e-12);
    EXPECT_FALSE(driftOf({}, first));
    EXPECT_FALSE(driftOf(estimate(0.0, 1.0), first));
}

TEST(ResultHistory, whatWasGivenDoesNotDrift) {
    control::Estimate given = estimate(2.0, 0.0);
    given.source = control::EstimateSource::Given;
    EXPECT_FALSE(driftOf(given, estimate(3.0, 0.1)));
    EXPECT_FALSE(driftOf(estimate(3.0, 0.1), given));
}

class ResultFolder : public testing::Test {
protected:
    void write(const QString& name, const std::string& text) {
        QFile file(folder.filePath(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(QByteArray::fromStdString(text));
    }
    QTemporaryDir folder;
};

TEST_F(ResultFolder, resultsAreInTheOrderOfTimeAndDriftWithinTheirDevice) {
    write("b.json", document("2026-02-01T00:00:00Z", "3e-3", "[2.9e-3,3.1e-3]"));
    write("a.json", document("2026-03-01T00:00:00Z", "2.02e-3", "[1.9e-3,2.1e-3]"));
    write("c.json", document("2026-01-01T00:00:00Z", "2e-3", "[1.9e-3,2.1e-3]"));
    write("other.json", document("2025-01-01T00:00:00Z", "9e-3", "[8e-3,10e-3]", "HB-99"));
    write("gains.json", R"({"schema":"halbench.gains/1"})");
    const std::vector<ResultRow> rows = resultsIn(folder.path().toStdString());
    ASSERT_EQ(rows.size(), 4U);
    EXPECT_EQ(rows[1].file, "c.json");
    EXPECT_FALSE(driftAt(rows, 1, 0)) << "the first of its device";
    EXPECT_TRUE(driftAt(rows, 2, 0)->isSignificant);
    EXPECT_FALSE(driftAt(rows, 3, 0)->isSignificant);
    EXPECT_NEAR(driftAt(rows, 3, 0)->ratio, 0.01, 1e-9);
}

TEST_F(ResultFolder, whatWasGivenAtFirstIsNotWhatLaterOnesAreMeasuredAgainst) {
    write("a.json", document("2026-01-01T00:00:00Z", "1e-3", "[1e-3,1e-3]", "HB-17", "given"));
    write("b.json", document("2026-02-01T00:00:00Z", "2e-3", "[1.9e-3,2.1e-3]"));
    write("c.json", document("2026-03-01T00:00:00Z", "2.5e-3", "[2.4e-3,2.6e-3]"));
    const std::vector<ResultRow> rows = resultsIn(folder.path().toStdString());
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_FALSE(driftAt(rows, 1, 0));
    EXPECT_NEAR(driftAt(rows, 2, 0)->ratio, 0.25, 1e-9);
}

} // namespace
} // namespace halbench::app
