#include "app/documents/import_documents.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace halbench::app {
namespace {

devices::CsvPlan planOf(const std::string& text) {
    const Result<devices::CsvPlan> plan = devices::planCsvImport(text, "x.csv", {});
    EXPECT_TRUE(plan) << plan.error().message;
    return plan ? *plan : devices::CsvPlan();
}

TEST(ImportDocuments, tellWhatWasSeenAndWhatIsAsked) {
    const devices::CsvPlan unsure = planOf("1,5\n2,5\n");
    const JsonValue document = importDocument({}, unsure, nullptr);
    EXPECT_TRUE(document.find("dialect")->isNull());
    ASSERT_EQ(document.find("questions")->items().size(), 1U);
    EXPECT_EQ(document.find("questions")->items()[0].find("answers")->items().size(), 2U);
    EXPECT_EQ(document.find("rows"), nullptr);
    EXPECT_THAT(previewText(unsure), testing::HasSubstr("--separator 'none' --decimal ,: 1 column: 1.5"));
}

TEST(ImportDocuments, tellWhatWasRead) {
    const std::string text = "t [ms];omega [rpm];p [bar]\n0,5;60;1\n1,5;;2\n9,5;60;3\n";
    const devices::CsvPlan plan = planOf(text);
    EXPECT_THAT(previewText(plan), testing::HasSubstr("2 'omega [rpm]': omega (rad/s, from rpm)"));
    const Result<devices::CsvImport> import = devices::importCsv(text, "x.csv", plan);
    ASSERT_TRUE(import) << import.error().message;
    const JsonValue document = importDocument({}, plan, &*import);
    EXPECT_EQ(document.find("rows")->integer(), 3);
    EXPECT_EQ(document.find("missing_values")->integer(), 1);
    EXPECT_EQ(document.find("columns")->items()[0].find("role")->text(), "time");
    EXPECT_TRUE(document.find("columns")->items()[2].find("unit")->isNull());
    std::vector<std::string> codes;
    for (const Finding& finding : qualityOf(plan, &*import).findings) {
        codes.push_back(finding.code);
    }
    // Steps of 1 ms and 8 ms: their median is 8 ms, of which no row is missing.
    EXPECT_THAT(codes, testing::ElementsAre("unit_not_known", "time_not_uniform", "missing_values"));
}

} // namespace
} // namespace halbench::app
