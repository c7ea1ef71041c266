#include "app/recordings/aligned_runs.h"

#include "control/base/assert.h"
#include "devices/recording/time_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace halbench::app {

namespace {

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
/// Of a period: times of recordings are decimal fractions, what is as near as that is the same time.
constexpr double SameTime_ratio = 1e-6;

/// The common time axis: multiples first ... first + rows - 1 of the period.
struct Grid {
    double period_s = 0.0;
    double rate_Hz = 0.0;
    double first = 0.0;
    std::size_t rows = 0;

    /// 3 / 10 Hz is 0.3 s, 3 * 0.1 s is not.
    double time_s(std::size_t row) const { return (first + static_cast<double>(row)) / rate_Hz; }
};

/// Rates are whole numbers when they are as near to one as a median of differences can be.
double rateOf(double period_s) {
    const double rate_Hz = 1.0 / period_s;
    return std::abs(rate_Hz - std::round(rate_Hz)) <= SameTime_ratio * rate_Hz ? std::round(rate_Hz)
                                                                               : rate_Hz;
}

std::string momentName(const RunAlignment& alignment) {
    switch (alignment.moment) {
    case RunAlignment::Moment::Trigger:
        return "trigger";
    case RunAlignment::Moment::Marker:
        return fmt::format("marker '{}'", alignment.marker);
    case RunAlignment::Moment::Start:
        break;
    }
    return "start";
}

/// Each once: a reference may mark every one of its steps.
std::string markerNames(const devices::RecordingMeta& meta) {
    std::string names;
    std::set<std::string> known;
    for (const auto& marker : meta.markers) {
        if (known.insert(marker.text).second) {
            names += (names.empty() ? "'" : ", '") + marker.text + "'";
        }
    }
    return names;
}

Result<std::vector<double>> zerosOf(const std::vector<ComparedRun>& runs, const RunAlignment& alignment) {
    std::vector<double> zeros_s;
    for (const ComparedRun& run : runs) {
        const std::optional<double> zero_s = alignedZero_s(run, alignment);
        if (!zero_s) {
            const std::string markers = markerNames(run.meta);
            return failure(ErrorCode::InvalidInput,
                           fmt::format("'{}' has no {}", run.name, momentName(alignment)),
                           markers.empty() ? "it has no markers; use --align start"
                                           : "it has the markers " + markers + "; or use --align start");
        }
        zeros_s.push_back(*zero_s);
    }
    return zeros_s;
}

Result<Grid> gridOf(const std::vector<ComparedRun>& runs, const std::vector<double>& zeros_s,
                    const OverlayRequest& request) {
    Grid grid;
    double begin_s = std::numeric_limits<double>::infinity();
    double end_s = -begin_s;
    std::size_t columns = 1;
    grid.period_s = begin_s;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const Recording& recording = runs[i].recording;
        if (recording.layout->period_s > 0.0) { // a single row has none
            grid.period_s = std::min(grid.period_s, recording.layout->period_s);
        }
        begin_s = std::min(begin_s, recording.time_s.front() - zeros_s[i]);
        end_s = std::max(end_s, recording.time_s.back() - zeros_s[i]);
        columns += recording.layout->columns.size();
    }
    if (!std::isfinite(grid.period_s)) {
        return failure(ErrorCode::InvalidInput, "none of the recordings has two rows",
                       "give recordings with data");
    }
    grid.rate_Hz = rateOf(grid.period_s);
    grid.period_s = 1.0 / grid.rate_Hz;
    begin_s = request.from_s.value_or(begin_s);
    end_s = request.to_s.value_or(end_s);
    grid.first = std::ceil(begin_s * grid.rate_Hz - SameTime_ratio);
    const double rows = std::floor(end_s * grid.rate_Hz + SameTime_ratio) - grid.first + 1.0;
    if (!(rows >= 1.0)) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("there is no row between {} s and {} s", begin_s, end_s),
                       "give --from and --to as times since the moment at which the runs are aligned");
    }
    if (rows * static_cast<double>(columns) > static_cast<double>(MostComparedValues)) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("{:.0f} rows of {} columns are too many numbers", rows, columns),
                       "give --from and --to, fewer signals or fewer recordings");
    }
    grid.rows = static_cast<std::size_t>(rows);
    return grid;
}

/// One run, read at increasing times.
class RunReader {
public:
    RunReader(const ComparedRun& run, double zero_s) : m_recording(run.recording), m_zero_s(zero_s) {}

