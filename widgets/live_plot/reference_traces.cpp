#include "widgets/live_plot/reference_traces.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace halbench::widgets {
namespace {

constexpr std::size_t MostSamples = 1000000;
constexpr std::size_t Columns = 262144;

/// Makes a history of one signal; a history of its own, because its time is not that of the others.
class TraceMaker {
public:
    TraceMaker(const std::string& signal, const std::string& unit, std::size_t samples)
        : m_history(std::make_shared<control::SampleHistory>(64 * samples + (std::size_t{1} << 20U))) {
        StreamLayout layout; // without a period: what is a gap is said with the samples
        layout.columns = {{signal, unit}};
        m_block.layout = std::make_shared<const StreamLayout>(std::move(layout));
    }
    void add(double time_s, double value, bool isAfterGap) {
        if (isAfterGap) {
            flush();
            m_block.lostRows = 1;
        }
        if (m_block.time_s.empty() || time_s > m_block.time_s.back()) {
            m_block.time_s.push_back(time_s);
            m_block.values.push_back(value);
        }
    }
    std::shared_ptr<const control::SampleHistory> finish() {
        flush();
        return m_history;
    }

private:
    void flush() {
        m_history->append(m_block);
        m_block.time_s.clear();
        m_block.values.clear();
        m_block.lostRows = 0;
    }

    std::shared_ptr<control::SampleHistory> m_history;
    SampleBlock m_block;
};

void addSamples(TraceMaker& maker, const control::SampleHistory& history, const std::string& signal,
                control::TimeRange range) {
    std::vector<control::TimedValue> samples;
    history.samples(signal, range, samples);
    for (const control::TimedValue& sample : samples) {
        maker.add(sample.time_s, sample.value, sample.isAfterGap);
    }
}

void addColumns(TraceMaker& maker, const control::SampleHistory& history, const std::string& signal,
                control::TimeRange range) {
    std::vector<control::HistoryColumn> columns;
    history.columns(signal, range, Columns, columns);
    const double width_s = range.length_s() / static_cast<double>(Columns);
    bool isAfterGap = true;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        isAfterGap = isAfterGap || columns[i].isAfterGap;
        if (!columns[i].extremes.isEmpty()) {
            const double begin_s = range.begin_s + width_s * static_cast<double>(i);
            maker.add(begin_s + 0.25 * width_s, columns[i].extremes.min, isAfterGap);
            maker.add(begin_s + 0.75 * width_s, columns[i].extremes.max, false);
            isAfterGap = false;
        }
    }
}

} // namespace

ReferenceTraces keptTraces(const control::SampleHistory& history, const std::set<std::string>& signalNames,
                           control::TimeRange range) {
    ReferenceTraces traces;
    traces.begin_s = range.begin_s;
    for (const std::string& signal : signalNames) {
        const std::size_t rows = history.rowsIn(signal, range);
        if (rows == 0) {
            continue;
        }
        TraceMaker maker(signal, history.unit(signal), std::min(rows, MostSamples));
        if (rows > MostSamples) {
            addColumns(maker, history, signal, range);
        } else {
            addSamples(maker, history, signal, range);
        }
        traces.samples[signal] = maker.finish();
    }
    return traces;
}

ReferenceTraces tracesOf(const Recording& recording) {
    ReferenceTraces traces;
    if (recording.rows() == 0) {
        return traces;
    }
    traces.begin_s = recording.time_s.front();
    const double reach_s = 1.5 * recording.layout->period_s; // farther apart are rows with lost ones between
    const std::size_t width = recording.layout->columns.size();
    for (std::size_t column = 0; column < width; ++column) {
        const StreamLayout::Column& place = recording.layout->columns[column];
        TraceMaker maker(place.name, place.unit, recording.rows());
        for (std::size_t row = 0; row < recording.rows(); ++row) {
            const bool isAfterGap =
                row > 0 && reach_s > 0.0 && recording.time_s[row] - recording.time_s[row - 1] > reach_s;
            maker.add(recording.time_s[row], recording.values[row * width + column], isAfterGap);
        }
        traces.samples[place.name] = maker.finish();
    }
    return traces;
}

double shiftOf(const ReferenceTraces& traces, double begin_s, const std::optional<double>& event_s) {
    return event_s && traces.event_s ? *event_s - *traces.event_s : begin_s - traces.begin_s;
}

} // namespace halbench::widgets
