#include "tests/conformance/actuator/toy_model.h"

#include "devices/simulated/override_table.h"
#include "tests/conformance/actuator/toy_board.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace halbench::devices {
namespace {

struct ToyParameters {
    double mass_kg = 0.2;
};

struct Truth {
    double position_m;
};

const hb_signal TruthSignals[1] = {HB_SIGNAL("truth.position", "m", HB_FLOAT64, Truth, position_m, 1.0F,
                                             -10.0F, 10.0F, nullptr, "True position")};

/// m x'' + 1 N s/m x' = 5 N/A (i_a cos(2 pi x/pitch) + i_b sin(2 pi x/pitch)); currents follow at once.
class ToyPlant final : public Plant {
public:
    explicit ToyPlant(const ToyParameters& parameters) : m_parameters(parameters) {}

    void read(std::span<float> readings) override { readings[0] = static_cast<float>(m_truth.position_m); }
    void drive(std::span<const float> outputs) override { m_current_A = {outputs[0], outputs[1]}; }
    void advance(int subSteps) override {
        constexpr double Step_s = 0.25e-3;
        for (int i = 0; i < subSteps; ++i) {
            const double phase = 2.0 * std::numbers::pi / 0.02 * m_truth.position_m;
            const double force_N =
                5.0 * (m_current_A.first * std::cos(phase) + m_current_A.second * std::sin(phase)) -
                m_speed_m_s;
            m_speed_m_s += force_N / m_parameters.mass_kg * Step_s;
            m_truth.position_m += m_speed_m_s * Step_s;
        }
    }
    hb_signal_table truth() const override { return {TruthSignals, 1, &m_truth}; }

private:
    ToyParameters m_parameters;
    Truth m_truth{};
    double m_speed_m_s = 0.0;
    std::pair<double, double> m_current_A{};
};

class ToyFirmware final : public Firmware {
public:
    ToyFirmware(const Plant& plant, SimulatedBoard::Line line) {
        hb_board_config config{};
        config.device = "sim-toy";
        config.transport_a2l = line.a2l;
        config.max_dto = line.maxDto;
        config.extra = plant.truth();
        toy_board_init(&m_toy, &toy_actuator, &config);
    }
    const hb_board& board() const override { return m_toy.board; }
    void tick(std::span<const float> readings, std::span<float> outputs) override {
        hb_board_tick(&m_toy.board, readings.data());
        outputs[0] = m_toy.signals.current_A[0];
        outputs[1] = m_toy.signals.current_A[1];
    }

private:
    toy_board m_toy{};
};

Result<ToyParameters> toyParameters(const Overrides& overrides) {
    const auto unchanged = [](ToyParameters parameters) { return parameters; };
    const OverrideTable<ToyParameters> table = {
        "sim:toy",
        "m, seed, imperfections, chain",
        [](std::string_view key) { return key == "m"; },
        [](ToyParameters& parameters, std::string_view, double value) -> Result<void> {
            if (!(value > 0.0)) {
                return failure(ErrorCode::OutOfRange, "m must be positive", "give a mass in kg");
            }
            parameters.mass_kg = value;
            return {};
        },
        unchanged,
        unchanged};
    return withOverrides(table, overrides);
}

} // namespace

SimulatedModel toyModel() {
    SimulatedModel model;
    model.name = "toy";
    model.title = "Slide with two coils";
    model.overrides = "m, seed, imperfections, chain";
    model.check = [](const Overrides& overrides) -> Result<void> {
        const Result<ToyParameters> parameters = toyParameters(overrides);
        return parameters ? Result<void>() : failure(parameters.error());
    };
    model.make = [](const Overrides& overrides, std::uint64_t,
                    SimulatedBoard::Line line) -> Result<std::unique_ptr<SimulatedBoard>> {
        const Result<ToyParameters> parameters = toyParameters(overrides);
        if (!parameters) {
            return failure(parameters.error());
        }
        auto plant = std::make_unique<ToyPlant>(*parameters);
        auto firmware = std::make_unique<ToyFirmware>(*plant, line);
        return std::make_unique<SimulatedBoard>(
            SimulatedActuator{std::move(plant), std::move(firmware), 1, 2});
    };
    return model;
}

} // namespace halbench::devices
