#include "app/procedures/calibrate/calibrate_procedure.h"
#include "app/procedures/excite/excitation_limits.h"
#include "app/procedures/identify/identify_procedure.h"
#include "tests/app/procedures/rogue_board.h"
#include "tests/app/procedures/simulated_motor.h"

#include <algorithm>
#include <map>

// A board whose own windows do not work: the host stops it, everything else ends as after a stop of the
// board itself (resources/help/architecture.md, safety).

namespace halbench::app {
namespace {

// The board's windows as they are when nobody restricts them.
std::vector<ParameterValue> withoutWindows(std::vector<ParameterValue> values) {
    for (ParameterValue& value : values) {
        if (value.name == "window.speed_enabled" || value.name == "window.position_enabled") {
            value.value = 0.0;
        }
    }
    return values;
}

// Such a board that also gives its full current whatever it is asked for, and does not end a run early.
std::vector<ParameterValue> runaway(std::vector<ParameterValue> values) {
    if (values.size() == 1 && values[0].name == "reference.start") {
        return {};
    }
    for (ParameterValue& value : values) {
        if (value.name.rfind("plateau.current_", 0) == 0) {
            value.value = 4.0;
        }
    }
    return withoutWindows(std::move(values));
}

std::map<std::string, double> calibrationOf(devices::Device& device) {
    std::map<std::string, double> values;
    for (const ParameterSpec& spec : device.catalogue().parameters) {
        if (spec.isTransactional && spec.name.rfind("window.", 0) != 0) {
            values[spec.name] = parameter(device, spec.name);
        }
    }
    return values;
}

class Runaway : public testing::Test {
protected:
    explicit Runaway(RogueBoard::Alter alter = withoutWindows)
        : m_board(openMotor("imperfections=off"), std::move(alter)) {
        setParameter(m_board, "gain.kp", 9.0); // not the default, so that a reset would be seen too
        m_before = calibrationOf(m_board);
    }

    template <typename T>
    void expectStopped(const Result<T>& result, const std::string& signal) {
        ASSERT_FALSE(result);
        EXPECT_EQ(result.error().code, ErrorCode::SafetyStop) << result.error().message; // exit code 4
        EXPECT_NE(result.error().message.find("stopped from here: " + signal), std::string::npos)
            << result.error().message;
        EXPECT_EQ(m_board.stops(), 1);
        EXPECT_TRUE(m_board.state().isStopLatched);
        EXPECT_FALSE(m_board.state().isArmed);
        EXPECT_EQ(calibrationOf(m_board), m_before) << "gains restored";
        const std::string name[] = {"current_command"};
        EXPECT_EQ(m_board.readSignals(name)->front(), 0.0);
    }

    RogueBoard m_board;
    std::map<std::string, double> m_before;
};

class RunawayCurrent : public Runaway {
protected:
    RunawayCurrent() : Runaway(runaway) {}
};

TEST_F(Runaway, aMoveIsStoppedAtItsSpeed) {
    MoveConfig config = move("step,amplitude_deg=300", 3);
    config.speedLimit_rad_s = 5.0;
    expectStopped(runMove(m_board, config, {}), "speed");
}

TEST_F(Runaway, aMoveIsStoppedWhereItLeavesItsPositionWindow) {
    RogueBoard board(openMotor("imperfections=off"), [](std::vector<ParameterValue> values) {
        for (ParameterValue& value : values) {
            if (value.name == "reference.amplitude") {
                value.value = 100.0; // rad, where 0.1 were asked for
            }
        }
        return withoutWindows(std::move(values));
    });
    MoveConfig config = move("step,amplitude_rad=0.1", 3);
    config.speedLimit_rad_s = 1000.0;
    const auto result = runMove(board, config, {});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::SafetyStop);
    EXPECT_NE(result.error().message.find("stopped from here: position"), std::string::npos)
        << result.error().message;
    EXPECT_FALSE(board.state().isArmed);
}

TEST_F(RunawayCurrent, anIdentificationIsStoppedAtItsSpeed) {
    IdentifyConfig config;
    config.sweep = {2.0, 3.0, 0.5};
    config.speedLimit_rad_s = 15.0;
    expectStopped(runIdentify(m_board, config, {}), "speed");
}

TEST_F(RunawayCurrent, aCalibrationIsStoppedAtItsSpeed) {
    CalibrateConfig config;
    config.which = {Calibration::Hall};
    config.speedLimit_rad_s = 15.0;
    expectStopped(runCalibrate(m_board, config, {}), "speed");
}

TEST(ExcitationLimits, areWiderThanTheBoardsAndFoundByRole) {
    const auto device = openMotor("");
    const auto limits = excitationLimits(device->catalogue(), 40.0, 2.0);
    ASSERT_EQ(limits.size(), 4U);
    EXPECT_EQ(limits[0].signal, "speed");
    EXPECT_GT(limits[0].max, 40.0);
    EXPECT_EQ(limits[0].min, -limits[0].max);
    EXPECT_EQ(limits[1].signal, "position");
    EXPECT_TRUE(limits[1].isFromStart);
    EXPECT_GT(limits[1].max, 2.0);
    EXPECT_EQ(limits[2].signal, "coil_temperature.a");
    EXPECT_GT(limits[2].max, parameter(*device, "limit.temperature"));
    EXPECT_TRUE(excitationLimits(devices::Catalogue{}, 40.0).empty()) << "a board without a profile";
}

TEST(ExcitationLimits, areStreamedBesideWhatIsMeasured) {
    const auto device = openMotor("");
    const auto signals = withWatchedSignals(device->catalogue(), {"hall.a", "speed"});
    EXPECT_EQ(signals, (std::vector<std::string>{"hall.a", "speed", "position", "coil_temperature.a",
                                                 "coil_temperature.b"}));
}

} // namespace
} // namespace halbench::app
