#include "devices/recording/recording_writer.h"

#include "control/base/assert.h"
#include "devices/recording/file_access.h"
#include "devices/recording/recording_csv.h"
#include "devices/recording/time_axis.h"

#include <QtCore/QFileInfo>

#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

namespace halbench::devices {

namespace {

constexpr std::size_t RowsPerBlock = 4096;

QString pathOf(const std::string& path) {
    return QString::fromStdString(path);
}

/// Everything on the disk, not only in the system's memory.
bool sync(QFile& file) {
    return file.flush() && ::fsync(file.handle()) == 0;
}

Result<void> writeText(const std::string& path, const std::string& text) {
    QFile file(pathOf(path));
    if (!file.open(QIODevice::WriteOnly)) {
        return cannotWrite(path, file);
    }
    const bool isWritten =
        file.write(text.data(), static_cast<qint64>(text.size())) == static_cast<qint64>(text.size());
    if (!isWritten || !sync(file)) {
        auto error = cannotWrite(path, file);
        std::remove(path.c_str()); // QFile would write the rest before it removes
        return error;
    }
    return {};
}

/// One behind the last row of the block that begins here: a block ends before a gap.
std::size_t blockEnd(const Recording& recording, std::size_t begin) {
    std::size_t end = begin + 1;
    while (end < recording.rows() && end - begin < RowsPerBlock && lostRowsBefore(recording, end) == 0) {
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
    block.lostRows = lostRowsBefore(recording, begin);
    block.time_s.assign(at(recording.time_s, begin), at(recording.time_s, end));
    block.values.assign(at(recording.values, begin * columns), at(recording.values, end * columns));
    return block;
}

/// Two programs with one file would mix their rows; a lock ends with its program, however that ended.
bool lock(QFile& file) {
    return ::flock(file.handle(), LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

/// A name beside `path` that is free: "run.interrupted.csv", "run.interrupted-2.csv" ...
std::string nameAside(const std::string& path) {
    const QFileInfo info(pathOf(path));
    const std::string ending = info.suffix() == QLatin1String("csv") ? ".csv" : "";
    const std::string stem = path.substr(0, path.size() - ending.size()) + ".interrupted";
    std::string name = stem + ending;
    for (int number = 2; QFileInfo::exists(pathOf(partialPathOf(name))); ++number) {
        name = fmt::format("{}-{}{}", stem, number, ending);
    }
    return name;
}

/// Everything at once, or nothing.
Result<void> writeAll(const std::string& path, const Recording& recording, RecordingMeta meta,
                      const std::string& suffix, CsvNumbers numbers) {
    HB_ASSERT(recording.layout != nullptr);
    meta.rates = recording.rates;
    Result<std::unique_ptr<RecordingWriter>> writer =
        RecordingWriter::create(path, *recording.layout, std::move(meta), {suffix, {}, realDisk(), numbers});
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
        (*writer)->discard();
    }
    return done;
}

} // namespace

std::string partialPathOf(const std::string& path) {
    return path + ".partial";
}

std::string journalPathOf(const std::string& path) {
    const std::string meta = metaPathOf(path);
    constexpr std::string_view Ending = ".meta.json";
    return partialPathOf(meta.substr(0, meta.size() - Ending.size()) + ".chunks");
}

std::string completeMetaPathOf(const std::string& path) {
    return partialPathOf(metaPathOf(path)) + ".new";
}

std::string nextMetaPathOf(const std::string& path) {
    return partialPathOf(metaPathOf(path)) + ".next";
}

RecordingWriter::RecordingWriter(const std::string& path, WriterOptions options, RecordingMeta meta)
    : m_options(std::move(options)), m_path(path), m_partial(path + m_options.suffix),
      m_metaPartial(metaPathOf(path) + m_options.suffix), m_meta(std::move(meta)), m_file(pathOf(m_partial)),
      m_hash(QCryptographicHash::Sha256) {
    m_meta.rows = 0;
    if (m_meta.device.transport == "replay") {
        m_options.numbers = CsvNumbers::Exact;
    }
}

/// Opens the working file; what is there already is a recording that somebody may want back.
Result<void> RecordingWriter::open() {
    const auto taken =
        failure(ErrorCode::Usage, fmt::format("'{}' is being written by another program", m_partial),
                "wait until it is finished, or use another name");
    if (QFile old(pathOf(m_partial)); old.open(QIODevice::ReadOnly) && old.size() > 0) {
        if (!lock(old)) {
            return taken;
        }
        const std::string aside = nameAside(m_path);
        if (Result<void> moved = moveInto(m_partial, partialPathOf(aside)); !moved) {
            return moved;
        }
        if (QFileInfo::exists(pathOf(m_metaPartial))) {
            (void)moveInto(m_metaPartial, partialPathOf(metaPathOf(aside))); // the rows can be read without
        }
        if (QFileInfo::exists(pathOf(journalPathOf(m_path)))) {
            (void)moveInto(journalPathOf(m_path), journalPathOf(aside));
        }
        m_movedAside = partialPathOf(aside);
    }
    if (!m_file.open(QIODevice::WriteOnly)) {
        return cannotWrite(m_path, m_file);
    }
    return lock(m_file) ? Result<void>() : taken;
}

Result<std::unique_ptr<RecordingWriter>> RecordingWriter::create(const std::string& path,
                                                                 const StreamLayout& layout,
                                                                 RecordingMeta meta, WriterOptions options) {
    if (const Result<void> folder = createFolderOf(path); !folder) {
        return failure(folder.error());
    }
    nameColumnsOf(layout, meta);
    std::unique_ptr<RecordingWriter> writer(new RecordingWriter(path, std::move(options), std::move(meta)));
    Result<void> begun = writer->open();
    if (!begun) {
        return failure(begun.error());
    }
    // The sidecar as it stands lets an interrupted recording be recovered with its names and parameters.
    begun = writeText(writer->m_metaPartial, toMetaJson(writer->m_meta));
    if (begun && writer->m_options.flushInterval_s) {
        writer->m_flush =
            std::make_unique<BackgroundFlush>(path, writer->m_file.handle(), journalPathOf(path),
                                              *writer->m_options.flushInterval_s, writer->m_options.disk);
    }
    begun = begun ? writer->put(csvHeader(layout)) : begun;
    if (!begun) {
        writer->discard();
        return failure(begun.error());
    }
    return writer;
}

Result<void> RecordingWriter::put(const std::string& text) {
    if (!m_error && m_flush) {
        m_error = m_flush->error();
    }
    if (m_error) {
        return failure(*m_error);
    }
    if (!m_options.disk.write(m_file, text)) {
        const auto error = cannotWrite(m_path, m_file);
        m_error = error.value();
        return error;
    }
    if (m_flush) {
        m_flush->add(text);
    }
    m_hash.addData(text.data(), static_cast<int>(text.size()));
    return {};
}

Result<void> RecordingWriter::append(const SampleBlock& block) {
    m_text.clear();
    appendCsvRows(m_text, block, m_options.numbers);
    if (Result<void> written = put(m_text); !written) {
        return written;
    }
    if ((block.lostRows != 0 || block.isBreak) && block.rows() != 0) {
        m_meta.gaps.push_back({block.time_s.front(), block.lostRows});
    }
    m_meta.rows += block.rows();
    m_meta.period_s = block.layout->period_s; // planned before, known now
    return {};
}

void RecordingWriter::addMarker(double time_s, const std::string& text) {
    m_meta.markers.push_back({time_s, text});
}

void RecordingWriter::addChange(double time_s, const std::string& parameter, double value) {
    m_meta.changes.push_back({time_s, parameter, value});
}

Result<void> RecordingWriter::keepEvents(const RecordingEvents& events) {
    RecordingMeta meta = m_meta;
    meta.markers.insert(meta.markers.end(), events.markers.begin(), events.markers.end());
    meta.changes.insert(meta.changes.end(), events.changes.begin(), events.changes.end());
    meta.droppedRows = events.droppedRows;
    meta.rates = events.rates;
    meta.rows = 0; // a recovery counts them and finds the gaps
    meta.gaps.clear();
    const std::string next = nextMetaPathOf(m_path);
    const Result<void> written = writeText(next, toMetaJson(meta));
    return written ? moveInto(next, m_metaPartial) : written;
}

Result<void> RecordingWriter::finish() {
    if (m_error) {
        return failure(*m_error);
    }
    if (!m_options.disk.sync(m_file.handle())) {
        return cannotWrite(m_path, m_file);
    }
    m_flush.reset();
    m_file.close();
    m_meta.sha256 = m_hash.result().toHex().toStdString();
    const std::string metaPath = metaPathOf(m_path);
    const std::string complete = completeMetaPathOf(m_path); // until it is, the first one serves a recovery
    if (Result<void> written = writeText(complete, toMetaJson(m_meta)); !written) {
        return written;
    }
    if (Result<void> moved = moveInto(m_partial, m_path); !moved) {
        std::remove(complete.c_str());
        return moved;
    }
    Result<void> moved = moveInto(complete, metaPath);
    if (moved) {
        removeWorkingFiles();
    }
    return moved;
}

void RecordingWriter::removeWorkingFiles() {
    std::remove(m_partial.c_str());
    std::remove(m_metaPartial.c_str());
    std::remove(nextMetaPathOf(m_path).c_str());
    if (m_options.flushInterval_s) {
        std::remove(journalPathOf(m_path).c_str());
    }
}

bool RecordingWriter::abandon() {
    if (m_meta.rows == 0) {
        discard();
        return false;
    }
    if (m_flush) {
        m_flush->stop(true);
    }
    m_file.close();
    return true;
}

void RecordingWriter::discard() {
    m_flush.reset();
    m_file.close();
    removeWorkingFiles();
}

Result<void> writeRecordingFile(const std::string& path, const Recording& recording, RecordingMeta meta) {
    return writeAll(path, recording, std::move(meta), ".partial", CsvNumbers::BoardFloats);
}

Result<void> writeExactRecordingFile(const std::string& path, const Recording& recording, RecordingMeta meta,
                                     const std::string& suffix) {
    return writeAll(path, recording, std::move(meta), suffix, CsvNumbers::Exact);
}

} // namespace halbench::devices
