#pragma once

#include "app/session/recorder.h"
#include "control/base/random.h"
#include "devices/formats/convert_recording.h"
#include "devices/formats/recording_file.h"
#include "devices/recording/recording_writer.h"

#include <QtCore/QTemporaryDir>

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <new>
#include <thread>

namespace halbench::app {

/// Records 32 signals at 10 kHz in a process of its own, kills it (SIGKILL) at random moments, and looks at
/// what is there.
class KillRecording : public testing::Test {
protected:
    static constexpr std::size_t Signals = 32;
    static constexpr std::size_t BlockRows = 100;
    static constexpr double Period_s = 1e-4;
    /// Rows of one flush interval: the most that may be lost, and what the writing process is ahead at most.
    static constexpr auto IntervalRows = static_cast<std::uint64_t>(devices::FlushInterval_s / Period_s);

    struct Progress { ///< shared by both processes
        std::atomic<std::uint64_t> pushed = 0;
        std::atomic<std::uint64_t> written = 0;
    };

    KillRecording() {
        void* memory =
            mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        m_progress = memory != MAP_FAILED ? new (memory) Progress : nullptr;
    }
    ~KillRecording() override { munmap(m_progress, sizeof(Progress)); }

    /// Any 64 bits that are a number between 1 and 2: nothing may be lost in the text.
    static double valueAt(std::uint64_t row, std::size_t column) {
        constexpr std::uint64_t Mixing = 0x9E3779B97F4A7C15U;
        const std::uint64_t mixed = (row * Signals + column + 1) * Mixing;
        return 1.0 + static_cast<double>(mixed >> 12U) / 4503599627370496.0;
    }

    void killTimes(int kills, std::uint64_t longestRows) {
        ASSERT_NE(m_progress, nullptr);
        Random random(5);
        int recovered = 0;
        for (int kill = 0; kill < kills; ++kill) {
            const std::uint64_t rows = random.below(longestRows);
            const std::uint64_t turns = random.below(200000); // anywhere between two blocks
            recovered += killOnce(rows, turns) ? 1 : 0;
            ASSERT_FALSE(HasFatalFailure()) << "kill " << kill << " at row " << rows;
        }
        EXPECT_GT(recovered, kills / 2); // the others had no row yet, or were complete
    }

private:
    /// Whether an interrupted recording was there.
    bool killOnce(std::uint64_t rows, std::uint64_t turns) {
        QTemporaryDir folder;
        const std::string path = folder.filePath("run.csv").toStdString();
        m_progress->pushed = 0;
        m_progress->written = 0;
        const pid_t child = fork();
        if (child == 0) {
            record(path);
            _exit(0);
        }
        while (m_progress->written < rows) {
            std::this_thread::yield();
        }
        for (std::atomic<std::uint64_t> turn = 0; turn < turns; ++turn) {
        }
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        return look(path);
    }

    void record(const std::string& path) {
        RecorderConfig config;
        config.path = path;
        config.layout.period_s = Period_s;
        for (std::size_t column = 0; column < Signals; ++column) {
            config.layout.columns.push_back({"s" + std::to_string(column), "A"});
        }
        const auto layout = std::make_shared<const StreamLayout>(config.layout);
        Recorder recorder(std::move(config));
        for (std::uint64_t row = 0;; row += BlockRows) {
            recorder.push(blockAt(layout, row));
            m_progress->pushed = row + BlockRows;
            do { // as fast as it can be written, not more than one interval ahead
                m_progress->written = recorder.status().rows;
            } while (row + BlockRows - m_progress->written >= IntervalRows);
        }
    }

    static SampleBlockPtr blockAt(const std::shared_ptr<const StreamLayout>& layout, std::uint64_t from) {
        auto block = std::make_shared<SampleBlock>();
        block->layout = layout;
        for (std::uint64_t row = from; row < from + BlockRows; ++row) {
            block->time_s.push_back(static_cast<double>(row) * Period_s);
            for (std::size_t column = 0; column < Signals; ++column) {
                block->values.push_back(valueAt(row, column));
            }
        }
        return block;
    }

    bool look(const std::string& path) {
        namespace fs = std::filesystem;
        EXPECT_FALSE(fs::exists(path));
        const std::uint64_t written = m_progress->written;
        const auto done = devices::convertRecording({path + ".partial", path, {}, {}, {}});
        if (!done) { // killed before its first row
            EXPECT_EQ(written, 0U) << done.error().message;
            return false;
        }
        EXPECT_GE(done->rows, written);
        EXPECT_LE(done->rows, m_progress->pushed);
        EXPECT_LE(m_progress->pushed - done->rows, IntervalRows + BlockRows);
        EXPECT_EQ(done->recovery->damagedOctets, 0U);
        const auto file = devices::readRecordingFile(path);
        EXPECT_TRUE(file) << (file ? "" : file.error().message);
        if (file) {
            EXPECT_TRUE(file->warnings.empty()); // the sidecar's SHA-256 fits
            EXPECT_EQ(file->recording.rows(), done->rows);
            EXPECT_TRUE(areExact(file->recording));
        }
        return true;
    }

    static bool areExact(const Recording& recording) {
        for (std::size_t row = 0; row < recording.rows(); ++row) {
            for (std::size_t column = 0; column < Signals; ++column) {
                if (recording.values[row * Signals + column] != valueAt(row, column)) {
                    return false;
                }
            }
        }
        return true;
    }

    Progress* m_progress = nullptr;
};

} // namespace halbench::app
