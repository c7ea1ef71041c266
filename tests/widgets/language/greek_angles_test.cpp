#include "widgets/language/greek_angles.h"

#include <gtest/gtest.h>

namespace halbench::widgets {
namespace {

TEST(GreekAngles, replaceNamesOfAnglesOnly) {
    EXPECT_EQ(greekAngles("alpha 40, beta -20, gamma 0 deg"), QString("α 40, β -20, γ 0 deg"));
    EXPECT_EQ(greekAngles("先绕 Z 转 gamma，再绕 Y 转beta"), QString("先绕 Z 转 γ，再绕 Y 转β"));
    EXPECT_EQ(greekAngles("sensor.alpha_1 and alphabet"), QString("sensor.alpha_1 and alphabet"));
}

} // namespace
} // namespace halbench::widgets
