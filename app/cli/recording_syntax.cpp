#include "app/cli/command_syntax.h"

#include <fmt/format.h>

#include <filesystem>

namespace halbench::app {

namespace {

/// In words; empty when a recording can have this name. Whoever has recorded for an hour does not want to
/// hear it then.
std::string problemOfRecordingName(const std::string& path) {
    if (!std::string_view(path).ends_with(".csv")) {
        return fmt::format("'{}' is no .csv file: a recording is written as CSV, of which halbench convert "
                           "makes .mf4 or .mat",
                           path);
    }
    std::error_code ignored; // what cannot be looked at is said when it is written
    if (std::filesystem::is_other(path, ignored) || std::filesystem::is_directory(path, ignored)) {
        return fmt::format("'{}' is a folder, device or pipe: name a file", path);
    }
    return {};
}

void addSpectrum(CLI::App& app, CommandOptions& options) {
    CLI::App* spectrum = addCommand(app, "spectrum", "Spectrum or power density of a recorded signal");
    spectrum->add_option("RECORDING", options.input, "Recording")->required();
    spectrum->add_option("--signal", options.signal, "Its name or column")->required()->type_name("NAME");
    spectrum->add_option("--kind", options.kind, "amplitude (default), rms, psd or asd");
    spectrum->add_option("--window", options.window,
                         "hann (default), rectangular, hamming, blackman, blackman-harris or flat-top");
    spectrum->add_option("--segment_s", options.segment, "Length of a segment")->type_name("S");
    spectrum->add_option("--overlap", options.overlap, "Of neighbouring segments, default 0.5")
        ->type_name("RATIO");
    spectrum->add_option("--from", options.from, "First time")->type_name("S");
    spectrum->add_option("--to", options.to, "Last time")->type_name("S");
    spectrum->add_option("--out", options.out, "Spectrum")->required()->type_name("FILE.csv");
}

void addImport(CLI::App& app, CommandOptions& options) {
    CLI::App* import = addCommand(app, "import", "Make a recording of another program's table");
    import->add_option("FILE", options.input, "Text with columns of numbers")->required();
    addRecordingOut(import, "--out", options.out, "Recording");
    import->add_option("--separator", options.separator, "',', ';', tab, space, or none for one column")
        ->type_name("SIGN");
    import->add_option("--decimal", options.decimal, "Decimal sign: . or ,")->type_name("SIGN");
    import->add_option("--header", options.header, "0, 1, or units for a line of names and one of units")
        ->type_name("LINES");
    import->add_option("--time", options.timeColumn, "Name or number of the time's column")
        ->type_name("COLUMN");
    import->add_option("--rate_Hz", options.rate, "Rows per second of a table without a time")
        ->type_name("F");
    import->add_option("--map", options.mappings, "Name of ours for a column of theirs; repeatable")
        ->take_all()
        ->allow_extra_args(false)
        ->type_name("OUR=THEIR");
    import->add_option("--unit", options.columnUnits, "Unit that a column is written in; repeatable")
        ->take_all()
        ->allow_extra_args(false)
        ->type_name("COLUMN=UNIT");
    import->add_flag("--preview", options.isPreview, "Say how the table would be read, write nothing");
}

void addDerive(CLI::App& command, CommandOptions& options) {
    command
        .add_option("--derive", options.derived,
                    "A signal computed from others, e.g. 'field = sqrt(hall.a^2 + hall.b^2)'; repeatable")
        ->take_all()
        ->allow_extra_args(false)
        ->type_name("'NAME [UNIT] = EXPRESSION'");
}

void addPlot(CLI::App& app, CommandOptions& options) {
    CLI::App* plot = addCommand(app, "plot", "Draw a recording for print");
    plot->add_option("RECORDING", options.input, "Recording")->required();
    plot->add_option("--out", options.out, "Picture")->required()->type_name("FILE.svg|.pdf|.png");
    plot->add_option("--signals", options.signals, "Names, separated by commas")->type_name("A,B");
    plot->add_option("--from", options.from, "First time")->type_name("S");
    plot->add_option("--to", options.to, "Last time")->type_name("S");
    plot->add_option("--right", options.right,
                     "Those on the right axis of the panel of the signal before them")
        ->type_name("A,B");
    plot->add_option("--title", options.title, "Instead of the file's name")->type_name("TEXT");
    addDerive(*plot, options);
}

void addComparing(CLI::App& app, CommandOptions& options) {
    CLI::App* recordings = addCommand(app, "recordings", "List a folder's recordings and identified values");
    recordings->add_option("FOLDER", options.input, "Default: the current one");
    recordings->add_option("--search", options.search, "Only those in which every word occurs")
        ->type_name("WORDS");
    recordings
        ->add_option(
            "--retain", options.retain,
            "What of the recordings that the program named is beyond N days or N GB; removes nothing")
        ->type_name("Nd,NGB");
    recordings->add_flag("--delete", options.isDeleted, "Delete what --retain finds, for good");
    recordings->add_flag("--trash", options.isTrashed, "Move what --retain finds to the trash");
    CLI::App* overlay = addCommand(app, "overlay", "Lay recordings over each other on one time axis");
    overlay->add_option("RECORDING", options.names, "Two or more; the others are compared with the first")
        ->required();
    overlay->add_option("--signals", options.signals, "Names, separated by commas")
        ->required()
        ->type_name("A,B");
    overlay->add_option("--align", options.align, "start (default), trigger or marker:TEXT");
    overlay->add_option("--from", options.from, "First time, since that moment")->type_name("S");
    overlay->add_option("--to", options.to, "Last time, since that moment")->type_name("S");
    addRecordingOut(overlay, "--out", options.out, "Recording of all of them")->required();
}

void addConvert(CLI::App& app, CommandOptions& options) {
    CLI::App* convert = addCommand(app, "convert", "Convert, cut and thin out recordings");
    convert->add_option("IN", options.input, "Recording")->required();
    convert->add_option("OUT", options.out, "New recording")->required();
    convert->add_option("--signals", options.signals, "Names, separated by commas")->type_name("A,B");
    convert->add_option("--from", options.from, "First time")->type_name("S");
    convert->add_option("--to", options.to, "Last time")->type_name("S");
    addDerive(*convert, options);
}

} // namespace

CLI::App* addCommand(CLI::App& app, const char* name, const char* help) {
    CLI::App* command = app.add_subcommand(name, help);
    command->fallthrough();
    return command;
}

CLI::Option* addRecordingOut(CLI::App* command, const char* name, std::string& path, const char* help) {
    CLI::Option* option = command->add_option(name, path, help)->type_name("FILE.csv");
    return option->check([](const std::string& given) {
        return given.empty() ? std::string() : problemOfRecordingName(given);
    });
}

void addRecordingCommands(CLI::App& app, CommandOptions& options) {
    addConvert(app, options);
    addSpectrum(app, options);
    addPlot(app, options);
    addImport(app, options);
    addComparing(app, options);
}

} // namespace halbench::app
