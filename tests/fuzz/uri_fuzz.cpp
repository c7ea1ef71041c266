// Device addresses: any text, and what follows of it for sim: and tcp:.
#include "devices/device_uri.h"
#include "devices/simulated/registry/simulated_device.h"
#include "devices/transport/tcp_socket.h"

using namespace halbench::devices;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const auto uri = parseDeviceUri(text);
    if (!uri) {
        if (uri.error().message.empty() || uri.error().hint.empty()) {
            __builtin_trap();
        }
        return 0;
    }
    if (uri->scheme == "sim") {
        (void)parseSimulatedAddress(*uri, std::nullopt);
    } else if (uri->scheme == "tcp") {
        (void)parseNetworkAddress(uri->address);
    }
    return 0;
}
