#include "devices/acquisition/recording_file.h"

#include "devices/acquisition/file_access.h"
#include "devices/acquisition/mdf4_reader.h"
#include "devices/acquisition/recording_chunks.h"
#include "devices/acquisition/recording_csv.h"
#include "devices/acquisition/recording_writer.h"
#include "devices/profile.h"

#include <QtCore/QCryptographicHash>
#include <QtCore/QFileInfo>

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace halbench::devices {

namespace {

constexpr qint64 MaxMeta = qint64{64} << 20;
constexpr qint64 Piece = qint64{4} << 20;
constexpr std::string_view PartialEnding = ".csv.partial";
constexpr std::string_view Mdf4Ending = ".mf4";

/// Shares of this machine's memory: of the numbers of a recording, and of a file that is read as a whole
/// (its text is held, often twice, and its numbers).
constexpr std::uint64_t NumbersShare = 3;
constexpr std::uint64_t TextShare = 8;
constexpr std::uint64_t LeastText = std::uint64_t{256} << 20;

std::uint64_t memoryShare(std::uint64_t share) {
    const long pages = ::sysconf(_SC_PHYS_PAGES);
    const long page_bytes = ::sysconf(_SC_PAGESIZE);
    const std::uint64_t all = pages > 0 && page_bytes > 0
                                  ? static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page_bytes)
                                  : 0;
    return std::max(LeastText, all / share);
}

qint64 maxText() {
    return static_cast<qint64>(memoryShare(TextShare));
}

QString pathOf(const std::string& path) {
    return QString::fromStdString(path);
}

Result<std::string> readText(const std::string& path, qint64 limit) {
    QFile file(pathOf(path));
    if (QFileInfo(file).isDir() || !file.open(QIODevice::ReadOnly)) {
        return failure(ErrorCode::FileSystem, fmt::format("cannot read '{}': {}", path, causeOf(file)),
                       "check the path");
    }
    if (file.size() > limit) {
        const std::string hint =
            isMdf4Recording(path)
                ? fmt::format("at most {} are read; write it in parts, with --from and --to", limit)
                : fmt::format(
                      "at most {} are read; cut the file into pieces that each begin with its first line",
                      limit);
        return failure(ErrorCode::InvalidInput, fmt::format("'{}' has {} octets", path, file.size()), hint);
    }
    std::string text(static_cast<std::size_t>(file.size()), '\0');
    qint64 length = 0;
    while (length < static_cast<qint64>(text.size())) {
        const qint64 got =
            file.read(text.data() + length, std::min(Piece, static_cast<qint64>(text.size()) - length));
        if (got <= 0) {
            return failure(ErrorCode::FileSystem, fmt::format("cannot read '{}': {}", path, causeOf(file)),
                           "check the path");
        }
        length += got;
    }
    return text;
}

std::string hexOf(const QByteArray& hash) {
    return hash.toHex().toStdString();
}

/// The numbers and the checksum of a file that may be longer than memory would hold as text.
Result<void> readPieces(const std::string& path, const std::function<Result<void>()>& checkAbort,
                        const std::function<void(double)>& onProgress, Recording& recording,
                        std::string& sha256) {
    QFile file(pathOf(path));
    if (QFileInfo(file).isDir() || !file.open(QIODevice::ReadOnly)) {
        return failure(ErrorCode::FileSystem, fmt::format("cannot read '{}': {}", path, causeOf(file)),
                       "check the path");
    }
    RecordingCsvParser parser(path, static_cast<std::uint64_t>(file.size()), memoryShare(NumbersShare),
                              checkAbort);
    QCryptographicHash hash(QCryptographicHash::Sha256);
    std::vector<char> piece(static_cast<std::size_t>(Piece));
    for (;;) {
        const qint64 length = file.read(piece.data(), Piece);
        if (length < 0) {
            return failure(ErrorCode::FileSystem, fmt::format("cannot read '{}': {}", path, causeOf(file)),
                           "check the path");
        }
        if (length == 0) {
            break;
        }
        hash.addData(piece.data(), static_cast<int>(length));
        if (const Result<void> fed = parser.feed({piece.data(), static_cast<std::size_t>(length)}); !fed) {
            return fed;
        }
        if (onProgress) {
            onProgress(static_cast<double>(file.pos()) /
                       static_cast<double>(std::max(file.size(), file.pos())));
        }
    }
    Result<Recording> whole = parser.finish();
    if (!whole) {
        return failure(whole.error());
    }
    recording = *std::move(whole);
    sha256 = hexOf(hash.result());
    return {};
}

/// Signal names of the shipped profiles by their column without unit: "hall_a" -> "hall.a".
std::string signalNameOf(const std::string& column) {
    const Result<std::optional<Profile>> profile = findProfile("htm");
    if (profile && *profile) {
        for (const auto& [role, name] : (*profile)->signalRoles) {
            if (csvColumnName(name, "") == column) {
                return name;
            }
        }
    }
    return column;
}

void nameColumns(RecordedFile& file) {
    StreamLayout layout = *file.recording.layout;
    for (StreamLayout::Column& column : layout.columns) {
        const std::string header = csvColumnName(column.name, column.unit);
        column.name = signalNameOf(column.name);
        for (const RecordingMeta::SignalNote& note : file.meta.signals) {
            if (note.column == header) {
                column = {note.name, note.unit};
            }
        }
    }
    if (file.hasMeta && file.meta.period_s > 0.0) {
        layout.period_s = file.meta.period_s;
    }
    file.recording.layout = std::make_shared<const StreamLayout>(std::move(layout));
}

bool hasEnding(const std::string& path, std::string_view ending) {
    return path.size() > ending.size() &&
           path.compare(path.size() - ending.size(), ending.size(), ending) == 0;
}

/// "run.csv.partial" -> "run.csv"
std::string finalPathOf(const std::string& path) {
    return path.substr(0, path.size() - partialPathOf("").size());
}

/// "run.csv.partial" -> "run.meta.json.partial"
std::string metaPartialOf(const std::string& path) {
    return partialPathOf(metaPathOf(finalPathOf(path)));
}

/// Up to the end of the last line that was written wholly. A power loss may have left zeros behind it.
std::size_t wholeLines(const std::string& text) {
    const std::size_t written = text.find('\0');
    const std::size_t lastEnd = text.rfind('\n', written);
    return lastEnd == std::string::npos ? 0 : lastEnd + 1;
}

/// Where it is. A program that was killed between the last two steps of a recording left it under the name
/// that it had until then.
std::string sidecarOf(const std::string& path) {
    const std::string metaPath = metaPathOf(path);
    const std::string last = completeMetaPathOf(path);
    return !QFileInfo::exists(pathOf(metaPath)) && QFileInfo::exists(pathOf(last)) ? last : metaPath;
}

/// Leaves out of the text what is damaged or no whole line.
std::size_t keepWhole(const std::string& path, std::string& text, PartialRecording& partial) {
    const Result<std::string> journal = readText(journalPathOf(finalPathOf(path)), MaxMeta);
    CheckedText checked = checkChunks(text, journal ? parseChunks(*journal) : std::vector<RecordingChunk>());
    text = std::move(checked.text);
    partial.damagedOctets = checked.damagedOctets;
    partial.cutOctets = text.size() - wholeLines(text);
    text.resize(wholeLines(text));
    return checked.checkedOctets;
}

/// What came after the last checksum may be anything after a power loss; what has one is worth having.
Result<Recording> parseWhole(const std::string& path, std::string text, std::size_t checkedOctets,
                             PartialRecording& partial) {
    Result<Recording> all = parseRecordingCsv(text, path);
    if (all || checkedOctets == 0 || checkedOctets >= text.size()) {
        return all;
    }
    partial.cutOctets += text.size() - checkedOctets;
    text.resize(checkedOctets);
    return parseRecordingCsv(text, path);
}

} // namespace

