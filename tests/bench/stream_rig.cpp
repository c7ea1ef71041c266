#include "tests/bench/stream_rig.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <future>
#include <thread>
#include <vector>

namespace halbench::bench {

namespace {

using namespace devices;
using Clock = std::chrono::steady_clock;

StreamRequest allSignals() {
    StreamRequest request;
    request.rate_Hz = FastBoard::Rate_Hz;
    for (std::size_t i = 0; i < FastBoard::Signals; ++i) {
        request.signals.push_back(FastBoard::signalName(i));
    }
    return request;
}

/// What arrived, and whether every value is the one that was sent.
struct Arrivals {
    std::uint64_t rows = 0;
    std::uint64_t lost = 0;
    std::uint64_t wrong = 0;
    double expected = -1.0; ///< of the first signal in the next row

    void take(const SampleBlock& block) {
        lost += block.lostRows;
        rows += block.rows();
        for (std::size_t row = 0; row < block.rows(); ++row) {
            const double first = block.value(row, 0);
            const double last = block.value(row, FastBoard::Signals - 1);
            const bool isRight = (expected < 0.0 || first == expected) &&
                                 last == first + static_cast<double>(FastBoard::Signals - 1);
            wrong += isRight ? 0 : 1;
            expected = std::fmod(first + 1.0, 1024.0);
        }
    }
};

double percentile99(std::vector<double>& values) {
    std::sort(values.begin(), values.end());
    return values.empty() ? 0.0 : values[values.size() - 1 - values.size() / 100];
}

/// How late this machine, with all else that runs on it, wakes a thread that waits.
class WakeReference {
public:
    WakeReference() : m_thread([this] { run(); }) {}
    /// 99 % of the time it is less than this.
    double stop_s() {
        m_isEnding = true;
        m_thread.join();
        return percentile99(m_late_s);
    }

private:
    void run() {
        while (!m_isEnding) {
            const auto due = Clock::now() + std::chrono::milliseconds(1);
            (void)std::promise<void>().get_future().wait_until(due);
            m_late_s.push_back(std::chrono::duration<double>(Clock::now() - due).count());
        }
    }
    std::atomic<bool> m_isEnding{false};
    std::vector<double> m_late_s;
    std::thread m_thread;
};

} // namespace

double clockTime_s(clockid_t clock) {
    timespec time{};
    return clock_gettime(clock, &time) != 0
               ? 0.0
               : static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double threadTime_s(pthread_t thread) {
    clockid_t clock{};
    return pthread_getcpuclockid(thread, &clock) != 0 ? 0.0 : clockTime_s(clock);
}

void benchStream(Goals& goals, const BoardLine& line, double duration_s) {
    const std::string name = fmt::format("32 signals at 20 kHz {} for {} s", line.name, duration_s);
    const auto device = line.open(std::make_shared<LinkOrders>());
    if (!device) {
        return goals.failed(name, device.error().message);
    }
    Arrivals arrivals;
    const auto started =
        (*device)->startStream(allSignals(), [&](const SampleBlockPtr& block) { arrivals.take(*block); });
    if (!started) {
        return goals.failed(name, started.error().message);
    }
    const auto used_s = [&] { return line.used_s ? line.used_s() : threadTime_s(pthread_self()); };
    const double before_s = used_s();
    const auto wall = Clock::now();
    const auto waited = (*device)->clock().waitFor(duration_s);
    const double spent_s = used_s() - before_s;
    const double elapsed_s = std::chrono::duration<double>(Clock::now() - wall).count();
    (*device)->stopStream();
    if (!waited) {
        return goals.failed(name, waited.error().message);
    }
    const double expected = FastBoard::Rate_Hz * (elapsed_s - FastBoard::MaxBacklog_s);
    goals.atLeast(name + ", rows", static_cast<double>(arrivals.rows), expected, "rows");
    goals.below("the same: rows lost, dropped by the board or wrong",
                static_cast<double>(arrivals.lost + arrivals.wrong + line.board->dropped()), 1.0, "rows");
    goals.below("the same: share of a core", spent_s / elapsed_s, 0.25, "");
    fmt::print("    a sample waited {:.1f} ms for this host at worst\n", 1e3 * line.board->worstBacklog_s());
}

void benchStop(Goals& goals, const BoardLine& line) {
    const std::string name = "a stop at that stream " + line.name;
    constexpr int Presses = 300;
    constexpr double Goal_ms = 5.0;
    const auto orders = std::make_shared<LinkOrders>();
    const auto device = line.open(orders);
    if (!device || !(*device)->startStream(allSignals(), [](const SampleBlockPtr&) {})) {
        return goals.failed(name, "the board could not be opened");
    }
    std::vector<double> latencies_s;
    std::atomic<bool> hasEnded{false};
    WakeReference reference;
    std::thread hand([&] { // presses at any moment of the connection's work
        for (int press = 0; press < Presses; ++press) {
            (void)std::promise<void>().get_future().wait_for(std::chrono::microseconds(15000 + 137 * press));
            (void)line.board->takeStop(0.0); // repetitions of the last one
            const auto pressed = Clock::now();
            ++orders->stops;
            const auto arrived = line.board->takeStop(1.0);
            latencies_s.push_back(arrived ? std::chrono::duration<double>(*arrived - pressed).count() : 1.0);
        }
        hasEnded = true;
    });
    Result<void> waited;
    while (!hasEnded && waited) {
        waited = (*device)->clock().waitFor(0.01);
    }
    hand.join();
    const double wake_s = reference.stop_s();
    if (!waited) {
        return goals.failed(name, waited.error().message);
    }
    // Three threads are woken on the way: the port's, the connection's and the board's.
    goals.below(name + ", 99th percentile", 1e3 * percentile99(latencies_s), Goal_ms + 3e3 * wake_s, "ms");
    fmt::print("    goal of a quiet machine {} ms; it wakes threads {:.2f} ms late (99 %); median {:.2f} ms, "
               "worst {:.2f} ms\n",
               Goal_ms, 1e3 * wake_s, 1e3 * latencies_s[Presses / 2], 1e3 * latencies_s.back());
}

void printLoad() {
    double load = 0.0;
    if (getloadavg(&load, 1) == 1) {
        fmt::print("    load of the machine {:.1f} on {} processors\n", load,
                   std::thread::hardware_concurrency());
    }
}

} // namespace halbench::bench
