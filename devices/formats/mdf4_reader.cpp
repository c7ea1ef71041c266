#include "devices/formats/mdf4_reader.h"

#include "devices/formats/mdf4_blocks.h"
#include "devices/formats/mdf4_comment.h"
#include "devices/recording/recording_csv.h"
#include "devices/recording/time_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace halbench::devices {

namespace {

using namespace mdf4;

constexpr std::size_t RowsBetweenChecks = 1000;
constexpr std::size_t MaxChannels = 1024;
constexpr const char* Hint = "the file is damaged or from another program; export CSV there";

/// One block that lies wholly inside the file.
struct Block {
    std::string_view id;
    std::uint64_t offset = 0;
    std::string_view links;
    std::string_view data;

    std::uint64_t link(std::size_t index) const { return get<std::uint64_t>(links, index * LinkSize); }
};

/// Follows the links of a file that may be damaged.
class Reader {
public:
    Reader(std::string_view octets, const std::string& origin) : m_octets(octets), m_origin(origin) {}

    tl::unexpected<Error> wrongAt(std::string_view id, std::uint64_t offset, const std::string& what,
                                  const std::string& hint = Hint) const {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("{}: block {} at byte {}: {}", m_origin, id, offset, what), hint);
    }

    Result<Block> block(const Shape& shape, std::uint64_t offset) const {
        if (offset % 8 != 0 || offset > m_octets.size() || m_octets.size() - offset < shape.size()) {
            return wrongAt(shape.id, offset, "it is outside the file");
        }
        const std::string_view rest = m_octets.substr(offset);
        if (rest.substr(0, shape.id.size()) != shape.id) {
            return wrongAt(shape.id, offset, "unexpected block type");
        }
        const auto length = get<std::uint64_t>(rest, 8);
        if (length < shape.size() || length > rest.size()) {
            return wrongAt(shape.id, offset, fmt::format("invalid length {}", length));
        }
        if (get<std::uint64_t>(rest, 16) != shape.links) {
            return wrongAt(shape.id, offset, "unexpected links");
        }
        const std::size_t begin = HeaderSize + LinkSize * shape.links;
        return Block{shape.id, offset, rest.substr(HeaderSize, begin - HeaderSize),
                     rest.substr(begin, length - begin)};
    }

    /// The text of a TX or MD; "" without a link. Ours are linked once: together they are shorter than the
    /// file, which bounds the memory of a file that links one of them again and again.
    Result<std::string_view> text(const Shape& shape, std::uint64_t offset) {
        if (offset == 0) {
            return std::string_view();
        }
        const Result<Block> found = block(shape, offset);
        if (!found) {
            return failure(found.error());
        }
        m_textOctets += found->data.size();
        if (m_textOctets > m_octets.size()) {
            return wrongAt(shape.id, offset, "it is linked more than once");
        }
        return found->data.substr(0, found->data.find('\0'));
    }

    std::string_view octets() const { return m_octets; }

private:
    std::string_view m_octets;
    const std::string& m_origin;
    std::uint64_t m_textOctets = 0;
};

Result<void> checkIdentification(const Reader& reader) {
    const std::string_view octets = reader.octets();
    if (octets.size() < IdentificationSize || (octets.substr(0, FinalisedId.size()) != FinalisedId &&
                                               octets.substr(0, UnfinalisedId.size()) != UnfinalisedId)) {
        return reader.wrongAt("ID", 0, "not an MDF file", "the file must begin with \"MDF\"");
    }
    if (octets.substr(0, UnfinalisedId.size()) == UnfinalisedId || get<std::uint32_t>(octets, 60) != 0) {
        return reader.wrongAt("ID", 0, "the file is not finalised",
                              "writing was interrupted; write it again");
    }
    if (get<std::uint16_t>(octets, 28) != Version) {
        return reader.wrongAt("ID", 28, fmt::format("version {}", get<std::uint16_t>(octets, 28)),
                              "only version 410 is read");
    }
    if (octets.substr(16, Program.size()) != Program) {
        return reader.wrongAt("ID", 16, "the file is from another program",
                              "only MDF4 files of Halbench can be read; export CSV in that program");
    }
    return {};
}

struct Group {
    Block channels; ///< CG
    Block header;   ///< HD
    std::uint64_t data = 0;
};

