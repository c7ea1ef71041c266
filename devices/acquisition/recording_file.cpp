#include "devices/acquisition/recording_file.h"

#include "control/base/assert.h"
#include "devices/acquisition/recording_csv.h"
#include "devices/profile.h"

#include <QtCore/QDir>
#include <QtCore/QFileInfo>

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>

namespace halbench::devices {

namespace {

constexpr qint64 MaxMeta = qint64{64} << 20;
constexpr qint64 MaxData = qint64{256} << 20;
constexpr double GapFactor = 1.5; // a step longer than this many periods has lost rows
constexpr std::size_t RowsPerBlock = 4096;

QString pathOf(const std::string& path) {
    return QString::fromStdString(path);
}

/// Qt has no words for a flush that failed; the system has.
std::string causeOf(const QFile& file) {
    const int cause = errno;
    return file.errorString() == QLatin1String("Unknown error") ? std::strerror(cause)
                                                                : file.errorString().toStdString();
}

tl::unexpected<Error> fileError(const std::string& path, const std::string& doing, const QFile& file) {
    return failure(ErrorCode::FileSystem, fmt::format("cannot {} '{}': {}", doing, path, causeOf(file)),
                   doing == "read" ? "check the path"
                                   : "check that the folder can be written and the disk has room");
}

std::string partialOf(const std::string& path) {
    return path + ".partial";
}

Result<void> moveInto(const std::string& from, const std::string& to) {
    if (std::rename(from.c_str(), to.c_str()) != 0) {
        return failure(ErrorCode::FileSystem,
                       fmt::format("cannot rename '{}' to '{}': {}", from, to, std::strerror(errno)),
                       "check that the folder can be written");
    }
    return {};
}

Result<void> createFolderOf(const std::string& path) {
    const QFileInfo info(pathOf(path));
    if (!QDir().mkpath(info.path())) {
        return failure(ErrorCode::FileSystem,
                       fmt::format("cannot create the folder '{}'", info.path().toStdString()),
                       "give a folder that can be written");
    }
    if (info.isDir()) {
        return failure(ErrorCode::FileSystem, fmt::format("'{}' is a folder", path),
                       "give the name of a file");
    }
    return {};
}

/// Everything on the disk, not only in the system's memory.
bool sync(QFile& file) {
    return file.flush() && ::fsync(file.handle()) == 0;
}

Result<void> writeText(const std::string& path, const std::string& text) {
    QFile file(pathOf(path));
    if (!file.open(QIODevice::WriteOnly)) {
        return fileError(path, "write", file);
    }
    const bool isWritten =
        file.write(text.data(), static_cast<qint64>(text.size())) == static_cast<qint64>(text.size());
    if (!isWritten || !sync(file)) {
        auto error = fileError(path, "write", file);
        std::remove(path.c_str()); // QFile would write the rest before it removes
        return error;
    }
    return {};
}

Result<std::string> readText(const std::string& path, qint64 limit) {
    QFile file(pathOf(path));
    if (QFileInfo(file).isDir() || !file.open(QIODevice::ReadOnly)) {
        return fileError(path, "read", file);
    }
    if (file.size() > limit) {
        return failure(ErrorCode::InvalidInput, fmt::format("'{}' has {} octets", path, file.size()),
                       fmt::format("at most {} are read", limit));
    }
    return file.readAll().toStdString();
}

/// Rows missing directly before this one.
std::uint64_t lostBefore(const Recording& recording, std::size_t row) {
    const double period_s = recording.layout->period_s;
    if (row == 0 || period_s <= 0.0) {
        return 0;
    }
    const double steps = (recording.time_s[row] - recording.time_s[row - 1]) / period_s;
    return steps > GapFactor ? static_cast<std::uint64_t>(std::min(std::round(steps) - 1.0, 1e15)) : 0;
}

/// One behind the last row of the block that begins here: a block ends before a gap.
std::size_t blockEnd(const Recording& recording, std::size_t begin) {
    std::size_t end = begin + 1;
    while (end < recording.rows() && end - begin < RowsPerBlock && lostBefore(recording, end) == 0) {
        ++end;
    }
    return end;
}

SampleBlock blockOf(const Recording& recording, std::size_t begin, std::size_t end) {
    const std::size_t columns = recording.layout->columns.size();
    const auto at = [](const std::vector<double>& values, std::size_t index) {
        return values.begin() + static_cast<std::ptrdiff_t>(index);
    };
    SampleBlock block;
    block.layout = recording.layout;
    block.lostRows = lostBefore(recording, begin);
    block.time_s.assign(at(recording.time_s, begin), at(recording.time_s, end));
    block.values.assign(at(recording.values, begin * columns), at(recording.values, end * columns));
    return block;
}

std::string hexOf(const QByteArray& hash) {
    return hash.toHex().toStdString();
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

} // namespace

RecordingWriter::RecordingWriter(std::string path, RecordingMeta meta)
    : m_path(std::move(path)), m_meta(std::move(meta)), m_file(pathOf(partialOf(m_path))),
      m_hash(QCryptographicHash::Sha256) {}

Result<std::unique_ptr<RecordingWriter>>
RecordingWriter::create(const std::string& path, const StreamLayout& layout, RecordingMeta meta) {
    if (const Result<void> folder = createFolderOf(path); !folder) {
        return failure(folder.error());
    }
    std::unique_ptr<RecordingWriter> writer(new RecordingWriter(path, std::move(meta)));
    if (!writer->m_file.open(QIODevice::WriteOnly)) {
        return fileError(path, "write", writer->m_file);
    }
    // The sidecar as it stands lets an interrupted recording be recovered with its names and parameters.
    if (const Result<void> meta_ = writeText(partialOf(metaPathOf(path)), toMetaJson(writer->m_meta));
        !meta_) {
        writer->m_file.remove();
        return failure(meta_.error());
    }
    if (const Result<void> header = writer->put(csvHeader(layout)); !header) {
        writer->m_file.remove();
        QFile::remove(pathOf(partialOf(metaPathOf(path))));
        return failure(header.error());
    }
    return writer;
}

Result<void> RecordingWriter::put(const std::string& text) {
    if (m_error) {
        return failure(*m_error);
    }
    const auto size = static_cast<qint64>(text.size());
    if (m_file.write(text.data(), size) != size || !m_file.flush()) {
        const auto error = fileError(m_path, "write", m_file);
        m_error = error.value();
        return error;
    }
    m_hash.addData(text.data(), static_cast<int>(text.size()));
    return {};
}

Result<void> RecordingWriter::append(const SampleBlock& block) {
    if (block.lostRows != 0 && block.rows() != 0) {
        m_meta.gaps.push_back({block.time_s.front(), block.lostRows});
    }
    m_meta.rows += block.rows();
    m_text.clear();
    appendCsvRows(m_text, block);
    return put(m_text);
}

void RecordingWriter::addMarker(double time_s, const std::string& text) {
    m_meta.markers.push_back({time_s, text});
}

void RecordingWriter::addChange(double time_s, const std::string& name, double value) {
    m_meta.changes.push_back({time_s, name, value});
}

Result<void> RecordingWriter::finish() {
    if (m_error) {
        return failure(*m_error);
    }
    if (!sync(m_file)) {
        return fileError(m_path, "write", m_file);
    }
    m_file.close();
    m_meta.sha256 = hexOf(m_hash.result());
    const std::string metaPath = metaPathOf(m_path);
    if (Result<void> written = writeText(partialOf(metaPath), toMetaJson(m_meta)); !written) {
        return written;
    }
    if (Result<void> moved = moveInto(partialOf(m_path), m_path); !moved) {
        return moved;
    }
    return moveInto(partialOf(metaPath), metaPath);
}

Result<void> writeRecordingFile(const std::string& path, const Recording& recording, RecordingMeta meta) {
    HB_ASSERT(recording.layout != nullptr);
    meta.rows = 0;
    Result<std::unique_ptr<RecordingWriter>> writer =
        RecordingWriter::create(path, *recording.layout, std::move(meta));
    if (!writer) {
        return failure(writer.error());
    }
    Result<void> done;
    for (std::size_t begin = 0; done && begin < recording.rows();) {
        const std::size_t end = blockEnd(recording, begin);
        done = (*writer)->append(blockOf(recording, begin, end));
        begin = end;
    }
    done = done ? (*writer)->finish() : done;
    if (!done) {
        writer->reset();
        QFile::remove(pathOf(partialOf(path)));
        QFile::remove(pathOf(partialOf(metaPathOf(path))));
    }
    return done;
}

Result<RecordedFile> readRecordingFile(const std::string& path) {
    const Result<std::string> text = readText(path, MaxData);
    if (!text) {
        return failure(text.error());
    }
    Result<Recording> recording = parseRecordingCsv(*text, path);
    if (!recording) {
        return failure(recording.error());
    }
    RecordedFile file;
    file.recording = *std::move(recording);
    const std::string metaPath = metaPathOf(path);
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
        const QByteArray hash =
            QCryptographicHash::hash(QByteArray::fromStdString(*text), QCryptographicHash::Sha256);
        if (hexOf(hash) != file.meta.sha256) {
            file.warnings.push_back(fmt::format("'{}' was changed since it was recorded (SHA-256)", path));
        }
    }
    nameColumns(file);
    return file;
}

Result<std::uint64_t> recoverRecording(const std::string& path) {
    Result<std::string> text = readText(partialOf(path), MaxData);
    if (!text) {
        return failure(text.error());
    }
    text->resize(text->rfind('\n') == std::string::npos ? 0 : text->rfind('\n') + 1);
    const Result<Recording> recording = parseRecordingCsv(*text, partialOf(path));
    if (!recording) {
        return failure(recording.error());
    }
    RecordingMeta meta;
    const std::string metaPartial = partialOf(metaPathOf(path));
    if (QFileInfo::exists(pathOf(metaPartial))) {
        const Result<std::string> metaText = readText(metaPartial, MaxMeta);
        Result<RecordingMeta> read = metaText ? parseMetaJson(*metaText, metaPartial)
                                              : Result<RecordingMeta>(failure(metaText.error()));
        if (read) {
            meta = *std::move(read);
        }
    }
    meta.gaps.clear();
    meta.markers.push_back(
        {recording->rows() != 0 ? recording->time_s.back() : 0.0, "recording interrupted"});
    RecordedFile file{*recording, meta, true, {}};
    nameColumns(file);
    if (const Result<void> written = writeRecordingFile(path, file.recording, std::move(meta)); !written) {
        return failure(written.error());
    }
    return recording->rows();
}

} // namespace halbench::devices
