#include "devices/simulated/spherical/simulated_spherical.h"

#include "devices/simulated/override_table.h"
#include "devices/simulated/spherical/pose_table.h"
#include "models/spherical/orientation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

namespace halbench::devices {
namespace {

constexpr const char* PosesKey = "poses";

struct Truth {
    double angle_rad[3];
    double rate_rad_s[3];
    double strength_T;
    double magnet_degC;
};

#define TRUTH(name, unit, member, limit, text)                                                               \
    HB_SIGNAL(name, unit, HB_FLOAT64, Truth, member, 1.0F, -(limit), limit, nullptr, text)

const hb_signal TruthSignals[] = {
    TRUTH("truth.alpha", "rad", angle_rad[0], 3.2F,
          "True rotation about stator X, third, known to the simulation only"),
    TRUTH("truth.beta", "rad", angle_rad[1], 1.6F,
          "True rotation about stator Y, second, known to the simulation only"),
    TRUTH("truth.gamma", "rad", angle_rad[2], 3.2F,
          "True rotation about stator Z, first, known to the simulation only"),
    TRUTH("truth.rate.x", "rad/s", rate_rad_s[0], 1000.0F,
          "True rate about stator X, known to the simulation only"),
    TRUTH("truth.rate.y", "rad/s", rate_rad_s[1], 1000.0F,
          "True rate about stator Y, known to the simulation only"),
    TRUTH("truth.rate.z", "rad/s", rate_rad_s[2], 1000.0F,
          "True rate about stator Z, known to the simulation only"),
    TRUTH("truth.strength", "T", strength_T, 1.0F,
          "True strength q of the field tensor, known to the simulation only"),
    TRUTH("truth.temperature", "degC", magnet_degC, 500.0F,
          "True temperature of the magnet, known to the simulation only"),
};

class SphericalBoardPlant final : public Plant {
public:
    explicit SphericalBoardPlant(models::SphericalPlant plant) : m_plant(std::move(plant)) {}

    models::SphericalPlant& model() { return m_plant; }
    const models::SphericalPlant& model() const { return m_plant; }

    void read(std::span<float> readings) override {
        const models::SphericalTruth& truth = m_plant.truth();
        const models::OrientationAngles angles = models::anglesOf(truth.rotation);
        m_truth = {{angles.alpha_rad, angles.beta_rad, angles.gamma_rad},
                   {truth.rate_rad_s[0], truth.rate_rad_s[1], truth.rate_rad_s[2]},
                   truth.strength_T,
                   truth.magnet_degC};
        m_plant.read(readings);
    }
    void drive(std::span<const float>) override {} // nothing drives the rotor
    void advance(int subSteps) override { m_plant.advance(subSteps); }
    hb_signal_table truth() const override { return {TruthSignals, std::size(TruthSignals), &m_truth}; }

private:
    models::SphericalPlant m_plant;
    Truth m_truth{};
};

class SphericalFirmware final : public Firmware {
public:
    SphericalFirmware(const SphericalBoardPlant& plant, std::uint64_t seed, SimulatedBoard::Line line)
        : m_identity(fmt::format("sim-spherical-{}", seed)) {
        const hb_spherical_hardware hardware = hardwareOf(plant.model());
        m_stored = initialCalibration(plant.model().parameters());
        hb_board_config config{};
        config.device = m_identity.c_str();
        config.transport_a2l = line.a2l;
        config.max_dto = line.maxDto;
        config.extra = plant.truth();
        config.store = &SphericalFirmware::store;
        config.store_context = &m_stored;
        config.stored = &m_stored;
        hb_spherical_init(&m_spherical, &hardware, &config);
    }

    const hb_board& board() const override { return m_spherical.board; }

    void tick(std::span<const float> readings, std::span<float>) override {
        hb_spherical_inputs inputs{};
        std::copy_n(readings.begin(), HB_FIELD_CHANNELS, inputs.field_code);
        inputs.coil_current_A = readings[models::SphericalPlant::CurrentIndex];
        inputs.temperature_degC = readings[models::SphericalPlant::TemperatureIndex];
        hb_spherical_tick(&m_spherical, &inputs);
    }

private:
    static std::uint8_t store(void* context, const void* page) {
        *static_cast<hb_spherical_calibration*>(context) =
            *static_cast<const hb_spherical_calibration*>(page);
        return 1;
    }

    static hb_spherical_hardware hardwareOf(const models::SphericalPlant& plant) {
        const models::FieldConverter& converter = plant.converter();
        hb_spherical_hardware hardware{};
        hardware.field_T_per_code = static_cast<float>(converter.step_T);
        // An ideal chain has no ends.
        const double codes = std::round(converter.range_T / converter.step_T);
        hardware.highest_code = converter.isQuantised ? static_cast<float>(codes - 1.0) : HUGE_VALF;
        hardware.lowest_code = converter.isQuantised ? static_cast<float>(-codes) : -HUGE_VALF;
        return hardware;
    }

