// What watching costs: the connection's share of a core at 12 signals of 1 kHz, and the memory of an hour.
#include "app/window/window_application.h"
#include "tests/bench/goal.h"
#include "tests/bench/window_rig.h"
#include "tests/memory_in_use.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QStandardPaths>
#include <QtTest/QTest>

#include <cmath>
#include <ctime>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace halbench::bench {
namespace {

constexpr std::size_t Signals = 12;
constexpr double Rate_Hz = 1000.0;

double threadTime_s() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Processor time of the connection thread so far, asked for on that thread.
double connectionTime_s(app::DeviceSession& session) {
    const auto time_s = std::make_shared<double>(0.0);
    (void)request(session, [time_s](devices::Device&) -> Result<void> {
        *time_s = threadTime_s();
        return {};
    });
    return *time_s;
}

/// Every block of the stream, as a second listener beside the window.
class Listener {
public:
    void take(const TimedBlock& block) {
        const std::lock_guard lock(m_mutex);
        m_rows += block.rows();
        m_lost += block.block->lostRows;
        m_first_s = m_first_s < 0.0 ? block.begin_s() : m_first_s;
        m_last_s = block.end_s();
        m_blocks.push_back(block);
    }
    /// Rows that the device's time axis has and the stream has not.
    double missingRows() const {
        const std::lock_guard lock(m_mutex);
        return std::round((m_last_s - m_first_s) * Rate_Hz) + 1.0 - static_cast<double>(m_rows);
    }
    std::uint64_t lostRows() const { return m_lost; }
    std::size_t rows() const { return m_rows; }
    const std::vector<TimedBlock>& blocks() const { return m_blocks; }

private:
    mutable std::mutex m_mutex;
    std::vector<TimedBlock> m_blocks;
    std::size_t m_rows = 0;
    std::uint64_t m_lost = 0;
    double m_first_s = -1.0;
    double m_last_s = 0.0;
};

bool watchTwelve(app::MainWindow& window) {
    app::DeviceSession& session = window.bench().session();
    std::vector<std::string> names;
    for (const SignalSpec& spec : session.catalogue().signals) {
        if (spec.maxRate_Hz >= Rate_Hz && names.size() < Signals) {
            names.push_back(spec.name);
        }
    }
    session.setLiveStream(names, Rate_Hz);
    window.bench().clearHistory();
    return names.size() == Signals &&
           QTest::qWaitFor([&] { return window.bench().history().range().has_value(); }, Patience_ms);
}

/// The simulated motor and its board run on the connection's thread too: the share is an upper bound.
void benchShare(Goals& goals, app::MainWindow& window) {
    constexpr int Duration_ms = 10000;
    app::DeviceSession& session = window.bench().session();
    const auto listener = std::make_shared<Listener>();
    session.setBlockSink([listener](const TimedBlock& block) { listener->take(block); });
    const double before_s = connectionTime_s(session);
    QElapsedTimer wall;
    wall.start();
    QTest::qWait(Duration_ms);
    double used_s = connectionTime_s(session) - before_s;
    const double wall_s = 1e-3 * static_cast<double>(wall.elapsed());
    session.setBlockSink({});
    const double start_s =
        threadTime_s(); // what the window's thread does with them: the same blocks once more
    control::SampleHistory history(std::size_t{256} << 20);
    for (const TimedBlock& block : listener->blocks()) {
        BlockColumns columns;
        columns.shift_s = block.shift_s;
        history.append(*block.block, columns);
    }
    used_s += threadTime_s() - start_s;
    if (static_cast<double>(listener->rows()) < 0.9 * Rate_Hz * wall_s) {
        return goals.failed("acquisition", "the stream did not keep its rate");
    }
    goals.below("acquisition of 12 signals at 1 kHz, share of a core", used_s / wall_s, 0.1, "");
    goals.below("rows that did not arrive",
                listener->missingRows() + static_cast<double>(listener->lostRows()), 1.0, "rows");
    goals.below("rows that the window lost", static_cast<double>(window.bench().history().lostRows()), 1.0,
                "rows");
}

/// An hour of device time through the window as it is, plots drawn, as fast as this machine simulates it. The
/// history is full after about a third of it; from then on every row that comes sends an old one to the disk.
void benchHour(Goals& goals, app::MainWindow& window) {
    const std::string name =
        "an hour of running: growth of memory after the history was full, without its own";
    constexpr double Hour_s = 3600.0;
    constexpr int Longest_ms = 900000;
    /// Blocks on their way at this speed, the log and the allocator's unevenness. 170 MB pass meanwhile: what
    /// kept two octets in a hundred of them would be more.
    constexpr double Bound_MB = 3.0;
    app::Workbench& bench = window.bench();
    bench.session().setPace({100.0});
    const double start_s = bench.session().report().deviceTime_s;
    const auto elapsed_s = [&] { return bench.session().report().deviceTime_s - start_s; };
    const auto isFull = [&] { return bench.history().pagedBytes() > 0; };
    const auto own_MB = [&] { return static_cast<double>(bench.history().bytes()) / 1048576.0; };
    if (!QTest::qWaitFor([&] { return isFull() || elapsed_s() > Hour_s; }, Longest_ms) || !isFull()) {
        return goals.failed(name, "the history did not get full");
    }
    QTest::qWait(1000); // pyramids and pages that are touched for the first time
    const double full_s = elapsed_s();
    const double before_MB = memoryInUse_MB() - own_MB();
    if (!QTest::qWaitFor([&] { return elapsed_s() > std::max(Hour_s, 1.5 * full_s); }, Longest_ms)) {
        return goals.failed(name, "this machine is too slow for an hour");
    }
    goals.below(name, memoryInUse_MB() - own_MB() - before_MB, Bound_MB, "MB");
    goals.below("the same: of the history itself", own_MB(), 256.0, "MB");
    goals.below("the same: full after", full_s, Hour_s, "s of device time");
    goals.below("the same: rows lost", static_cast<double>(bench.history().lostRows()), 1.0, "rows");
}

int run() {
    Goals goals;
    const auto window = openWindow();
    if (!connectMotor(*window) || !watchTwelve(*window)) {
        goals.failed("acquisition", "12 signals of the simulated motor could not be watched");
        return goals.exitCode();
    }
    benchShare(goals, *window);
    benchHour(goals, *window);
    return goals.exitCode();
}

} // namespace
} // namespace halbench::bench

int main(int count, char** arguments) {
    QStandardPaths::setTestModeEnabled(true);
    const halbench::app::WindowApplication application(count, arguments);
    return halbench::bench::run();
}
