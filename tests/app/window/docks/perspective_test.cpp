#include "app/window/docks/perspective.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

TEST(Perspective, isFoundAgainByItsName) {
    for (const Perspective perspective : AllPerspectives) {
        EXPECT_EQ(perspectiveOf(perspectiveId(perspective)), perspective);
        EXPECT_FALSE(perspectiveTitle(perspective).isEmpty());
    }
    EXPECT_FALSE(perspectiveOf(QStringLiteral("none")));
}

} // namespace
} // namespace halbench::app
