#include "app/workbench/played_recording.h"

#include "app/session/device_session.h"
#include "devices/formats/replay_device.h"

#include <QPointer>

namespace halbench::app {

void askPlayedRecording(DeviceSession& session, QObject& receiver,
                        std::function<void(std::shared_ptr<const devices::RecordedFile>)> then) {
    using File = std::shared_ptr<const devices::RecordedFile>;
    session.request(
        [](devices::Device& device) { return Result<File>(devices::recordingOf(device)); },
        [then = std::move(then), receiver = QPointer<QObject>(&receiver)](const Result<File>& file) {
            if (receiver != nullptr && file) {
                then(*file);
            }
        });
}

} // namespace halbench::app
