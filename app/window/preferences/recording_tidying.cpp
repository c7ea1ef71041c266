#include "app/window/preferences/recording_tidying.h"

#include "widgets/language/phrasebook.h"

#include <QDir>
#include <QFileInfo>
#include <QTimer>

namespace halbench::app {

namespace {

constexpr int Typing_ms = 700;

} // namespace

QString agreedName(const QString& folder) {
    const QDir dir(folder);
    return dir.exists() ? dir.canonicalPath() : QDir::cleanPath(dir.absolutePath());
}

RecordingTidying::RecordingTidying(Workbench& bench, QObject* parent)
    : QObject(parent), m_bench(bench), m_folder(bench.recording().folder()) {
    connect(&m_bench.recording(), &RecordingControl::finished, this,
            [this](const QString& path) { tidy(QFileInfo(path).path()); });
    connect(&m_bench.recording(), &RecordingControl::folderChanged, this, &RecordingTidying::onFolder);
}

RecordingTidying::~RecordingTidying() {
    *m_isEnding = true;
}

void RecordingTidying::setLimits(const RetentionLimits& limits, const QStringList& agreed) {
    m_limits = limits;
    m_agreed = agreed;
    *m_isEnding = true; // what goes on by the limits of before
    m_isEnding = std::make_shared<std::atomic<bool>>(false);
    tidy(m_bench.recording().folder());
}

bool RecordingTidying::isAgreed(const QString& folder) const {
    return m_agreed.contains(agreedName(folder));
}

/// What would go from a folder that is new here is said soon, not only after the first recording; not of the
/// folders above it that its name passes while it is typed.
void RecordingTidying::onFolder() {
    const QString folder = m_bench.recording().folder();
    if (folder != m_folder && !isAgreed(folder)) {
        QTimer::singleShot(Typing_ms, this, [this, folder] {
            if (folder == m_bench.recording().folder()) {
                tidy(folder);
            }
        });
    }
    m_folder = folder;
}

void RecordingTidying::tidy(const QString& folder) {
    if (!m_limits.isOn()) {
        return;
    }
    const bool mayRemove = isAgreed(folder);
    m_files.run(
        [folder, limits = m_limits, now = m_bench.now(), isEnding = m_isEnding, mayRemove]() -> Result<Look> {
            Look look{planRetention(folder, limits, now), {}};
            for (const RetentionPlan::Removal& removal : look.plan.removals) {
                if (*isEnding || !mayRemove) {
                    break; // the next look goes on
                }
                look.outcomes.push_back({removal, removeRecording(removal, RemovalWay::Trash, now)});
            }
            return look;
        },
        [this, folder, mayRemove](const Result<Look>& look) { tell(folder, *look, mayRemove); });
}

void RecordingTidying::tell(const QString& folder, const Look& look, bool isAgreed) {
    if (!look.plan.fromFuture.isEmpty()) {
        m_bench.session().message(
            MessageLevel::Warning, tr("recordings"),
            tr("nothing deleted: %1 has a date in the future, check the clock").arg(look.plan.fromFuture));
    }
    if (const auto count = static_cast<int>(look.plan.removals.size()); count > 0 && !isAgreed) {
        Q_EMIT withheld(folder, count);
    }
    const int removed = tellOutcomes(look.outcomes);
    if (removed > 0) {
        m_bench.recording().noteFilesChanged();
    }
    Q_EMIT tidied(removed);
}

int RecordingTidying::tellOutcomes(const std::vector<Outcome>& outcomes) {
    DeviceSession& session = m_bench.session();
    int removed = 0;
    for (const Outcome& outcome : outcomes) {
        const QString path = QDir::toNativeSeparators(outcome.removal.recording.path);
        if (!outcome.result) {
            session.message(MessageLevel::Warning, tr("recordings"),
                            tr("not deleted: %1").arg(widgets::inWords(outcome.result.error().message)));
            continue;
        }
        ++removed;
        const QString reason = outcome.removal.isTooOld ? tr("older than the limit in the preferences")
                                                        : tr("above the disk limit in the preferences");
        session.message(MessageLevel::Info, tr("recordings"),
                        tr("moved to the trash: %1 (%2)").arg(path, reason));
    }
    return removed;
}

} // namespace halbench::app
