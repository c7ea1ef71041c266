#include "devices/formats/mdf4_blocks.h"
#include "devices/formats/mdf4_writer.h"
#include "mdf4_sample.h"

#include <QtCore/QTemporaryDir>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace halbench::devices {
namespace {

TEST(Mdf4Writer, theFileIsTheSameHoweverTheRowsCome) {
    const Mdf4Sample sample = mdf4Sample();
    const std::string whole = mdf4Octets(sample);
    EXPECT_EQ(whole.substr(0, 24), "MDF     4.10    Halbench");
    EXPECT_EQ(mdf4Octets(sample, 1), whole);
    EXPECT_EQ(mdf4Octets(sample, 7), whole);
}

TEST(Mdf4Writer, untilItIsFinishedTheFileSaysSo) {
    const Mdf4Sample sample = mdf4Sample();
    QBuffer buffer;
    buffer.open(QIODevice::ReadWrite);
    Mdf4Writer writer(buffer, sample.meta);
    ASSERT_TRUE(writer.begin(*sample.recording.layout));
    EXPECT_EQ(buffer.data().left(8), "UnFinMF ");
    EXPECT_EQ(mdf4::get<std::uint16_t>(buffer.data().toStdString(), 60), 5)
        << "cycle count and last length due";
    ASSERT_TRUE(writer.finish());
    EXPECT_EQ(buffer.data().left(8), "MDF     ");
}

TEST(Mdf4Writer, theStartIsNanosecondsSince1970) {
    // date -u -d 2026-01-02T03:04:05Z +%s -> 1767323045
    EXPECT_EQ(mdf4::get<std::uint64_t>(mdf4Octets(mdf4Sample()), 64 + 24 + 48), 1767323045000000000U);
}

TEST(Mdf4Writer, aFolderThatCannotBeMadeIsAClearErrorAndLeavesNothing) {
    const QTemporaryDir folder;
    std::ofstream(folder.filePath("file").toStdString()) << "x";
    const Mdf4Sample sample = mdf4Sample();
    const auto written =
        writeMdf4File(folder.filePath("file/run.mf4").toStdString(), sample.recording, sample.meta);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, ErrorCode::FileSystem);
    EXPECT_FALSE(written.error().hint.empty());
}

TEST(Mdf4Writer, aDeviceThatIsFullIsNoticed) {
    const Mdf4Sample sample = mdf4Sample();
    QBuffer closed; // takes nothing
    Mdf4Writer writer(closed, sample.meta);
    EXPECT_FALSE(writer.begin(*sample.recording.layout));
}

} // namespace
} // namespace halbench::devices
