#include "tests/conformance/actuator/toy_model.h"

#include "control/base/random.h"
#include "devices/simulated/axes_firmware.h"
#include "devices/simulated/override_table.h"
#include "tests/conformance/actuator/toy_board.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

namespace halbench::devices {
namespace {

struct ToyParameters {
    double mass_kg = 0.2;
};

struct Truth {
    double position_m[2];
};

const hb_signal TruthSignals[] = {HB_SIGNAL("truth.position.x", "m", HB_FLOAT64, Truth, position_m[0], 1.0F,
                                            -1000.0F, 1000.0F, nullptr, "True position"),
                                  HB_SIGNAL("truth.position.y", "m", HB_FLOAT64, Truth, position_m[1], 1.0F,
                                            -1000.0F, 1000.0F, nullptr, "True position")};

/// m x'' + 1 N s/m x' = 5 N/A i - F sgn x', F = 0 on x and 0.3 N on y; currents follow at once.
class ToyPlant final : public Plant {
public:
    ToyPlant(const ToyParameters& parameters, std::uint64_t seed)
        : m_mass_kg(parameters.mass_kg), m_noise(seed) {}

    void read(std::span<float> readings) override {
        std::transform(std::begin(m_truth.position_m), std::end(m_truth.position_m), readings.begin(),
                       [&](double true_m) { return static_cast<float>(true_m + 1e-7 * m_noise.gaussian()); });
    }
    void drive(std::span<const float> outputs) override {
        std::copy_n(outputs.begin(), 2, m_current_A.begin());
    }
    void advance(int subSteps) override {
        constexpr double Step_s = 0.25e-3;
        constexpr std::array Friction_N = {0.0, 0.3};
        for (int k = 0; k < subSteps; ++k) {
            for (std::size_t i = 0; i < 2; ++i) {
                double& speed_m_s = m_speed_m_s[i];
                speed_m_s += (5.0 * m_current_A[i] - speed_m_s) / m_mass_kg * Step_s;
                // Friction takes away at most the motion that there is.
                const double loss_m_s = Friction_N[i] / m_mass_kg * Step_s;
                speed_m_s -= std::copysign(std::min(std::fabs(speed_m_s), loss_m_s), speed_m_s);
                m_truth.position_m[i] += speed_m_s * Step_s;
            }
        }
    }
    hb_signal_table truth() const override { return {TruthSignals, std::size(TruthSignals), &m_truth}; }

private:
    double m_mass_kg;
    Random m_noise;
    Truth m_truth{};
    std::array<double, 2> m_speed_m_s{};
    std::array<float, 2> m_current_A{};
};

/// The toy's tables without what arms and drives.
class SensingTables {
public:
    SensingTables() : m_actuator(toy_actuator) {
        for (const hb_parameter& parameter :
             std::span(toy_actuator.parameters, toy_actuator.parameter_count)) {
            const std::string_view name = parameter.entry.words; // a zero follows the name
            const bool isDriven = name == "hb.arm" || name == "hb.mode" || name.starts_with("hb.setpoint") ||
                                  name.starts_with("gain.") || name.starts_with("limit.") ||
                                  name.starts_with("reference.");
            if (!isDriven) {
                m_parameters.push_back(parameter);
            }
        }
        m_actuator.model = "sense";
        m_actuator.parameters = m_parameters.data();
        m_actuator.parameter_count = static_cast<std::uint16_t>(m_parameters.size());
        m_actuator.axis_count = 0;
    }
    const hb_actuator& actuator() const { return m_actuator; }

private:
    std::vector<hb_parameter> m_parameters;
    hb_actuator m_actuator;
};

Result<ToyParameters> toyParameters(const Overrides& overrides) {
    const auto unchanged = [](ToyParameters parameters) { return parameters; };
    const auto setMass = [](ToyParameters& parameters, std::string_view, double value) -> Result<void> {
        if (!(value > 0.0)) {
            return failure(ErrorCode::OutOfRange, "m must be positive", "give a mass in kg");
        }
        parameters.mass_kg = value;
        return {};
    };
    return withOverrides(OverrideTable<ToyParameters>{"sim:toy", "m, seed, imperfections, chain",
                                                      [](std::string_view key) { return key == "m"; },
                                                      setMass, unchanged, unchanged},
                         overrides);
}

SimulatedModel modelOf(std::string name, std::string title, const hb_actuator& actuator) {
    const auto check = [](const Overrides& overrides) -> Result<void> {
        const Result<ToyParameters> parameters = toyParameters(overrides);
        return parameters ? Result<void>() : failure(parameters.error());
    };
    const auto make = [name,
                       &actuator](const Overrides& overrides, std::uint64_t seed,
                                  SimulatedBoard::Line line) -> Result<std::unique_ptr<SimulatedBoard>> {
        const Result<ToyParameters> parameters = toyParameters(overrides);
        if (!parameters) {
            return failure(parameters.error());
        }
        auto plant = std::make_unique<ToyPlant>(*parameters, seed);
        auto firmware = std::make_unique<AxesFirmware>(actuator, "sim-" + name, *plant, line);
        return std::make_unique<SimulatedBoard>(
            SimulatedActuator{std::move(plant), std::move(firmware), 2, 2});
    };
    return {std::move(name), std::move(title), "m, seed, imperfections, chain", check, make};
}

} // namespace

SimulatedModel toyModel() {
    return modelOf("toy", "Two slides", toy_actuator);
}

SimulatedModel sensingToyModel() {
    static const SensingTables Tables;
    return modelOf("sense", "Two slides with scales", Tables.actuator());
}

} // namespace halbench::devices
