#include "app/recordings/name_reservation.h"

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>
#include <QtCore/QLocale>
#include <QtCore/QTemporaryDir>

#include <gtest/gtest.h>

#include <barrier>
#include <set>
#include <thread>

namespace halbench::app {
namespace {

class RecordingNameTest : public testing::Test {
protected:
    void TearDown() override { QLocale::setDefault(QLocale::c()); }

    void touch(const QString& name) {
        QFile file(folder.filePath(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    }
    std::string named(const QString& mask, const QString& name = {}) {
        const auto made = recordingName(mask, {"HB 17/b", name, date}, folder.path());
        return made ? made->toStdString() : "refused: " + made.error().message;
    }

    QDateTime date{{2026, 1, 9}, {3, 4, 5}, Qt::UTC};
    QTemporaryDir folder;
};

TEST_F(RecordingNameTest, fillsInWhatItSaysInTheCLocale) {
    EXPECT_EQ(named(DefaultNameMask), "HB-17-b_2026-01-09T03-04-05");
    QLocale::setDefault(QLocale(QLocale::Arabic, QLocale::Egypt)); // its digits are others
    EXPECT_EQ(named("{date} {time} {number}"), "2026-01-09 03-04-05 001");
    EXPECT_EQ(named("{name}.{device}", QString::fromUtf8("Prüfling 3")), std::string("Pr\xc3\xbc"
                                                                                     "fling 3.HB-17-b"));
    EXPECT_EQ(named("{name}"), "recording");
    date = date.toOffsetFromUtc(7200); // the same moment
    EXPECT_EQ(named("{time}"), "03-04-05");
}

TEST_F(RecordingNameTest, theNumberIsBehindTheHighestAndNeverUsedAgain) {
    touch("run_002.csv");
    touch("run_0041.meta.json"); // of a recording whose data are gone
    touch("other_900.csv");
    touch("run_77x.csv");
    EXPECT_EQ(named("run_{number}"), "run_042");
    touch("run_999.csv.partial"); // being recorded
    EXPECT_EQ(named("run_{number}"), "run_1000");
}

/// As two programs do that begin in the same moment: both have looked before one of them writes.
TEST_F(RecordingNameTest, aReservedNameIsGivenToNobodyElse) {
    const NameParts parts{"HB-17", {}, date};
    for (const char* mask : {"run", "run_{number}"}) {
        auto first = reserveRecordingName(mask, parts, folder.path());
        auto second = reserveRecordingName(mask, parts, folder.path());
        ASSERT_TRUE(first && second);
        EXPECT_NE(first->name, second->name);
        second->hold.reset(); // it did not begin
        touch(first->name + ".csv.partial");
        first->hold.reset();
        const auto third = reserveRecordingName(mask, parts, folder.path());
        ASSERT_TRUE(third);
        EXPECT_EQ(third->name, second->name);
    }
    EXPECT_TRUE(QDir(folder.path()).entryList({"*.reserved"}).isEmpty()) << "nothing is left of them";
}

TEST_F(RecordingNameTest, manyRecordersAtOnceGetANameEach) {
    constexpr int Recorders = 8;
    constexpr int Each = 10;
    std::barrier begin(Recorders);
    std::vector<std::vector<std::string>> names(Recorders);
    std::vector<std::thread> recorders;
    for (int i = 0; i < Recorders; ++i) {
        recorders.emplace_back([&, i] {
            begin.arrive_and_wait();
            for (int k = 0; k < Each; ++k) {
                auto name = reserveRecordingName("r{number}", {"HB-17", {}, date}, folder.path());
                ASSERT_TRUE(name);
                // Over a recording that is there it would be lost: NewOnly finds that out.
                QFile file(folder.filePath(name->name + ".csv.partial"));
                ASSERT_TRUE(file.open(QIODevice::NewOnly | QIODevice::WriteOnly)) << name->name.toStdString();
                names[static_cast<std::size_t>(i)].push_back(name->name.toStdString());
            }
        });
    }
    for (std::thread& one : recorders) {
        one.join();
    }
    std::set<std::string> all;
    for (const auto& some : names) {
        all.insert(some.begin(), some.end());
    }
    EXPECT_EQ(all.size(), std::size_t{Recorders} * Each);
}

TEST_F(RecordingNameTest, aFolderIsMadeAndWhatCannotBeIsSaid) {
    const NameParts parts{"HB-17", {}, date};
    EXPECT_TRUE(reserveRecordingName("run", parts, folder.filePath("new/deep")));
    touch("file");
    const auto inFile = reserveRecordingName("run", parts, folder.filePath("file"));
    ASSERT_FALSE(inFile);
    EXPECT_EQ(inFile.error().code, ErrorCode::FileSystem);
}

TEST_F(RecordingNameTest, aTakenNameIsNeverGivenAgain) {
    for (const char* file : {"run.mf4", "run-2.csv", "run-3.meta.json"}) {
        touch(file);
    }
    EXPECT_EQ(named("run"), "run-4");
    EXPECT_EQ(named(DefaultNameMask), "HB-17-b_2026-01-09T03-04-05");
    touch("HB-17-b_2026-01-09T03-04-05.csv");
    EXPECT_EQ(named(DefaultNameMask), "HB-17-b_2026-01-09T03-04-05-2") << "in the same second";
}

TEST_F(RecordingNameTest, whatAFileSystemRefusesIsReplaced) {
    EXPECT_EQ(named("{name}", "a/b\\c:d*e?f\"g<h>i|j\nk"), "a-b-c-d-e-f-g-h-i-j k");
    EXPECT_EQ(named("{name}", "../../etc"), "-.-..-etc") << "no other folder";
    EXPECT_EQ(named("{name}", ".hidden"), "-hidden");
    EXPECT_EQ(named("{name}", "NUL"), "NUL_");
    EXPECT_EQ(named("com1.{name}", "x"), "com1_.x");
    for (const char* name : {"a/b", "..", "/", "\\x"}) {
        const auto made = recordingName("{name}", {{}, name, date}, folder.path());
        ASSERT_TRUE(made);
        EXPECT_EQ(QFileInfo(folder.filePath(*made)).path(), folder.path()) << name;
    }
}

TEST_F(RecordingNameTest, aWrongMaskIsRefusedWithItsPlaceAndARemedy) {
    const std::pair<const char*, const char*> wrong[] = {
        {"", "the name mask is empty"},
        {"  ", "the name mask is empty"},
        {"run {devcie}", "name mask, character 5: there is no placeholder 'devcie'"},
        {"run {date", "name mask, character 5: '{' without '}'"},
        {"run date}", "name mask, character 9: '}' without '{'"},
        {"2026/{date}", "name mask, character 5: a name cannot contain a folder"},
        {"a:{date}", "name mask, character 2: ':' is not allowed in file names"},
        {"{number}{number}", "name mask, character 9: a second {number}"},
        {"{date}.csv", "name mask, character 7: the file extension is added automatically"},
        {".{date}", "name mask, character 1: a name cannot begin with a space or a dot"}};
    for (const auto& [mask, message] : wrong) {
        const auto checked = checkNameMask(mask);
        ASSERT_FALSE(checked) << mask;
        EXPECT_EQ(checked.error().message, message);
        EXPECT_FALSE(checked.error().hint.empty()) << mask;
        EXPECT_EQ(checked.error().code, ErrorCode::InvalidInput);
        EXPECT_FALSE(recordingName(mask, {"d", "n", date}, folder.path()));
    }
    EXPECT_TRUE(checkNameMask("{device}-{name}_{date}T{time} {number}"));
}

TEST_F(RecordingNameTest, aNameThatNoFileSystemTakesIsRefused) {
    EXPECT_EQ(named("{name}", QString(201, 'x')), "refused: the name of the recording would have 201 bytes");
    EXPECT_EQ(named("{name}", QString(200, 'x')), std::string(200, 'x'));
}

} // namespace
} // namespace halbench::app
