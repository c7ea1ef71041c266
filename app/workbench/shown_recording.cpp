#include "app/workbench/shown_recording.h"

#include "app/workbench/played_recording.h"
#include "devices/recording/time_axis.h"
#include "widgets/language/phrasebook.h"

#include <algorithm>
#include <utility>

namespace halbench::app {

namespace {

/// In one go: some milliseconds of the window's time.
constexpr std::size_t PieceValues = 300000;
/// Between two pieces, for keys, mouse and frames.
constexpr int Pause_ms = 5;

} // namespace

ShownRecording::ShownRecording(Workbench& bench) : m_bench(bench) {
    m_filling.setInterval(Pause_ms);
    connect(&m_filling, &QTimer::timeout, this, &ShownRecording::fill);
    connect(&m_bench.session(), &DeviceSession::stateChanged, this, &ShownRecording::onState);
    connect(&m_bench.session(), &DeviceSession::connectFailed, this, &ShownRecording::forget);
    connect(&m_bench.session(), &DeviceSession::openProgress, this, [this](double fraction) {
        if (isReading()) {
            m_fraction = fraction;
            Q_EMIT changed();
        }
    });
    connect(&m_bench, &Workbench::derivedSignalsChanged, this, [this] {
        if (m_file != nullptr) { // all of it has them
            m_bench.clearHistory();
            begin(m_file);
        }
    });
}

void ShownRecording::open(const QString& path) {
    forget();
    m_path = path;
    m_wanted = QStringLiteral("replay:") + path;
    m_fraction = 0.0;
    m_bench.session().connectDevice(m_wanted, {0.0}); // time stands still
    Q_EMIT changed();
}

void ShownRecording::cancel() {
    if (isReading()) {
        m_wanted.clear();
        m_bench.session().closeRecording();
    } else if (m_filling.isActive()) {
        m_filling.stop();
        Q_EMIT ended();
    }
    Q_EMIT changed();
}

void ShownRecording::leave() {
    if (m_file != nullptr) {
        forget();
        m_bench.clearHistory();
    }
}

void ShownRecording::forget() {
    m_filling.stop();
    m_wanted.clear();
    m_file.reset();
    m_nextRow = 0;
    Q_EMIT changed();
}

double ShownRecording::length_s() const {
    const bool isThere = m_file != nullptr && m_file->recording.rows() > 0;
    return isThere ? m_file->recording.time_s.back() - m_file->recording.time_s.front() : 0.0;
}

double ShownRecording::shown_s() const {
    const bool isThere = m_file != nullptr && m_nextRow > 0;
    return isThere ? m_file->recording.time_s[m_nextRow - 1] - m_file->recording.time_s.front() : 0.0;
}

void ShownRecording::onState() {
    const DeviceSession& session = m_bench.session();
    if (session.state() != SessionState::Connected) {
        const bool isOver = session.state() == SessionState::Leaving && m_file != nullptr;
        if (isOver) { // what it showed stays until another device comes
            m_filling.stop();
            m_file.reset();
            Q_EMIT changed();
        }
        return;
    }
    if (m_wanted.isEmpty() || session.info().uri != m_wanted.toStdString()) {
        forget();
        return;
    }
    askPlayedRecording(m_bench.session(), *this,
                       [this, wanted = m_wanted](std::shared_ptr<const devices::RecordedFile> file) {
                           if (wanted == m_wanted && file != nullptr) {
                               m_wanted.clear();
                               begin(std::move(file));
                               sayDoubts();
                           }
                       });
}

void ShownRecording::begin(std::shared_ptr<const devices::RecordedFile> file) {
    m_file = std::move(file);
    m_nextRow = 0;
    m_fraction = 0.0;
    m_filling.start();
    Q_EMIT began();
    Q_EMIT changed();
}

void ShownRecording::sayDoubts() {
    for (const std::string& warning : m_file->warnings) {
        const QString text = widgets::inWords(warning);
        m_bench.session().message(MessageLevel::Warning, tr("recording"), text);
        Q_EMIT doubted(text);
    }
}

/// Up to the next rows that are missing.
SampleBlock ShownRecording::nextPiece() const {
    const Recording& recording = m_file->recording;
    const std::size_t width = recording.layout->columns.size();
    const std::size_t most = std::max<std::size_t>(PieceValues / std::max<std::size_t>(width, 1), 1);
    std::size_t end = m_nextRow + 1;
    while (end < recording.rows() && end - m_nextRow < most && devices::lostRowsBefore(recording, end) == 0) {
        ++end;
    }
    SampleBlock block;
    block.layout = recording.layout;
    block.lostRows = m_nextRow > 0 ? devices::lostRowsBefore(recording, m_nextRow) : 0;
    block.time_s.reserve(end - m_nextRow);
    for (std::size_t row = m_nextRow; row < end; ++row) {
        block.time_s.push_back(recording.time_s[row] - recording.time_s.front());
    }
    const auto at = [&](std::size_t row) {
        return recording.values.begin() + static_cast<std::ptrdiff_t>(row * width);
    };
    block.values.assign(at(m_nextRow), at(end));
    return block;
}

void ShownRecording::fill() {
    if (m_bench.settleHistory()) {
        return; // the disk is slower
    }
    const std::size_t rows = m_file->recording.rows();
    const std::size_t width = std::max<std::size_t>(m_file->recording.layout->columns.size(), 1);
    for (std::size_t values = 0; m_nextRow < rows && values < PieceValues;) {
        const SampleBlock block = nextPiece();
        m_bench.show(block, 0.0, true);
        m_nextRow += block.rows();
        values += (block.rows() + 1) * width; // many gaps make many pieces
    }
    m_fraction = static_cast<double>(m_nextRow) / static_cast<double>(rows);
    if (m_nextRow == rows) {
        m_filling.stop();
        Q_EMIT m_bench.samplesArrived();
        Q_EMIT ended();
    }
    Q_EMIT changed();
}

} // namespace halbench::app
