#include "control/base/random.h"
#include "devices/formats/convert_recording.h"
#include "devices/formats/recording_file.h"
#include "devices/formats/replay_device.h"
#include "tests/devices/recording/recording_sample.h"

#include <QtCore/QTemporaryDir>

#include <gtest/gtest.h>

#include <bit>
#include <clocale>
#include <cmath>
#include <limits>

namespace halbench::devices {
namespace {

class ConvertExactTest : public testing::Test {
protected:
    std::string path(const std::string& name) const { return m_folder.filePath(name.c_str()).toStdString(); }

    /// Any bits that are a number: doubles, doubles that are exactly floats, the ends of both ranges.
    static Recording anyNumbers() {
        Recording recording;
        recording.layout = std::make_shared<const StreamLayout>(
            StreamLayout{{{"position", "rad"}, {"hall.a", "T"}, {"status", ""}}, 0.01});
        Random random(1);
        std::vector<double> values = {0.0,
                                      -0.0,
                                      0.1,
                                      static_cast<double>(0.1F),
                                      16777216.5,
                                      1e22,
                                      std::numeric_limits<double>::max(),
                                      std::numeric_limits<double>::min(),
                                      std::numeric_limits<double>::denorm_min(),
                                      static_cast<double>(std::numeric_limits<float>::max()),
                                      static_cast<double>(std::numeric_limits<float>::denorm_min()),
                                      std::nan("")};
        while (values.size() < 6000) {
            const std::uint64_t bits = random.bits();
            const auto any = std::bit_cast<double>(bits);
            const auto narrow = std::bit_cast<float>(static_cast<std::uint32_t>(bits));
            values.push_back(std::isfinite(any) ? any : 1.0);
            values.push_back(std::isfinite(narrow) ? static_cast<double>(narrow) : 2.0);
        }
        recording.values = values;
        for (std::size_t row = 0; row < values.size() / 3; ++row) {
            recording.time_s.push_back(static_cast<double>(row) / 100.0);
        }
        return recording;
    }

    QTemporaryDir m_folder;
};

TEST_F(ConvertExactTest, aFileThatIsReadAndWrittenIsTheSameToTheLastOctet) {
    const Recording recording = anyNumbers();
    ASSERT_TRUE(writeExactRecordingFile(path("exact.csv"), recording, metaOf(recording)));
    ASSERT_TRUE(writeRecordingFile(path("board.csv"), recording, metaOf(recording)));
    for (const std::string name : {"exact", "board"}) {
        ASSERT_TRUE(convertRecording({path(name + ".csv"), path("again.csv"), {}, {}, {}}));
        EXPECT_EQ(contentOf(path("again.csv")), contentOf(path(name + ".csv"))) << name;
        ASSERT_TRUE(convertRecording({path(name + ".csv"), path("again.mf4"), {}, {}, {}}));
        ASSERT_TRUE(convertRecording({path("again.mf4"), path("again.csv"), {}, {}, {}}));
        EXPECT_EQ(contentOf(path("again.csv")), contentOf(path(name + ".csv"))) << name << " through MDF4";
    }
}

TEST_F(ConvertExactTest, everyNumberComesBackToTheLastBitInAGermanLocaleToo) {
    const char* const before = std::setlocale(LC_ALL, nullptr);
    const std::string kept = before != nullptr ? before : "C";
    std::setlocale(LC_ALL, "de_DE.UTF-8"); // a decimal comma, where that language is installed
    const Recording recording = anyNumbers();
    ASSERT_TRUE(writeExactRecordingFile(path("exact.csv"), recording, metaOf(recording)));
    const auto back = readRecordingFile(path("exact.csv"));
    std::setlocale(LC_ALL, kept.c_str());
    ASSERT_TRUE(back) << back.error().message;
    ASSERT_EQ(back->recording.values.size(), recording.values.size());
    for (std::size_t i = 0; i < recording.values.size(); ++i) {
        if (!std::isnan(recording.values[i])) {
            ASSERT_EQ(std::bit_cast<std::uint64_t>(back->recording.values[i]),
                      std::bit_cast<std::uint64_t>(recording.values[i]))
                << i;
        }
    }
}

TEST_F(ConvertExactTest, aReplayedRecordingIsRecordedAgainExactly) {
    const Recording recording = anyNumbers();
    ASSERT_TRUE(writeExactRecordingFile(path("exact.csv"), recording, metaOf(recording)));
    const auto device = openReplayDevice("replay:" + path("exact.csv"), path("exact.csv"));
    ASSERT_TRUE(device);
    RecordingMeta meta = describeRecording(**device, *recording.layout, "1970-01-01T00:00:00Z");
    auto writer = RecordingWriter::create(path("again.csv"), *recording.layout, std::move(meta));
    ASSERT_TRUE(writer);
    ASSERT_TRUE((*writer)->append({recording.layout, recording.time_s, recording.values, 0.0, 0}));
    ASSERT_TRUE((*writer)->finish());
    EXPECT_EQ(contentOf(path("again.csv")), contentOf(path("exact.csv")));
}

} // namespace
} // namespace halbench::devices
