#include "devices/recording/recording_salvage.h"

#include "devices/recording/recording_chunks.h"
#include "devices/recording/recording_csv.h"
#include "devices/recording/time_axis.h"

#include <algorithm>
#include <optional>

namespace halbench::devices {

namespace {

/// Up to the end of the last line that was written wholly; a power loss may have left zeros behind it.
std::string_view wholeLines(std::string_view text) {
    const std::size_t written = text.find_last_not_of('\0');
    const std::size_t lastEnd = written == std::string_view::npos ? written : text.rfind('\n', written);
    return text.substr(0, lastEnd == std::string_view::npos ? 0 : lastEnd + 1);
}

/// With its end, which is taken from `text`.
std::string_view takeLine(std::string_view& text) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end == std::string_view::npos ? end : end + 1);
    text.remove_prefix(line.size());
    return line;
}

std::string_view withoutEnd(std::string_view line) {
    return line.substr(0, line.find('\n'));
}

/// The columns that the sidecar names; nothing when it says none, or contradicts itself: each follows from
/// name and unit of its signal.
std::optional<StreamLayout> columnsOf(const RecordingMeta& meta) {
    StreamLayout signals;
    for (const RecordingMeta::SignalNote& note : meta.signals) {
        signals.columns.push_back({note.name, note.unit});
    }
    const std::vector<std::string> names = csvColumnNames(signals);
    std::string header = "time_s";
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (meta.signals[i].column != names[i]) {
            return std::nullopt;
        }
        header += ',' + names[i];
    }
    Result<StreamLayout> layout = parseCsvHeader(header, "sidecar");
    return layout && !meta.signals.empty() ? std::optional(*std::move(layout)) : std::nullopt;
}

/// A damaged first line may still be a header, with another name in it, or with the first row in it. `next`:
/// the line behind it.
Result<StreamLayout> chooseColumns(std::string_view first, bool isConfirmed, std::string_view next,
                                   const RecordingMeta& meta, const std::string& origin) {
    Result<StreamLayout> own = parseCsvHeader(first, origin);
    std::optional<StreamLayout> told = columnsOf(meta);
    if (!told || (own && isConfirmed)) {
        return own;
    }
    Recording row;
    const bool isOfAnother = own && own->columns.size() != told->columns.size() &&
                             appendCsvRow(next, own->columns.size(), row); // a sidecar that is not its own
    return isOfAnother ? own : Result<StreamLayout>(*std::move(told));
}

/// Takes rows of text into one recording.
class Salvage {
public:
    explicit Salvage(std::size_t columns) : m_columns(columns) {}

    /// What a checksum confirms is rows; else it was not ours.
    void takeConfirmed(std::string_view text) {
        while (!text.empty()) {
            const std::size_t octets = text.size();
            if (!takes(takeLine(text))) {
                m_rows.damagedOctets += octets;
                return;
            }
        }
    }

    /// The end of the file.
    void takeUnchecked(std::string_view text) {
        const std::size_t confirmed = m_rows.recording.rows();
        std::string_view lines = wholeLines(text);
        m_rows.cutOctets += text.size() - lines.size();
        std::size_t rowOctets = 0; // of the last row
        while (!lines.empty()) {
            const std::size_t left = lines.size();
            const std::string_view line = takeLine(lines);
            if (takes(line)) {
                rowOctets = line.size();
                continue;
            }
            if (m_rows.recording.rows() > confirmed && mayBeWrong(line)) {
                dropLast();
                m_rows.damagedOctets += rowOctets;
            }
            if (m_rows.recording.rows() > 0) { // what follows may be of an older file
                m_rows.damagedOctets += left;
                break;
            }
            m_rows.damagedOctets += line.size(); // as nothing was read yet, this was no end of it either
        }
        m_rows.uncheckedRows = m_rows.recording.rows() - confirmed;
    }

    void leaveOut(std::string_view text) { m_rows.damagedOctets += text.size(); }

    SalvagedRows finish(StreamLayout layout) {
        Recording& recording = m_rows.recording;
        layout.period_s = nominalPeriod(recording.time_s);
        recording.lostRows = countLostRows(recording.time_s, layout.period_s);
        recording.layout = std::make_shared<const StreamLayout>(std::move(layout));
        return std::move(m_rows);
    }

private:
    bool takes(std::string_view line) { return appendCsvRow(withoutEnd(line), m_columns, m_rows.recording); }

    /// `line` is a row but for its time: was it the last one whose time is wrong, one that leapt ahead?
    bool mayBeWrong(std::string_view line) const {
        Recording alone;
        if (!appendCsvRow(withoutEnd(line), m_columns, alone)) {
            return false;
        }
        const std::vector<double>& time_s = m_rows.recording.time_s;
        return time_s.size() < 2 || alone.time_s[0] > time_s[time_s.size() - 2];
    }

    void dropLast() {
        m_rows.recording.time_s.pop_back();
        m_rows.recording.values.resize(m_rows.recording.values.size() - m_columns);
    }

    std::size_t m_columns;
    SalvagedRows m_rows;
};

} // namespace

Result<SalvagedRows> salvageRows(std::string_view text, std::string_view journal, const RecordingMeta& meta,
                                 const std::string& origin) {
    const std::vector<CheckedPart> parts = checkChunks(text, parseChunks(journal));
    const bool isConfirmed = !parts.empty() && parts.front().state == PartState::Confirmed;
    std::string_view rest = text;
    const std::string_view header = takeLine(rest);
    Result<StreamLayout> layout =
        chooseColumns(withoutEnd(header), isConfirmed, withoutEnd(takeLine(rest)), meta, origin);
    if (!layout) {
        return failure(layout.error());
    }
    Salvage salvage(layout->columns.size());
    for (const CheckedPart& part : parts) {
        const bool isFirst = part.text.data() == text.data();
        const std::string_view rows = part.text.substr(
            isFirst && part.state != PartState::Damaged ? std::min(header.size(), part.text.size()) : 0);
        if (part.state == PartState::Confirmed) {
            salvage.takeConfirmed(rows);
        } else if (part.state == PartState::Damaged) {
            salvage.leaveOut(rows);
        } else {
            salvage.takeUnchecked(rows);
        }
    }
    return salvage.finish(*std::move(layout));
}

bool holdsRows(std::string_view text, const RecordingMeta& meta) {
    std::string_view lines = wholeLines(text);
    const std::string_view first = withoutEnd(takeLine(lines));
    const Result<StreamLayout> own = parseCsvHeader(first, "");
    const std::optional<StreamLayout> told = columnsOf(meta);
    const bool isHeader = own && (!told || csvHeader(*told) == csvHeader(*own));
    return !lines.empty() || (!first.empty() && !isHeader);
}

} // namespace halbench::devices
