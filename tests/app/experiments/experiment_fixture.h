#pragma once

#include "app/experiments/experiment_runner.h"
#include "app/headless/command_header.h"
#include "devices/open/open_device.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <string>
#include <vector>

namespace halbench::app {

/// Runs experiments on a motor without imperfections.
class ExperimentRunner : public ::testing::Test {
protected:
    ExperimentRunner() : m_console(ConsoleStyle{.isQuiet = true, .level = LogLevel::Error}) {
        m_device = devices::openDevice("sim:htm?imperfections=off", {}).value();
    }

    RunOutcome run(const std::string& text, const std::string& folder = {}) {
        m_experiment = parseExperiment(text, "e.toml", {}).value();
        return runExperiment(m_context, *m_device, m_experiment, 1, folder);
    }
    ResultHeader header() { return headerFor(m_context, "halbench.run/1", *m_device); }
    double kp() { return m_device->readParameters(std::vector<std::string>{"gain.kp"}).value()[0]; }

    Console m_console;
    std::atomic<int> m_interruptSignal = 0;
    CommandContext m_context{{}, m_console, m_interruptSignal};
    std::unique_ptr<devices::Device> m_device;
    Experiment m_experiment;
};

} // namespace halbench::app
