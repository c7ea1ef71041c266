#pragma once

#include "devices/firmware/planar/hb_planar.h"
#include "models/planar/planar_plant.h"
#include "tests/devices/firmware/mps2/mps2_fixture.h"

namespace halbench::mps2 {

/// The positioner's physics with a chip that fails at a given tick.
class PlatenPlant : public devices::Plant {
public:
    struct Failure {
        std::uint64_t tick = 0;
        int chip = 0;
        models::ChipFault fault = models::ChipFault::None;
    };

    PlatenPlant(models::PlanarPlant plant, std::vector<Failure> failures)
        : m_plant(std::move(plant)), m_failures(std::move(failures)) {}

    void read(std::span<float> readings) override {
        for (const Failure& failure : m_failures) {
            if (failure.tick == m_tick) {
                m_plant.setFault(failure.chip, failure.fault);
            }
        }
        ++m_tick;
        m_plant.read(readings);
    }
    void drive(std::span<const float> outputs) override { m_plant.drive(outputs); }
    void advance(int subSteps) override { m_plant.advance(subSteps); }
    hb_signal_table truth() const override { return {nullptr, 0, nullptr}; }

private:
    models::PlanarPlant m_plant;
    std::vector<Failure> m_failures;
    std::uint64_t m_tick = 0;
};

/// The board's C built for the host.
class HostPlanar : public devices::Firmware {
public:
    HostPlanar() { hb_planar_init(&m_planar, nullptr, nullptr); }
    const hb_board& board() const override { return m_planar.board; }
    void tick(std::span<const float> readings, std::span<float> outputs) override {
        hb_planar_inputs inputs{};
        std::copy_n(readings.begin(), HB_CHIP_FIELDS, inputs.field_code);
        std::copy_n(readings.begin() + HB_CHIP_FIELDS, HB_COILS, inputs.temperature_code);
        hb_planar_outputs driven{};
        hb_planar_tick(&m_planar, &inputs, &driven);
        std::copy_n(driven.dac_code, HB_COILS, outputs.begin());
    }

private:
    hb_planar m_planar{};
};

inline constexpr PlantLine PlanarLine{models::PlanarPlant::ReadingCount, 0, models::PlanarPlant::DriveCount,
                                      4};

inline std::unique_ptr<devices::Plant> platenPlant(std::vector<PlatenPlant::Failure> failures = {},
                                                   std::shared_ptr<Readings> readings = nullptr) {
    auto physics = models::PlanarPlant::make(models::PlanarParameters{}, 1);
    EXPECT_TRUE(physics) << physics.error().message;
    std::unique_ptr<devices::Plant> plant =
        std::make_unique<PlatenPlant>(std::move(*physics), std::move(failures));
    if (readings) {
        plant = std::make_unique<WatchedPlant>(std::move(plant), std::move(readings));
    }
    return plant;
}

/// The host's build at the readings of another run.
inline Bench planarHostBench(std::shared_ptr<const Readings> readings) {
    auto board = std::make_shared<devices::SimulatedBoard>(devices::SimulatedActuator{
        std::make_unique<ReplayedPlant>(std::move(readings)), std::make_unique<HostPlanar>(),
        models::PlanarPlant::ReadingCount, models::PlanarPlant::DriveCount});
    return connect(std::make_unique<devices::LoopbackTransport>(std::move(board), false), nullptr);
}

} // namespace halbench::mps2
