#pragma once

#include "control/base/result.h"
#include "control/base/sample_block.h"
#include "devices/recording/recording_meta.h"

#include <QtCore/QIODevice>

#include <string>

namespace halbench::devices {

/// Writes a recording as ASAM MDF 4.10, sorted: one group, time as its master channel, 64-bit floats, row
/// after row in one data block at the end; markers and changes of parameters as events behind it. Rows are
/// written as they come and none is kept. Until finish() the file calls itself unfinalised ("UnFinMF"), as
/// the standard wants it. The calls say whether the device took everything; it knows the cause. Thread: one.
class Mdf4Writer {
public:
    /// `output` is open for writing, can seek and outlives this.
    Mdf4Writer(QIODevice& output, RecordingMeta meta);

    bool begin(const StreamLayout& layout);
    bool append(const SampleBlock& block);
    bool finish();

private:
    std::uint64_t here() const { return m_begin + m_bytes.size(); }
    std::uint64_t addText(const std::string& text);
    std::uint64_t addComment(const std::string& xml);
    std::uint64_t addHistory();
    std::uint64_t addSource();
    std::uint64_t addChannels(const StreamLayout& layout);
    std::uint64_t addEvents();
    std::string headerBlock(std::uint64_t firstEvent) const;
    bool flush();
    bool patch(std::uint64_t offset, const std::string& octets);

    QIODevice& m_output;
    RecordingMeta m_meta;
    std::string m_bytes;              ///< not yet written
    std::uint64_t m_begin = 0;        ///< where they will stand in the file
    std::uint64_t m_history = 0;      ///< offsets of blocks
    std::uint64_t m_comment = 0;      ///<
    std::uint64_t m_dataGroup = 0;    ///<
    std::uint64_t m_channelGroup = 0; ///<
    std::uint64_t m_data = 0;         ///<
    std::uint64_t m_rows = 0;
    std::size_t m_columns = 0;
};

/// A whole recording at once; on an error nothing is left behind and an older file stays. Errors: FileSystem.
Result<void> writeMdf4File(const std::string& path, const Recording& recording, RecordingMeta meta);

} // namespace halbench::devices
