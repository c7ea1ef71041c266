#include "app/documents/pose_table_file.h"
#include "app/documents/text/output_file.h"

#include <QTemporaryDir>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace halbench::app {
namespace {

TEST(PoseTable, isReadInSiWithItsTimes) {
    const auto table =
        parsePoseTable("# a comment\ntime_ms,x_mm,phi_deg,y_m\n\n500,1,0.1,-2e-3\n1500, 2 ,0,0\n", "p.csv");
    ASSERT_TRUE(table) << table.error().message;
    EXPECT_EQ(table->time_s, (std::vector<double>{0.5, 1.5}));
    ASSERT_EQ(table->columns.size(), 3u);
    EXPECT_EQ(table->columns[0].axis, "x");
    EXPECT_EQ(table->columns[0].unit, "m");
    EXPECT_EQ(table->columns[1].name, "phi_deg");
    EXPECT_EQ(table->columns[1].unit, "rad");
    EXPECT_DOUBLE_EQ(table->rows[0][0], 1e-3);
    EXPECT_NEAR(table->rows[0][1], 0.1 * 3.14159265358979 / 180.0, 1e-15);
    EXPECT_DOUBLE_EQ(table->rows[0][2], -2e-3);
    EXPECT_DOUBLE_EQ(table->rows[1][0], 2e-3);
    EXPECT_EQ(table->lines, (std::vector<std::size_t>{4, 5}));
    EXPECT_EQ(table->placeOf(1), "p.csv:5");
    EXPECT_EQ(table->columnOf("y"), 2u);
    EXPECT_FALSE(table->columnOf("z"));
}

TEST(PoseTable, isTheSameInEveryDialect) {
    const auto plain = parsePoseTable("x_mm,y_mm\n1.5,2\n3,-4.25\n", "p");
    ASSERT_TRUE(plain);
    for (const char* text : {"\xEF\xBB\xBFx_mm,y_mm\r\n1.5,2\r\n3,-4.25\r\n", "x_mm;y_mm\n1,5;2\n3;-4,25\n",
                             "x_mm;y_mm;\n1.5;2;\n3;-4.25;\n", "x_mm\ty_mm\n1.5\t2\n3\t-4.25",
                             "x_mm,y_mm\n1.5,2,\n3,-4.25,\n"}) {
        const auto table = parsePoseTable(text, "p");
        ASSERT_TRUE(table) << text << ": " << table.error().message;
        EXPECT_EQ(table->rows, plain->rows) << text;
    }
}

// A table begins with the pose 0, which has no decimal sign.
TEST(PoseTable, rowsOfWholeNumbersDoNotFixTheDecimalSign) {
    const auto comma = parsePoseTable("time_s;x_mm\n0;0\n1;2\n1,5;-2,25\n", "p");
    ASSERT_TRUE(comma) << comma.error().message;
    EXPECT_DOUBLE_EQ(comma->time_s[2], 1.5);
    EXPECT_DOUBLE_EQ(comma->rows[2][0], -2.25e-3);
    const auto point = parsePoseTable("time_s;x_mm\n0;0\n1.5;2\n", "p");
    ASSERT_TRUE(point);
    EXPECT_DOUBLE_EQ(point->time_s[1], 1.5);
    EXPECT_FALSE(parsePoseTable("time_s;x_mm\n0;0\n1.5;2\n2,5;2\n", "p")) << "one file, one sign";
}

TEST(PoseTable, everyMistakeIsToldWithItsPlace) {
    struct Case {
        std::string text;
        std::string place;
        std::string word;
    };
    const Case cases[] = {
        {"", "p:1:1:", "empty"},
        {"\n\n# nothing\n", "p:1:1:", "empty"},
        {"x_mm,y_mm\n", "p:1:1:", "no rows"},
        {"x_mm\n1\n", "p:2:1:", "one row"},
        {"x_mm,y_mm\n1,2\n3,nan\n", "p:3:3:", "'nan' is not a finite number (y_mm)"},
        {"x_mm,y_mm\n1,2\ninf,3\n", "p:3:1:", "'inf' is not a finite number (x_mm)"},
        {"x_mm,y_mm\n1,2\n1,two\n", "p:3:3:", "'two'"},
        {"x_mm,y_mm\n1,2\n1,\n", "p:3:3:", "y_mm has no value"},
        {"x_mm,y_mm\n1,2\n1\n", "p:3:1:", "1 cells, but the header has 2"},
        {"x_mm,y_mm\n1,2\n1,2,3\n", "p:3:5:", "3 cells"},
        {"x_mm;y_mm\n1,5;2\n1.5;2\n", "p:3:1:", "'1.5'"}, // the decimal sign changed
        {"x_mm,y_mm\n1,1e999\n1,2\n", "p:2:3:", "'1e999'"},
        {"time_s,x_mm\n1,1\n0.5,2\n", "p:3:1:", "0.5 s comes after 1 s"},
        {"x_mm,time_s\n1,1\n2,1\n", "p:3:3:", "1 s comes after 1 s"},
        {"time_s,x_mm\n-1,1\n0,2\n", "p:2:1:", "negative"},
        {"time_s\n1\n2\n", "p:1:1:", "no column of an axis"},
        {"x_mm,x_m\n1,1\n2,2\n", "p:1:6:", "axis x is given twice, as x_mm and x_m"},
        {"time_s,time_ms,x_mm\n1,1,1\n2,2,2\n", "p:1:8:", "time is given twice"},
        {"x,y\n1,1\n2,2\n", "p:1:1:", "'x' has no unit"},
        {"_mm\n1\n2\n", "p:1:1:", "no unit"},
        {"x_mm,y_kg\n1,1\n2,2\n", "p:1:6:", "'kg' is no unit of a length or an angle"},
        {"time_mm,x_mm\n1,1\n2,2\n", "p:1:1:", "'mm' is no unit of a time"},
        {"x_mm,\"y_mm\n1,1\n2,2\n", "p:1:", "quoted"},
    };
    for (const Case& wrong : cases) {
        const auto table = parsePoseTable(wrong.text, "p");
        ASSERT_FALSE(table) << wrong.text;
        EXPECT_EQ(table.error().code, ErrorCode::InvalidInput) << wrong.text;
        EXPECT_TRUE(table.error().message.starts_with(wrong.place)) << wrong.text << table.error().message;
        EXPECT_NE(table.error().message.find(wrong.word), std::string::npos) << table.error().message;
        EXPECT_FALSE(table.error().hint.empty()) << wrong.text;
    }
}

TEST(PoseTable, refusesWhatIsTooLargeOrNoText) {
    std::string rows = "x_mm\n";
    for (std::size_t row = 0; row < MaxPoseRows; ++row) {
        rows += "1\n";
    }
    EXPECT_TRUE(parsePoseTable(rows, "p"));
    const auto tooMany = parsePoseTable(rows + "1\n", "p");
    ASSERT_FALSE(tooMany);
    EXPECT_NE(tooMany.error().message.find(fmt::format("p:{}:1: more than", MaxPoseRows + 2)),
              std::string::npos)
        << tooMany.error().message;
    EXPECT_FALSE(parsePoseTable(std::string(MaxPoseTableOctets + 1, ' '), "p"));
    EXPECT_FALSE(parsePoseTable(std::string_view("x_mm\n1\n\0\n", 10), "p"));
    EXPECT_FALSE(parsePoseTable("x_mm\n" + std::string(70000, '1') + "\n2\n", "p"));
}

TEST(PoseTableFile, isReadForATableAndForNothingElse) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("poses.csv").toStdString();
    ASSERT_TRUE(writeFile(path, "time_s,x_mm\n1,2\n2,0\n"));
    auto reference = parseMoveReference("table,file=" + path);
    ASSERT_TRUE(reference);
    ASSERT_TRUE(readTableOf(*reference));
    ASSERT_TRUE(reference->table);
    EXPECT_DOUBLE_EQ(reference->table->motion.duration_s(), 2.0);
    auto step = parseMoveReference("step,amplitude_mm=1");
    ASSERT_TRUE(step);
    EXPECT_TRUE(readTableOf(*step));
    EXPECT_FALSE(step->table);
    auto missing = parseMoveReference("table,file=" + path + ".none");
    ASSERT_TRUE(missing);
    EXPECT_EQ(readTableOf(*missing).error().code, ErrorCode::FileSystem);
}

} // namespace
} // namespace halbench::app
