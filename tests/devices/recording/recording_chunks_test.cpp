#include "devices/recording/recording_chunks.h"

#include <gtest/gtest.h>

namespace halbench::devices {
namespace {

TEST(RecordingChunks, theChecksumIsThatOfTheStandardsCheckWord) {
    EXPECT_EQ(crc32("123456789"), 0xCBF43926U); // the check value of CRC-32/ISO-HDLC
    EXPECT_EQ(crc32(""), 0U);
    EXPECT_EQ(crc32("6789", crc32("12345")), crc32("123456789")) << "of pieces, as of the whole";
}

TEST(RecordingChunks, linesComeBackUpToTheFirstThatIsTorn) {
    const RecordingChunk one{10, 0x0000BEEFU};
    const RecordingChunk two{20, 0xFFFFFFFFU};
    const std::string text = chunkLine(one) + chunkLine(two);
    EXPECT_EQ(text, "10 0000beef\n20 ffffffff\n");
    for (std::size_t size = 0; size <= text.size(); ++size) {
        const std::size_t whole = size == text.size() ? 2 : size >= chunkLine(one).size() ? 1 : 0;
        EXPECT_EQ(parseChunks(text.substr(0, size)).size(), whole) << size;
    }
    EXPECT_EQ(parseChunks(text), (std::vector<RecordingChunk>{one, two}));
    for (const char* wrong : {"0 00000000\n", "-1 00000000\n", "1 0000000g\n", "1  0000000\n", "1\n", "\n"}) {
        EXPECT_TRUE(parseChunks(wrong + text).empty()) << wrong;
    }
}

TEST(RecordingChunks, aDamagedChunkIsLeftOutAndTheOthersStay) {
    const std::vector<std::string> parts = {"first\n", "second\n", "third\n"};
    std::vector<RecordingChunk> chunks;
    for (const std::string& part : parts) {
        chunks.push_back({part.size(), crc32(part)});
    }
    using enum PartState;
    using Parts = std::vector<CheckedPart>;
    EXPECT_EQ(
        checkChunks("first\nsecond\nthird\ntail", chunks),
        (Parts{
            {"first\n", Confirmed}, {"second\n", Confirmed}, {"third\n", Confirmed}, {"tail", Unchecked}}));
    EXPECT_EQ(checkChunks("first\nsecOnd\nthird\n", chunks),
              (Parts{{"first\n", Confirmed}, {"secOnd\n", Damaged}, {"third\n", Confirmed}}));
    EXPECT_EQ(checkChunks("first\nsec", chunks), (Parts{{"first\n", Confirmed}, {"sec", Unchecked}}))
        << "the beginning of a chunk is not damaged";
    EXPECT_EQ(checkChunks("all\n", {}), (Parts{{"all\n", Unchecked}}))
        << "without checksums nothing is known to be damaged";
    EXPECT_TRUE(checkChunks("", chunks).empty());
}

} // namespace
} // namespace halbench::devices
