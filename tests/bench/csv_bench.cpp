// Writing and reading recordings against what everybody writes first (fprintf, strtod) and, with --peers,
// against pandas on the same table in the same run.
#include "control/base/random.h"
#include "devices/recording/recording_csv.h"
#include "tests/bench/goal.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <vector>

namespace halbench::bench {
namespace {

constexpr std::size_t Rows = 200000;
constexpr std::size_t RowsPerBlock = 1000;
constexpr std::size_t Columns = 15; // and the time
constexpr int Rounds = 3;

/// The rows from `first` on, as a recorder gets them.
SampleBlock rowsOf(const SampleBlock& block, std::size_t first, std::size_t count) {
    SampleBlock rows;
    rows.layout = block.layout;
    const auto time = block.time_s.begin() + static_cast<std::ptrdiff_t>(first);
    const auto value = block.values.begin() + static_cast<std::ptrdiff_t>(first * Columns);
    rows.time_s.assign(time, time + static_cast<std::ptrdiff_t>(count));
    rows.values.assign(value, value + static_cast<std::ptrdiff_t>(count * Columns));
    return rows;
}

std::vector<SampleBlock> blocksOf(const SampleBlock& block) {
    std::vector<SampleBlock> blocks;
    for (std::size_t row = 0; row < Rows; row += RowsPerBlock) {
        blocks.push_back(rowsOf(block, row, RowsPerBlock));
    }
    return blocks;
}

/// A sine with noise in every column: numbers with all their digits.
SampleBlock table() {
    StreamLayout layout;
    layout.period_s = 1e-3;
    for (std::size_t column = 0; column < Columns; ++column) {
        layout.columns.push_back({fmt::format("s{}", column), "A"});
    }
    SampleBlock block;
    block.layout = std::make_shared<const StreamLayout>(std::move(layout));
    Random random(7);
    for (std::size_t row = 0; row < Rows; ++row) {
        block.time_s.push_back(static_cast<double>(row) / 1000.0);
        for (std::size_t column = 0; column < Columns; ++column) {
            block.values.push_back(std::sin(0.01 * static_cast<double>(row * (column + 1))) +
                                   0.01 * random.gaussian());
        }
    }
    return block;
}

std::string ourText(const SampleBlock& block) {
    std::string text = devices::csvHeader(*block.layout);
    devices::appendCsvRows(text, block, devices::CsvNumbers::Exact);
    return text;
}

void printed(const SampleBlock& block) {
    std::FILE* file = std::fopen("/dev/null", "w");
    for (std::size_t row = 0; row < block.rows(); ++row) {
        std::fprintf(file, "%.17g", block.time_s[row]);
        for (std::size_t column = 0; column < Columns; ++column) {
            std::fprintf(file, ",%.17g", block.value(row, column));
        }
        std::fputc('\n', file);
    }
    std::fclose(file);
}

double scanned(const std::string& text) {
    double sum = 0.0;
    std::istringstream stream(text);
    std::string line;
    std::getline(stream, line);
    while (std::getline(stream, line)) {
        char* at = line.data();
        for (std::size_t column = 0; column <= Columns; ++column) {
            sum += std::strtod(at, &at);
            at += *at == ',' ? 1 : 0;
        }
    }
    return sum;
}

/// Into a file, as pandas does, block by block, as the recorder does.
void write(std::FILE* file, const std::vector<SampleBlock>& blocks) {
    std::rewind(file);
    std::string text = devices::csvHeader(*blocks.front().layout);
    for (const SampleBlock& block : blocks) {
        devices::appendCsvRows(text, block, devices::CsvNumbers::Exact);
        std::fwrite(text.data(), 1, text.size(), file);
        text.clear();
    }
    std::fflush(file);
}

Result<Recording> read(std::FILE* file, std::size_t size) {
    std::string text(size, '\0');
    std::rewind(file);
    text.resize(std::fread(text.data(), 1, size, file));
    return devices::parseRecordingCsv(text, "x.csv");
}

bool isExact(const SampleBlock& block, const Recording& back) {
    bool isSame = back.values.size() == block.values.size() && back.time_s == block.time_s;
    for (std::size_t i = 0; isSame && i < block.values.size(); ++i) {
        isSame =
            std::bit_cast<std::uint64_t>(back.values[i]) == std::bit_cast<std::uint64_t>(block.values[i]);
    }
    return isSame;
}

struct Peer {
    double write_s = 0.0;
    double read_s = 0.0;
};

/// "WRITE_S READ_S" of the script, run by the system's Python, to which the package belongs, by processor
/// time like ours.
bool askPandas(Peer& peer) {
    std::FILE* pipe = popen("/usr/bin/python3 " HALBENCH_PEERS "/pandas_csv.py", "r");
    if (pipe == nullptr) {
        return false;
    }
    const bool isRead = std::fscanf(pipe, "%lf %lf", &peer.write_s, &peer.read_s) == 2;
    return pclose(pipe) == 0 && isRead;
}

int run(bool withPeers) {
    Goals goals;
    const SampleBlock block = table();
    const std::string text = ourText(block);
    std::FILE* file = std::tmpfile();
    const std::vector<SampleBlock> blocks = blocksOf(block);
    write(file, blocks);
    const auto back = read(file, text.size());
    if (!back || !isExact(block, *back)) {
        goals.failed("reading back every bit", "a value changed");
    }
    const double write_s = processorTime_s([&] { write(file, blocks); }, Rounds);
    const double read_s =
        processorTime_s([&] { benchmark::DoNotOptimize(read(file, text.size())->values.data()); }, Rounds);
    std::fclose(file);
    const double printf_s = processorTime_s([&] { printed(block); }, Rounds);
    const double strtod_s = processorTime_s([&] { benchmark::DoNotOptimize(scanned(text)); }, Rounds);
    const double megabytes = static_cast<double>(text.size()) / 1e6;
    fmt::print("CSV: writing {:.0f} MB/s, reading {:.0f} MB/s; fprintf {:.0f}, strtod {:.0f} MB/s\n",
               megabytes / write_s, megabytes / read_s, megabytes / printf_s, megabytes / strtod_s);
    goals.atLeast("writing CSV against fprintf %.17g", printf_s / write_s, 2.0, "x");
    goals.atLeast("reading CSV against getline and strtod", strtod_s / read_s, 1.5, "x");
    Peer pandas;
    if (withPeers && !askPandas(pandas)) {
        goals.failed("CSV against pandas", "python3-pandas could not be run");
    } else if (withPeers) {
        goals.atLeast("writing CSV against pandas to_csv", pandas.write_s / write_s, 10.0, "x");
        goals.atLeast("reading CSV, every bit, against pandas read_csv", pandas.read_s / read_s, 2.0, "x");
    }
    return goals.exitCode();
}

} // namespace
} // namespace halbench::bench

int main(int count, char** arguments) {
    return halbench::bench::run(count > 1 && std::strcmp(arguments[1], "--peers") == 0);
}
