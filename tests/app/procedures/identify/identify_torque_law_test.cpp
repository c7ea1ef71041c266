#include "app/procedures/identify/identify_torque_law.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace halbench::app {
namespace {

using control::DepartureDirection;
using control::TorqueDeparture;

IdentifyFits fitsWith(TorqueDeparture departure, double value_ratio,
                      DepartureDirection direction = DepartureDirection::Both) {
    IdentifyFits fits;
    fits.linearity.emplace();
    fits.linearity->departure = departure;
    fits.linearity->direction = direction;
    fits.linearity->knee_A = 2.5;
    fits.linearity->value_ratio = value_ratio;
    fits.linearity->probability = 1e-6;
    fits.linearity->isSignificant = true;
    fits.linearity->isNotable = true;
    return fits;
}

TEST(TorqueLaw, eachDepartureIsNamedWithItsAmountAndARemedy) {
    struct Case {
        TorqueDeparture departure;
        double value_ratio;
        DepartureDirection direction;
        const char* words;
    };
    for (const Case& one :
         {Case{TorqueDeparture::Saturation, 0.75, DepartureDirection::Both,
               "above 2.5 A the torque per ampere is 25 %"},
          Case{TorqueDeparture::Saturation, 0.5, DepartureDirection::Forward, "above 2.5 A forward"},
          Case{TorqueDeparture::Saturation, 0.5, DepartureDirection::Reverse, "above 2.5 A in reverse"},
          Case{TorqueDeparture::Offset, 0.2, DepartureDirection::Both, "0.2 A less than commanded"},
          Case{TorqueDeparture::GainByDirection, -0.1, DepartureDirection::Both,
               "20 % between the directions"},
          Case{TorqueDeparture::GainDrift, 0.05, DepartureDirection::Both, "changed by 10 %"},
          Case{TorqueDeparture::FrictionDrift, 0.05, DepartureDirection::Both, "friction changed by 10 %"},
          Case{TorqueDeparture::FrictionByLoad, 0.1, DepartureDirection::Both,
               "friction increases with the current"},
          Case{TorqueDeparture::Unnamed, 0.0, DepartureDirection::Both, "p = 1e-06"}}) {
        IdentifyResult result;
        judgeTorqueLaw(result, fitsWith(one.departure, one.value_ratio, one.direction));
        EXPECT_EQ(result.quality.verdict, Verdict::Doubtful);
        ASSERT_EQ(result.quality.findings.size(), 1U) << one.words;
        EXPECT_EQ(result.quality.findings[0].code, "torque_not_proportional");
        EXPECT_NE(result.quality.findings[0].message.find(one.words), std::string::npos)
            << result.quality.findings[0].message;
        EXPECT_FALSE(result.quality.findings[0].hint.empty());
        EXPECT_EQ(result.notes.at("torque_linearity_p"), 1e-6);
    }
}

TEST(TorqueLaw, whatMovesTheConstantsLittleIsNoFinding) {
    IdentifyFits fits = fitsWith(TorqueDeparture::Saturation, 0.01);
    fits.linearity->isNotable = false;
    IdentifyResult result;
    judgeTorqueLaw(result, fits);
    EXPECT_EQ(result.quality.verdict, Verdict::Good);
    EXPECT_TRUE(result.quality.findings.empty());
}

TEST(TorqueLaw, currentsThatAreKnownBadlySayNothingOfSmallAsymmetries) {
    IdentifyFits fits;
    EXPECT_EQ(smallestAsymmetry(fits, 0.001), 1.0) << "nothing is known of friction";
    fits.sweep.emplace();
    fits.sweep->friction_A = 1.0;
    fits.points.resize(2);
    fits.points[0].current_A = 2.0;
    fits.points[1].current_A = -4.0;
    // 0.1 % of the largest current, 4 mA, of 1 A of friction.
    EXPECT_DOUBLE_EQ(smallestAsymmetry(fits, 0.001), 0.004);
}

} // namespace
} // namespace halbench::app
