#include "devices/simulated/htm/simulated_htm.h"

#include "control/base/units.h"
#include "devices/simulated/override_table.h"
#include "models/htm/htm_plant.h"

#include <fmt/format.h>

#include <cmath>

namespace halbench::devices {
namespace {

struct Truth {
    double position_rad;
    double speed_rad_s;
};

const hb_signal TruthSignals[2] = {
    HB_SIGNAL("truth.position", "rad", HB_FLOAT64, Truth, position_rad, 1.0F, -1e6F, 1e6F, nullptr,
              "True rotor angle, known to the simulation only"),
    HB_SIGNAL("truth.speed", "rad/s", HB_FLOAT64, Truth, speed_rad_s, 1.0F, -1e3F, 1e3F, nullptr,
              "True rotor speed, known to the simulation only"),
};

enum Reading { HallA = HtmHallReading, HallB, TemperatureA, TemperatureB, ReadingCount };
enum Output { DacA, DacB, Amplitude, IsEnabled, OutputCount };

/// The motor as its board sees it. Looks at the board for what a real motor does by itself: friction differs
/// from one run to the next.
class HtmBoardPlant final : public Plant {
public:
    explicit HtmBoardPlant(models::HtmPlant plant) : m_plant(std::move(plant)) {}

    void watch(const hb_htm& motor) { m_motor = &motor; }
    const models::HtmParameters& parameters() const { return m_plant.parameters(); }

    void read(std::span<float> readings) override {
        updateTruth();
        const models::HtmReadings codes = m_plant.read();
        readings[HallA] = static_cast<float>(codes.hallCode[0]);
        readings[HallB] = static_cast<float>(codes.hallCode[1]);
        readings[TemperatureA] = static_cast<float>(codes.temperatureCode[0]);
        readings[TemperatureB] = static_cast<float>(codes.temperatureCode[1]);
    }

    void drive(std::span<const float> outputs) override {
        redrawFrictionAtNewSegment();
        models::HtmDrive drive;
        if (outputs[IsEnabled] != 0.0F) {
            drive.dacCode = {static_cast<double>(outputs[DacA]), static_cast<double>(outputs[DacB])};
            drive.amplitude_A = static_cast<double>(outputs[Amplitude]);
        }
        m_plant.drive(drive);
        if (!m_isCounting) {
            startCountingTurns();
        }
    }

    void advance(int subSteps) override { m_plant.advance(subSteps); }
    hb_signal_table truth() const override { return {TruthSignals, 2, &m_truth}; }

private:
    void updateTruth() {
        m_truth.position_rad = m_plant.truth().rotor.angle_rad - m_turns_rad;
        m_truth.speed_rad_s = m_plant.truth().rotor.speed_rad_s;
    }

    // The board starts counting turns within half a turn of its first reading; truth counts the same ones.
    void startCountingTurns() {
        const double board_rad = m_motor->signals.position * (2.0 * Pi / HB_HTM_COUNTS_PER_TURN);
        m_turns_rad = 2.0 * Pi * std::round((m_truth.position_rad - board_rad) / (2.0 * Pi));
        m_isCounting = true;
        updateTruth();
    }

    // A generator that is started again while it runs counts from segment 1 anew: its ticks fall back,
    // although the segment may be the same.
    void redrawFrictionAtNewSegment() {
        const bool isRestarted =
            m_motor->reference.running != 0 && m_motor->reference.ticks < m_referenceTicks;
        m_referenceTicks = m_motor->reference.ticks;
        if (m_motor->signals.board.reference_segment != m_segment || isRestarted) {
            m_segment = m_motor->signals.board.reference_segment;
            m_plant.redrawFriction();
        }
    }

    models::HtmPlant m_plant;
    const hb_htm* m_motor = nullptr;
    Truth m_truth{};
    double m_turns_rad = 0.0; ///< whole turns between the plant's angle and the board's
    bool m_isCounting = false;
    std::uint16_t m_segment = 0;
    std::uint32_t m_referenceTicks = 0;
};

class HtmFirmware final : public Firmware {
public:
    HtmFirmware(const HtmBoardPlant& plant, std::uint64_t seed, SimulatedBoard::Line line)
        : m_identity(fmt::format("sim-htm-{}", seed)) {
        m_stored = initialCalibration(plant.parameters());
        hb_htm_config config{};
        config.device = m_identity.c_str();
        config.transport_a2l = line.a2l;
        config.max_dto = line.maxDto;
        config.extra = plant.truth();
        config.store = &HtmFirmware::store;
        config.store_context = &m_stored;
        config.stored = &m_stored;
        hb_htm_init(&m_motor, &config);
    }

