#pragma once

#include "app/procedures/base/procedure.h"
#include "app/procedures/tune/analyse.h"
#include "control/analysis/measured_margins.h"
#include "control/identify/frequency_fit.h"
#include "devices/device.h"

#include <complex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace halbench::app {

enum class Excitation { Multisine, SteppedSine, Chirp };

/// "multisine", "stepped-sine", "chirp"
std::string_view excitationName(Excitation excitation);
/// Error: UnknownName; the hint lists them.
Result<Excitation> excitation(std::string_view name);

/// Help: resources/help/htm-theory.md 7.6.
struct FrequencyConfig {
    Excitation excitation = Excitation::Multisine;
    double from_Hz = 0.5;
    double to_Hz = 40.0;
    double base_rad_s = 5.0; ///< of the constant motion below the excitation; its sign is the direction
    std::optional<double> amplitude_rad; ///< of a sine of the same rms; absent: as large as is safe
    int periods = 8;                     ///< of a chirp sweeps, that are averaged, 4 to 64
    double leastCoherence = 0.9;         ///< points below are shown, and used for nothing
    double speedLimit_rad_s = 40.0;
    double pauseTemperature_degC = 65.0;
    double refuseTemperature_degC = 70.0;
    /// Lag of the currents behind their command, first order (htm-theory.md 3.2); for the fit.
    double actuatorLag_s = 0.3e-3;
    /// 95 % of what scales current and torque constant and no response can show: converter, magnets.
    double gainError_ratio = 0.005;
};

/// One frequency. The radius of `plant` is what scatters and what no scatter shows together.
struct FrequencyResultPoint {
    control::PlantPoint measured;
    double radius = 0.0; ///< 95 %: scatter + gain error |G| + error of the stray field's compensation
    std::complex<double> openLoop;
    double openLoopRadius = 0.0;
    std::complex<double> closedLoop; ///< L/(1 + L)
    bool isUsed = false;             ///< coherent enough
};

/// Band of lines that are excited at once, and their strength.
struct FrequencyBand {
    double from_Hz = 0.0;
    double to_Hz = 0.0;
    int lines = 0;
    double amplitude_rad = 0.0; ///< of a sine of the same rms
};

struct FrequencyResult {
    FrequencyConfig config;
    double turn_rad_s = 0.0; ///< base speed as used, signed
    std::vector<FrequencyBand> bands;
    double period_s = 0.01;          ///< of the position loop
    control::SampledPositionLaw law; ///< that ran meanwhile
    std::vector<FrequencyResultPoint> points;
    control::MeasuredMargins margins;
    std::optional<control::FrequencyFit> fit;
    double strayError_rad_per_A = 0.0;  ///< in every radius
    bool wasStrayUncompensated = false; ///< before; while measuring it is compensated
    DataQuality quality;
    double duration_s = 0.0;
    std::optional<double> highestTemperature_degC; ///< of the coils, where the board reports it
    double highestCurrent_A = 0.0;
    double lowestSpeed_rad_s = 0.0; ///< magnitude, while excited
    Recording recording;            ///< all of it, once each position sample
};

/// Turns the motor steadily in mode position, adds the excitation to the reference, and recovers the plant,
/// the open and the closed loop. The gains that run on the board stay as they are; everything else is
/// restored, and the motor disarmed, on every way out. Walks Prepare, Excite, Record, Fit, Judge, Done or
/// Restored. `stray`: how well the coils' field is compensated.
/// Errors: NotFinite, OutOfRange (of the configuration), Refused (heat; the speed came near zero; rows were
/// lost), of the device, of the abort.
Result<FrequencyResult> runFrequency(devices::Device& device, const FrequencyConfig& config,
                                     const std::optional<StrayField>& stray,
                                     const ProcedureObserver& observer);

} // namespace halbench::app
