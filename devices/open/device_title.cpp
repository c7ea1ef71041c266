#include "devices/open/device_title.h"

#include "devices/device_uri.h"
#include "devices/simulated/registry/simulated_models.h"

namespace halbench::devices {

std::string simulatedTitle(const std::string& address) {
    const Result<DeviceUri> uri = parseDeviceUri(address);
    const SimulatedModel* model = uri && uri->scheme == "sim" ? findSimulatedModel(uri->address) : nullptr;
    return model != nullptr ? model->title : std::string();
}

} // namespace halbench::devices
