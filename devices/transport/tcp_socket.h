#pragma once

#include "control/base/result.h"
#include "devices/transport/descriptor.h"
#include "devices/transport/network_address.h"

namespace halbench::devices {

/// Errors: DeviceLost with the cause in words.
Result<Descriptor> connectTcp(const NetworkAddress& address, double timeout_s);
/// The next waiting connection; closed when there is none.
Descriptor acceptTcp(const Descriptor& listener);

} // namespace halbench::devices
