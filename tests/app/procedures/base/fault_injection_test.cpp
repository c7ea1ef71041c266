#include "devices/simulated/htm/simulated_htm.h"
#include "tests/app/procedures/base/procedure_cases.h"
#include "tests/app/procedures/faulty_motor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <ostream>
#include <set>

// Every state of every procedure x every fault: afterwards the actuator is disarmed and the old gains run
// (resources/help/architecture.md, procedures). The cases are generated from AllProcedureStates, so that a
// new state without a procedure that walks through it fails here.

namespace halbench::app {
namespace {

enum class Fault { Abort, Unplug, BoardFault, NotANumber, Timeout, Kill };
constexpr std::array AllFaults = {Fault::Abort,      Fault::Unplug,  Fault::BoardFault,
                                  Fault::NotANumber, Fault::Timeout, Fault::Kill};

std::string faultName(Fault fault) {
    static const std::string names[] = {"abort", "unplug", "fault", "nan", "timeout", "sigkill"};
    return names[static_cast<std::size_t>(fault)];
}

constexpr double OldGain_A_per_rad = 9.0; // not the board's default, so that a reset would be seen too

// Samples whose every number is all ones: not a number in single and double precision. Head of a sample
// packet: one octet identity, four of time.
void spoilSamples(std::vector<std::uint8_t>& packet) {
    constexpr std::size_t Head = 5;
    constexpr std::uint8_t FirstOwnPacket = 0xFC;
    if (!packet.empty() && packet[0] < FirstOwnPacket && packet.size() > Head) {
        std::fill(packet.begin() + Head, packet.end(), std::uint8_t{0xFF});
    }
}

struct FaultCase {
    ProcedureCase procedure;
    ProcedureState state;
    Fault fault;
};

void PrintTo(const FaultCase& faultCase, std::ostream* stream) {
    *stream << faultCase.procedure.name << " in " << procedureStateName(faultCase.state) << ": "
            << faultName(faultCase.fault);
}

std::string caseName(const ::testing::TestParamInfo<FaultCase>& info) {
    return info.param.procedure.name + "_" + std::string(procedureStateName(info.param.state)) + "_" +
           faultName(info.param.fault);
}

std::vector<FaultCase> allCases() {
    std::vector<FaultCase> cases;
    for (const ProcedureCase& procedure : procedureCases()) {
        for (const ProcedureState state : AllProcedureStates) {
            const bool isVisited = std::count(procedure.states.begin(), procedure.states.end(), state) > 0;
            if (isVisited || (state == ProcedureState::Restored && !procedure.isReadOnly)) {
                for (const Fault fault : AllFaults) {
                    cases.push_back({procedure, state, fault});
                }
            }
        }
    }
    return cases;
}

class FaultInjection : public ::testing::TestWithParam<FaultCase> {
protected:
    FaultInjection() : motor("seed=1") {}

    void SetUp() override {
        device = motor.connect();
        const ParameterValue old[] = {{"gain.kp", OldGain_A_per_rad}};
        ASSERT_TRUE(device->writeParameters(old));
        before = calibration(*device);
        ASSERT_FALSE(before.empty());
    }

    // Everything on the calibration pages except the marks of the transactions.
    static std::map<std::string, double> calibration(devices::Device& from) {
        std::vector<std::string> names;
        for (const ParameterSpec& spec : from.catalogue().parameters) {
            if (spec.isTransactional && spec.name.rfind("set.", 0) != 0) {
                names.push_back(spec.name);
            }
        }
        const auto values = from.readParameters(names);
        EXPECT_TRUE(values);
        std::map<std::string, double> result;
        for (std::size_t i = 0; values && i < names.size(); ++i) {
            result[names[i]] = (*values)[i];
        }
        return result;
    }

    // Restored is reached only by a run that something else ended before.
    ProcedureObserver observer() {
        ProcedureObserver watching;
        watching.onState = [this](ProcedureState state) {
            if (state == GetParam().state) {
                hasHappened = true;
                inject(GetParam().fault);
            } else if (GetParam().state == ProcedureState::Restored && state != ProcedureState::Prepare) {
                isAborted = true;
            }
        };
        watching.checkAbort = [this]() -> Result<void> {
            return isAborted ? Result<void>(failure(ErrorCode::Interrupted, "stopped by the test", ""))
                             : Result<void>();
        };
        return watching;
    }