    // The factory's settings with what this board was built for: nominal places and the field of the design.
    // The errors of the sensors are for the user to find out.
    hb_spherical_calibration initialCalibration(const models::SphericalParameters& parameters) {
        hb_spherical_init(&m_spherical, nullptr, nullptr);
        hb_spherical_calibration page = m_spherical.pages[0];
        page.frames = static_cast<float>(parameters.frames);
        page.rotor.strength_T = static_cast<float>(models::rotorFieldOf(parameters).strength_T);
        page.drift_per_K = static_cast<float>(parameters.strengthTemperature_per_K);
        for (std::size_t i = 0; i < HB_FIELD_SENSORS; ++i) {
            const models::PlacementAngles& place = parameters.placement[i];
            page.sensors.alpha_rad[i] = static_cast<float>(place.alpha_rad);
            page.sensors.beta_rad[i] = static_cast<float>(place.beta_rad);
            page.sensors.gamma_rad[i] = static_cast<float>(place.gamma_rad);
            page.sensors.radius_m[i] = static_cast<float>(parameters.sensorRadius_m);
        }
        return page;
    }

    hb_spherical m_spherical{};
    hb_spherical_calibration m_stored{};
    std::string m_identity;
};

std::string knownKeys() {
    return models::sphericalParameterKeys() + ", " + PosesKey;
}

struct Setup {
    models::SphericalParameters parameters;
    models::RotorMotionConfig motion;
};

Result<Setup> setupOf(Overrides overrides) {
    const auto poses = std::find_if(overrides.begin(), overrides.end(),
                                    [](const auto& row) { return row.first == PosesKey; });
    std::optional<std::string> path;
    if (poses != overrides.end()) {
        path = poses->second;
        overrides.erase(poses);
    }
    const OverrideTable<models::SphericalParameters> table = {
        "sim:spherical",
        knownKeys(),
        [](std::string_view key) { return models::findSphericalParameter(key) != nullptr; },
        &models::setSphericalParameter,
        [](models::SphericalParameters parameters) { return models::withoutImperfections(parameters); },
        [](models::SphericalParameters parameters) { return models::withIdealChain(parameters); }};
    const Result<models::SphericalParameters> parameters = withOverrides(table, overrides);
    if (!parameters) {
        return failure(parameters.error());
    }
    Setup setup{*parameters, models::motionOf(*parameters)};
    if (path) {
        auto poseTable = readPoseTable(*path);
        if (!poseTable) {
            return failure(poseTable.error());
        }
        setup.motion.kind = models::MotionKind::Table;
        setup.motion.table = *std::move(poseTable);
    }
    if (auto checked = models::checkSphericalParameters(setup.parameters); !checked) {
        return failure(checked.error());
    }
    return setup;
}

} // namespace

SimulatedModel sphericalModel() {
    SimulatedModel model;
    model.name = "spherical";
    model.title = "Spherical motor, orientation sensing";
    model.overrides = knownKeys();
    model.keys = overrideSpecs(models::sphericalParameterSpecs(), [](std::string_view key) {
        return models::sphericalParameter(models::SphericalParameters{}, key);
    });
    OverrideSpec poses;
    poses.key = PosesKey;
    poses.meaning = "motion: CSV file of poses";
    poses.isText = true;
    model.keys.push_back(poses);
    model.check = [](const Overrides& overrides) -> Result<void> {
        const Result<Setup> setup = setupOf(overrides);
        return setup ? Result<void>() : failure(setup.error());
    };
    model.make = [](const Overrides& overrides, std::uint64_t seed,
                    SimulatedBoard::Line line) -> Result<std::unique_ptr<SimulatedBoard>> {
        const Result<Setup> setup = setupOf(overrides);
        if (!setup) {
            return failure(setup.error());
        }
        Result<models::SphericalPlant> physics =
            models::SphericalPlant::make(setup->parameters, setup->motion, seed);
        if (!physics) {
            return failure(physics.error());
        }
        auto plant = std::make_unique<SphericalBoardPlant>(std::move(*physics));
        auto firmware = std::make_unique<SphericalFirmware>(*plant, seed, line);
        return std::make_unique<SimulatedBoard>(SimulatedActuator{std::move(plant), std::move(firmware),
                                                                  models::SphericalPlant::ReadingCount, 0});
    };
    return model;
}

const hb_spherical& sphericalFirmware(const SimulatedBoard& board) {
    return *static_cast<const hb_spherical*>(board.firmware().context);
}

models::SphericalPlant& sphericalPlant(SimulatedBoard& board) {
    return static_cast<SphericalBoardPlant&>(board.plant()).model();
}

} // namespace halbench::devices
