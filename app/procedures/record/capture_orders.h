#pragma once

#include "app/procedures/record/capture_procedure.h"

#include <vector>

namespace halbench::app {

/// What the board's capture does, in the order of the board's own states.
enum class CaptureState { Idle, Filling, Waiting, Running, Full };

inline constexpr std::size_t CaptureSignals = 4; ///< at most
inline constexpr double CaptureRows = 4096.0;
inline constexpr double CaptureRate_Hz = 1000.0; ///< the loop's

bool canCapture(const devices::Catalogue& catalogue);
/// The fastest rate at which the board's rows cover so much time.
double captureRateFor_Hz(double length_s);

/// What the board is to be set to. Errors: as runCapture().
Result<std::vector<ParameterValue>> captureSetUp(const devices::Catalogue& catalogue,
                                                 const CaptureConfig& config);
/// What the board is set to now, with the same names. Errors: of the device.
Result<std::vector<ParameterValue>> captureSetUpBefore(devices::Device& device,
                                                       std::vector<ParameterValue> values);
/// Sets it up and starts it; nothing is armed and nothing else is written. Errors: of the device.
Result<void> startCapture(devices::Device& device, const std::vector<ParameterValue>& values);
/// Stops it and puts the set-up back. Errors: of the device.
Result<void> endCapture(devices::Device& device, const std::vector<ParameterValue>& before);
/// Errors: of the device; Protocol.
Result<CaptureState> readCaptureState(devices::Device& device);
/// What was read is what was asked for. Errors: Protocol, NotFinite.
Result<Recording> checkCapture(Result<Recording> capture, const CaptureConfig& config);

} // namespace halbench::app
