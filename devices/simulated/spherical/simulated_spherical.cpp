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
constexpr const char* NoiseKey = "noise";

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

/// What a host may change while the simulation runs.
struct Settings {
    float angle_rad[3] = {};
    float rate_rad_s = 1.0F;
    float coilCurrent_A = 0.0F;
    std::uint8_t fault[9] = {};
};

constexpr float HalfTurn = 3.1415927F;
constexpr float SlowestRate_rad_s = 1.7e-4F; // 0.01 to 10 000 degrees a second, as the key rate_deg_s
constexpr float FastestRate_rad_s = 174.6F;

#define SETTING(name, unit, member, lower, upper, text)                                                      \
    HB_PARAM(HB_EXTRA, name, unit, HB_FLOAT32, Settings, member, 0.0F, lower, upper, nullptr, text)
#define FAULT(name, channel)                                                                                 \
    HB_PARAM(HB_EXTRA, name, "", HB_UBYTE, Settings, fault[channel], 0.0F, 0.0F, 3.0F,                       \
             "none|dead|stuck|clipped", "Fault of this channel, of a simulation only")

const hb_parameter SettingTable[] = {
    SETTING("simulation.alpha", "rad", angle_rad[0], -HalfTurn, HalfTurn,
            "Set-point of the rotation about X; a change ends another motion"),
    SETTING("simulation.beta", "rad", angle_rad[1], -0.5F * HalfTurn, 0.5F * HalfTurn,
            "Set-point of the rotation about Y; a change ends another motion"),
    SETTING("simulation.gamma", "rad", angle_rad[2], -HalfTurn, HalfTurn,
            "Set-point of the rotation about Z; a change ends another motion"),
    SETTING("simulation.rate", "rad/s", rate_rad_s, SlowestRate_rad_s, FastestRate_rad_s,
            "Largest rate towards the set-point"),
    SETTING("simulation.coil_current", "A", coilCurrent_A, -100.0F, 100.0F,
            "Current that the simulation drives through the coil"),
    FAULT("simulation.fault.0.r", 0),
    FAULT("simulation.fault.0.theta", 1),
    FAULT("simulation.fault.0.phi", 2),
    FAULT("simulation.fault.1.r", 3),
    FAULT("simulation.fault.1.theta", 4),
    FAULT("simulation.fault.1.phi", 5),
    FAULT("simulation.fault.2.r", 6),
    FAULT("simulation.fault.2.theta", 7),
    FAULT("simulation.fault.2.phi", 8),
};

Settings startOf(const models::SphericalParameters& parameters) {
    Settings settings;
    settings.angle_rad[0] = static_cast<float>(parameters.start.alpha_rad);
    settings.angle_rad[1] = static_cast<float>(parameters.start.beta_rad);
    settings.angle_rad[2] = static_cast<float>(parameters.start.gamma_rad);
    settings.rate_rad_s = static_cast<float>(parameters.rate_rad_s);
    settings.coilCurrent_A = static_cast<float>(parameters.coilCurrent_A);
    std::transform(parameters.fault.begin(), parameters.fault.end(), std::begin(settings.fault),
                   [](double fault) { return static_cast<std::uint8_t>(fault); });
    return settings;
}

class SphericalBoardPlant final : public Plant {
public:
    explicit SphericalBoardPlant(models::SphericalPlant plant)
        : m_plant(std::move(plant)), m_settings(startOf(m_plant.parameters())), m_applied(m_settings) {}

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
    void advance(int subSteps) override {
        applySettings();
        m_plant.advance(subSteps);
    }
    hb_parameter_table settings() override {
        return {SettingTable, reinterpret_cast<std::uint8_t*>(&m_settings), std::size(SettingTable),
                offsetof(Settings, fault) + sizeof Settings::fault}; // without padding
    }
    hb_signal_table truth() const override { return {TruthSignals, std::size(TruthSignals), &m_truth}; }

private:
    // Only what a host has changed: values of an address are doubles and go on as they are.
    void applySettings() {
        const float(&angle_rad)[3] = m_settings.angle_rad;
        const bool isSame = std::equal(std::begin(angle_rad), std::end(angle_rad), m_applied.angle_rad);
        if (!isSame) {
            m_plant.turnTo({angle_rad[0], angle_rad[1], angle_rad[2]}, m_settings.rate_rad_s);
        } else if (m_settings.rate_rad_s != m_applied.rate_rad_s) {
            m_plant.setRate(m_settings.rate_rad_s);
        }
        if (m_settings.coilCurrent_A != m_applied.coilCurrent_A) {
            m_plant.setCoilCurrent_A(m_settings.coilCurrent_A);
        }
        for (std::size_t i = 0; i < std::size(m_settings.fault); ++i) {
            if (m_settings.fault[i] != m_applied.fault[i]) {
                m_plant.setFault(static_cast<int>(i), static_cast<models::ChannelFault>(m_settings.fault[i]));
            }
        }
        m_applied = m_settings;
    }

    models::SphericalPlant m_plant;
    Settings m_settings;
    Settings m_applied;
    Truth m_truth{};
};

class SphericalFirmware final : public Firmware {
public:
    SphericalFirmware(SphericalBoardPlant& plant, std::uint64_t seed, SimulatedBoard::Line line)
        : m_identity(fmt::format("sim-spherical-{}", seed)) {
        const hb_spherical_hardware hardware = hardwareOf(plant.model());
        m_stored = initialCalibration(plant.model().parameters());
        hb_board_config config{};
        config.device = m_identity.c_str();
        config.transport_a2l = line.a2l;
        config.max_dto = line.maxDto;
        config.extra = plant.truth();
        config.extra_parameters = plant.settings();
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
        [](models::SphericalParameters parameters) { return models::withIdealChain(parameters); },
        &models::sphericalParameterWords};
    // A preset is the start; the value itself wins over it, in any order.
    std::stable_partition(overrides.begin(), overrides.end(),
                          [](const auto& row) { return row.first == NoiseKey; });
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
    model.keys = overrideSpecs(
        models::sphericalParameterSpecs(),
        [](std::string_view key) { return models::sphericalParameter(models::SphericalParameters{}, key); },
        &models::sphericalParameterWords);
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
