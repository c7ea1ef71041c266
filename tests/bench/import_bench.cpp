// Reading another program's table against the reader that everybody writes first: getline and strtod. What
// pandas takes for the same is measured by `./dev bench --peers`.
#include "control/base/random.h"
#include "devices/formats/csv_import.h"
#include "tests/bench/goal.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace halbench::bench {
namespace {

constexpr int Rows = 100000;
constexpr int Columns = 8;

std::string table(char separator, char decimal) {
    Random random(7);
    std::string text = fmt::format("t [s]{0}a{0}b{0}c{0}d{0}e{0}f{0}g\n", separator);
    for (int row = 0; row < Rows; ++row) {
        std::string line = fmt::format("{:.3f}", row / 1000.0);
        for (int column = 1; column < Columns; ++column) {
            line += separator + fmt::format("{}", random.gaussian());
        }
        std::replace(line.begin(), line.end(), '.', decimal);
        text += line + '\n';
    }
    return text;
}

/// Every line a string, every cell up to the next separator through strtod; the decimal comma becomes a point
/// before.
std::vector<double> plainRead(const std::string& text, char separator, char decimal) {
    std::vector<double> values;
    std::istringstream stream(text);
    std::string line;
    std::getline(stream, line);
    while (std::getline(stream, line)) {
        if (decimal == ',') {
            std::replace(line.begin(), line.end(), ',', '.');
        }
        const char* at = line.c_str();
        for (int column = 0; column < Columns; ++column) {
            char* end = nullptr;
            values.push_back(std::strtod(at, &end));
            at = *end == separator ? end + 1 : end;
        }
    }
    return values;
}

void benchReading(Goals& goals, char separator, char decimal) {
    const std::string text = table(separator, decimal);
    const double ours_s = processorTime_s(
        [&] {
            const auto plan = devices::planCsvImport(text, "x.csv", {});
            benchmark::DoNotOptimize(devices::importCsv(text, "x.csv", *plan)->recording.values.data());
        },
        5);
    const double plain_s =
        processorTime_s([&] { benchmark::DoNotOptimize(plainRead(text, separator, decimal).data()); }, 5);
    const double megabytes = static_cast<double>(text.size()) / 1e6;
    fmt::print("importing with '{}' and '{}': {:.0f} MB/s, getline and strtod {:.0f} MB/s\n", separator,
               decimal, megabytes / ours_s, megabytes / plain_s);
    // Two and a half to three times were measured; two leaves room for other work on the machine.
    goals.atLeast(
        fmt::format("importing a table with '{}' and '{}' against getline and strtod", separator, decimal),
        plain_s / ours_s, 2.0, "x");
}

} // namespace
} // namespace halbench::bench

int main() {
    halbench::bench::Goals goals;
    halbench::bench::benchReading(goals, ',', '.');
    halbench::bench::benchReading(goals, ';', ',');
    return goals.exitCode();
}
