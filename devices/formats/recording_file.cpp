#include "devices/formats/recording_file.h"

#include "devices/formats/mdf4_reader.h"
#include "devices/formats/recording_units.h"
#include "devices/profile.h"
#include "devices/recording/file_access.h"
#include "devices/recording/recording_csv.h"
#include "devices/recording/recording_salvage.h"
#include "devices/recording/recording_writer.h"
#include "devices/recording/time_axis.h"

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
                ? fmt::format("at most {} can be read; write parts with --from and --to", limit)
                : fmt::format(
                      "at most {} are read; cut the file into pieces that each begin with its first line",
                      limit);
        return failure(ErrorCode::InvalidInput, fmt::format("'{}' has {} bytes", path, file.size()), hint);
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

/// Answers of which columns the sidecar says name and unit.
std::vector<bool> nameColumns(RecordedFile& file) {
    StreamLayout layout = *file.recording.layout;
    std::vector<bool> isNoted(layout.columns.size(), false);
    for (std::size_t i = 0; i < layout.columns.size(); ++i) {
        StreamLayout::Column& column = layout.columns[i];
        const std::string header = csvColumnName(column.name, column.unit);
        column.name = signalNameOf(column.name);
        for (const RecordingMeta::SignalNote& note : file.meta.signals) {
            if (note.column == header) {
                column = {note.name, note.unit};
                isNoted[i] = true;
            }
        }
    }
    if (file.hasMeta && file.meta.period_s > 0.0) {
        layout.period_s = file.meta.period_s;
    }
    file.recording.layout = std::make_shared<const StreamLayout>(std::move(layout));
    return isNoted;
}

Result<RecordedFile> inSi(RecordedFile file, const std::vector<bool>& isNoted, const std::string& path) {
    const Result<void> converted = convertToSi(file, isNoted, path);
    if (!file.meta.device.otherFirmware.empty()) {
        file.warnings.push_back(otherFirmwareWarning(file.meta.device));
    }
    return converted ? Result<RecordedFile>(std::move(file)) : failure(converted.error());
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

/// Where it is. A program that was killed between the last two steps of a recording left it under the name
/// that it had until then.
std::string sidecarOf(const std::string& path) {
    const std::string metaPath = metaPathOf(path);
    const std::string last = completeMetaPathOf(path);
    return !QFileInfo::exists(pathOf(metaPath)) && QFileInfo::exists(pathOf(last)) ? last : metaPath;
}

/// The rows are worth more than their sidecar: a damaged one does not stop a recovery.
void readPartialMeta(const std::string& path, RecordedFile& file) {
    const Result<std::string> text = readText(metaPartialOf(path), MaxMeta);
    if (text) {
        Result<RecordingMeta> meta = parseMetaJson(*text, metaPartialOf(path));
        file.hasMeta = meta.has_value();
        file.meta = meta ? *std::move(meta) : RecordingMeta();
    }
}

/// Only where nothing was recorded may anybody remove it.
tl::unexpected<Error> noRowsIn(const std::string& path, bool isEmpty, std::string_view journal) {
    if (isEmpty) {
        return failure(ErrorCode::InvalidInput, fmt::format("'{}' has no complete row", path),
                       "nothing was recorded before the interruption; the file can be removed");
    }
    return failure(
        ErrorCode::InvalidInput, fmt::format("'{}' has no undamaged row", path),
        journal.empty()
            ? std::string("the file is not changed: its content can be read as text")
            : fmt::format("the file is not changed; move '{}' away to read the data without checksum",
                          journalPathOf(finalPathOf(path))));
}

/// How the data differ from what their sidecar says was recorded. What lacks rows may have other faults too.
std::string changeOf(const std::string& path, const RecordedFile& file) {
    const std::uint64_t rows = file.recording.rows();
    const std::string name =
        std::filesystem::path(path).filename().string(); // a result shall not tell the folder
    return rows >= file.meta.rows ? fmt::format("'{}' was changed since it was recorded (SHA-256)", name)
                                  : fmt::format("'{}' was changed since it was recorded: {} of {} rows", name,
                                                rows, file.meta.rows);
}

} // namespace

Result<RecordedFile> readRecordingFile(const std::string& path,
                                       const std::function<Result<void>()>& checkAbort,
                                       const std::function<void(double)>& onProgress) {
    if (isMdf4Recording(path)) {
        const Result<std::string> text = readText(path, maxText());
        Result<RecordedFile> file = text ? parseMdf4(*text, path, checkAbort) : failure(text.error());
        const std::size_t columns = file ? file->recording.layout->columns.size() : 0;
        return file ? inSi(*std::move(file), std::vector<bool>(columns, true), path) : file;
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
        setRates(file.recording, file.meta.rates);
        if (sha256 != file.meta.sha256) {
            file.warnings.push_back(changeOf(path, file));
        }
    }
    const std::vector<bool> isNoted = nameColumns(file);
    return inSi(std::move(file), isNoted, path);
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
    readPartialMeta(path, partial.file);
    const std::string journal = readText(journalPathOf(finalPathOf(path)), MaxMeta).value_or(std::string());
    const bool isEmpty = !holdsRows(*text, partial.file.meta);
    Result<SalvagedRows> salvaged = salvageRows(*text, journal, partial.file.meta, path);
    if (isEmpty || (salvaged && salvaged->recording.rows() == 0)) {
        return noRowsIn(path, isEmpty, journal);
    }
    if (!salvaged) {
        return failure(salvaged.error());
    }
    partial.file.recording = std::move(salvaged->recording);
    setRates(partial.file.recording, partial.file.meta.rates);
    partial.cutOctets = salvaged->cutOctets;
    partial.damagedOctets = salvaged->damagedOctets;
    partial.uncheckedRows = salvaged->uncheckedRows;
    const std::vector<bool> isNoted = nameColumns(partial.file);
    if (const Result<void> converted = convertToSi(partial.file, isNoted, path); !converted) {
        return failure(converted.error());
    }
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
