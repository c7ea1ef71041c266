#include "tests/conformance/stage/stage_model.h"

#include "devices/simulated/override_table.h"
#include "tests/conformance/stage/stage_board.h"

#include <array>
#include <cmath>

namespace halbench::devices {
namespace {

struct StageParameters {
    double mass_kg[STAGE_AXES] = {0.2, 0.5};
    double friction_N = 0.05; ///< of axis b
};

struct Truth {
    double position_m[STAGE_AXES];
};

const hb_signal TruthSignals[STAGE_AXES] = {HB_SIGNAL("truth.position.a", "m", HB_FLOAT64, Truth,
                                                      position_m[0], 1.0F, -10.0F, 10.0F, nullptr, "True"),
                                            HB_SIGNAL("truth.position.b", "m", HB_FLOAT64, Truth,
                                                      position_m[1], 1.0F, -10.0F, 10.0F, nullptr, "True")};

/// m x'' + 0.4 N s/m x' = 5 N/A i, on axis b less Coulomb friction; currents follow at once.
class StagePlant final : public Plant {
public:
    explicit StagePlant(const StageParameters& parameters) : m_parameters(parameters) {}

    void read(std::span<float> readings) override {
        for (std::size_t i = 0; i < STAGE_AXES; ++i) {
            readings[i] = static_cast<float>(m_truth.position_m[i]);
        }
    }
    void drive(std::span<const float> outputs) override { m_current_A = {outputs[0], outputs[1]}; }
    void advance(int subSteps) override {
        constexpr double Step_s = 0.25e-3;
        constexpr double Damping_Ns_per_m = 0.4;
        for (int step = 0; step < subSteps; ++step) {
            for (std::size_t i = 0; i < STAGE_AXES; ++i) {
                double& speed = m_speed_m_s[i];
                const double drive_N = STAGE_FORCE_N_PER_A * m_current_A[i] - Damping_Ns_per_m * speed;
                speed += drive_N / m_parameters.mass_kg[i] * Step_s;
                const double held_m_s =
                    (i == 1 ? m_parameters.friction_N : 0.0) / m_parameters.mass_kg[i] * Step_s;
                speed = std::copysign(std::max(std::fabs(speed) - held_m_s, 0.0), speed);
                m_truth.position_m[i] += speed * Step_s;
            }
        }
    }
    hb_signal_table truth() const override { return {TruthSignals, STAGE_AXES, &m_truth}; }

private:
    StageParameters m_parameters;
    Truth m_truth{};
    std::array<double, STAGE_AXES> m_speed_m_s{};
    std::array<float, STAGE_AXES> m_current_A{};
};

class StageFirmware final : public Firmware {
public:
    StageFirmware(const Plant& plant, SimulatedBoard::Line line) {
        hb_board_config config{};
        config.device = "sim-stage";
        config.transport_a2l = line.a2l;
        config.max_dto = line.maxDto;
        config.extra = plant.truth();
        stage_board_init(&m_stage, &config);
    }
    const hb_board& board() const override { return m_stage.board; }
    void tick(std::span<const float> readings, std::span<float> outputs) override {
        hb_board_tick(&m_stage.board, readings.data());
        std::copy_n(m_stage.signals.current_A, STAGE_AXES, outputs.begin());
    }

private:
    stage_board m_stage{};
};

Result<StageParameters> stageParameters(const Overrides& overrides) {
    const auto unchanged = [](StageParameters parameters) { return parameters; };
    const OverrideTable<StageParameters> table = {
        "sim:stage",
        "ma, mb, friction, seed, imperfections, chain",
        [](std::string_view key) { return key == "ma" || key == "mb" || key == "friction"; },
        [](StageParameters& parameters, std::string_view key, double value) -> Result<void> {
            if (!(value >= 0.0) || (key != "friction" && value == 0.0)) {
                return failure(ErrorCode::OutOfRange, "a mass must be positive", "give it in kg");
            }
            double& number =
                key == "friction" ? parameters.friction_N : parameters.mass_kg[key == "ma" ? 0 : 1];
            number = value;
            return {};
        },
        unchanged,
        unchanged};
    return withOverrides(table, overrides);
}

} // namespace

SimulatedModel stageModel() {
    SimulatedModel model;
    model.name = "stage";
    model.title = "Stage with two linear axes";
    model.overrides = "ma, mb, friction, seed, imperfections, chain";
    model.check = [](const Overrides& overrides) -> Result<void> {
        const Result<StageParameters> parameters = stageParameters(overrides);
        return parameters ? Result<void>() : failure(parameters.error());
    };
    model.make = [](const Overrides& overrides, std::uint64_t,
                    SimulatedBoard::Line line) -> Result<std::unique_ptr<SimulatedBoard>> {
        const Result<StageParameters> parameters = stageParameters(overrides);
        if (!parameters) {
            return failure(parameters.error());
        }
        auto plant = std::make_unique<StagePlant>(*parameters);
        auto firmware = std::make_unique<StageFirmware>(*plant, line);
        return std::make_unique<SimulatedBoard>(
            SimulatedActuator{std::move(plant), std::move(firmware), STAGE_AXES, STAGE_AXES});
    };
    return model;
}

} // namespace halbench::devices
