#include "app/headless/console.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>

namespace halbench::app {

namespace {

constexpr std::array<std::string_view, 4> LevelNames = {"error", "warning", "info", "debug"};
constexpr std::array<std::string_view, 4> LevelColors = {"\033[31m", "\033[33m", "", "\033[2m"};

void writeErr(std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stderr);
}

} // namespace

void Console::write(std::string_view text) {
    noteFailure(std::fwrite(text.data(), 1, text.size(), stdout) == text.size());
}

// A reader that has seen enough (`| head`) is no failure.
void Console::noteFailure(bool isWritten) {
    m_hasFailed = m_hasFailed || (!isWritten && errno != EPIPE);
}

void Console::print(std::string_view text) {
    if (!m_style.isJson) {
        wipeProgress();
        write(text);
    }
}

Result<void> Console::printDocument(const JsonValue& document) {
    if (!m_style.isJson) {
        return {};
    }
    const Result<std::string> text = toJsonText(document);
    if (!text) {
        return failure(text.error());
    }
    wipeProgress();
    write(*text);
    return {};
}

void Console::announce(const std::string& line) {
    write(line + "\n");
    std::fflush(stdout);
}

void Console::log(LogLevel level, std::string_view text) {
    const bool isHidden = m_style.isQuiet && level > LogLevel::Warning;
    if (isHidden || level > m_style.level) {
        return;
    }
    wipeProgress();
    const std::size_t index = static_cast<std::size_t>(level);
    const bool isPlain = !m_style.useColor || LevelColors[index].empty();
    writeErr(fmt::format("{}halbench: {}{}{}\n", isPlain ? "" : LevelColors[index],
                         level == LogLevel::Info ? "" : std::string(LevelNames[index]) + ": ", text,
                         isPlain ? "" : "\033[0m"));
}

void Console::progress(double fraction, std::string_view text) {
    if (!m_style.isTerminal || m_style.isQuiet) {
        return;
    }
    constexpr int Width = 30;
    const int filled = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * Width);
    writeErr(fmt::format("\r\033[K[{:=<{}}{:{}}] {:.60}", "", filled, "", Width - filled, text));
    std::fflush(stderr);
    m_showsProgress = true;
}

void Console::wipeProgress() {
    if (m_showsProgress) {
        writeErr("\r\033[K");
        m_showsProgress = false;
    }
}

void Console::error(const Error& error, ExitCode code) {
    wipeProgress();
    const bool isColored = m_style.useColor;
    writeErr(fmt::format("{}halbench: {}{}\n", isColored ? "\033[31m" : "", errorLine(error),
                         isColored ? "\033[0m" : ""));
    if (m_style.isJson) {
        if (const Result<std::string> text = toJsonText(errorDocument(error, code))) {
            write(*text);
        }
    }
}

Result<void> Console::finish() {
    wipeProgress();
    noteFailure(std::fflush(stdout) == 0);
    if (m_hasFailed) {
        return failure(ErrorCode::FileSystem, "stdout cannot be written completely",
                       "free space on the disk or read the pipe to its end");
    }
    return {};
}

} // namespace halbench::app
