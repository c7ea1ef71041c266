#pragma once

#include "app/recordings/recording_list.h"

#include <array>
#include <functional>
#include <string>

namespace halbench::app {

/// How much of the recordings that the program named is kept; at least one of the two.
struct RetentionLimits {
    std::optional<int> days;
    std::optional<std::uint64_t> size_bytes;

    bool isOn() const { return days || size_bytes; }
    bool operator==(const RetentionLimits&) const = default;
};

inline constexpr int MostRetentionDays = 36500;
inline constexpr std::uint64_t RetentionGB_bytes = 1000000000;
inline constexpr std::uint64_t MostRetention_GB = 1000000;

/// "30d", "20GB" or "30d,20GB". Errors: Usage.
Result<RetentionLimits> parseRetention(const std::string& text);

/// Why a recording stays although it is beyond the limits.
enum class KeptBecause { Tags, Notes, Results, Open, Recent, WriteProtected, Link, Changed, ClockInDoubt };
/// "has tags", for the command line and, by way of the phrase book, the window.
std::string keptBecauseText(KeptBecause reason);

/// One recording of the program's naming with its sidecar.
struct NamedRecording {
    QString path;
    QString name;
    QDateTime date; ///< when it began or when its file was written last, whichever is later
    std::uint64_t size_bytes = 0;
};

struct RetentionPlan {
    struct Removal {
        NamedRecording recording;
        bool isTooOld = false; ///< else there is no room
    };
    struct Kept {
        NamedRecording recording;
        KeptBecause reason = KeptBecause::Tags;
    };
    std::vector<Removal> removals; ///< oldest first
    std::vector<Kept> kept;        ///< those that the limits would take
    std::size_t recordings = 0;    ///< that the program named, in the folder
    std::uint64_t before_bytes = 0;
    std::uint64_t after_bytes = 0;
    QString fromFuture; ///< the recording that is dated furthest after `now`: nothing goes; empty: none
};

/// What of a folder's recordings goes, oldest first, so that the limits are kept. Only what Halbench wrote
/// and named itself (the sidecar says so, and the name is still that one) is counted and may go, and never
/// one with tags, notes or any file beside it that bears its name, one that is open or being written, write
/// protected, a link, or of the last 24 hours before `now`. Where one is dated after `now`, the clock is or
/// was wrong, nobody knows what is old, and nothing goes. Touches nothing. For a thread of its own.
RetentionPlan planRetention(const QString& folder, const RetentionLimits& limits, const QDateTime& now);

enum class RemovalWay { Trash, Delete };
/// Moves a file to a trash; false: it did not, and the file is where it was.
using TrashMove = std::function<bool(const QString& path)>;
bool systemTrash(const QString& path);

/// Removes one recording of a plan with its sidecar after another look at everything that protects it, its
/// rows against the checksum too: what was edited since stays. `Trash` never deletes: what the trash does not
/// take, full or missing, stays. Errors: Refused (it is protected by now; `message` says by what),
/// FileSystem.
Result<void> removeRecording(const RetentionPlan::Removal& removal, RemovalWay way, const QDateTime& now,
                             const TrashMove& moveToTrash = systemTrash);

} // namespace halbench::app
