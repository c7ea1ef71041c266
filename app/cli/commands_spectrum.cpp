#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/documents/result_header.h"
#include "app/documents/spectrum_table.h"
#include "app/documents/text/numbers.h"
#include "app/documents/text/output_file.h"
#include "app/headless/command_header.h"
#include "app/headless/recording_integrity.h"
#include "control/base/units.h"
#include "control/signals/spectrum.h"
#include "devices/formats/convert_recording.h"
#include "devices/formats/recording_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace halbench::app {

namespace {

struct SpectrumOptions {
    std::string input, out;
    std::string signal;
    std::string kind, window, segment, overlap;
    std::string from, to;
};

using control::Spectrum;
using control::SpectrumScale;

constexpr std::size_t ListedPeaks = 10;

struct Kind {
    const char* name;
    SpectrumScale scale;
};

constexpr std::array Kinds = {Kind{"amplitude", SpectrumScale::Peak}, Kind{"rms", SpectrumScale::Rms},
                              Kind{"psd", SpectrumScale::Density}, Kind{"asd", SpectrumScale::RootDensity}};

const char* kindName(SpectrumScale scale) {
    return std::find_if(Kinds.begin(), Kinds.end(), [scale](const Kind& kind) { return kind.scale == scale; })
        ->name;
}

Result<SpectrumScale> kindOption(const std::string& text) {
    std::string known;
    for (const Kind& kind : Kinds) {
        if (text.empty() || text == kind.name) {
            return kind.scale;
        }
        known += (known.empty() ? "" : ", ") + std::string(kind.name);
    }
    return failure(ErrorCode::Usage, "--kind: '" + text + "' is no kind of spectrum", "use one of " + known);
}

Result<control::WindowShape> windowOption(const std::string& text) {
    const auto shape = text.empty() ? control::WindowShape::Hann : control::findWindow(text);
    if (shape) {
        return *shape;
    }
    std::string known;
    for (const control::WindowFigures& window : control::windowFigures()) {
        known += (known.empty() ? "" : ", ") + std::string(window.name);
    }
    return failure(ErrorCode::Usage, "--window: '" + text + "' is no window", "use one of " + known);
}

Result<control::SpectrumConfig> spectrumConfigFrom(const SpectrumOptions& options) {
    const Result<SpectrumScale> scale = kindOption(options.kind);
    const Result<control::WindowShape> window = windowOption(options.window);
    const Result<std::optional<double>> segment = optionalNumber("--segment_s", options.segment);
    const Result<std::optional<double>> overlap = optionalNumber("--overlap", options.overlap);
    if (!scale || !window || !segment || !overlap) {
        return failure(!scale     ? scale.error()
                       : !window  ? window.error()
                       : !segment ? segment.error()
                                  : overlap.error());
    }
    control::SpectrumConfig config;
    config.scale = *scale;
    config.window = *window;
    config.segment_s = *segment;
    config.overlap_ratio = overlap->value_or(config.overlap_ratio);
    return config;
}

/// One signal of a recording, in the interval asked for.
struct Source {
    Recording part;
    ResultHeader header;

