#include "app/window/recording_tidying.h"

#include "widgets/phrasebook.h"

#include <QDir>
#include <QFileInfo>

namespace halbench::app {

RecordingTidying::RecordingTidying(Workbench& bench, QObject* parent) : QObject(parent), m_bench(bench) {
    connect(&m_bench.recording(), &RecordingControl::finished, this,
            [this](const QString& path) { tidy(QFileInfo(path).path()); });
}

RecordingTidying::~RecordingTidying() {
    *m_isEnding = true;
}

void RecordingTidying::setLimits(const RetentionLimits& limits) {
    m_limits = limits;
    *m_isEnding = true; // what goes on by the limits of before
    m_isEnding = std::make_shared<std::atomic<bool>>(false);
    tidy(m_bench.recording().folder());
}

void RecordingTidying::tidy(const QString& folder) {
    if (!m_limits.isOn()) {
        return;
    }
    m_files.run(
        [folder, limits = m_limits, now = m_bench.now(),
         isEnding = m_isEnding]() -> Result<std::vector<Outcome>> {
            std::vector<Outcome> outcomes;
            const RetentionPlan plan = planRetention(folder, limits, now);
            for (const RetentionPlan::Removal& removal : plan.removals) {
                if (*isEnding) {
                    break; // the next look goes on
                }
                outcomes.push_back({removal, removeRecording(removal, RemovalWay::Trash, now)});
            }
            return outcomes;
        },
        [this](const Result<std::vector<Outcome>>& outcomes) { tell(*outcomes); });
}

void RecordingTidying::tell(const std::vector<Outcome>& outcomes) {
    DeviceSession& session = m_bench.session();
    int removed = 0;
    for (const Outcome& outcome : outcomes) {
        const QString path = QDir::toNativeSeparators(outcome.removal.recording.path);
        if (!outcome.result) {
            session.message(MessageLevel::Warning, tr("recordings"),
                            tr("not tidied away: %1").arg(widgets::inWords(outcome.result.error().message)));
            continue;
        }
        ++removed;
        const QString reason = outcome.removal.isTooOld ? tr("older than the preferences keep")
                                                        : tr("no room by the preferences");
        session.message(MessageLevel::Info, tr("recordings"),
                        tr("moved to the trash: %1 (%2)").arg(path, reason));
    }
    if (removed > 0) {
        m_bench.recording().noteFilesChanged();
    }
    Q_EMIT tidied(removed);
}

} // namespace halbench::app
