#include "app/wizards/turn_text.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

TEST(TurnText, saysDirectionSpeedTurnsAndTime) {
    const QString forward = turnText(20.0, 40.0, 125.0);
    EXPECT_TRUE(forward.contains(QStringLiteral("forward at 20.0 rad/s, about 40 turns")))
        << forward.toStdString();
    EXPECT_TRUE(forward.contains(QStringLiteral("2:05"))) << forward.toStdString();
    EXPECT_TRUE(turnText(-20.0, 40.0, 125.0).contains(QStringLiteral("in reverse at 20.0 rad/s")));
}

} // namespace
} // namespace halbench::app
