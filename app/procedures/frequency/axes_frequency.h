#pragma once

#include "app/procedures/base/procedure.h"
#include "control/analysis/measured_margins.h"
#include "control/identify/matrix_loop.h"
#include "devices/axis_spec.h"
#include "models/htm/htm_ideal_loop.h"

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace halbench::app {

/// Frequency response of a device with several axes. Help: resources/help/identification.md.
struct AxesFrequencyConfig {
    std::string axis; ///< one of them while the others are closed; "" or "all": all of them at once
    double from_Hz = 1.0;
    double to_Hz = 50.0;
    double effort_ratio = 0.25; ///< of what an axis has at its limit: amplitude of a sine of the same rms
    int periods = 24;           ///< of each experiment, 4 to 256
    double leastCoherence = 0.9;
    double pauseTemperature_degC = 60.0;
    double refuseTemperature_degC = 70.0;
};

/// One frequency. Rows and columns in the order of `AxesFrequencyResult::axes`.
struct AxesFrequencyPoint {
    control::MatrixPoint plant; ///< command that flows, the delay taken out, to position
    control::MatrixLoopPoint loop;
    std::vector<bool> isUsed; ///< axis by axis: coherent enough
    bool isWhole() const;     ///< all of them
};

/// Frequency band that was excited at once.
struct AxesFrequencyBand {
    double from_Hz = 0.0;
    double to_Hz = 0.0;
    int linesPerAxis = 0;
    std::vector<double> effort; ///< amplitude of each axis, of a sine of the same rms
};

/// The largest value of a figure between frequencies that bracket it, or why there is none.
struct MeasuredPeak {
    enum class Withheld {
        No,
        NoPoint, ///< no frequency at which all axes are coherent
        Edge     ///< it is largest at the first or last frequency that is used
    };
    Withheld withheld = Withheld::NoPoint;
    double frequency_rad_s = 0.0;
    double value = 0.0;
    double radius = 0.0;
};

struct AxisResponse {
    devices::AxisSpec axis;
    control::SampledPositionLaw law;  ///< that ran meanwhile
    control::MeasuredMargins margins; ///< of its loop while the others are closed
};

struct AxesFrequencyResult {
    AxesFrequencyConfig config;
    std::vector<AxisResponse> axes; ///< that were excited
    std::vector<AxesFrequencyBand> bands;
    double period_s = 1e-3;
    int delaySamples = 0;
    std::vector<AxesFrequencyPoint> points; ///< ascending
    MeasuredPeak sensitivity;   ///< of the largest singular value of S, positions in units of the test step
    MeasuredPeak complementary; ///< likewise of T
    double limited_ratio = 0.0; ///< share of the samples in which the currents were at their limit
    bool wasSensorLeftOut = false; ///< the board went on without one of its sensors
    DataQuality quality;
    double duration_s = 0.0;
    std::optional<double> highestTemperature_degC; ///< of the coils, where the board reports it
    Recording recording;
};

/// Adds multisines on interleaved frequencies to the command of every axis while the loops hold the position,
/// and recovers the plant matrix, the loops and their margins. With n axes every band takes n experiments in
/// which the axes change places, so that each is excited at each line. The gains that run stay as they are;
/// everything else is restored, and the device disarmed, on every way out. Walks Prepare, Excite, Record,
/// Fit, Judge, Done or Restored. Errors: Usage, UnknownName (axis), NotFinite, OutOfRange, DeviceRefused (a
/// board that cannot add an excitation), Refused (heat, lost rows), SafetyStop, of the device, of the abort.
Result<AxesFrequencyResult> runAxesFrequency(devices::Device& device, const AxesFrequencyConfig& config,
                                             const ProcedureObserver& observer);

/// Check of the settings against the device, before anything moves. Errors: as above.
Result<void> checkAxesFrequency(const devices::Catalogue& catalogue, const AxesFrequencyConfig& config);

/// Device time of the excitation. Errors: as of checkAxesFrequency().
Result<double> axesFrequencyDuration_s(const devices::Catalogue& catalogue,
                                       const AxesFrequencyConfig& config);

} // namespace halbench::app
