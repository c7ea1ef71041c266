#pragma once

#include "app/batch/recording_retention.h"
#include "app/workspaces/file_queue.h"
#include "app/workspaces/workbench.h"

#include <atomic>
#include <memory>

namespace halbench::app {

/// Keeps the limits of the preferences on the recordings that the program named: when they are set, and after
/// each recording, on a thread of its own. Each one that goes is in the log
/// (resources/help/monitor.md, "Names of recordings"). Thread: GUI.
class RecordingTidying : public QObject {
    Q_OBJECT

public:
    RecordingTidying(Workbench& bench, QObject* parent);
    /// Ends with the recording that is being removed.
    ~RecordingTidying() override;

    /// Looks at the folder at once when there is a limit.
    void setLimits(const RetentionLimits& limits);

Q_SIGNALS:
    void tidied(int removed); ///< once after every look

private:
    struct Outcome {
        RetentionPlan::Removal removal;
        Result<void> result;
    };

    void tidy(const QString& folder);
    void tell(const std::vector<Outcome>& outcomes);

    Workbench& m_bench;
    RetentionLimits m_limits;
    std::shared_ptr<std::atomic<bool>> m_isEnding = std::make_shared<std::atomic<bool>>(false);
    FileQueue m_files;
};

} // namespace halbench::app
