// Written by tests/architecture/phrases.py --write from the sources: not for editing.
#include "widgets/phrases.h"

#include <QtGlobal>

namespace halbench::widgets {

// clang-format off
namespace {

constexpr const char* Table[] = {
    QT_TRANSLATE_NOOP("Phrases", "a text"),
    QT_TRANSLATE_NOOP("Phrases", "a whole number"),
    QT_TRANSLATE_NOOP("Phrases", "a number"),
    QT_TRANSLATE_NOOP("Phrases", "true or false"),
    QT_TRANSLATE_NOOP("Phrases", "a list"),
    QT_TRANSLATE_NOOP("Phrases", "a table"),
    QT_TRANSLATE_NOOP("Phrases", "a date or time"),
    QT_TRANSLATE_NOOP("Phrases", "a value"),
    QT_TRANSLATE_NOOP("Phrases", "{}: is not PATH=VALUE"),
    QT_TRANSLATE_NOOP("Phrases", "write step.sweep.given.J=6e-4"),
    QT_TRANSLATE_NOOP("Phrases", "{}: there is no such step"),
    QT_TRANSLATE_NOOP("Phrases", "write step.NAME.KEY=VALUE with the name of a step of the file"),
    QT_TRANSLATE_NOOP("Phrases", "{}:{}:{}: not valid JSON: {}"),
    QT_TRANSLATE_NOOP("Phrases", "correct the file or write it again with --out"),
    QT_TRANSLATE_NOOP("Phrases", "the result holds a value that is not a finite number at '{}'"),
    QT_TRANSLATE_NOOP("Phrases", "report this with the command line that led to it"),
    QT_TRANSLATE_NOOP("Phrases", "is \"{}\", this version reads \"{}\""),
    QT_TRANSLATE_NOOP("Phrases", "is missing"),
    QT_TRANSLATE_NOOP("Phrases", "is \"{}\", not \"{}\""),
    QT_TRANSLATE_NOOP("Phrases", "must be a finite number"),
    QT_TRANSLATE_NOOP("Phrases", "must be a whole number from 0 to {}"),
    QT_TRANSLATE_NOOP("Phrases", "write the file again with 'halbench {} --out'"),
    QT_TRANSLATE_NOOP("Phrases", "must be a list of lists of numbers"),
    QT_TRANSLATE_NOOP("Phrases", "must hold finite numbers"),
    QT_TRANSLATE_NOOP("Phrases", "needs as many rows as names"),
    QT_TRANSLATE_NOOP("Phrases", "must be square"),
    QT_TRANSLATE_NOOP("Phrases", "{}: this estimate was refused"),
    QT_TRANSLATE_NOOP("Phrases", "see its findings, then identify again"),
    QT_TRANSLATE_NOOP("Phrases", "must be \"parallel\""),
    QT_TRANSLATE_NOOP("Phrases", "needs a value and the two ends of its interval"),
    QT_TRANSLATE_NOOP("Phrases", "{}: cannot write: {}"),
    QT_TRANSLATE_NOOP("Phrases", "free space on the disk"),
    QT_TRANSLATE_NOOP("Phrases", "choose another path or change its permissions"),
    QT_TRANSLATE_NOOP("Phrases", "{}: is a folder"),
    QT_TRANSLATE_NOOP("Phrases", "name a file"),
    QT_TRANSLATE_NOOP("Phrases", "{}: cannot read: {}"),
    QT_TRANSLATE_NOOP("Phrases", "{}: larger than 256 MB"),
    QT_TRANSLATE_NOOP("Phrases", "give a smaller file"),
    QT_TRANSLATE_NOOP("Phrases", "there is no preset '{}' for a device of model '{}'"),
    QT_TRANSLATE_NOOP("Phrases", "htm has {}"),
    QT_TRANSLATE_NOOP("Phrases", "compare with resources/presets/htm/published.json"),
    QT_TRANSLATE_NOOP("Phrases", "must be \"halbench.preset/1\""),
    QT_TRANSLATE_NOOP("Phrases", "must be an object of numbers"),
    QT_TRANSLATE_NOOP("Phrases", "{}:{}:{}: not valid TOML: {}"),
    QT_TRANSLATE_NOOP("Phrases", "correct the line; the form is in resources/help/command-line.md"),
    QT_TRANSLATE_NOOP("Phrases", "'{}' must be a text"),
    QT_TRANSLATE_NOOP("Phrases", "'layout' must be a table"),
    QT_TRANSLATE_NOOP("Phrases", "'{}' must be a list of tables, [[{}]]"),
    QT_TRANSLATE_NOOP("Phrases", "the file is left as it is; open another project or mend this line"),
    QT_TRANSLATE_NOOP("Phrases", "unknown key '{}'; a [[{}]] has name and document"),
    QT_TRANSLATE_NOOP("Phrases", "'{}' must be a finite number"),
    QT_TRANSLATE_NOOP("Phrases", "'signals' must be a list of texts"),
    QT_TRANSLATE_NOOP("Phrases", "unknown key '{}'; a [[plot]] has signals, min, max, unit"),
    QT_TRANSLATE_NOOP("Phrases", "a [[plot]] has both min and max, or neither; min is less than max"),
    QT_TRANSLATE_NOOP("Phrases", "'plot' must be a list of tables, [[plot]]"),
    QT_TRANSLATE_NOOP("Phrases", "'monitor' must be a table"),
    QT_TRANSLATE_NOOP("Phrases", "[monitor] has follow (true or false) and span_s"),
    QT_TRANSLATE_NOOP("Phrases", "'span_s' must be more than 0"),
    QT_TRANSLATE_NOOP("Phrases", "unknown key '{}'; known are schema, device, notes, perspective, layout, monitor, plot, model, design, calibration"),
    QT_TRANSLATE_NOOP("Phrases", "{}: is a '{}', made by a newer version"),
    QT_TRANSLATE_NOOP("Phrases", "this version reads {}; the file is left as it is"),
    QT_TRANSLATE_NOOP("Phrases", "{}: is not a Halbench project"),
    QT_TRANSLATE_NOOP("Phrases", "a project begins with schema = \"{}\""),
    QT_TRANSLATE_NOOP("Phrases", "{} is open in another window (process {} on {})"),
    QT_TRANSLATE_NOOP("Phrases", "close it there; if it is open nowhere, remove {}"),
    QT_TRANSLATE_NOOP("Phrases", "stopped by command"),
    QT_TRANSLATE_NOOP("Phrases", "stopped by watchdog"),
    QT_TRANSLATE_NOOP("Phrases", "choose another preset"),
    QT_TRANSLATE_NOOP("Phrases", "'{}' is too large for a preset"),
    QT_TRANSLATE_NOOP("Phrases", "choose a preset file"),
    QT_TRANSLATE_NOOP("Phrases", "'{}' was written by a newer Halbench ({})"),
    QT_TRANSLATE_NOOP("Phrases", "open it there, or install that version"),
    QT_TRANSLATE_NOOP("Phrases", "'{}' is for a device of model '{}'"),
    QT_TRANSLATE_NOOP("Phrases", "this device is of model '{}'"),
    QT_TRANSLATE_NOOP("Phrases", "'{}' cannot be the name of a preset"),
    QT_TRANSLATE_NOOP("Phrases", "use letters, digits, spaces, points and hyphens"),
    QT_TRANSLATE_NOOP("Phrases", "check the folder and the space on the disk"),
    QT_TRANSLATE_NOOP("Phrases", "choose another folder or name"),
    QT_TRANSLATE_NOOP("Phrases", "there is no picture to save"),
};

} // namespace
// clang-format on

std::span<const char* const> phrasesOfFiles() {
    return Table;
}

} // namespace halbench::widgets
