#include "devices/transport/octet_inbox.h"

#include <gtest/gtest.h>

#include <thread>

namespace halbench::devices {
namespace {

using Octets = std::vector<std::uint8_t>;

TEST(OctetInbox, givesEverythingThatCameBeforeTheError) {
    OctetInbox inbox;
    Octets octets;
    EXPECT_FALSE(inbox.take(octets, 0.0).value());
    inbox.put(Octets{1, 2});
    inbox.put(Octets{3});
    inbox.fail({ErrorCode::DeviceLost, "first", ""});
    inbox.fail({ErrorCode::DeviceLost, "second", ""});
    EXPECT_TRUE(inbox.take(octets, 0.0).value());
    EXPECT_EQ(octets, (Octets{1, 2, 3}));
    const auto after = inbox.take(octets, 0.0);
    ASSERT_FALSE(after);
    EXPECT_EQ(after.error().message, "first");
    inbox.clear();
    EXPECT_FALSE(inbox.take(octets, 0.0).value());
    EXPECT_EQ(inbox.received(), 3U);
}

TEST(OctetInbox, anOverflowEndsTheConnectionBehindAllThatWaited) {
    OctetInbox inbox;
    inbox.put(Octets(OctetInbox::MaxWaiting, 1));
    inbox.put(Octets(5, 2));
    Octets octets;
    EXPECT_TRUE(inbox.take(octets, 0.0).value());
    EXPECT_EQ(octets.size(), OctetInbox::MaxWaiting) << "nothing is thrown away behind anybody's back";
    EXPECT_EQ(octets.back(), 1);
    inbox.put(Octets(5, 3));
    const auto end = inbox.take(octets, 0.0);
    ASSERT_FALSE(end) << "what came later has a hole in front of it";
    EXPECT_EQ(end.error().code, ErrorCode::DeviceLost);
    EXPECT_EQ(end.error().message, "8 MB from the device were not processed in time");
    EXPECT_NE(end.error().hint.find("connect again"), std::string::npos);
    inbox.clear();
    inbox.put(Octets(5, 4));
    EXPECT_TRUE(inbox.take(octets, 0.0).value());
    EXPECT_EQ(octets, Octets(5, 4));
}

TEST(OctetInbox, carriesEveryOctetFromThreadToThreadInOrder) {
    OctetInbox inbox;
    constexpr std::size_t Count = 20000;
    std::thread sender([&] {
        for (std::size_t i = 0; i < Count; ++i) {
            const auto octet = static_cast<std::uint8_t>(i);
            inbox.put({&octet, 1});
        }
    });
    Octets all;
    Octets octets;
    while (all.size() < Count && inbox.take(octets, 10.0).value_or(false)) {
        all.insert(all.end(), octets.begin(), octets.end());
    }
    sender.join();
    ASSERT_EQ(all.size(), Count);
    for (std::size_t i = 0; i < Count; ++i) {
        ASSERT_EQ(all[i], static_cast<std::uint8_t>(i));
    }
}

} // namespace
} // namespace halbench::devices
