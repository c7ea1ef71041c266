#pragma once

#include "control/base/result.h"
#include "devices/device.h"

#include <string>
#include <vector>

namespace halbench::devices {

/// The most rows a second of these signals that board and link carry, and a rate that the board has: one
/// formula for the window and the command line. The board's part is the fastest rate at which it samples all
/// of them. The link's part, for rows of n values of up to four octets in packets of 64:
///
///     serial  (baud / 10) / (4 n + 8 packets)    15 signals at 115200 Bd: 169, of a loop of 1000 Hz then 167
///                                                (resources/help/protocol.md 3.14)
///     hid     1000 / packets                     one report a millisecond
///     others  no less than boards send
///
/// The board samples at whole parts of its rate only, so that the result is the greatest of these below both.
/// 0: they do not come periodically, or there are none; names that the device does not have are left out.
double greatestRate_Hz(const DeviceInfo& info, const Catalogue& catalogue,
                       const std::vector<std::string>& signals);

/// The greatest whole part of the first rate that is not above the second; 0 for a rate of 0.
double wholePart_Hz(double rate_Hz, double most_Hz);

/// Errors: OutOfRange (the rate is above greatestRate_Hz(), which is named).
Result<void> checkStreamRate(const DeviceInfo& info, const Catalogue& catalogue,
                             const std::vector<std::string>& signals, double rate_Hz);

} // namespace halbench::devices
