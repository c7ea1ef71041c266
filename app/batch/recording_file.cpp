#include "app/batch/recording_file.h"

#include "devices/acquisition/recording_file.h"

namespace halbench::app {

Result<void> writeRecording(const std::string& path, const Recording& recording, devices::Device& device,
                            const std::string& started) {
    Recording written = recording;
    if (!written.layout) { // a stream that ended before its first row
        written.layout = std::make_shared<const StreamLayout>();
    }
    return devices::writeRecordingFile(path, written,
                                       devices::describeRecording(device, *written.layout, started));
}

} // namespace halbench::app