    const StreamLayout::Column& signal() const { return part.layout->columns.front(); }
};

Result<Source> readSource(CommandContext& context, const SpectrumOptions& options,
                          const AbortCheck& checkAbort) {
    const Result<std::optional<double>> from = optionalNumber("--from", options.from);
    const Result<std::optional<double>> to = optionalNumber("--to", options.to);
    if (!from || !to) {
        return failure(from ? to.error() : from.error());
    }
    const Result<devices::RecordedFile> file = devices::readRecordingFile(options.input, checkAbort);
    if (!file) {
        return failure(file.error());
    }
    sayWarnings(context, file->warnings);
    Result<Recording> part = devices::selectPart(file->recording, {options.signal}, *from, *to);
    if (!part) {
        return failure(part.error());
    }
    Source source{*std::move(part), headerFor(context, "halbench.spectrum/1")};
    noteWarnings(source.header.quality, file->warnings);
    if (file->hasMeta) {
        source.header.device = file->meta.device;
        source.header.started = file->meta.started;
    }
    return source;
}

DataQuality qualityOf(const Spectrum& spectrum, std::size_t rows) {
    DataQuality quality;
    if (2 * spectrum.usedRows < rows) {
        quality.verdict = Verdict::Doubtful;
        quality.findings.push_back(
            {"rows_left_out",
             fmt::format(
                 "{} of {} rows were used: {} gaps and {} missing values leave no room for more segments",
                 spectrum.usedRows, rows, spectrum.gaps, spectrum.missingValues),
             "give a shorter --segment_s"});
    }
    return quality;
}

JsonValue windowJson(const Spectrum& spectrum) {
    const control::WindowFigures& figures = control::figuresOf(spectrum.config.window);
    JsonValue window = JsonValue::object();
    window.set("name", figures.name).set("coherent_gain", figures.coherentGain);
    window.set("noise_bandwidth_lines", figures.noiseBandwidth_lines);
    return window.set("scalloping_dB", figures.scalloping_dB);
}

JsonValue peaksJson(const Spectrum& spectrum) {
    JsonValue peaks = JsonValue::array();
    for (const std::size_t line : control::highestPeaks(spectrum, ListedPeaks)) {
        JsonValue peak = JsonValue::object();
        peak.set("frequency_Hz", spectrum.frequency_Hz[line]).set("value", spectrum.values[line]);
        peaks.push(peak.set("low", spectrum.low[line]).set("high", spectrum.high[line]));
    }
    return peaks;
}

JsonValue toJson(const Source& source, const Spectrum& spectrum) {
    JsonValue document = toJson(source.header);
    document.set("signal", source.signal().name).set("kind", kindName(spectrum.config.scale));
    document.set("value_unit", spectrum.unit).set("window", windowJson(spectrum));
    document.set("rows", static_cast<std::uint64_t>(source.part.rows()));
    document.set("used_rows", static_cast<std::uint64_t>(spectrum.usedRows));
    document.set("gaps", static_cast<std::uint64_t>(spectrum.gaps));
    document.set("missing_values", static_cast<std::uint64_t>(spectrum.missingValues));
    document.set("segment_s", spectrum.segment_s()).set("overlap_ratio", spectrum.config.overlap_ratio);
    document.set("segments", static_cast<std::uint64_t>(spectrum.segments));
    document.set("equivalent_averages", spectrum.equivalentAverages);
    document.set("confidence_ratio", spectrum.config.confidence_ratio);
    document.set("line_distance_Hz", spectrum.lineDistance_Hz());
    document.set("noise_bandwidth_Hz", spectrum.noiseBandwidth_Hz());
    JsonValue rms = JsonValue::object();
    rms.set("value", spectrum.rms);
    document.set("rms", rms.set("unit", control::spectrumUnit(source.signal().unit, SpectrumScale::Rms)));
    return document.set("peaks", peaksJson(spectrum));
}

std::string summaryText(const Source& source, const Spectrum& spectrum) {
    std::string text = fmt::format("{} of {}, {}\n", kindName(spectrum.config.scale), source.signal().name,
                                   spectrum.unit.empty() ? "no unit" : spectrum.unit);
    text += fmt::format("{:<20} {} of {:.6g} s, {}\n", "segments", spectrum.segments, spectrum.segment_s(),
                        control::figuresOf(spectrum.config.window).name);
    text += fmt::format("{:<20} {:.6g} Hz apart, noise bandwidth {:.6g} Hz\n", "lines",
                        spectrum.lineDistance_Hz(), spectrum.noiseBandwidth_Hz());
    text += fmt::format("{:<20} {:.6g} {}\n", "rms", spectrum.rms,
                        control::spectrumUnit(source.signal().unit, SpectrumScale::Rms));
    text += "highest peaks\n";
    for (const std::size_t line : control::highestPeaks(spectrum, ListedPeaks)) {
        text += fmt::format("  {:>12.6g} Hz  {:.6g}  [{:.6g}, {:.6g}]\n", spectrum.frequency_Hz[line],
                            spectrum.values[line], spectrum.low[line], spectrum.high[line]);
    }
    return text + findingLines(source.header.quality);
}

CommandResult runSpectrumCommand(CommandContext& context, const SpectrumOptions& options) {
    const Result<control::SpectrumConfig> config = spectrumConfigFrom(options);
    if (!config) {
        return failure(config.error());
    }
    const AbortCheck isInterrupted = [&context] { return checkInterrupt(context); };
    Result<Source> source = readSource(context, options, isInterrupted);
    if (!source) {
        return failure(source.error());
    }
    const Result<Spectrum> spectrum = control::spectrum(
        {source->part.time_s, source->part.values, source->signal().unit}, *config, isInterrupted);
    if (!spectrum) {
        return failure(spectrum.error().code, options.input + ": " + spectrum.error().message,
                       spectrum.error().hint);
    }
    addQuality(source->header.quality, qualityOf(*spectrum, source->part.rows()));
    if (const Result<void> written = writeFile(options.out, spectrumTable(*spectrum, source->signal().unit));
        !written) {
        return failure(written.error());
    }
    context.console.log(LogLevel::Info, "wrote " + options.out);
    if (const Result<void> done =
            deliver(context, toJson(*source, *spectrum), summaryText(*source, *spectrum), "");
        !done) {
        return failure(done.error());
    }
    return ExitCode::Done;
}

void addOptions(CommandSyntax& syntax, SpectrumOptions& options) {
    syntax.argument("RECORDING", options.input, "Recording");
    syntax.option("--signal", options.signal, "Its name or column", "NAME", Presence::Required);
    syntax.option("--kind", options.kind, "amplitude (default), rms, psd or asd");
    syntax.option("--window", options.window,
                  "hann (default), rectangular, hamming, blackman, blackman-harris or flat-top");
    syntax.option("--segment_s", options.segment, "Length of a segment", "S");
    syntax.option("--overlap", options.overlap, "Of neighbouring segments, default 0.5", "RATIO");
    syntax.option("--from", options.from, "First time", "S");
    syntax.option("--to", options.to, "Last time", "S");
    syntax.option("--out", options.out, "Spectrum", "FILE.csv", Presence::Required);
}

CommandOutputs outputsOf(const SpectrumOptions& options) {
    return {{options.out}, {}};
}

} // namespace

Command spectrumCommand() {
    return makeCommand<SpectrumOptions>("spectrum", "Spectrum or power density of a recorded signal",
                                        {addOptions, runSpectrumCommand, outputsOf});
}

} // namespace halbench::app
