#include "app/actuators/spherical/sensing_board.h"
#include "app/actuators/spherical/sensing_calibrate.h"
#include "app/actuators/spherical/sensing_columns.h"
#include "app/actuators/spherical/sensing_motion.h"
#include "app/actuators/spherical/sensing_signs.h"
#include "tests/app/actuators/spherical/simulated_sphere.h"

#include <gmock/gmock.h>

namespace halbench::app {
namespace {

constexpr std::size_t Width = 12;

/// 40 s of tumbling: nine fields in T, three true angles in rad.
const Recording& tumbling() {
    static const Recording recording = [] {
        const auto device = openSphere("motion=5&adc=1&temp_error_K=0&seed=4");
        std::vector<std::string> names = fieldSignals();
        names.insert(names.end(), {"truth.alpha", "truth.beta", "truth.gamma"});
        Recording made;
        auto layout = std::make_shared<StreamLayout>();
        for (std::size_t i = 0; i < names.size(); ++i) {
            layout->columns.push_back({names[i], i < 9 ? "T" : "rad"});
        }
        made.layout = layout;
        for (int i = 0; i < 400; ++i) {
            EXPECT_TRUE(device->clock().waitFor(0.1));
            const auto values = *device->readSignals(names);
            made.time_s.push_back(0.1 * i);
            made.values.insert(made.values.end(), values.begin(), values.end());
        }
        return made;
    }();
    return recording;
}

struct Change {
    std::size_t first;
    std::size_t end;
    double factor;
};

/// The recording with some columns scaled, named and marked with units anew.
Recording changed(const std::vector<Change>& changes,
                  const std::map<std::size_t, StreamLayout::Column>& columns = {}) {
    Recording recording = tumbling();
    for (const Change& change : changes) {
        for (std::size_t row = 0; row < recording.rows(); ++row) {
            for (std::size_t c = change.first; c < change.end; ++c) {
                recording.values[Width * row + c] *= change.factor;
            }
        }
    }
    auto layout = std::make_shared<StreamLayout>(*recording.layout);
    for (const auto& [index, column] : columns) {
        layout->columns[index] = column;
    }
    recording.layout = layout;
    return recording;
}

const std::map<std::size_t, StreamLayout::Column> WithoutAngles = {
    {9, {"a", ""}}, {10, {"b", ""}}, {11, {"c", ""}}};

std::map<std::size_t, StreamLayout::Column> references(const std::string& unit) {
    return {{9, {"reference.alpha", unit}}, {10, {"reference.beta", unit}}, {11, {"reference.gamma", unit}}};
}

Result<CalibrateResult> calibrated(const Recording& recording) {
    return calibrateSensingRecording(recording, {}, sensorsOnly(false), {});
}

std::string messageOf(const CalibrateResult& result, const std::string& code) {
    for (const Finding& finding : result.quality.findings) {
        if (finding.code == code) {
            return finding.message;
        }
    }
    return {};
}

std::map<std::string, double> figuresOf(const CalibrateResult& result) {
    std::map<std::string, double> figures;
    for (const CalibrationFigure& figure : result.figures) {
        figures[figure.name] = *figure.estimate.value;
    }
    return figures;
}

// All nine reversed are the field of a rotor spun by 90 degrees (every order of the field is twice an odd
// number): only an orientation tells them apart.
TEST(SensingRecording, reversedReadingsAreToldFromOrientationsOfTheRecording) {
    for (const auto& columns : {std::map<std::size_t, StreamLayout::Column>(), references("rad")}) {
        const auto result = calibrated(changed({{0, 9, -1.0}}, columns));
        ASSERT_TRUE(result) << result.error().message;
        EXPECT_EQ(result->quality.verdict, Verdict::Refused);
        EXPECT_THAT(messageOf(*result, "readings_reversed"), testing::HasSubstr("all readings"));
        EXPECT_TRUE(result->proposed.empty());
    }
    const auto one = calibrated(changed({{3, 6, -1.0}}));
    ASSERT_TRUE(one);
    EXPECT_THAT(messageOf(*one, "readings_reversed"),
                testing::StartsWith("field.1.r, field.1.theta, field.1.phi read"));
}

TEST(SensingRecording, aReversedSensorIsToldWithoutAnyOrientation) {
    const std::array<std::pair<Change, const char*>, 3> cases = {
        {{{3, 6, -1.0}, "field.1.r, field.1.theta, field.1.phi"},
         {{4, 5, -1.0}, "field.1.theta"},
         {{8, 9, -1.0}, "field.2.phi"}}};
    for (const auto& [change, names] : cases) {
        const auto result = calibrated(changed({change}, WithoutAngles));
        ASSERT_TRUE(result);
        EXPECT_EQ(result->quality.verdict, Verdict::Refused) << names;
        EXPECT_EQ(messageOf(*result, "readings_reversed"),
                  std::string(names) + " read with the opposite sign of the others");
    }
    const auto all = calibrated(changed({{0, 9, -1.0}}, WithoutAngles));
    ASSERT_TRUE(all);
    EXPECT_THAT(messageOf(*all, "sign_not_observable"), testing::HasSubstr("90 degrees"));
    EXPECT_EQ(messageOf(*all, "readings_reversed"), "");
}

TEST(SensingRecording, healthyReadingsContradictNothing) {
    for (const auto& columns :
         {std::map<std::size_t, StreamLayout::Column>(), WithoutAngles, references("rad")}) {
        const auto motion = sensedMotion(changed({}, columns));
        ASSERT_TRUE(motion) << motion.error().message;
        EXPECT_FALSE(contradictingReadings(*motion, notedSensingBoard({})));
    }
}

TEST(SensingRecording, unitsOfTheColumnsAreConverted) {
    const auto expected = calibrated(changed({}, references("rad")));
    std::map<std::size_t, StreamLayout::Column> columns = references("deg");
    const std::vector<std::string> names = fieldSignals();
    for (std::size_t c = 0; c < 9; ++c) {
        columns[c] =
            c < 3 ? StreamLayout::Column{names[c] + " [mT]", ""} : StreamLayout::Column{names[c], "mT"};
    }
    const auto result = calibrated(changed({{0, 9, 1e3}, {9, 12, 180.0 / Pi}}, columns));
    ASSERT_TRUE(expected);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(result->quality.verdict, Verdict::Good);
    // Scaled and scaled back, a reading differs by a few last digits.
    for (const auto& [name, value] : figuresOf(*expected)) {
        EXPECT_NEAR(figuresOf(*result).at(name), value, 1e-9) << name;
    }
}

TEST(SensingRecording, unitsThatCannotBeAreNamed) {
    const auto message = [](const Recording& recording) {
        const auto result = calibrated(recording);
        return result ? std::string("accepted") : result.error().message + "; " + result.error().hint;
    };
    EXPECT_THAT(message(changed({}, {{4, {"field.1.theta", "A"}}})),
                testing::HasSubstr("'field.1.theta' is not in T"));
    EXPECT_THAT(message(changed({{4, 5, 1e3}})), testing::HasSubstr("another unit"));
    EXPECT_THAT(message(changed({{9, 12, 180.0 / Pi}}, references(""))), testing::HasSubstr("in degrees"));
    EXPECT_THAT(message(changed({}, references("V"))), testing::HasSubstr("'reference.alpha' is not in rad"));
}

// Angles in a tenth of their unit.
TEST(SensingRecording, orientationsOfSomethingElseAreNamed) {
    const auto result = calibrated(changed({{9, 12, 0.1}}, references("rad")));
    ASSERT_TRUE(result);
    EXPECT_EQ(result->quality.verdict, Verdict::Refused);
    EXPECT_THAT(messageOf(*result, "references_do_not_fit"), testing::HasSubstr("degrees (median)"));
}

TEST(SensingRecording, aMissingSensorIsNamed) {
    const std::map<std::size_t, StreamLayout::Column> columns = {
        {6, {"hall.6", "T"}}, {7, {"hall.7", "T"}}, {8, {"hall.8", "T"}}};
    const auto without = calibrated(changed({}, columns));
    ASSERT_FALSE(without);
    EXPECT_THAT(without.error().message, testing::HasSubstr("sensor 2 is missing"));
    EXPECT_THAT(without.error().hint, testing::HasSubstr("hall.6 [T]"));
    const auto silent = calibrated(changed({{6, 9, std::nan("")}}));
    ASSERT_TRUE(silent);
    EXPECT_EQ(silent->quality.verdict, Verdict::Refused);
    EXPECT_THAT(messageOf(*silent, "sensor_missing"), testing::StartsWith("sensor 2"));
}

// Gain, offset and skews of a channel without readings stay; the others come out as with all channels.
TEST(SensingRecording, aMissingChannelLeavesTheOthers) {
    const auto all = calibrated(changed({}, references("rad")));
    const auto result = calibrated(changed({{6, 7, std::nan("")}}, references("rad")));
    ASSERT_TRUE(all);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(result->quality.verdict, Verdict::Doubtful);
    EXPECT_THAT(messageOf(*result, "channel_left_out"), testing::StartsWith("field.2.r"));
    const auto expected = figuresOf(*all);
    const auto found = figuresOf(*result);
    EXPECT_FALSE(found.contains("sensor2.gain_r"));
    EXPECT_FALSE(found.contains("sensor2.skew_r_phi"));
    // 400 readings of 100 uT each: 2e-4 is many deviations of a gain.
    EXPECT_NEAR(found.at("sensor1.gain_r") - found.at("sensor0.gain_r"),
                expected.at("sensor1.gain_r") - expected.at("sensor0.gain_r"), 2e-4);
}

TEST(SensingColumns, namesOfOtherToolsAreRead) {
    Recording recording;
    auto layout = std::make_shared<StreamLayout>();
    layout->columns = {{"field_0_r_mT", ""}, {"coil_current_set", "V"}, {"field.0.phi", ""}};
    recording.layout = layout;
    recording.time_s = {0.0};
    recording.values = {120.0, 1.0, 0.2};
    const auto converted = sensingColumn(recording, "field.0.r", "T", ColumnsWithoutUnit::Refused);
    ASSERT_TRUE(converted);
    EXPECT_DOUBLE_EQ(converted->values(recording).front(), 0.12);
    EXPECT_EQ(sensingColumn(recording, "coil.current", "A", ColumnsWithoutUnit::Taken).error().code,
              ErrorCode::UnknownName);
    EXPECT_TRUE(sensingColumn(recording, "field.0.phi", "T", ColumnsWithoutUnit::Taken));
    EXPECT_EQ(sensingColumn(recording, "field.0.phi", "T", ColumnsWithoutUnit::Refused).error().code,
              ErrorCode::InvalidInput);
    EXPECT_EQ(columnNames(recording), "field_0_r_mT, coil_current_set [V], field.0.phi");
}

} // namespace
} // namespace halbench::app
