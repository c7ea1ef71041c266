// How long after a sample was measured it is on the screen, in real time: 32 signals at 10 kHz that come as a
// connection hands them over, drawn 30 times a second.
#include "devices/acquisition/display_inbox.h"
#include "tests/bench/goal.h"
#include "tests/control/history/history_blocks.h"
#include "widgets/live_plot/live_plot_stack.h"

#include <QApplication>
#include <QEvent>
#include <QTimer>

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <ctime>
#include <functional>
#include <future>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

namespace halbench::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t Signals = 32;
constexpr std::size_t SignalsPerPlot = 4;
constexpr double Period_s = 1e-4;
constexpr std::size_t BlockRows = 50; ///< a slice of the connection: 5 ms
constexpr double View_s = 10.0;
constexpr double History_s = 60.0;
constexpr int Duration_ms = 20000;
constexpr QSize Screen(1600, 900);
constexpr double Goal_ms = 50.0;

double valueAt(std::size_t row, std::size_t column) {
    const double t = static_cast<double>(row) * Period_s;
    return std::sin(3.0 * t + static_cast<double>(column)) +
           0.05 * static_cast<double>((row * 7 + column * 131) % 997) / 997.0;
}

std::shared_ptr<const StreamLayout> layout() {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < Signals; ++i) {
        names.push_back(fmt::format("signal.{}", i));
    }
    return control::layoutOf(names, Period_s);
}

/// Knows when everything that was to be painted is on the screen.
class Application : public QApplication {
public:
    using QApplication::QApplication;
    std::function<void()> onPainted;

    bool notify(QObject* receiver, QEvent* event) override {
        const bool isPainting = event->type() == QEvent::UpdateRequest;
        const bool isDone = QApplication::notify(receiver, event);
        if (isPainting && onPainted) {
            onPainted();
        }
        return isDone;
    }
};

/// Measures in real time: the row with number `first` + n was measured n periods after the start.
class Board {
public:
    Board(devices::DisplayInbox& inbox, std::shared_ptr<const StreamLayout> layout, std::size_t first)
        : m_inbox(inbox), m_layout(std::move(layout)), m_first(first), m_start(Clock::now()),
          m_thread([this] { run(); }) {}
    ~Board() {
        m_isEnding = true;
        m_thread.join();
    }
    double age_s(std::size_t row, Clock::time_point now) const {
        return std::chrono::duration<double>(now - m_start).count() -
               static_cast<double>(row - m_first) * Period_s;
    }
    double late_s() const { return m_late_s; }

private:
    void run() {
        for (std::size_t row = m_first; !m_isEnding; row += BlockRows) {
            const auto block =
                std::make_shared<SampleBlock>(control::blockOf(m_layout, row, BlockRows, valueAt));
            const auto due =
                m_start + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(
                              static_cast<double>(row + BlockRows - m_first) * Period_s));
            (void)std::promise<void>().get_future().wait_until(due);
            m_late_s = std::max(m_late_s.load(), std::chrono::duration<double>(Clock::now() - due).count());
            m_inbox.push(TimedBlock(block));
        }
    }

    devices::DisplayInbox& m_inbox;
    const std::shared_ptr<const StreamLayout> m_layout;
    const std::size_t m_first;
    const Clock::time_point m_start;
    std::atomic<bool> m_isEnding = false;
    std::atomic<double> m_late_s = 0.0;
    std::thread m_thread;
};

std::vector<widgets::PlotSpec> specs(const StreamLayout& layout) {
    std::vector<widgets::PlotSpec> plots;
    for (std::size_t i = 0; i < layout.columns.size(); ++i) {
        if (i % SignalsPerPlot == 0) {
            plots.push_back({"field", "T", {}, {}, {}});
        }
        const std::string& name = layout.columns[i].name;
        plots.back().curves.push_back({name, QString::fromStdString(name), "T", 1.0, 3});
    }
    return plots;
}

int run(Application& application) {
    Goals goals;
    const auto columns = layout();
    control::SampleHistory history(std::size_t{256} << 20);
    std::size_t row = 0;
    for (; static_cast<double>(row) * Period_s < History_s; row += 1000) {
        history.append(control::blockOf(columns, row, 1000, valueAt));
    }
    widgets::LivePlotStack stack;
    stack.setTheme(widgets::loadTheme("dark").value());
    stack.setHistory(&history);
    stack.setPlots(specs(*columns));
    stack.resize(Screen);
    stack.setTimeSpan(View_s);
    stack.show();
    devices::DisplayInbox inbox(120000);
    Board board(inbox, columns, row);
    std::vector<std::size_t> waiting; // first rows of blocks that are in the history and not on the screen
    std::vector<double> ages_s;
    int frames = 0;
    QObject::connect(&stack, &widgets::LivePlotStack::frameStarting, &stack, [&] {
        for (const TimedBlock& block : inbox.take()) {
            history.append(*block.block);
            waiting.push_back(row);
            row += block.rows();
        }
    });
    application.onPainted = [&] {
        if (waiting.empty()) {
            return;
        }
        const Clock::time_point now = Clock::now();
        for (const std::size_t first : std::exchange(waiting, {})) {
            for (std::size_t i = 0; i < BlockRows; ++i) {
                ages_s.push_back(board.age_s(first + i, now));
            }
        }
        ++frames;
    };
    QTimer::singleShot(Duration_ms, &application, &QApplication::quit);
    const std::clock_t before = std::clock();
    QApplication::exec();
    const double used = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC / (1e-3 * Duration_ms);
    application.onPainted = {};
    if (ages_s.empty()) {
        goals.failed("sample to screen", "nothing was painted");
        return goals.exitCode();
    }
    std::sort(ages_s.begin(), ages_s.end());
    const auto at = [&](double share) {
        return 1e3 * ages_s[static_cast<std::size_t>(share * static_cast<double>(ages_s.size() - 1))];
    };
    fmt::print(
        "    {} samples of each of 32 signals; median {:.1f} ms, 90 % {:.1f} ms, longest {:.1f} ms; the "
        "board's thread was late by {:.1f} ms at most; {:.2f} of a core\n",
        ages_s.size(), at(0.5), at(0.9), at(1.0), 1e3 * board.late_s(), used);
    goals.below("sample to screen, 32 signals at 10 kHz, 99th percentile", at(0.99), Goal_ms, "ms");
    goals.atLeast("the same: frames a second", frames / (1e-3 * Duration_ms), 28.0, "");
    goals.below("the same: rows left out", static_cast<double>(inbox.skippedRows()), 1.0, "rows");
    return goals.exitCode();
}

} // namespace
} // namespace halbench::bench

int main(int count, char** arguments) {
    halbench::bench::Application application(count, arguments);
    return halbench::bench::run(application);
}
