#pragma once

#include "app/recordings/recording_retention.h"
#include "app/workbench/file_queue.h"
#include "app/workbench/workbench.h"

#include <atomic>
#include <memory>

namespace halbench::app {

/// How a folder is called among those whose plan was agreed to.
QString agreedName(const QString& folder);

/// Keeps the limits of the preferences on the recordings that the program named: when they are set, and after
/// each recording, on a thread of its own. Each one that goes is in the log. In a folder whose plan nobody
/// has seen nothing goes (resources/help/monitor.md, "Names of recordings"). Thread: GUI.
class RecordingTidying : public QObject {
    Q_OBJECT

public:
    RecordingTidying(Workbench& bench, QObject* parent);
    /// Ends with the recording that is being removed.
    ~RecordingTidying() override;

    /// Looks at the folder at once when there is a limit. `agreed`: agreedName() of the folders in which what
    /// goes was seen and said yes to.
    void setLimits(const RetentionLimits& limits, const QStringList& agreed);

Q_SIGNALS:
    void tidied(int removed); ///< once after every look
    /// Before it: so many would go, and it was not agreed to.
    void withheld(const QString& folder, int count);

private:
    struct Outcome {
        RetentionPlan::Removal removal;
        Result<void> result;
    };

    struct Look {
        RetentionPlan plan;
        std::vector<Outcome> outcomes;
    };

    bool isAgreed(const QString& folder) const;
    void onFolder();
    void tidy(const QString& folder);
    void tell(const QString& folder, const Look& look, bool isAgreed);
    int tellOutcomes(const std::vector<Outcome>& outcomes);

    Workbench& m_bench;
    RetentionLimits m_limits;
    QStringList m_agreed;
    QString m_folder; ///< of the recordings, when it was last heard of
    std::shared_ptr<std::atomic<bool>> m_isEnding = std::make_shared<std::atomic<bool>>(false);
    FileQueue m_files;
};

} // namespace halbench::app
