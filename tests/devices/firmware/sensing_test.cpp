#include "devices/firmware/control/hb_safety.h"
#include "devices/firmware/control/hb_sensing.h"
#include "devices/firmware/control/hb_speed.h"
#include "tests/devices/firmware/board_fixture.h"

#include <gtest/gtest.h>

namespace halbench::devices::firmware {
namespace {

constexpr double Degree = Pi / 180.0;

hb_hall_correction ideal(std::uint8_t decode = HB_DECODE_ARCTANGENT) {
    hb_hall_correction correction{};
    correction.gain_ratio = 1.0F;
    correction.amplitude_T = static_cast<float>(FieldAmplitude_T);
    correction.decode = decode;
    return correction;
}

double decodeFields(double a_T, double b_T, const hb_hall_correction& correction) {
    hb_sensing sensing;
    hb_sensing_init(&sensing);
    sensing.field_T[0] = static_cast<float>(a_T);
    sensing.field_T[1] = static_cast<float>(b_T);
    float amplitude = 0.0F;
    return static_cast<double>(hb_sensing_decode(&sensing, &correction, &amplitude));
}

double fieldOfCode(float code, double temperature_degC) {
    hb_sensing sensing;
    hb_sensing_init(&sensing);
    const float hall[2] = {code, code};
    const float temperature[2] = {static_cast<float>(temperatureCode(temperature_degC)),
                                  static_cast<float>(temperatureCode(temperature_degC))};
    EXPECT_EQ(hb_sensing_convert(&sensing, hall, temperature), HB_FAULT_NONE);
    return static_cast<double>(sensing.field_T[0]);
}

TEST(Sensing, hasTheConverterStepOfTheSource) {
    // 5 V/1024/12.5 mV/mT = 0.390625 mT at 25 degC; /1.066 at 80 degC. Float of 0.16 T keeps 1e-8 T.
    EXPECT_NEAR(fieldOfCode(600, 25) - fieldOfCode(599, 25), 0.390625e-3, 2e-8);
    EXPECT_NEAR(fieldOfCode(600, 79.999) - fieldOfCode(599, 79.999), 0.390625e-3 / 1.066, 2e-8);
    EXPECT_NEAR(fieldOfCode(511.5F, 25), 0.0, 1e-8); // middle of the converter is zero field
}

TEST(Sensing, readsTheTemperatureSensor) {
    hb_sensing sensing;
    hb_sensing_init(&sensing);
    // 750 mV at 25 degC, 10 mV/degC: T = 0.1 mV - 50, and the converter reads code + 1/2
    const float hall[2] = {512, 512};
    const float temperature[2] = {153.1F, 194.06F};
    hb_sensing_convert(&sensing, hall, temperature);
    EXPECT_NEAR(static_cast<double>(sensing.temperature_degC[0]),
                (153.1 + 0.5) * 5000.0 / 1024.0 * 0.1 - 50.0, 1e-4);
    EXPECT_NEAR(static_cast<double>(sensing.temperature_degC[1]), 45.0, 0.02);
}

TEST(Sensing, decodesExactlyWithTheArctangent) {
    for (double angle = -3.1; angle < 3.14; angle += 0.01) {
        // float of both fields and of the result: 4e-7 rad
        EXPECT_NEAR(
            decodeFields(FieldAmplitude_T * std::cos(angle), FieldAmplitude_T * std::sin(angle), ideal()),
            angle, 4e-7);
    }
}

TEST(Sensing, hasTheErrorOfTheLinearFit) {
    double largest = 0.0;
    double sum = 0.0;
    constexpr int Count = 36000;
    for (int i = 0; i < Count; ++i) {
        const double angle = (i + 0.5) * 2.0 * Pi / Count - Pi;
        const double error = decodeFields(FieldAmplitude_T * std::cos(angle),
                                          FieldAmplitude_T * std::sin(angle), ideal(HB_DECODE_LINEAR)) -
                             angle;
        const double wrapped = std::remainder(error, 2.0 * Pi);
        largest = std::max(largest, std::abs(wrapped));
        sum += wrapped * wrapped;
    }
    // resources/help/htm-theory.md 3.5: 1.898 deg peak, 1.361 deg rms
    EXPECT_NEAR(largest / Degree, 1.898, 1e-3);
    EXPECT_NEAR(std::sqrt(sum / Count) / Degree, 1.361, 1e-3);
}

TEST(Sensing, hasTheStrayErrorOfTheSource) {
    // 10 mT on the channel that passes through zero: 4.05 deg with the line, atan(10/157) = 3.64 deg
    // otherwise.
    EXPECT_NEAR(decodeFields(FieldAmplitude_T, 0.01, ideal(HB_DECODE_LINEAR)) / Degree, 4.05, 0.005);
    EXPECT_NEAR(decodeFields(FieldAmplitude_T, 0.01, ideal()) / Degree, 3.64, 0.005);
    hb_hall_correction compensated = ideal();
    compensated.stray_T[1] = 0.01F;
    EXPECT_NEAR(decodeFields(FieldAmplitude_T, 0.01, compensated), 0.0, 1e-7);
}

TEST(Sensing, undoesOffsetGainAndQuadrature) {
    hb_hall_correction correction = ideal();
    correction.offset_T[0] = 0.004F;
    correction.offset_T[1] = -0.003F;
    correction.gain_ratio = 1.05F;
    correction.quadrature_rad = 0.02F;
    for (double angle = -3.0; angle < 3.0; angle += 0.1) {
        const double a = FieldAmplitude_T * std::cos(angle) + 0.004;
        const double b = 1.05 * FieldAmplitude_T * std::sin(angle + 0.02) - 0.003;
        EXPECT_NEAR(decodeFields(a, b, correction), angle, 1e-6); // a few float roundings
    }
}

TEST(Sensing, subtractsTheErrorMap) {
    float cosine[HB_ERROR_MAP_ORDERS] = {0.01F, 0.0F, 0.02F, 0.0F, 0.0F, -0.01F};
    float sine[HB_ERROR_MAP_ORDERS] = {0.0F, 0.015F, 0.0F, 0.0F, 0.005F, 0.0F};
    for (double angle = -3.1; angle < 3.1; angle += 0.05) {
        double expected = angle;
        for (int k = 1; k <= HB_ERROR_MAP_ORDERS; ++k) {
            expected -= static_cast<double>(cosine[k - 1]) * std::cos(k * angle) +
                        static_cast<double>(sine[k - 1]) * std::sin(k * angle);
        }
        const double corrected =
            static_cast<double>(hb_error_map_correct(static_cast<float>(angle), cosine, sine));
        EXPECT_NEAR(std::remainder(corrected - expected, 2.0 * Pi), 0.0, 2e-6);
        EXPECT_LE(std::abs(corrected), 3.1416);
    }
}

TEST(Sensing, unwrapsManyTurnsWithoutDrift) {
    BoardFixture f;
    f.angle_rad = 0.0;
    f.tick();
    constexpr int Steps = 200000; // 0.5 rad a tick: 15915 turns, past the wrap of the position counts at 8192
    for (int i = 1; i <= Steps; ++i) {
        f.angle_rad = 0.5 * i;
        f.tick();
    }
    const double angle =
        f.board().sensing.turns * 2.0 * Pi + static_cast<double>(f.board().sensing.angle_rad);
    EXPECT_NEAR(angle, 0.5 * Steps, 1e-6);
    EXPECT_NEAR(static_cast<double>(f.board().signals.speed_rad_s), 500.0, 1e-3);
}

TEST(Sensing, showsTheQuantisationOfTheConverterInTheAngle) {
    // Property 6 of resources/help/htm-theory.md 10: 0.041 deg rms, 0.097 deg max with the 10 bit converter.
    double largest = 0.0;
    double sum = 0.0;
    constexpr int Count = 20000;
    for (int i = 0; i < Count; ++i) {
        const double angle = (i + 0.37) * 2.0 * Pi / Count - Pi;
        hb_sensing sensing;
        hb_sensing_init(&sensing);
        // floor(V 1024/5); hallCode() is the exact code less one half
        const float hall[2] = {
            static_cast<float>(std::floor(hallCode(FieldAmplitude_T * std::cos(angle)) + 0.5)),
            static_cast<float>(std::floor(hallCode(FieldAmplitude_T * std::sin(angle)) + 0.5))};
        const float temperature[2] = {static_cast<float>(temperatureCode(25)),
                                      static_cast<float>(temperatureCode(25))};
        hb_sensing_convert(&sensing, hall, temperature);
        const hb_hall_correction correction = ideal();
        float amplitude = 0.0F;
        const double error = std::remainder(
            static_cast<double>(hb_sensing_decode(&sensing, &correction, &amplitude)) - angle, 2.0 * Pi);
        largest = std::max(largest, std::abs(error));
        sum += error * error;
    }
    EXPECT_NEAR(std::sqrt(sum / Count) / Degree, 0.041, 1e-3);
    EXPECT_NEAR(largest / Degree, 0.097, 5e-3); // the grid of angles need not hit the worst one
}

TEST(Speed, isTheSlopeOfALine) {
    hb_speed speed;
    hb_speed_init(&speed);
    EXPECT_EQ(hb_speed_update(&speed, 1000), 0.0F);
    for (int i = 1; i < 100; ++i) {
        ASSERT_FLOAT_EQ(hb_speed_update(&speed, 1000 + 37 * i), 37.0F) << i;
    }
}

TEST(Speed, isTheLeastSquaresSlopeOfACurve) {
    hb_speed speed;
    hb_speed_init(&speed);
    float slope = 0.0F;
    for (int i = 0; i < HB_SPEED_WINDOW + 50; ++i) {
        slope = hb_speed_update(&speed, i * i);
    }
    // The least-squares slope of a parabola over a symmetric window is its slope in the middle.
    const double middle = (HB_SPEED_WINDOW + 49) - (HB_SPEED_WINDOW - 1) / 2.0;
    EXPECT_NEAR(static_cast<double>(slope), 2.0 * middle, 1e-4 * middle);
}

TEST(Speed, survivesTheWrapOfTheCounts) {
    hb_speed speed;
    hb_speed_init(&speed);
    std::uint32_t position = 0x7FF00000U;
    for (int i = 0; i < 5000; ++i) {
        position += 40000;
        const float slope = hb_speed_update(&speed, static_cast<std::int32_t>(position));
        if (i > 0) {
            ASSERT_FLOAT_EQ(slope, 40000.0F) << i;
        }
    }
}

TEST(Speed, isNotDominatedByTheConverter) {
    // 2 rad/s with the angle of the 10 bit chain: differencing would show steps of 2.5 rad/s. White noise of
    // 0.041 deg would give 0.0135 rad/s rms over 32 samples; slow rotation colours it, so three times that is
    // allowed.
    BoardFixture f;
    double sum = 0.0;
    int count = 0;
    f.angle_rad = 0.1;
    for (int i = 0; i < 4000; ++i) {
        f.angle_rad += 2.0e-3;
        hb_htm_inputs in = f.inputs();
        in.hall_code[0] = std::floor(in.hall_code[0] + 0.5F);
        in.hall_code[1] = std::floor(in.hall_code[1] + 0.5F);
        hb_htm_fast_tick(&f.board(), &in, &f.outputs);
        if (i > HB_SPEED_WINDOW) {
            const double error = static_cast<double>(f.board().signals.speed_rad_s) - 2.0;
            sum += error * error;
            ++count;
        }
    }
    EXPECT_LT(std::sqrt(sum / count), 3 * 0.0135);
}

} // namespace
} // namespace halbench::devices::firmware
