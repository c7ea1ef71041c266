#pragma once

#include "app/experiments/experiment_runner.h"
#include "devices/open/open_device.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <memory>
#include <string>

namespace halbench::app {

// What the suites of actuators with several axes have in common.

inline std::unique_ptr<devices::Device> openSimulated(const std::string& address) {
    auto device = devices::openDevice(address, {});
    EXPECT_TRUE(device) << device.error().message;
    return device ? std::move(*device) : nullptr;
}

/// NaN, and a failure of the test, for one that cannot be read.
inline double parameterOf(devices::Device& device, const std::string& name) {
    const std::string names[] = {name};
    const auto values = device.readParameters(names);
    EXPECT_TRUE(values) << name;
    return values ? values->front() : NAN;
}

/// An experiment of the steps and checks in `body`, run on an open device.
struct AxisExperiment {
    AxisExperiment(devices::Device& device, const std::string& body) {
        auto parsed = parseExperiment("schema = \"halbench.experiment/1\"\n" + body, "axes.toml", {});
        EXPECT_TRUE(parsed) << parsed.error().message;
        if (parsed) {
            experiment = *std::move(parsed);
            Console console{ConsoleStyle{}};
            const std::atomic<int> signal = 0;
            CommandContext context{{}, console, signal};
            outcome = runExperiment(context, device, experiment, 1, "");
        }
    }

    void expectPassed(std::size_t steps) const {
        EXPECT_FALSE(outcome.stoppedBy) << outcome.stoppedBy->message;
        EXPECT_EQ(outcome.steps.size(), steps);
        for (const StepOutcome& step : outcome.steps) {
            for (const Finding& finding : step.quality.findings) {
                EXPECT_NE(step.quality.verdict, Verdict::Refused) << step.name << ": " << finding.message;
            }
        }
        for (const CheckOutcome& check : outcome.checks) {
            EXPECT_TRUE(check.passed) << check.quantity << " = " << check.value.value_or(NAN);
        }
        EXPECT_TRUE(outcome.passed);
    }

    Experiment experiment;
    RunOutcome outcome;
};

/// Steps that design the loops of `model` (a line that names it), write them and move one axis.
inline std::string tuneApplyMove(const std::string& model, const std::string& axis, int amplitude_um) {
    return "[[step]]\nkind = \"tune\"\nname = \"loops\"\n" + model +
           "\n[[step]]\nkind = \"apply\"\nname = \"write\"\ngains = \"loops\"\n"
           "[[step]]\nkind = \"move\"\nname = \"right\"\naxis = \"" +
           axis + "\"\nreference = { shape = \"step\", amplitude_um = " + std::to_string(amplitude_um) +
           " }\nduration_s = 2\n[[check]]\nquantity = \"write.kept\"\nmin = 1\n";
}

} // namespace halbench::app
