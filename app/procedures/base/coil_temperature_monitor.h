#pragma once

#include "control/base/sample_block.h"
#include "control/history/sample_history.h"
#include "control/identify/limit_forecast.h"
#include "devices/device.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace halbench::app {

/// When one coil is at the device's limit, if the load stays as it is.
struct CoilForecast {
    std::string signal; ///< the coil's temperature
    control::LimitForecast forecast;
};

/// Watches the coils' temperatures and currents as they come, and says when they reach a limit
/// (control/identify/limit_forecast.h). Belongs to one thread at a time.
class CoilTemperatureMonitor {
public:
    /// What it looks at by the roles coil_temperature.a and .b, current.a and .b; without the former it says
    /// nothing.
    explicit CoilTemperatureMonitor(const devices::Catalogue& catalogue);

    /// Its signals of a block; times may be any that rise.
    void take(const SampleBlock& block);
    /// One sample of one coil; NaN: a current that is not known.
    void add(std::size_t coil, double time_s, double temperature_degC, double current_A);
    /// Those of one coil, oldest first. To a temperature belongs the current of its moment, or the last one
    /// before it: the two may come from streams of other columns and rates.
    void add(std::size_t coil, std::span<const control::TimedValue> temperatures_degC,
             std::span<const control::TimedValue> currents_A);

    struct Coil {
        std::string temperature; ///< name; empty: the device has none
        std::string current;
        control::ThermalBins bins;
    };
    const std::array<Coil, 2>& coils() const { return m_coils; }

    /// Of every coil of which there were samples.
    std::vector<CoilForecast> forecasts(double limit_degC) const;
    /// Of those the ones that tell something: a coil at its limit, or what is known of one that is heated.
    std::vector<CoilForecast> tellingForecasts(double limit_degC) const;

private:
    bool isHeated(const std::string& temperature) const;

    std::array<Coil, 2> m_coils;
};

/// The one to be said first: at the limit, then the earliest that may reach it, then one that is withheld.
const CoilForecast* mostUrgent(const std::vector<CoilForecast>& forecasts);

/// The limit on the device, else the profile's T_limit_degC; nothing when there is neither. Errors are
/// nothing.
std::optional<double> temperatureLimit_degC(devices::Device& device);

} // namespace halbench::app