    void inject(Fault fault) {
        switch (fault) {
        case Fault::Abort:
            isAborted = true;
            break;
        case Fault::Unplug:
            motor.faults().isUnplugged = true;
            break;
        case Fault::BoardFault:
            motor.board().breakReading(devices::HtmHallReading, 1023.0);
            break;
        case Fault::NotANumber:
            motor.faults().alterReceived = spoilSamples;
            break;
        case Fault::Timeout:
            motor.faults().isStalled = true;
            break;
        case Fault::Kill:
            motor.faults().isMute = true;
            break;
        }
    }

    void expectOldGainsAndNoMotion(bool hasSucceeded) {
        EXPECT_FALSE(motor.isArmed());
        EXPECT_EQ(motor.commandedCurrent_A(), 0.0);
        motor.repair();
        const auto later = motor.connect();
        ASSERT_NE(later, nullptr);
        const std::map<std::string, double> after = calibration(*later);
        if (hasSucceeded) {
            EXPECT_EQ(after.at("gain.kp"),
                      GetParam().procedure.keptGain_A_per_rad.value_or(OldGain_A_per_rad));
            EXPECT_EQ(after.at("window.position_enabled"), before.at("window.position_enabled"));
        } else {
            EXPECT_EQ(after, before);
        }
        EXPECT_EQ(devices::htmFirmware(motor.board()).signals.board.torn_count, 0U);
    }

    FaultyMotor motor;
    std::unique_ptr<devices::Device> device;
    std::map<std::string, double> before;
    bool hasHappened = false;
    bool isAborted = false;
};

TEST_P(FaultInjection, leavesTheOldGainsAndNothingMoving) {
    const Result<void> result = GetParam().procedure.run(*device, observer());
    EXPECT_TRUE(hasHappened);
    const bool isLater =
        GetParam().state == ProcedureState::Done || GetParam().state == ProcedureState::Restored;
    const bool isLinkFault = GetParam().fault == Fault::Unplug || GetParam().fault == Fault::Timeout ||
                             GetParam().fault == Fault::Kill;
    if (isLinkFault && !isLater && GetParam().state != ProcedureState::Judge) {
        EXPECT_FALSE(result); // a procedure cannot go well without its device
    }
    device.reset();
    motor.board().advanceTo(motor.board().time_s() + 2.0); // the board's watchdog is set to one second
    expectOldGainsAndNoMotion(result.has_value());
}

INSTANTIATE_TEST_SUITE_P(All, FaultInjection, ::testing::ValuesIn(allCases()), caseName);

TEST(FaultInjectionCases, everyProcedureWalksThroughTheStatesItDeclares) {
    for (const ProcedureCase& procedure : procedureCases()) {
        FaultyMotor motor("seed=1");
        const auto device = motor.connect();
        std::vector<ProcedureState> visited;
        ProcedureObserver observer;
        observer.onState = [&](ProcedureState state) {
            if (std::count(visited.begin(), visited.end(), state) == 0) {
                visited.push_back(state);
            }
        };
        const Result<void> result = procedure.run(*device, observer);
        EXPECT_TRUE(result) << procedure.name << ": " << result.error().message;
        EXPECT_EQ(visited, procedure.states) << procedure.name;
        EXPECT_FALSE(motor.isArmed()) << procedure.name;
    }
}

TEST(FaultInjectionCases, everyStateHasAProcedureThatWalksThroughIt) {
    std::set<ProcedureState> covered = {ProcedureState::Restored};
    for (const ProcedureCase& procedure : procedureCases()) {
        covered.insert(procedure.states.begin(), procedure.states.end());
    }
    for (const ProcedureState state : AllProcedureStates) {
        EXPECT_EQ(covered.count(state), 1U) << procedureStateName(state);
    }
}

} // namespace
} // namespace halbench::app
