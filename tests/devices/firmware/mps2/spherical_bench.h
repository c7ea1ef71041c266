#pragma once

#include "devices/simulated/spherical/simulated_spherical.h"
#include "models/spherical/spherical_plant.h"
#include "tests/devices/firmware/mps2/mps2_fixture.h"

namespace halbench::mps2 {

/// The rotor that moves as prescribed, and its sensors, of which channels clip for a while.
class RotorPlant : public devices::Plant {
public:
    struct Clipping {
        std::size_t channel = 0;
        std::uint64_t from = 0, to = 0; ///< ticks
    };
    static constexpr float LastCode = 2047.0F;

    RotorPlant(models::SphericalPlant plant, std::vector<Clipping> clippings)
        : m_plant(std::move(plant)), m_clippings(std::move(clippings)) {}

    void read(std::span<float> readings) override {
        m_plant.read(readings);
        for (const Clipping& clipping : m_clippings) {
            if (clipping.from <= m_tick && m_tick < clipping.to) {
                readings[clipping.channel] = LastCode;
            }
        }
        ++m_tick;
    }
    void drive(std::span<const float>) override {}
    void advance(int subSteps) override { m_plant.advance(subSteps); }
    hb_signal_table truth() const override { return {nullptr, 0, nullptr}; }

private:
    models::SphericalPlant m_plant;
    std::vector<Clipping> m_clippings;
    std::uint64_t m_tick = 0;
};

/// The board's C built for the host.
class HostSpherical : public devices::Firmware {
public:
    HostSpherical() { hb_spherical_init(&m_spherical, nullptr, nullptr); }
    const hb_board& board() const override { return m_spherical.board; }
    void tick(std::span<const float> readings, std::span<float>) override {
        hb_spherical_inputs inputs{};
        std::copy_n(readings.begin(), HB_FIELD_CHANNELS, inputs.field_code);
        inputs.coil_current_A = readings[models::SphericalPlant::CurrentIndex];
        inputs.temperature_degC = readings[models::SphericalPlant::TemperatureIndex];
        hb_spherical_tick(&m_spherical, &inputs);
    }

private:
    hb_spherical m_spherical{};
};

inline constexpr PlantLine SphericalLine{HB_FIELD_CHANNELS, 2, 0, 4};

/// Tumbling fast, so that a short run sees many orientations.
inline std::unique_ptr<devices::Plant> rotorPlant(std::vector<RotorPlant::Clipping> clippings,
                                                  std::shared_ptr<Readings> readings) {
    models::SphericalParameters parameters;
    parameters.motion = static_cast<double>(models::MotionKind::Tumble);
    parameters.tumbleFrequency_Hz = 3.0;
    parameters.rate_rad_s = 20.0;
    parameters.coilCurrent_A = 2.0;
    auto physics = models::SphericalPlant::make(parameters, 1);
    EXPECT_TRUE(physics) << physics.error().message;
    return std::make_unique<WatchedPlant>(
        std::make_unique<RotorPlant>(std::move(*physics), std::move(clippings)), std::move(readings));
}

/// The host's build at the readings of another run.
inline Bench sphericalHostBench(std::shared_ptr<const Readings> readings) {
    auto board = std::make_shared<devices::SimulatedBoard>(devices::SimulatedActuator{
        std::make_unique<ReplayedPlant>(std::move(readings)), std::make_unique<HostSpherical>(),
        models::SphericalPlant::ReadingCount, 0});
    return connect(std::make_unique<devices::LoopbackTransport>(std::move(board), false), nullptr);
}

} // namespace halbench::mps2