/// HD -> the one DG -> the one CG.
Result<Group> readGroup(const Reader& reader) {
    const Result<Block> header = reader.block(Hd, HdOffset);
    if (!header) {
        return failure(header.error());
    }
    const Result<Block> dataGroup = reader.block(Dg, header->link(0));
    if (!dataGroup) {
        return failure(dataGroup.error());
    }
    if (dataGroup->link(0) != 0 || dataGroup->data[0] != 0) {
        return reader.wrongAt(Dg.id, dataGroup->offset, "the file is not sorted or has several groups");
    }
    const Result<Block> group = reader.block(Cg, dataGroup->link(1));
    if (!group) {
        return failure(group.error());
    }
    if (group->link(0) != 0 || get<std::uint16_t>(group->data, 16) != 0 ||
        get<std::uint32_t>(group->data, 28) != 0) {
        return reader.wrongAt(Cg.id, group->offset, "it has flags, invalidation bits or a neighbour");
    }
    return Group{*group, *header, dataGroup->link(2)};
}

/// Time first, then what is recorded: all 64-bit floats one behind the other.
bool isOurs(const Block& channel, std::size_t index) {
    return channel.link(1) == 0 && channel.link(4) == 0 && channel.link(5) == 0 &&
           get<std::uint8_t>(channel.data, 0) == (index == 0 ? Master : 0) &&
           get<std::uint8_t>(channel.data, 1) == (index == 0 ? TimeAxis : 0) &&
           get<std::uint8_t>(channel.data, 2) == Real && get<std::uint8_t>(channel.data, 3) == 0 &&
           get<std::uint32_t>(channel.data, 4) == index * sizeof(double) &&
           get<std::uint32_t>(channel.data, 8) == 64 && get<std::uint32_t>(channel.data, 12) == 0;
}

/// What a CSV header can hold.
bool isName(std::string_view name) {
    return !name.empty() && std::none_of(name.begin(), name.end(), [](char character) {
        return character == ',' || character == '"' || (character >= 0 && character < ' ');
    });
}

Result<RecordingMeta::SignalNote> readSignal(Reader& reader, const Block& channel) {
    const Result<std::string_view> name = reader.text(Tx, channel.link(2));
    const Result<std::string_view> unit = reader.text(Tx, channel.link(6));
    const Result<std::string_view> comment = reader.text(Md, channel.link(7));
    if (!name || !unit || !comment) {
        return failure(!name ? name.error() : !unit ? unit.error() : comment.error());
    }
    ChannelNote note;
    if (!comment->empty()) {
        Result<ChannelNote> read = readChannelComment(*comment);
        if (!read) {
            return reader.wrongAt(Md.id, channel.link(7), read.error().message);
        }
        note = *std::move(read);
    }
    const std::string signal = note.signal.empty() ? std::string(*name) : note.signal;
    if (!isName(signal)) {
        return reader.wrongAt(Cn.id, channel.offset, "not a valid signal name");
    }
    return RecordingMeta::SignalNote{signal, csvColumnName(signal, std::string(*unit)), std::string(*unit),
                                     note.role, note.expression};
}

Result<void> readChannels(Reader& reader, const Block& group, RecordingMeta& meta) {
    std::set<std::pair<std::string, std::string>> seen; // name and unit
    StreamLayout layout;
    std::size_t count = 0;
    for (std::uint64_t offset = group.link(1); offset != 0; ++count) {
        const Result<Block> channel = reader.block(Cn, offset);
        if (!channel) {
            return failure(channel.error());
        }
        if (!isOurs(*channel, count) || count > MaxChannels) {
            return reader.wrongAt(Cn.id, offset, "it is of another kind than time and 64-bit floats");
        }
        if (count > 0) {
            Result<RecordingMeta::SignalNote> signal = readSignal(reader, *channel);
            if (!signal) {
                return failure(signal.error());
            }
            if (!seen.insert({signal->name, signal->unit}).second) {
                return reader.wrongAt(Cn.id, offset, fmt::format("column '{}' occurs twice", signal->column));
            }
            layout.columns.push_back({signal->name, signal->unit});
            meta.signals.push_back(*std::move(signal));
        }
        offset = channel->link(0);
    }
    if (count == 0 || get<std::uint32_t>(group.data, 24) != count * sizeof(double)) {
        return reader.wrongAt(Cg.id, group.offset, "its row length does not match its channels");
    }
    nameColumnsOf(layout, meta);
    return {};
}

