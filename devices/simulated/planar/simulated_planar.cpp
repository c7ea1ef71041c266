#include "devices/simulated/planar/simulated_planar.h"

#include "devices/simulated/override_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::devices {
namespace {

struct Truth {
    double position[3];
    double speed[3];
    double effort[3];
};

#define TRUTH(name, unit, member, limit, text)                                                               \
    HB_SIGNAL(name, unit, HB_FLOAT64, Truth, member, 1.0F, -(limit), limit, nullptr, text)

const hb_signal TruthSignals[] = {
    TRUTH("truth.position.x", "m", position[0], 10.0F, "True pose along x, known to the simulation only"),
    TRUTH("truth.position.y", "m", position[1], 10.0F, "True pose along y, known to the simulation only"),
    TRUTH("truth.position.phi", "rad", position[2], 3.2F, "True rotation, known to the simulation only"),
    TRUTH("truth.speed.x", "m/s", speed[0], 10.0F, "True speed along x, known to the simulation only"),
    TRUTH("truth.speed.y", "m/s", speed[1], 10.0F, "True speed along y, known to the simulation only"),
    TRUTH("truth.speed.phi", "rad/s", speed[2], 100.0F,
          "True speed of rotation, known to the simulation only"),
    TRUTH("truth.effort.x", "N", effort[0], 100.0F,
          "True force of the coils along x, known to the simulation only"),
    TRUTH("truth.effort.y", "N", effort[1], 100.0F,
          "True force of the coils along y, known to the simulation only"),
    TRUTH("truth.effort.phi", "N*m", effort[2], 10.0F,
          "True torque of the coils, known to the simulation only"),
};

class PlanarBoardPlant final : public Plant {
public:
    explicit PlanarBoardPlant(models::PlanarPlant plant) : m_plant(std::move(plant)) {}

    models::PlanarPlant& model() { return m_plant; }
    const models::PlanarPlant& model() const { return m_plant; }

    void read(std::span<float> readings) override {
        const models::PlanarTruth& truth = m_plant.truth();
        const models::PlatenState& platen = truth.platen;
        m_truth = {{platen.pose.x_m, platen.pose.y_m, platen.pose.angle_rad},
                   {platen.velocity.x_m_s, platen.velocity.y_m_s, platen.velocity.angle_rad_s},
                   {truth.wrench.forceX_N, truth.wrench.forceY_N, truth.wrench.torque_Nm}};
        m_plant.read(readings);
    }
    void drive(std::span<const float> outputs) override { m_plant.drive(outputs); }
    void advance(int subSteps) override { m_plant.advance(subSteps); }
    hb_signal_table truth() const override { return {TruthSignals, std::size(TruthSignals), &m_truth}; }

private:
    models::PlanarPlant m_plant;
    Truth m_truth{};
};

class PlanarFirmware final : public Firmware {
public:
    PlanarFirmware(const PlanarBoardPlant& plant, std::uint64_t seed, SimulatedBoard::Line line)
        : m_identity(fmt::format("sim-planar-{}", seed)) {
        const hb_planar_hardware hardware = hardwareOf(plant.model());
        m_stored = initialCalibration(plant.model().parameters());
        hb_board_config config{};
        config.device = m_identity.c_str();
        config.transport_a2l = line.a2l;
        config.max_dto = line.maxDto;
        config.extra = plant.truth();
        config.store = &PlanarFirmware::store;
        config.store_context = &m_stored;
        config.stored = &m_stored;
        hb_planar_init(&m_planar, &hardware, &config);
    }

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
    static std::uint8_t store(void* context, const void* page) {
        *static_cast<hb_planar_calibration*>(context) = *static_cast<const hb_planar_calibration*>(page);
        return 1;
    }

    static hb_planar_hardware hardwareOf(const models::PlanarPlant& plant) {
        const models::PlanarParameters& parameters = plant.parameters();
        hb_planar_hardware hardware{};
        hardware.adc_V_per_code = static_cast<float>(models::adcStep_V(plant.adc()));
        hardware.adc_lowest_V = static_cast<float>(-parameters.adcRange_V);
        hardware.adc_last_code = std::ldexp(1.0F, plant.adc().bits) - 1.0F;
        hardware.field_V_per_T = static_cast<float>(parameters.hallSensitivity_V_per_T);
        hardware.dac_codes_per_A =
            static_cast<float>(1.0 / (models::dacStep_V(plant.dac()) * parameters.amplifierGain_A_per_V));
        hardware.dac_zero_code = static_cast<float>(models::exactDacCode(plant.dac(), 0.0));
        return hardware;
    }

