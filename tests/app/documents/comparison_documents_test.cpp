#include "app/documents/comparison_documents.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

ConfigurationComparison comparison() {
    ConfigurationComparison made;
    made.rows = {
        {"gain.kp", "A/rad", false, 10.0, 25.0, 10.0, RowState::Differs, "", true},
        {"gain.ki", "A/(rad*s)", false, 0.1, 0.1, 0.1, RowState::Same, "", false},
        {"gone", "", false, {}, 1.0, {}, RowState::OnlyInFile, "not available on this device", false}};
    made.findings = {{"other_device", "another device", "look twice"}};
    return made;
}

TEST(ComparisonDocuments, thePeoplesTableShowsWhatDiffersAndCountsTheRest) {
    const std::string text = comparisonText(comparison(), {});
    EXPECT_NE(text.find("gain.kp"), std::string::npos);
    EXPECT_EQ(text.find("gain.ki"), std::string::npos);
    EXPECT_NE(text.find("not available on this device"), std::string::npos);
    EXPECT_NE(text.find("1 of 3 the same"), std::string::npos);
    EXPECT_NE(text.find("another device; look twice"), std::string::npos);
}

TEST(ComparisonDocuments, anOutcomeStandsBesideItsRow) {
    const std::vector<RowOutcome> outcomes = {{"gain.kp", false, "the value read back differs"}};
    EXPECT_NE(comparisonText(comparison(), outcomes).find("not restored: the value read back differs"),
              std::string::npos);
    const JsonValue document = comparisonDocument({}, {}, comparison(), outcomes);
    const JsonValue::Array& rows = document.find("rows")->items();
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_FALSE(rows[0].find("restored")->boolean());
    EXPECT_TRUE(rows[1].find("restored")->isNull()); // nobody asked for it
    EXPECT_TRUE(rows[2].find("device")->isNull());
    EXPECT_EQ(rows[2].find("state")->text(), "only_in_file");
}

} // namespace
} // namespace halbench::app
