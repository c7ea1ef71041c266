#include "devices/formats/mdf4_blocks.h"
#include "devices/formats/mdf4_reader.h"
#include "mdf4_sample.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace halbench::devices {
namespace {

/// Where the link `index` of the block at `offset` stands.
std::size_t linkPlace(std::size_t offset, std::size_t index) {
    return offset + mdf4::HeaderSize + mdf4::LinkSize * index;
}

std::uint64_t linkOf(const std::string& octets, std::uint64_t offset, std::size_t index) {
    return mdf4::get<std::uint64_t>(octets, linkPlace(offset, index));
}

/// Offsets of the sample's blocks.
struct Places {
    explicit Places(const std::string& octets)
        : dataGroup(linkOf(octets, mdf4::HdOffset, 0)), group(linkOf(octets, dataGroup, 1)),
          channel(linkOf(octets, group, 1)), data(linkOf(octets, dataGroup, 2)),
          event(linkOf(octets, mdf4::HdOffset, 4)) {}
    std::uint64_t dataGroup;
    std::uint64_t group;
    std::uint64_t channel;
    std::uint64_t data;
    std::uint64_t event;
};

template <typename Number>
std::string with(std::string octets, std::size_t place, Number value) {
    std::string number;
    mdf4::put(number, value);
    return octets.replace(place, number.size(), number);
}

/// The error, which must be InvalidInput with a hint.
std::string refusal(const std::string& octets) {
    const auto file = parseMdf4(octets, "run.mf4");
    if (file) {
        return "accepted";
    }
    EXPECT_EQ(file.error().code, ErrorCode::InvalidInput);
    EXPECT_FALSE(file.error().hint.empty());
    return file.error().message;
}

TEST(Mdf4Reader, everythingThatWasWrittenComesBack) {
    const Mdf4Sample sample = mdf4Sample();
    const auto file = parseMdf4(mdf4Octets(sample), "run.mf4");
    ASSERT_TRUE(file) << file.error().message;
    EXPECT_EQ(file->recording.time_s, sample.recording.time_s);
    ASSERT_EQ(file->recording.values.size(), sample.recording.values.size());
    for (std::size_t i = 0; i < file->recording.values.size(); ++i) {
        const double expected = sample.recording.values[i];
        EXPECT_TRUE(std::isnan(expected) ? std::isnan(file->recording.values[i])
                                         : file->recording.values[i] == expected);
    }
    EXPECT_EQ(file->recording.lostRows, 5U);
    const auto& columns = file->recording.layout->columns;
    ASSERT_EQ(columns.size(), 4U);
    EXPECT_EQ(columns[1].name + columns[1].unit + columns[2].name + columns[2].unit, "xAxV");
    EXPECT_EQ(columns[3].name, "time") << "the axis has this name too";
    EXPECT_EQ(file->meta.signals[0].role, "position");
    EXPECT_EQ(file->meta.device.id, "id <1>");
    EXPECT_EQ(file->meta.started, sample.meta.started);
    ASSERT_EQ(file->meta.markers.size(), 2U);
    EXPECT_EQ(file->meta.markers[0].time_s, -0.1);
    EXPECT_EQ(file->meta.markers[1].time_s, 1.0 / 7.0) << "every digit";
    EXPECT_EQ(file->meta.markers[1].text, "\xC3\xA4");
    ASSERT_EQ(file->meta.changes.size(), 1U);
    EXPECT_EQ(file->meta.changes[0].name, "gain.kp");
    EXPECT_EQ(file->meta.changes[0].value, 1.0 / 3.0);
}

TEST(Mdf4Reader, aFileCutOffAnywhereIsRefused) {
    const std::string whole = mdf4Octets(mdf4Sample());
    for (std::size_t size = 0; size < whole.size(); ++size) {
        EXPECT_NE(refusal(whole.substr(0, size)).find("run.mf4: block "), std::string::npos) << size;
    }
}

TEST(Mdf4Reader, oneWrongOctetAnywhereIsReadOrRefusedAndNothingElse) {
    const std::string whole = mdf4Octets(mdf4Sample());
    for (std::size_t place = 0; place < whole.size(); ++place) {
        for (const char wrong : {'\x00', '\x7F', '\xFF'}) {
            std::string damaged = whole;
            damaged[place] = wrong;
            const auto file = parseMdf4(damaged, "run.mf4");
            if (file) {
                EXPECT_EQ(file->recording.rows(), 20U) << place;
            } else {
                EXPECT_EQ(file.error().code, ErrorCode::InvalidInput) << place;
            }
        }
    }
}

TEST(Mdf4Reader, otherFilesAreRefusedByNameOfWhatTheyAre) {
    const std::string whole = mdf4Octets(mdf4Sample());
    EXPECT_EQ(refusal(""), "run.mf4: block ID at byte 0: not an MDF file");
    EXPECT_EQ(refusal(std::string(1000, 'x')), "run.mf4: block ID at byte 0: not an MDF file");
    EXPECT_EQ(refusal("UnFinMF " + whole.substr(8)),
              "run.mf4: block ID at byte 0: the file is not finalised");
    EXPECT_EQ(refusal(with(whole, 28, std::uint16_t{330})), "run.mf4: block ID at byte 28: version 330");
    EXPECT_EQ(refusal(std::string(whole).replace(16, 8, "Another ")),
              "run.mf4: block ID at byte 16: the file is from another program");
}

TEST(Mdf4Reader, damageIsNamedWithItsBlockAndOctet) {
    const std::string whole = mdf4Octets(mdf4Sample());
    const Places at(whole);
    EXPECT_EQ(refusal(with(whole, linkPlace(mdf4::HdOffset, 0), std::uint64_t{1} << 40)),
              fmt::format("run.mf4: block ##DG at byte {}: it is outside the file", std::uint64_t{1} << 40));
    EXPECT_EQ(refusal(with(whole, linkPlace(mdf4::HdOffset, 0), at.group)),
              fmt::format("run.mf4: block ##DG at byte {}: unexpected block type", at.group));
    EXPECT_EQ(refusal(with(whole, at.data + 8, ~std::uint64_t{0})),
              fmt::format("run.mf4: block ##DT at byte {}: invalid length {}", at.data, ~std::uint64_t{0}));
    const std::size_t cycles = at.group + mdf4::Cg.size() - mdf4::Cg.data + mdf4::CycleCount;
    EXPECT_EQ(refusal(with(whole, cycles, std::uint64_t{1} << 61)), // rows x 40 octets wrap to 0 in 64 bits
              fmt::format("run.mf4: block ##DT at byte {}: its length does not match {} rows", at.data,
                          std::uint64_t{1} << 61));
    EXPECT_EQ(refusal(with(whole, at.data + mdf4::HeaderSize + 40, -1.0)),
              fmt::format("run.mf4: block ##DT at byte {}: row 1: the time does not increase", at.data));
}

TEST(Mdf4Reader, chainsThatEndInThemselvesAreRefused) {
    const std::string whole = mdf4Octets(mdf4Sample());
    const Places at(whole);
    EXPECT_NE(refusal(with(whole, linkPlace(at.channel, 0), at.channel)).find("##CN"), std::string::npos);
    EXPECT_NE(refusal(with(whole, linkPlace(at.event, 0), at.event)).find("time channel or link"),
              std::string::npos);
}

TEST(Mdf4Reader, aTextLinkedAgainAndAgainDoesNotFillTheMemory) {
    Mdf4Sample sample = mdf4Sample();
    sample.meta.markers.assign(100, {0.0, ""});
    sample.meta.markers[0].text.assign(20000, 'x');
    std::string octets = mdf4Octets(sample);
    std::uint64_t event = linkOf(octets, mdf4::HdOffset, 4);
    const std::uint64_t text = linkOf(octets, event, 3);
    for (; event != 0; event = linkOf(octets, event, 0)) {
        octets = with(octets, linkPlace(event, 3), text);
    }
    EXPECT_EQ(refusal(octets),
              fmt::format("run.mf4: block ##TX at byte {}: it is linked more than once", text));
}

TEST(Mdf4Reader, readingCanBeAborted) {
    Mdf4Sample sample = mdf4Sample();
    sample.recording.time_s.clear();
    sample.recording.values.assign(4 * 2000, 0.0);
    for (int row = 0; row < 2000; ++row) {
        sample.recording.time_s.push_back(row);
    }
    const auto file = parseMdf4(mdf4Octets(sample), "run.mf4",
                                [] { return Result<void>(failure(ErrorCode::Interrupted, "enough")); });
    ASSERT_FALSE(file);
    EXPECT_EQ(file.error().code, ErrorCode::Interrupted);
}

} // namespace
} // namespace halbench::devices