Result<void> readEvents(Reader& reader, std::uint64_t offset, RecordingMeta& meta) {
    while (offset != 0) {
        const Result<Block> event = reader.block(Ev, offset);
        if (!event) {
            return failure(event.error());
        }
        const double time_s =
            static_cast<double>(get<std::int64_t>(event->data, 16)) * get<double>(event->data, 24);
        const std::uint64_t next = event->link(0);
        if (!std::isfinite(time_s) || (next != 0 && next <= offset)) { // a chain never ends in itself
            return reader.wrongAt(Ev.id, offset, "its time channel or link is invalid");
        }
        const Result<std::string_view> name = reader.text(Tx, event->link(3));
        const Result<std::string_view> comment = reader.text(Md, event->link(4));
        if (!name || !comment) {
            return failure(name ? comment.error() : name.error());
        }
        auto change = comment->empty() ? Result<std::optional<RecordingMeta::ParameterChange>>(std::nullopt)
                                       : readEventComment(*comment);
        if (!change) {
            return reader.wrongAt(Md.id, event->link(4), change.error().message);
        }
        if (*change) {
            meta.changes.push_back({time_s, (*change)->name, (*change)->value});
        } else {
            meta.markers.push_back({time_s, std::string(*name)});
        }
        offset = next;
    }
    return {};
}

Result<void> readRows(const Reader& reader, const Block& data, std::uint64_t rows, std::size_t columns,
                      const std::function<Result<void>()>& checkAbort, Recording& recording) {
    const std::size_t width = (columns + 1) * sizeof(double);
    if (data.data.size() % width != 0 || data.data.size() / width != rows) {
        return reader.wrongAt(Dt.id, data.offset, fmt::format("its length does not match {} rows", rows));
    }
    recording.time_s.reserve(rows);
    recording.values.reserve(rows * columns);
    for (std::size_t place = 0; place < data.data.size(); place += width) {
        const double time_s = get<double>(data.data, place);
        if (!std::isfinite(time_s) || (!recording.time_s.empty() && time_s <= recording.time_s.back())) {
            return reader.wrongAt(Dt.id, data.offset,
                                  fmt::format("row {}: the time does not increase", place / width));
        }
        recording.time_s.push_back(time_s);
        for (std::size_t column = 1; column <= columns; ++column) {
            const double value = get<double>(data.data, place + column * sizeof(double));
            recording.values.push_back(std::isfinite(value) ? value
                                                            : std::numeric_limits<double>::quiet_NaN());
        }
        if (checkAbort && recording.time_s.size() % RowsBetweenChecks == 0) {
            if (Result<void> goesOn = checkAbort(); !goesOn) {
                return goesOn;
            }
        }
    }
    return {};
}

Result<void> readMeta(Reader& reader, const Group& group, RecordingMeta& meta) {
    const Result<std::string_view> comment = reader.text(Md, group.header.link(5));
    if (!comment) {
        return failure(comment.error());
    }
    if (const Result<void> read = readHeaderComment(*comment, meta); !read) {
        return reader.wrongAt(Md.id, group.header.link(5), read.error().message);
    }
    Result<void> read = readChannels(reader, group.channels, meta);
    return read ? readEvents(reader, group.header.link(4), meta) : read;
}

} // namespace

Result<RecordedFile> parseMdf4(std::string_view octets, const std::string& origin,
                               const std::function<Result<void>()>& checkAbort) {
    Reader reader(octets, origin);
    if (const Result<void> known = checkIdentification(reader); !known) {
        return failure(known.error());
    }
    const Result<Group> group = readGroup(reader);
    if (!group) {
        return failure(group.error());
    }
    RecordedFile file;
    file.hasMeta = true;
    if (const Result<void> read = readMeta(reader, *group, file.meta); !read) {
        return failure(read.error());
    }
    const Result<Block> data = reader.block(Dt, group->data);
    if (!data) {
        return failure(data.error());
    }
    file.meta.rows = get<std::uint64_t>(group->channels.data, CycleCount);
    if (const Result<void> read =
            readRows(reader, *data, file.meta.rows, file.meta.signals.size(), checkAbort, file.recording);
        !read) {
        return failure(read.error());
    }
    StreamLayout layout;
    for (const RecordingMeta::SignalNote& signal : file.meta.signals) {
        layout.columns.push_back({signal.name, signal.unit});
    }
    const double period_s = nominalPeriod(file.recording.time_s);
    layout.period_s = file.meta.period_s > 0.0 ? file.meta.period_s : period_s;
    file.recording.lostRows = countLostRows(file.recording.time_s, period_s);
    file.recording.layout = std::make_shared<const StreamLayout>(std::move(layout));
    setRates(file.recording, file.meta.rates);
    return file;
}

} // namespace halbench::devices
