#include "app/documents/text/output_file.h"
#include "app/experiments/experiment_schema.h"

#include <gmock/gmock.h>

namespace halbench::app {

namespace {

std::string sourceFile(const std::string& path) {
    return readFile(std::string(HALBENCH_SOURCE_DIR) + "/" + path).value_or("");
}

} // namespace

// The published schema and the help are the table of keys and nothing else; when this fails, copy what the
// message shows into the file.
TEST(ExperimentSchemaTest, publishedSchemaIsTheTableOfKeys) {
    const Result<std::string> text = toJsonText(experimentSchema());
    ASSERT_TRUE(text);
    EXPECT_EQ(sourceFile("resources/schemas/experiment.schema.json"), *text);
}

TEST(ExperimentSchemaTest, helpShowsEveryKeyOfEveryKind) {
    EXPECT_THAT(sourceFile("resources/help/command-line.md"), testing::HasSubstr(experimentKeyTables()));
}

} // namespace halbench::app