    /// Appends the value of every signal at that time since the moment.
    void append(double time_s, std::vector<double>& values) {
        const double wanted_s = time_s + m_zero_s;
        const std::vector<double>& times_s = m_recording.time_s;
        const double near_s = SameTime_ratio * m_recording.layout->period_s;
        while (m_next < times_s.size() && times_s[m_next] < wanted_s - near_s) {
            ++m_next;
        }
        for (std::size_t column = 0; column < m_recording.layout->columns.size(); ++column) {
            values.push_back(m_next >= times_s.size()               ? NotANumber
                             : times_s[m_next] <= wanted_s + near_s ? at(m_next, column)
                                                                    : between(wanted_s, column));
        }
    }

private:
    double at(std::size_t row, std::size_t column) const {
        return m_recording.values[row * m_recording.layout->columns.size() + column];
    }
    /// Between the sample before and m_next.
    double between(double wanted_s, std::size_t column) const {
        if (m_next == 0 || devices::lostRowsBefore(m_recording, m_next) > 0) {
            return NotANumber;
        }
        const double before_s = m_recording.time_s[m_next - 1];
        const double share = (wanted_s - before_s) / (m_recording.time_s[m_next] - before_s);
        const double before = at(m_next - 1, column);
        const double after = at(m_next, column);
        if (m_recording.layout->columns[column].unit.empty()) {
            return share <= 0.5 ? before : after;
        }
        return before + share * (after - before);
    }

    const Recording& m_recording;
    double m_zero_s;
    std::size_t m_next = 0; ///< first sample that is not before the time
};

std::string labelOf(const std::string& name) {
    std::string label = name;
    for (char& letter : label) {
        const auto octet = static_cast<unsigned char>(letter);
        const bool isPlain = octet >= 0x80 || (letter >= '0' && letter <= '9') ||
                             (letter >= 'A' && letter <= 'Z') || (letter >= 'a' && letter <= 'z') ||
                             letter == '-' || letter == '_';
        letter = isPlain ? letter : '_';
    }
    return label;
}

} // namespace

Result<RunAlignment> alignmentNamed(const std::string& text) {
    constexpr std::string_view Marker = "marker:";
    if (text == "start") {
        return RunAlignment{};
    }
    if (text == "trigger") {
        return RunAlignment{RunAlignment::Moment::Trigger, {}};
    }
    if (text.size() > Marker.size() && text.compare(0, Marker.size(), Marker) == 0) {
        return RunAlignment{RunAlignment::Moment::Marker, text.substr(Marker.size())};
    }
    return failure(ErrorCode::Usage, "--align: '" + text + "' is no moment of a recording",
                   "use start, trigger or marker:TEXT");
}

std::vector<std::string> runLabels(const std::vector<ComparedRun>& runs) {
    std::vector<std::string> labels;
    std::set<std::string> taken;
    for (const ComparedRun& run : runs) {
        const std::string plain = labelOf(run.name);
        std::string label = plain;
        for (int number = 2; !taken.insert(label).second; ++number) {
            label = fmt::format("{}-{}", plain, number);
        }
        labels.push_back(label);
    }
    return labels;
}

Result<Recording> onOneAxis(const std::vector<ComparedRun>& runs, const OverlayRequest& request) {
    const Result<std::vector<double>> zeros_s = zerosOf(runs, request.alignment);
    if (!zeros_s) {
        return failure(zeros_s.error());
    }
    const Result<Grid> grid = gridOf(runs, *zeros_s, request);
    if (!grid) {
        return failure(grid.error());
    }
    const std::vector<std::string> labels = runLabels(runs);
    StreamLayout layout;
    layout.period_s = grid->period_s;
    std::vector<RunReader> readers;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        readers.emplace_back(runs[i], (*zeros_s)[i]);
        for (const StreamLayout::Column& column : runs[i].recording.layout->columns) {
            layout.columns.push_back({labels[i] + '.' + column.name, column.unit});
        }
    }
    Recording all;
    all.values.reserve(grid->rows * layout.columns.size());
    for (std::size_t row = 0; row < grid->rows; ++row) {
        all.time_s.push_back(grid->time_s(row));
        for (RunReader& reader : readers) {
            reader.append(all.time_s.back(), all.values);
        }
    }
    all.layout = std::make_shared<const StreamLayout>(std::move(layout));
    return all;
}

ColumnDifference differenceBetween(const Recording& recording, std::size_t reference, std::size_t column) {
    const std::size_t width = recording.layout->columns.size();
    HB_ASSERT(reference < width && column < width);
    ColumnDifference difference;
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t row = 0; row < recording.rows(); ++row) {
        const double apart =
            recording.values[row * width + column] - recording.values[row * width + reference];
        if (!std::isfinite(apart)) {
            continue;
        }
        ++difference.rows;
        sum += apart;
        squares += apart * apart;
        if (std::abs(apart) > std::abs(difference.largest) || difference.rows == 1) {
            difference.largest = apart;
            difference.largestAt_s = recording.time_s[row];
        }
    }
    if (difference.rows > 0) {
        difference.mean = sum / static_cast<double>(difference.rows);
        difference.rms = std::sqrt(squares / static_cast<double>(difference.rows));
    }
    return difference;
}

} // namespace halbench::app