Result<RecordedFile> readRecordingFile(const std::string& path,
                                       const std::function<Result<void>()>& checkAbort,
                                       const std::function<void(double)>& onProgress) {
    if (isMdf4Recording(path)) {
        const Result<std::string> text = readText(path, maxText());
        return text ? parseMdf4(*text, path, checkAbort) : failure(text.error());
    }
    RecordedFile file;
    std::string sha256;
    if (const Result<void> read = readPieces(path, checkAbort, onProgress, file.recording, sha256); !read) {
        return failure(read.error());
    }
    const std::string metaPath = sidecarOf(path);
    if (QFileInfo::exists(pathOf(metaPath))) {
        const Result<std::string> metaText = readText(metaPath, MaxMeta);
        if (!metaText) {
            return failure(metaText.error());
        }
        Result<RecordingMeta> meta = parseMetaJson(*metaText, metaPath);
        if (!meta) {
            return failure(meta.error());
        }
        file.meta = *std::move(meta);
        file.hasMeta = true;
        if (sha256 != file.meta.sha256) {
            file.warnings.push_back(fmt::format("'{}' was changed since it was recorded (SHA-256)", path));
        }
    }
    nameColumns(file);
    return file;
}

Result<std::string> readTableText(const std::string& path) {
    return readText(path, maxText());
}

bool isPartialRecording(const std::string& path) {
    return hasEnding(path, PartialEnding);
}

bool isMdf4Recording(const std::string& path) {
    return hasEnding(path, Mdf4Ending);
}

Result<PartialRecording> readPartialRecording(const std::string& path) {
    Result<std::string> text = readText(path, maxText());
    if (!text) {
        return failure(text.error());
    }
    PartialRecording partial;
    const std::size_t checkedOctets = keepWhole(path, *text, partial);
    if (text->find('\n') == std::string::npos || text->find('\n') + 1 == text->size()) {
        return failure(ErrorCode::InvalidInput, fmt::format("'{}' holds no whole row", path),
                       "nothing was recorded before the interruption; the file can be removed");
    }
    Result<Recording> recording = parseWhole(path, *std::move(text), checkedOctets, partial);
    if (!recording) {
        return failure(recording.error());
    }
    partial.file.recording = *std::move(recording);
    const Result<std::string> metaText = readText(metaPartialOf(path), MaxMeta);
    if (metaText) { // the rows are worth more than their sidecar: a damaged one does not stop a recovery
        Result<RecordingMeta> meta = parseMetaJson(*metaText, metaPartialOf(path));
        partial.file.hasMeta = meta.has_value();
        partial.file.meta = meta ? *std::move(meta) : RecordingMeta();
    }
    nameColumns(partial.file);
    partial.file.meta.markers.push_back({partial.file.recording.time_s.back(), "recording interrupted"});
    return partial;
}

std::string retirePartialRecording(const std::string& path, bool isDamaged) {
    std::string kept;
    std::error_code problem; // what cannot be renamed stays where it is
    if (isDamaged && std::filesystem::exists(path, problem)) {
        kept = finalPathOf(path) + ".damaged";
        for (int number = 2; std::filesystem::exists(kept, problem); ++number) {
            kept = finalPathOf(path) + ".damaged-" + std::to_string(number);
        }
        std::filesystem::rename(path, kept, problem);
        kept = problem ? path : kept;
    } else {
        std::remove(path.c_str());
    }
    std::remove(metaPartialOf(path).c_str());
    std::remove(nextMetaPathOf(finalPathOf(path)).c_str());
    std::remove(journalPathOf(finalPathOf(path)).c_str());
    return kept;
}

} // namespace halbench::devices
