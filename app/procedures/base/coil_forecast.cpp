#include "app/procedures/base/coil_forecast.h"

#include "app/procedures/base/procedure_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

constexpr double LongestPause_s = 1800.0; // nearly four thermal time constants

double constantOr(const devices::Catalogue& catalogue, const char* name, double otherwise) {
    const auto found = catalogue.knownConstants.find(name);
    return found == catalogue.knownConstants.end() ? otherwise : found->second;
}

Result<CoilTemperatures> waitUntilCool(devices::Device& device, const ProcedureObserver& observer,
                                       double pause_degC) {
    const double start_s = device.clock().now_s();
    for (;;) {
        const auto now = readCoilTemperatures(device);
        if (!now || now->highest_degC <= pause_degC) {
            return now;
        }
        if (device.clock().now_s() - start_s > LongestPause_s) {
            return failure(ErrorCode::Refused,
                           fmt::format("coil temperature {:.0f} degC, does not fall below {:.0f} degC",
                                       now->highest_degC, pause_degC),
                           "Cool the motor, then try again.");
        }
        const std::string text = fmt::format("cooling the coils: {:.0f} degC", now->highest_degC);
        if (auto waited = waitObserved(device, observer, 1.0, 0.0, 0.0, text); !waited) {
            return failure(waited.error());
        }
    }
}

std::vector<std::string> coilSignals(const devices::Catalogue& catalogue) {
    std::vector<std::string> names;
    for (const SignalSpec& signal : catalogue.signals) {
        if (signal.role.starts_with("coil_temperature.")) {
            names.push_back(signal.name);
        }
    }
    return names;
}

} // namespace

Result<CoilTemperatures> readCoilTemperatures(devices::Device& device) {
    const std::vector<std::string> names = coilSignals(device.catalogue());
    if (names.empty()) {
        return CoilTemperatures{};
    }
    const auto values = device.readSignals(names);
    if (!values) {
        return failure(values.error());
    }
    if (!std::all_of(values->begin(), values->end(), [](double value) { return std::isfinite(value); })) {
        return failure(ErrorCode::NotFinite, "a coil temperature is not a number",
                       "check the temperature sensors");
    }
    const auto [lowest, highest] = std::minmax_element(values->begin(), values->end());
    return CoilTemperatures{*highest, *lowest};
}

double CoilTemperatures::sensorExcess_K() const {
    constexpr double Room_degC = 25.0;
    return std::max(std::abs(highest_degC - Room_degC), std::abs(lowest_degC - Room_degC));
}

Result<double> readSensorExcess_K(devices::Device& device) {
    if (coilSignals(device.catalogue()).empty()) {
        constexpr double Limit_degC = 80.0;
        const double limit_degC = constantOr(device.catalogue(), "T_limit_degC", Limit_degC);
        return CoilTemperatures{limit_degC, limit_degC}.sensorExcess_K();
    }
    const auto now = readCoilTemperatures(device);
    return now ? Result<double>(now->sensorExcess_K()) : failure(now.error());
}

std::optional<double> highestCoil_degC(const devices::Catalogue& catalogue, const Recording& recording) {
    return highestCoil_degC(coilSignals(catalogue), recording);
}

std::optional<double> highestCoil_degC(std::span<const std::string> signals, const Recording& recording) {
    std::optional<double> highest_degC;
    if (!recording.layout) {
        return highest_degC;
    }
    for (const std::string& name : signals) {
        for (const double value_degC : recording.column(name)) {
            highest_degC = std::max(value_degC, highest_degC.value_or(value_degC));
        }
    }
    return highest_degC;
}

double sensorTemperature_per_K(const devices::Catalogue& catalogue) {
    return std::abs(constantOr(catalogue, "S_TC", 0.0));
}

models::CoilHeatingConfig coilModel(const devices::Catalogue& catalogue) {
    models::CoilHeatingConfig model;
    model.heatCapacity_J_per_K = constantOr(catalogue, "C_th", model.heatCapacity_J_per_K);
    model.thermalResistance_K_per_W = constantOr(catalogue, "R_th", model.thermalResistance_K_per_W);
    model.resistanceAt25_Ohm = constantOr(catalogue, "R_a", model.resistanceAt25_Ohm);
    model.copperCoefficient_per_K = constantOr(catalogue, "alpha_copper", model.copperCoefficient_per_K);
    return model;
}

double forecastCoil_degC(const models::CoilHeatingConfig& model, const CoilTemperatures& start,
                         double meanSquare_A2, double duration_s) {
    constexpr double WarmestAmbient_degC = 40.0;
    models::CoilHeatingConfig config = model;
    config.ambient_degC = std::min(start.lowest_degC, WarmestAmbient_degC);
    models::CoilHeatingState coil{start.highest_degC};
    stepCoilHeatingSquare(config, coil, meanSquare_A2, duration_s);
    return std::max(coil.temperature_degC, start.highest_degC);
}

Result<double> admitHeat(devices::Device& device, const ProcedureObserver& observer, double meanSquare_A2,
                         double duration_s, double pause_degC, double refuse_degC) {
    const auto start = waitUntilCool(device, observer, pause_degC);
    if (!start) {
        return failure(start.error());
    }
    const double forecast_degC =
        forecastCoil_degC(coilModel(device.catalogue()), *start, meanSquare_A2, duration_s);
    if (forecast_degC > refuse_degC) {
        return failure(ErrorCode::Refused,
                       fmt::format("expected coil temperature {:.0f} degC, limit {:.0f} degC", forecast_degC,
                                   refuse_degC),
                       "Nothing was armed. Use a shorter run or less current, or let the motor cool.");
    }
    return forecast_degC;
}

} // namespace halbench::app
