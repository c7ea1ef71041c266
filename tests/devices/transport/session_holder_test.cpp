#include "devices/transport/session_holder.h"

#include <gtest/gtest.h>

#include <vector>

namespace halbench::devices {
namespace {

using Octets = std::vector<std::uint8_t>;
using Ruling = SessionHolder::Ruling;

const Octets Connect{0xFF, 0x00};
const Octets Disconnect{0xFE};
const Octets Status{0xFD};
const Octets Stop{0xF1, 0x45};
const Octets Release{0xF1, 0x52};
const Octets EndedByWatchdog{0xFD, 0x07, 0x02};

TEST(SessionHolder, firstMasterHoldsItAndOthersAreRefused) {
    SessionHolder session;
    EXPECT_EQ(session.judge("a", Status, 0.0), Ruling::Ignored) << "a session begins with CONNECT";
    EXPECT_EQ(session.judge("a", Connect, 0.0), Ruling::Begins);
    EXPECT_EQ(session.judge("b", Connect, 0.1), Ruling::Refused);
    EXPECT_EQ(session.judge("a", Status, 0.2), Ruling::OfMaster);
    EXPECT_EQ(session.judge("a", Connect, 0.3), Ruling::Begins) << "its own master may begin it anew";
    EXPECT_EQ(session.judge("b", Connect, 0.4), Ruling::Refused);
}

TEST(SessionHolder, aStrangerStopsTheBoardAndDoesNothingElse) {
    SessionHolder session;
    EXPECT_EQ(session.judge("b", Stop, 0.0), Ruling::StrangersStop);
    (void)session.judge("a", Connect, 0.0);
    EXPECT_EQ(session.judge("b", Stop, 0.1), Ruling::StrangersStop);
    for (const Octets& packet :
         {Status, Disconnect, Release, Octets{0xFF, 0x01}, Octets{0xFF}, Octets{0x00}}) {
        EXPECT_EQ(session.judge("b", packet, 0.1), Ruling::Ignored);
    }
    EXPECT_EQ(session.judge("a", Stop, 0.2), Ruling::OfMaster);
}

TEST(SessionHolder, isFreeOnceItsMasterEndsItLeavesOrIsEndedByTheBoard) {
    for (int end = 0; end < 3; ++end) {
        SessionHolder session;
        (void)session.judge("a", Connect, 0.0);
        if (end == 0) {
            EXPECT_EQ(session.judge("a", Disconnect, 0.1), Ruling::OfMaster) << "it is answered";
        } else if (end == 1) {
            session.noteLeft("b"); // another connection means nothing
            EXPECT_EQ(session.judge("c", Connect, 0.1), Ruling::Refused);
            session.noteLeft("a");
        } else {
            session.noteSaid(Octets{0xFD, 0x06}); // another event
            EXPECT_EQ(session.judge("c", Connect, 0.1), Ruling::Refused);
            session.noteSaid(EndedByWatchdog);
        }
        EXPECT_EQ(session.judge("a", Status, 0.2), Ruling::Ignored) << end;
        EXPECT_EQ(session.judge("b", Connect, 0.2), Ruling::Begins) << end;
        EXPECT_EQ(session.judge("a", Connect, 0.3), Ruling::Refused) << end;
    }
}

TEST(SessionHolder, isLostBySilenceOnlyToOneWhoAsks) {
    SessionHolder session;
    (void)session.judge("a", Connect, 0.0);
    EXPECT_EQ(session.judge("b", Connect, SessionHolder::Timeout_s), Ruling::Refused);
    EXPECT_EQ(session.judge("a", Status, 60.0), Ruling::OfMaster) << "nobody asked meanwhile";
    EXPECT_EQ(session.judge("b", Connect, 60.0 + SessionHolder::Timeout_s), Ruling::Refused);
    EXPECT_EQ(session.judge("b", Connect, 60.1 + SessionHolder::Timeout_s), Ruling::Begins);
    EXPECT_EQ(session.judge("a", Status, 64.0), Ruling::Ignored);
}

} // namespace
} // namespace halbench::devices
