#include "devices/recording/disk_access.h"

#include <unistd.h>

namespace halbench::devices {

DiskAccess realDisk() {
    return {[](QFile& file, std::string_view octets) {
                const auto size = static_cast<qint64>(octets.size());
                return file.write(octets.data(), size) == size && file.flush();
            },
            [](int handle) { return ::fdatasync(handle) == 0; }};
}

} // namespace halbench::devices