    // The factory's settings with what this board was built for: the nominal geometry, its limit and delay.
    // Mass, forces and the chips' errors are for the user to find out.
    hb_planar_calibration initialCalibration(const models::PlanarParameters& parameters) {
        hb_planar_init(&m_planar, nullptr, nullptr);
        hb_planar_calibration page = m_planar.pages[0];
        page.coils.pitch_m = static_cast<float>(parameters.geometry.matrix.pitch_m);
        page.coils.coil_width_m = static_cast<float>(parameters.geometry.winding.width_m);
        page.coils.arm56_m = static_cast<float>(parameters.geometry.arm56_m);
        page.limit_current_A = static_cast<float>(parameters.currentLimit_A);
        page.delay_samples = static_cast<float>(parameters.delaySamples);
        for (std::size_t j = 0; j < HB_CHIPS; ++j) {
            page.chips.amplitude_T[j] = static_cast<float>(parameters.hallField_T);
            page.chips.place_x_m[j] = static_cast<float>(parameters.chipX_m[j]);
            page.chips.place_y_m[j] = static_cast<float>(parameters.chipY_m[j]);
        }
        return page;
    }

    hb_planar m_planar{};
    hb_planar_calibration m_stored{};
    std::string m_identity;
};

// A key and its symbol are one value: none of two that are written is the one that is meant.
Result<void> checkWrittenOnce(const Overrides& overrides) {
    for (const models::PlanarSymbol& symbol : models::planarSymbols()) {
        const auto isWritten = [&overrides](std::string_view key) {
            return std::any_of(overrides.begin(), overrides.end(),
                               [key](const auto& each) { return each.first == key; });
        };
        if (isWritten(symbol.symbol) && isWritten(symbol.key)) {
            return failure(ErrorCode::InvalidInput,
                           fmt::format("{} and {} are the same value", symbol.symbol, symbol.key),
                           "Give one of them.");
        }
    }
    return {};
}

Result<models::PlanarParameters> planarParameters(const Overrides& overrides) {
    if (auto checked = checkWrittenOnce(overrides); !checked) {
        return failure(checked.error());
    }
    const OverrideTable<models::PlanarParameters> table = {
        "sim:planar",
        models::planarParameterKeys(),
        [](std::string_view key) { return models::findPlanarParameter(key) != nullptr; },
        &models::setPlanarParameter,
        [](models::PlanarParameters parameters) { return models::withoutImperfections(parameters); },
        [](models::PlanarParameters parameters) { return models::withIdealChain(parameters); },
        &models::planarParameterWords};
    return withOverrides(table, overrides);
}

} // namespace

SimulatedModel planarModel() {
    SimulatedModel model;
    model.name = "planar";
    model.title = "Planar six-coil positioner";
    model.overrides = models::planarParameterKeys();
    model.keys = overrideSpecs(
        models::planarParameterSpecs(),
        [](std::string_view key) { return models::planarParameter(models::PlanarParameters{}, key); },
        &models::planarParameterWords);
    model.check = [](const Overrides& overrides) -> Result<void> {
        const Result<models::PlanarParameters> parameters = planarParameters(overrides);
        return parameters ? models::checkPlanarParameters(*parameters) : failure(parameters.error());
    };
    model.make = [](const Overrides& overrides, std::uint64_t seed,
                    SimulatedBoard::Line line) -> Result<std::unique_ptr<SimulatedBoard>> {
        const Result<models::PlanarParameters> parameters = planarParameters(overrides);
        if (!parameters) {
            return failure(parameters.error());
        }
        Result<models::PlanarPlant> physics = models::PlanarPlant::make(*parameters, seed);
        if (!physics) {
            return failure(physics.error());
        }
        auto plant = std::make_unique<PlanarBoardPlant>(std::move(*physics));
        auto firmware = std::make_unique<PlanarFirmware>(*plant, seed, line);
        return std::make_unique<SimulatedBoard>(SimulatedActuator{std::move(plant), std::move(firmware),
                                                                  models::PlanarPlant::ReadingCount,
                                                                  models::PlanarPlant::DriveCount});
    };
    return model;
}

const hb_planar& planarFirmware(const SimulatedBoard& board) {
    return *static_cast<const hb_planar*>(board.firmware().context);
}

const models::PlanarTruth& planarTruth(const SimulatedBoard& board) {
    return static_cast<const PlanarBoardPlant&>(board.plant()).model().truth();
}

void setChipFault(SimulatedBoard& board, int chip, models::ChipFault fault) {
    static_cast<PlanarBoardPlant&>(board.plant()).model().setFault(chip, fault);
}

} // namespace halbench::devices
