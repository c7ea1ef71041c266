#include "app/procedures/excite/travel_reference.h"
#include "tests/app/procedures/simulated_motor.h"

#include <cmath>

namespace halbench::app {
namespace {

/// Three axes, set up as for the travels of resources/help/planar-theory.md section 9.2.
std::unique_ptr<devices::Device> openPlaten(const std::string& query = "imperfections=off&chain=ideal") {
    auto device = devices::openDevice("sim:planar?" + query, {});
    EXPECT_TRUE(device) << device.error().message;
    if (!device) {
        return nullptr;
    }
    for (const auto& [name, value] : {std::pair{"coil.force_constant", -3.52301},
                                      {"feedforward.x.inertia", 0.64},
                                      {"feedforward.y.inertia", 0.64}}) {
        setParameter(**device, name, value);
    }
    return std::move(*device);
}

MoveConfig travelOf(const std::string& axis, const std::string& reference) {
    MoveConfig config = move(reference, 0.0);
    config.axis = axis;
    config.duration_s = defaultDuration_s(config.reference).value_or(0.0);
    return config;
}

const std::string Limits = ",rate_mm_s=20,acceleration_m_s2=0.5,jerk_m_s3=20";

TEST(TravelMove, sCurveArrivesWhenItSaidItWould) {
    const auto device = openPlaten();
    ASSERT_NE(device, nullptr);
    const MoveConfig config = travelOf("x", "s-curve,amplitude_mm=-4" + Limits);
    // d/v + v/a + a/j = 0.2 + 0.04 + 0.025 s, and a second of rest.
    ASSERT_NEAR(config.duration_s, 1.265, 1e-9);
    const MoveResult result = moved(*device, config);
    EXPECT_EQ(result.quality.verdict, Verdict::Good);
    ASSERT_TRUE(result.travel_s && result.truth);
    EXPECT_NEAR(*result.travel_s, 0.265, 1e-9);
    const std::vector<double> reference = result.recording.column("reference.x");
    ASSERT_GT(reference.size(), 300u);
    EXPECT_LT(reference[263], reference[262]);                    // goes on
    EXPECT_NEAR(reference[266] - reference.front(), -4e-3, 1e-8); // is there
    EXPECT_LT(std::fabs(result.truth->finalError), 1e-5);
    // Constant speed of 20 mm/s for 0.16 s; the lag of the filtered difference is 66 um at 0.438 m/s^2
    // (planar_motion_test.cpp), which fades while the speed is constant: 2 % as for figure 19.
    ASSERT_TRUE(result.truth->rampEndSpeed);
    EXPECT_NEAR(*result.truth->rampEndSpeed / -0.02, 1.0, 0.02);
}

TEST(TravelMove, pathsTellTheirContourError) {
    for (const std::string& shape :
         {std::string("circle,radius_mm=2"), std::string("raster,width_mm=2,lines=4,pitch_um=300"),
          std::string("arc,radius_mm=2,angle_deg=-110,heading_deg=20"),
          std::string("line,length_mm=4,heading_deg=-130")}) {
        const auto device = openPlaten();
        ASSERT_NE(device, nullptr);
        const MoveConfig config = travelOf("", shape + Limits);
        const MoveResult result = moved(*device, config);
        EXPECT_EQ(result.quality.verdict, Verdict::Good) << shape;
        ASSERT_TRUE(result.contour && result.contour->truth && result.travel_s) << shape;
        ASSERT_EQ(result.partners.size(), 1u) << shape;
        EXPECT_EQ(result.axis.id, "x");
        EXPECT_EQ(result.partners.front().axis.id, "y");
        ASSERT_EQ(result.others.size(), 1u);
        EXPECT_EQ(result.others.front().axis.id, "phi");
        // Second route to the contour error: the error of each axis at the same instant is never smaller.
        const auto peak = [&](const MoveFigures& x, const MoveFigures& y) {
            return std::hypot(x.peakError, y.peakError);
        };
        EXPECT_GT(result.contour->truth->peak, 0.0);
        EXPECT_LE(result.contour->truth->peak, peak(*result.truth, *result.partners.front().truth)) << shape;
        EXPECT_LE(result.contour->truth->rms, result.contour->truth->peak);
        // 66 um of lag at 0.438 m/s^2 by the filtered difference, at 0.5 m/s^2 in two axes: 110 um.
        EXPECT_LT(result.contour->truth->peak, 110e-6) << shape;
        EXPECT_EQ(parameter(*device, "path.shape"), 0.0);
    }
}

TEST(TravelMove, pathThatWasEndedBeforeItsStartIsNoOrderForLater) {
    const auto device = openPlaten();
    ASSERT_NE(device, nullptr);
    ProcedureObserver observer;
    observer.onState = [&](ProcedureState state) {
        if (state == ProcedureState::Excite) {
            EXPECT_EQ(parameter(*device, "path.shape"), 1.0);
        }
    };
    int asked = 0;
    observer.checkAbort = [&asked]() -> Result<void> {
        return ++asked < 12 ? Result<void>() : failure(ErrorCode::Interrupted, "ended", "");
    };
    const auto result = runMove(*device, travelOf("", "circle,radius_mm=2" + Limits), observer);
    ASSERT_FALSE(result);
    EXPECT_FALSE(device->state().isArmed);
    EXPECT_EQ(parameter(*device, "path.shape"), 0.0);
}

TEST(TravelMove, refusesBeforeAnythingMoves) {
    const auto device = openPlaten();
    ASSERT_NE(device, nullptr);
    const auto codeOf = [&](const MoveConfig& config) {
        const auto result = runMove(*device, config, {});
        EXPECT_FALSE(result);
        EXPECT_FALSE(device->state().isArmed);
        return result ? ErrorCode::Internal : result.error().code;
    };
    EXPECT_EQ(codeOf(travelOf("x", "circle,radius_mm=2" + Limits)), ErrorCode::Usage);
    EXPECT_EQ(codeOf(travelOf("", "circle,radius_mm=30" + Limits)), ErrorCode::OutOfRange); // 60 mm along x
    EXPECT_EQ(codeOf(travelOf("phi", "s-curve,amplitude_mm=1" + Limits)), ErrorCode::InvalidInput);
    EXPECT_EQ(codeOf(travelOf("", "line,amplitude_deg=0.1,rate_deg_s=1,acceleration_rad_s2=1")),
              ErrorCode::InvalidInput); // radians are no metres
    MoveConfig tooShort = travelOf("x", "s-curve,amplitude_mm=4" + Limits);
    tooShort.duration_s = 0.2;
    EXPECT_EQ(codeOf(tooShort), ErrorCode::InvalidInput);
}

// The platen begins at (6.35, -6.35 mm); its stops stand at 50 mm and 20 mrad (planar-theory.md section 3).
TEST(TravelMove, noReferenceLeadsBeyondTheEndOfTheTravel) {
    const auto device = openPlaten();
    ASSERT_NE(device, nullptr);
    const auto errorOf = [&](const std::string& axis, const std::string& reference) {
        MoveConfig config = move(reference, 0.0);
        config.axis = axis;
        config.duration_s = defaultDuration_s(config.reference).value_or(1.0);
        const auto result = runMove(*device, config, {});
        EXPECT_FALSE(device->state().isArmed);
        return result ? std::string() : result.error().message;
    };
    for (const auto& [axis, reference] :
         {std::pair<std::string, std::string>{"x", "step,amplitude_mm=48"},
          {"y", "step,amplitude_mm=-44"},
          {"phi", "step,amplitude_mrad=25"},
          {"phi", "sine,amplitude_mrad=21,frequency_hz=0.2"},
          {"x", "s-curve,amplitude_mm=44" + Limits},
          {"y", "staircase,amplitude_mm=-9,period_s=0.1,count=5"},
          {"x", "ramp,rate_mm_s=45"},
          {"phi", "ramp,rate_mrad_s=19.5"}, // a second of it, and it goes on for 30 ms and brakes
          {"", "line,length_mm=45,heading_deg=0" + Limits},
          {"", "raster,width_mm=2,lines=3,pitch_mm=-23" + Limits},
          {"", "circle,radius_mm=22.5" + Limits}}) {
        EXPECT_NE(errorOf(axis, reference).find("its travel ends at"), std::string::npos)
            << axis << " " << reference << ": " << errorOf(axis, reference);
    }
    EXPECT_EQ(errorOf("", "circle,radius_mm=-22.5" + Limits), ""); // 45 mm the other way
    EXPECT_EQ(errorOf("y", "s-curve,amplitude_mm=42" + Limits), "");
}

TEST(TravelMove, motorHasNeitherTravelsNorPaths) {
    auto device = devices::openDevice("sim:htm", {});
    ASSERT_TRUE(device);
    for (const char* reference : {"trapezoid,amplitude_deg=10,rate_deg_s=20,acceleration_rad_s2=3",
                                  "circle,radius_mm=2,rate_mm_s=1,acceleration_m_s2=1"}) {
        const auto result = runMove(**device, travelOf("", reference), {});
        ASSERT_FALSE(result) << reference;
        EXPECT_EQ(result.error().code, ErrorCode::InvalidInput) << result.error().message;
        EXPECT_FALSE((*device)->state().isArmed);
    }
}

TEST(TravelMove, measuresTheStairsOfFigure14) {
    const auto device = openPlaten();
    ASSERT_NE(device, nullptr);
    MoveConfig config = move("staircase,amplitude_um=8,period_s=1.25,count=5", 6.25);
    config.axis = "x";
    const MoveResult result = moved(*device, config);
    ASSERT_TRUE(result.truth);
    ASSERT_EQ(result.truth->stairs.size(), 5u);
    // Section 9.2; printed to 0.01 um, and the start is known to a tick.
    constexpr double Expected_um[] = {7.84, 15.83, 23.83, 31.83, 39.83};
    for (std::size_t stair = 0; stair < 5; ++stair) {
        EXPECT_NEAR(1e6 * result.truth->stairs[stair].mean, Expected_um[stair], 0.1) << stair;
        ASSERT_TRUE(result.truth->stairs[stair].riseTime_s);
        EXPECT_NEAR(*result.truth->stairs[stair].riseTime_s, 0.25, 0.03);
    }
}

TEST(TravelMove, restShowsTheNoiseOfTheReadings) {
    const auto device = openPlaten("seed=4");
    ASSERT_NE(device, nullptr);
    MoveConfig config = move("rest", 5.0);
    config.axis = "x";
    const MoveResult result = moved(*device, config);
    EXPECT_EQ(result.quality.verdict, Verdict::Good);
    ASSERT_TRUE(result.measured.restRms && result.truth && result.truth->restRms);
    ASSERT_EQ(result.others.size(), 2u);
    // Section 9.2: 6.1 um, 5.4 um and 77 urad rms measured, 20 %.
    EXPECT_NEAR(*result.measured.restRms, 6.1e-6, 1.2e-6);
    EXPECT_NEAR(result.others[0].measuredRestRms.value_or(0.0), 5.4e-6, 1.1e-6);
    EXPECT_NEAR(result.others[1].measuredRestRms.value_or(0.0), 77e-6, 16e-6);
    EXPECT_LT(*result.truth->restRms, 2e-6); // 1.2 to 1.4 um of true motion, and the cable's slow force
}

} // namespace
} // namespace halbench::app