    const hb_htm& motor() const { return m_motor; }
    const hb_board& board() const override { return m_motor.board; }

    void tick(std::span<const float> readings, std::span<float> outputs) override {
        const hb_htm_inputs inputs = {{readings[HallA], readings[HallB]},
                                      {readings[TemperatureA], readings[TemperatureB]}};
        hb_htm_outputs driven{};
        hb_htm_fast_tick(&m_motor, &inputs, &driven);
        outputs[DacA] = driven.dac_code[0];
        outputs[DacB] = driven.dac_code[1];
        outputs[Amplitude] = driven.current_command_A;
        outputs[IsEnabled] = driven.output_enabled;
    }

private:
    static std::uint8_t store(void* context, const void* page) {
        *static_cast<hb_htm_calibration*>(context) = *static_cast<const hb_htm_calibration*>(page);
        return 1;
    }

    // The factory's settings (preset "published") with what this board was built for: its current limit, its
    // computation delay, and no stray compensation in a motor that has no stray field.
    hb_htm_calibration initialCalibration(const models::HtmParameters& parameters) {
        hb_htm_init(&m_motor, nullptr);
        hb_htm_calibration page = m_motor.pages[0];
        page.limit_current = static_cast<float>(parameters.currentLimit_A);
        page.delay_samples = static_cast<float>(parameters.delaySamples);
        if (parameters.stray_T_per_A == 0.0) {
            page.stray_coefficient = 0.0F;
        }
        return page;
    }

    hb_htm m_motor{};
    hb_htm_calibration m_stored{};
    std::string m_identity;
};

} // namespace

Result<models::HtmParameters> htmParameters(const Overrides& overrides) {
    const OverrideTable<models::HtmParameters> table = {
        "sim:htm",
        models::htmParameterKeys(),
        [](std::string_view key) { return models::findHtmParameter(key) != nullptr; },
        &models::setHtmParameter,
        [](models::HtmParameters parameters) { return models::withoutImperfections(parameters); },
        [](models::HtmParameters parameters) { return models::withIdealChain(parameters); }};
    return withOverrides(table, overrides);
}

Result<std::unique_ptr<SimulatedBoard>> makeSimulatedHtm(const models::HtmParameters& parameters,
                                                         std::uint64_t seed, SimulatedBoard::Line line) {
    Result<models::HtmPlant> model = models::HtmPlant::make(parameters, seed);
    if (!model) {
        return failure(model.error());
    }
    auto plant = std::make_unique<HtmBoardPlant>(std::move(*model));
    auto firmware = std::make_unique<HtmFirmware>(*plant, seed, line);
    plant->watch(firmware->motor());
    return std::make_unique<SimulatedBoard>(
        SimulatedActuator{std::move(plant), std::move(firmware), ReadingCount, OutputCount});
}

SimulatedModel htmModel() {
    SimulatedModel model;
    model.name = "htm";
    model.title = "Two-phase Halbach-cylinder motor";
    model.overrides = models::htmParameterKeys();
    model.keys = overrideSpecs(models::htmParameterSpecs(), [](std::string_view key) {
        return models::htmParameter(models::HtmParameters{}, key);
    });
    model.check = [](const Overrides& overrides) -> Result<void> {
        const Result<models::HtmParameters> parameters = htmParameters(overrides);
        return parameters ? Result<void>() : failure(parameters.error());
    };
    model.make = [](const Overrides& overrides, std::uint64_t seed,
                    SimulatedBoard::Line line) -> Result<std::unique_ptr<SimulatedBoard>> {
        const Result<models::HtmParameters> parameters = htmParameters(overrides);
        if (!parameters) {
            return failure(parameters.error());
        }
        return makeSimulatedHtm(*parameters, seed, line);
    };
    return model;
}

const hb_htm& htmFirmware(const SimulatedBoard& board) {
    return *static_cast<const hb_htm*>(board.firmware().context);
}

} // namespace halbench::devices
