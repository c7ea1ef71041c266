#pragma once

#include "app/headless/exit_code.h"

#include <string>
#include <string_view>

namespace halbench::app {

enum class LogLevel { Error, Warning, Info, Debug };

/// What the user asked of the program's voice; also known before the command line is understood, so that an
/// error of usage is reported in the right form.
struct ConsoleStyle {
    bool isJson = false;
    bool isQuiet = false;
    bool useColor = false;
    bool isTerminal = false; ///< stderr is one: only then is there a progress bar
    LogLevel level = LogLevel::Info;
};

/// The program's two voices: results on stdout, everything else on stderr. Thread: the main one.
class Console {
public:
    explicit Console(ConsoleStyle style) : m_style(style) {}

    const ConsoleStyle& style() const { return m_style; }
    void setStyle(const ConsoleStyle& style) { m_style = style; }

    /// Text of a result, as it is; nothing under --json.
    void print(std::string_view text);
    /// The one JSON document of a result; nothing without --json.
    Result<void> printDocument(const JsonValue& document);
    /// A line on stdout that somebody waits for, flushed at once, also under --json.
    void announce(const std::string& line);
    void log(LogLevel level, std::string_view text);
    /// A bar of 30 signs with a text behind it; a finished one is wiped away.
    void progress(double fraction, std::string_view text);
    /// One line on stderr, and halbench.error/1 on stdout under --json.
    void error(const Error& error, ExitCode code);
    /// Flushes stdout. Error: FileSystem when something could not be written.
    Result<void> finish();

private:
    void write(std::string_view text);
    void noteFailure(bool isWritten);
    void wipeProgress();

    ConsoleStyle m_style;
    bool m_hasFailed = false;
    bool m_showsProgress = false;
};

} // namespace halbench::app
