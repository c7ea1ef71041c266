#pragma once

#include <cstddef>
#include <deque>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace halbench::control {

/// One second of a coil's temperature and of the current that heats it.
struct ThermalBin {
    double time_s = 0.0; ///< mean of its samples'
    double mean_degC = 0.0;
    double square_A2 = std::numeric_limits<double>::quiet_NaN(); ///< mean square; NaN: not known
    std::size_t samples = 0;
    double stepSquares_K2 = 0.0; ///< sum of squares of the differences between neighbours
    double leastStep_K =
        std::numeric_limits<double>::infinity(); ///< between neighbours, of those that differ
};

/// The newest half hour of a coil, in seconds: what limit_forecast.h extrapolates. A gap of more than two
/// seconds, or a clock that runs back, forgets what was before: nobody knows the load of it.
class ThermalBins {
public:
    static constexpr double Width_s = 1.0;
    static constexpr std::size_t Most = 1800;
    static constexpr double LongestGap_s = 2.0;

    /// Values that are not finite are passed over; so is a current that is none.
    void add(double time_s, double temperature_degC, double current_A);
    void clear();

    /// Oldest first, without the second that is not complete.
    const std::deque<ThermalBin>& bins() const { return m_bins; }
    std::optional<double> newest_degC() const { return m_newest_degC; }

private:
    void close();

    std::deque<ThermalBin> m_bins;
    ThermalBin m_open;
    double m_begin_s = 0.0; ///< of the open one
    double m_last_s = 0.0;
    double m_squares_A2 = 0.0;
    std::size_t m_currents = 0;
    std::optional<double> m_newest_degC;
};

/// The newest of them in which the load did not change: groups of five seconds whose mean square of the
/// current stays within 5 % (and 0.01 A^2) of their mean. A current that is not known ends
/// them: without currents there are none.
std::vector<ThermalBin> atSteadyLoad(const std::deque<ThermalBin>& bins);

} // namespace halbench::control
