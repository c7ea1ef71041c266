// A frame of live plots against plain Qwt curves with the same samples, drawn into the same kind of widget.
#include "control/base/random.h"
#include "control/base/units.h"
#include "devices/history/page_file.h"
#include "tests/bench/goal.h"
#include "tests/control/history/history_blocks.h"
#include "widgets/figure/figure_file.h"
#include "widgets/figure/offscreen_application.h"
#include "widgets/live_plot/live_plot_stack.h"

#include <QApplication>
#include <QTemporaryDir>
#include <qwt_plot.h>
#include <qwt_plot_curve.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <future>
#include <memory>

namespace halbench::bench {
namespace {

using control::SampleHistory;
using widgets::LivePlotStack;

constexpr int Signals = 12;
constexpr int SignalsPerPlot = 3;
constexpr double Period_s = 0.001;
constexpr double SwingsInView = 4.0; ///< so that pictures of any length look alike
constexpr QSize Screen(1600, 900);
constexpr std::size_t Budget_bytes = std::size_t{256} << 20;
/// Samples that arrive between two frames at 30 frames a second.
constexpr std::size_t RowsPerFrame = 33;

/// Sines with 2 % noise; `swing_s` is their period.
class Source {
public:
    explicit Source(double swing_s, int count = Signals) : m_swing_s(swing_s) {
        std::vector<std::string> names;
        for (int i = 0; i < count; ++i) {
            names.push_back("signal." + std::to_string(i));
        }
        m_layout = control::layoutOf(names, Period_s);
        Random random(1);
        for (double& noise : m_noise) {
            noise = 0.02 * random.gaussian();
        }
    }
    double at(std::size_t row, std::size_t column) const {
        const double turns = static_cast<double>(row) * Period_s / m_swing_s;
        return std::sin(2.0 * Pi * turns + static_cast<double>(column)) +
               m_noise[(row * 7 + column * 131) % m_noise.size()];
    }
    void feed(SampleHistory& history, std::size_t rows) {
        history.append(control::blockOf(
            m_layout, m_row, rows, [this](std::size_t row, std::size_t column) { return at(row, column); }));
        m_row += rows;
    }
    const std::vector<StreamLayout::Column>& columns() const { return m_layout->columns; }

private:
    double m_swing_s;
    std::shared_ptr<const StreamLayout> m_layout;
    std::size_t m_row = 0;
    std::array<double, 9973> m_noise{};
};

std::vector<widgets::PlotSpec> specs(const Source& source) {
    std::vector<widgets::PlotSpec> plots;
    for (std::size_t i = 0; i < source.columns().size(); ++i) {
        if (i % SignalsPerPlot == 0) {
            plots.push_back({"field", "T", {}, {}, {}});
        }
        const std::string& name = source.columns()[i].name;
        plots.back().curves.push_back({name, QString::fromStdString(name), "T", 1.0, 3});
    }
    return plots;
}

/// Processor time of a frame: new samples, scrolling, everything drawn anew into the window's buffer.
double frame_s(SampleHistory& history, Source& source, LivePlotStack& stack) {
    constexpr int Frames = 20;
    const auto frames = [&] {
        for (int i = 0; i < Frames; ++i) {
            source.feed(history, RowsPerFrame);
            stack.refresh();
            QApplication::processEvents();
        }
    };
    frames();
    return processorTime_s(frames, 7) / Frames;
}

void fill(SampleHistory& history, Source& source, double history_s) {
    for (double fed_s = 0.0; fed_s < history_s; fed_s += 1.0) {
        source.feed(history, 1000);
    }
}

double shownFrame_s(SampleHistory& history, Source& source, double view_s) {
    LivePlotStack stack;
    stack.setTheme(widgets::loadTheme("dark").value());
    stack.setHistory(&history);
    stack.setPlots(specs(source));
    stack.resize(Screen);
    stack.setTimeSpan(view_s);
    stack.show();
    QApplication::processEvents();
    return frame_s(history, source, stack);
}

double liveFrame_s(double history_s, double view_s) {
    SampleHistory history(Budget_bytes);
    Source source(view_s / SwingsInView);
    fill(history, source, history_s);
    return shownFrame_s(history, source, view_s);
}

/// Many signals, half a million samples of each in view.
double crowdedFrame_s() {
    constexpr int Crowd = 32;
    constexpr double View_s = 500.0;
    SampleHistory history(std::size_t{1} << 30);
    Source source(View_s / SwingsInView, Crowd);
    fill(history, source, View_s);
    return shownFrame_s(history, source, View_s);
}

/// The same curves by QwtPlotCurve as it comes, all samples in view.
double plainFrame_s(double view_s) {
    const auto samples = static_cast<std::size_t>(view_s / Period_s);
    std::vector<std::unique_ptr<QwtPlot>> plots;
    const Source source(view_s / SwingsInView);
    for (int i = 0; i < Signals; ++i) {
        if (i % SignalsPerPlot == 0) {
            plots.push_back(std::make_unique<QwtPlot>());
            plots.back()->resize(Screen.width(), Screen.height() / (Signals / SignalsPerPlot));
            plots.back()->setAxisScale(QwtPlot::xBottom, 0.0, view_s);
            plots.back()->setAxisScale(QwtPlot::yLeft, -1.2, 1.2);
        }
        QVector<QPointF> points;
        for (std::size_t row = 0; row < samples; ++row) {
            points << QPointF(static_cast<double>(row) * Period_s,
                              source.at(row, static_cast<std::size_t>(i)));
        }
        auto* curve = new QwtPlotCurve; // the plot owns it
        curve->setSamples(points);
        curve->attach(plots.back().get());
    }
    for (const auto& plot : plots) {
        plot->show();
        QApplication::processEvents();
    }
    return processorTime_s(
        [&] {
            for (const auto& plot : plots) {
                plot->replot();
                QApplication::processEvents();
            }
        },
        3);
}

void benchFrames(Goals& goals) {
    const double all_s = liveFrame_s(600.0, 600.0);
    const double short_s = liveFrame_s(10.0, 10.0);
    const double near_s = liveFrame_s(600.0, 10.0);
    const double sparse_s = liveFrame_s(600.0, 1.0);
    const double plain_s = plainFrame_s(600.0);
    goals.below("frame, 12 signals at 1 kHz, all 10 minutes in view at 1600x900", 1e3 * all_s, 8.0, "ms");
    goals.below("frame, the last 10 s of 10 minutes", 1e3 * near_s, 8.0, "ms");
    goals.below("frame, the last second of 10 minutes (single samples)", 1e3 * sparse_s, 8.0, "ms");
    goals.below("frame, 32 signals of half a million samples each in view", 1e3 * crowdedFrame_s(), 8.0,
                "ms");
    // Sixty times the samples: the pyramid is a level deeper, and noise has larger extremes to fill.
    goals.below("frame with 10 minutes in view against 10 s", all_s / short_s, 1.5, "x");
    goals.below("frame over 10 minutes of history against 10 s", near_s / short_s, 1.3, "x");
    goals.atLeast("frame with 10 minutes in view against plain Qwt", plain_s / all_s, 50.0, "x");
}

void benchIngest(Goals& goals) {
    const auto layout = control::layoutOf({"a", "b", "c", "d"}, Period_s);
    const SampleBlock block = control::blockOf(layout, 0, 250'000, [](std::size_t row, std::size_t column) {
        return std::sin(0.1 * static_cast<double>(row + column));
    });
    SampleHistory history(std::size_t{32} << 20);
    const double seconds = processorTime_s([&] { history.append(block); }, 7);
    const double values = 1e-6 * 4.0 * 250'000.0;
    goals.atLeast("ingest into history and extremes", values / seconds, 40.0, "million values/s");
    const QTemporaryDir folder;
    devices::PageFileConfig config;
    config.folder = folder.path().toStdString();
    const auto pages = std::make_shared<devices::PageFile>(config);
    history.setStore(pages);
    const double paged_s = processorTime_s( // of both threads
        [&] {
            history.append(block);
            pages->waitUntilIdle();
            history.settle();
        },
        7);
    goals.atLeast("the same, and to the disk", values / paged_s, 40.0, "million values/s");
}

/// Longest of the first looks at stretches of an old hour: all that is drawn is read back.
double longestLook_s(const SampleHistory& history, double length_s, double history_s) {
    constexpr int Looks = 5;
    double longest_s = 0.0;
    std::vector<control::HistoryColumn> columns;
    for (int look = 0; look < Looks; ++look) {
        const double begin_s = 0.1 * history_s * look / Looks;
        const auto draw = [&] {
            for (const std::string& signal : history.signals()) {
                history.columns(signal, {begin_s, begin_s + length_s}, 1600, columns);
            }
        };
        longest_s = std::max(longest_s, processorTime_s(draw, 1)); // from the cache nothing is waited for
    }
    return longest_s;
}

/// A hundred million samples, of which memory holds a fifth.
void benchLongHistory(Goals& goals) {
    constexpr double Long_s = 8334.0;
    constexpr double Short_s = 8.334;
    const QTemporaryDir folder;
    devices::PageFileConfig config;
    config.folder = folder.path().toStdString();
    const auto pages = std::make_shared<devices::PageFile>(config);
    SampleHistory history(Budget_bytes);
    history.setStore(pages);
    Source source(Long_s / SwingsInView);
    // Hours come here within a second, which no disk follows: it is waited for, as hours would.
    constexpr double Part_s = 100.0;
    for (double fed_s = 0.0; fed_s < Long_s; fed_s += Part_s) {
        fill(history, source, std::min(Part_s, Long_s - fed_s));
        pages->waitUntilIdle();
    }
    history.settle();
    const double raw_MB = 8e-6 * (Signals + 1) * 1e3 * Long_s;
    goals.below("history of 1e8 samples: memory", 1e-6 * static_cast<double>(history.bytes()), 268.5, "MB");
    goals.atLeast("the same: on the disk", 1e-6 * static_cast<double>(history.pagedBytes()), 0.6 * raw_MB,
                  "MB");
    goals.below("the same: pages that are lost", pages->trouble() ? 1.0 : 0.0, 1.0, "");
    for (const double length_s : {1.0, 10.0, 100.0, 1000.0, 3000.0}) {
        goals.below(fmt::format("first look at {} s of it, 12 signals, from the disk's cache", length_s),
                    1e3 * longestLook_s(history, length_s, Long_s), 50.0, "ms");
    }
    const double long_s = shownFrame_s(history, source, Long_s);
    const double short_s = liveFrame_s(Short_s, Short_s);
    goals.below("frame with 1e8 samples in view against 1e5", long_s / short_s, 1.5, "x");
}

/// A look at old samples while every read takes as long as a disk that turns: the picture does not wait.
void benchSlowDisk(Goals& goals) {
    constexpr double History_s = 2000.0;
    constexpr auto Turn = std::chrono::milliseconds(10);
    const QTemporaryDir folder;
    devices::PageFileConfig config;
    config.folder = folder.path().toStdString();
    devices::PageDisk disk = devices::realPageDisk();
    std::atomic<int> reads = 0;
    disk.read = [&reads, Turn, read = disk.read](int handle, std::span<std::byte> octets,
                                                 std::uint64_t offset) {
        ++reads;
        (void)std::promise<void>().get_future().wait_for(Turn);
        return read(handle, octets, offset);
    };
    const auto pages = std::make_shared<devices::PageFile>(config, disk);
    SampleHistory history(Budget_bytes / 4);
    history.setStore(pages);
    Source source(10.0);
    fill(history, source, History_s);
    pages->waitUntilIdle();
    history.settle();
    std::vector<control::HistoryColumn> columns;
    const auto look = [&](double begin_s) {
        for (const std::string& signal : history.signals()) {
            history.columns(signal, {begin_s, begin_s + 10.0}, 1600, columns);
        }
    };
    const double waited_s = wallTime_s([&] { look(100.0); }, 1);
    fmt::print("    a first look at 10 s that waits for a disk of 10 ms a read: {:.0f} ms, {} reads\n",
               1e3 * waited_s, reads.load());
    bool isWhole = false;
    double longest_s = 0.0;
    int frames = 0;
    const auto frame = [&] {
        const SampleHistory::Glance glance(history);
        look(200.0);
        isWhole = glance.isWhole();
    };
    const auto watch = [&] {
        for (; !isWhole && frames < 1000; ++frames) {
            history.settle();
            longest_s = std::max(longest_s, wallTime_s(frame, 1));
            (void)std::promise<void>().get_future().wait_for(std::chrono::milliseconds(33));
        }
    };
    const double complete_s = wallTime_s(watch, 1);
    fmt::print("    the same as plots do it: complete after {:.0f} ms and {} frames\n", 1e3 * complete_s,
               frames);
    goals.below("longest question of a frame to a disk of 10 ms a read", 1e3 * longest_s, 8.0, "ms");
    goals.below("the same: pictures that never became whole", isWhole ? 0.0 : 1.0, 1.0, "");
}

void benchPyramid(Goals& goals) {
    SampleHistory history(Budget_bytes);
    Source source(1.0);
    fill(history, source, 4.096 * 100.0);
    const double raw_bytes = 8.0 * (Signals + 1) * 4096.0 * 100.0;
    goals.below("memory of the extremes against that of the samples",
                (static_cast<double>(history.bytes()) - raw_bytes) / raw_bytes, 1.0 / 3.0, "");
}

/// A recording for print, from its samples to the file's content.
void benchPicture(Goals& goals) {
    constexpr std::size_t Points = 1'000'000;
    const Source source(Points * Period_s / SwingsInView);
    widgets::Figure figure;
    figure.x = {"time", "s", false, {}, {}, {}};
    widgets::Panel panel;
    panel.y = {"field", "T", false, {}, {}, {}};
    widgets::Curve curve;
    curve.label = "signal.0";
    for (std::size_t row = 0; row < Points; ++row) {
        curve.x.push_back(static_cast<double>(row) * Period_s);
        curve.y.push_back(source.at(row, 0));
    }
    panel.curves.push_back(std::move(curve));
    figure.panels.push_back(std::move(panel));
    const widgets::Theme theme = widgets::loadTheme("light").value();
    const auto draw = [&] {
        return widgets::pictureFile(figure, theme, widgets::PictureFormat::Pdf).value().size();
    };
    const int size_octets = draw();
    goals.below("a million points to PDF", 1e3 * processorTime_s(draw, 7), 100.0, "ms");
    goals.below("size of that PDF", 1e-3 * size_octets, 200.0, "kB");
}

} // namespace
} // namespace halbench::bench

int main() {
    const auto application = halbench::widgets::OffscreenApplication::ensure();
    halbench::bench::Goals goals;
    halbench::bench::benchIngest(goals);
    halbench::bench::benchPyramid(goals);
    halbench::bench::benchFrames(goals);
    halbench::bench::benchLongHistory(goals);
    halbench::bench::benchSlowDisk(goals);
    halbench::bench::benchPicture(goals);
    return goals.exitCode();
}
