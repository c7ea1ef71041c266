#pragma once

#include "devices/simulated/loopback_transport.h"
#include "devices/xcp/xcp_device.h"
#include "tests/devices/firmware/mps2/emulator/mps2_transport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace halbench::mps2 {

/// Readings of a run, tick after tick.
using Readings = std::vector<std::vector<float>>;

/// A plant whose readings are kept.
class WatchedPlant : public devices::Plant {
public:
    WatchedPlant(std::unique_ptr<devices::Plant> plant, std::shared_ptr<Readings> readings)
        : m_plant(std::move(plant)), m_readings(std::move(readings)) {}

    void read(std::span<float> readings) override {
        m_plant->read(readings);
        m_readings->emplace_back(readings.begin(), readings.end());
    }
    void drive(std::span<const float> outputs) override { m_plant->drive(outputs); }
    void advance(int subSteps) override { m_plant->advance(subSteps); }
    hb_signal_table truth() const override { return m_plant->truth(); }

private:
    std::unique_ptr<devices::Plant> m_plant;
    std::shared_ptr<Readings> m_readings;
};

/// The readings of a run once more, whatever drives; the last ones stay.
class ReplayedPlant : public devices::Plant {
public:
    explicit ReplayedPlant(std::shared_ptr<const Readings> readings) : m_readings(std::move(readings)) {}

    void read(std::span<float> readings) override {
        std::copy(m_readings->at(m_tick).begin(), m_readings->at(m_tick).end(), readings.begin());
        m_tick = std::min(m_tick + 1, m_readings->size() - 1);
    }
    void drive(std::span<const float>) override {}
    void advance(int) override {}
    hb_signal_table truth() const override { return {nullptr, 0, nullptr}; }

private:
    std::shared_ptr<const Readings> m_readings;
    std::size_t m_tick = 0;
};

/// A program built with the test.
inline std::string boardProgram(const std::string& actuator) {
    const auto test = std::filesystem::read_symlink("/proc/self/exe");
    return test.parent_path().parent_path() / "firmware" / ("mps2_" + actuator + ".elf");
}

/// A board and the master that talks to it, in the board's time.
struct Bench {
    std::shared_ptr<Mps2Board> emulated; ///< or none: the host's build
    std::unique_ptr<devices::Device> device;

    void wait(double time_s) {
        const auto waited = device->clock().waitFor(time_s);
        ASSERT_TRUE(waited) << waited.error().message;
    }
    void write(const std::vector<ParameterValue>& values) {
        const auto written = device->writeParameters(values);
        ASSERT_TRUE(written) << values.front().name << ": " << written.error().message;
    }
    double signal(const std::string& name) {
        const std::string names[] = {name};
        const auto values = device->readSignals(names);
        EXPECT_TRUE(values) << name;
        return values ? values->front() : NAN;
    }
    /// Every value on the device that can be written.
    std::vector<double> parameters() {
        std::vector<std::string> names;
        for (const ParameterSpec& spec : device->catalogue().parameters) {
            names.push_back(spec.name);
        }
        const auto values = device->readParameters(names);
        EXPECT_TRUE(values);
        return values ? *values : std::vector<double>{};
    }
    /// Keeps these signals at 1 kHz from now on.
    void record(const std::vector<std::string>& names, Recording& recording) {
        const auto started = device->startStream(
            {names, 1000.0}, [&recording](const SampleBlockPtr& block) { recording.append(*block); });
        ASSERT_TRUE(started) << started.error().message;
    }
};

inline Bench connect(std::unique_ptr<devices::Transport> line, std::shared_ptr<Mps2Board> emulated) {
    auto device = devices::openXcpDevice(std::move(line), {});
    EXPECT_TRUE(device) << device.error().message;
    return {std::move(emulated), device ? std::move(*device) : nullptr};
}

inline Bench emulatedBench(const std::string& actuator, std::unique_ptr<devices::Plant> plant,
                           PlantLine line) {
    auto made = Mps2Board::make(boardProgram(actuator), std::move(plant), line);
    EXPECT_TRUE(made) << made.error().message;
    std::shared_ptr<Mps2Board> board = made ? std::move(*made) : nullptr;
    return board ? connect(std::make_unique<Mps2Transport>(board), board) : Bench{};
}

/// Largest difference of one column.
inline double largestDifference(const Recording& one, const Recording& other, const std::string& name) {
    const std::vector<double> a = one.column(name);
    const std::vector<double> b = other.column(name);
    EXPECT_EQ(a.size(), b.size()) << name;
    double largest = 0.0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        largest = std::max(largest, std::abs(a[i] - b[i]));
    }
    return largest;
}

} // namespace halbench::mps2
