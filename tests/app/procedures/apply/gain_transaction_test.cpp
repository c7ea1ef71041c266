#include "app/procedures/apply/gain_transaction.h"
#include "tests/app/procedures/simulated_motor.h"

#include <gtest/gtest.h>

#include <limits>

namespace halbench::app {
namespace {

TEST(GainTransaction, checksEveryValueBeforeTheFirstIsSent) {
    const auto device = openMotor("");
    const devices::Catalogue& catalogue = device->catalogue();
    EXPECT_TRUE(checkValues(catalogue, {{"gain.kp", 12.0}, {"gain.ki", 0.0}}));
    const double notANumber = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(checkValues(catalogue, {{"gain.kp", notANumber}}).error().code, ErrorCode::NotFinite);
    EXPECT_EQ(checkValues(catalogue, {{"gain.kp", 12.0}, {"gain.ki", -1.0}}).error().code,
              ErrorCode::OutOfRange);
    EXPECT_EQ(checkValues(catalogue, {{"gain.kx", 1.0}}).error().code, ErrorCode::UnknownName);
}

TEST(GainTransaction, readsBackTheSameParametersInTheirOrder) {
    const auto device = openMotor("");
    const auto found = readBack(*device, {{"gain.ki", 7.0}, {"gain.kp", 7.0}});
    ASSERT_TRUE(found);
    EXPECT_EQ(namesOf(*found), (std::vector<std::string>{"gain.ki", "gain.kp"}));
    EXPECT_NEAR((*found)[0].value, 0.1, 1e-7); // single precision
    EXPECT_EQ((*found)[1].value, 10.0);
}

TEST(GainTransaction, takesSinglePrecisionForTheSameAndNothingElse) {
    EXPECT_TRUE(compareValues({{"gain.ki", 0.1}}, {{"gain.ki", static_cast<double>(0.1F)}}));
    EXPECT_FALSE(compareValues({{"gain.ki", 0.1}}, {{"gain.ki", 0.1001}}));
    EXPECT_FALSE(compareValues({{"gain.ki", 0.1}}, {{"gain.ki", std::numeric_limits<double>::quiet_NaN()}}));
}

TEST(GainTransaction, keepsTheNewValuesAndPutsTheRestBack) {
    const auto device = openMotor("");
    auto guard = RestoreGuard::take(*device);
    ASSERT_TRUE(guard);
    setParameter(*device, "gain.kp", 12.0);
    setParameter(*device, "window.speed", 5.0);
    ASSERT_TRUE(keepValues(*device, *guard, {{"gain.kp", 12.0}}));
    guard->keep();
    ASSERT_TRUE(guard->restore());
    EXPECT_EQ(parameter(*device, "gain.kp"), 12.0);
    EXPECT_EQ(parameter(*device, "window.speed"), 40.0);
}

} // namespace
} // namespace halbench::app
