"""What the layers below Qt say to people, so that the window can say it in the user's language: every text with words
in it is taken from the sources and kept, with {} for what is filled in, in widgets/language/phrases_*.cpp, where lupdate finds
it. The tables have to be what the sources say, and the window has to look up what it shows.

usage: phrases.py ROOT [--write]   (--write brings the tables up to date; then lupdate and the translators are due)
"""
import os
import re
import sys

from tree import is_source, line_of, read_tree

# table: folders and files whose texts reach the window
TABLES = {
    "control": ("control/",),
    "lines": ("devices/transport/", "devices/xcp/", "app/session/"),
    "devices": ("models/", "devices/"),
    "tuning": ("app/procedures/apply/", "app/procedures/tune/"),
    "references": ("app/procedures/excite/",),
    "procedures": ("app/procedures/",),
    "actuators": ("app/actuators/",),
    "files": ("app/documents/pose_table_file.cpp", "app/documents/text/config_node.cpp", "app/documents/axes_frequency_file.cpp", "app/documents/frequency_file.cpp", "app/tuning/gains_judgement.cpp", "app/documents/configuration_", "app/documents/document_units.cpp", "app/documents/document_limits.cpp", "app/documents/identification_file.cpp", "app/documents/import_documents.cpp", "app/documents/text/json_parser.cpp",
              "app/documents/text/json_value.cpp", "app/documents/model_file.cpp", "app/documents/text/output_file.cpp",
              "app/documents/presets.cpp", "app/recordings/recording_list.cpp", "app/recordings/recording_name.cpp",
              "app/recordings/recording_retention.cpp", "app/recordings/sidecar_change.cpp", "app/documents/result_header.cpp", "app/recordings/run_comparison.cpp",
              "app/documents/text/toml_reader.cpp", "app/tuning/what_if_report.cpp", "app/window/project/project_", "app/window/start/", "app/workbench/", "app/workspaces/",
              "app/wizards/", "widgets/figure/figure_file.cpp", "widgets/figure/figure_view.cpp"),
}
# what of these folders no window shows: command line only, or no sentence but a word of a file format
NEVER_SHOWN = (
    "control/base/assert.cpp", "control/base/result.h", "devices/firmware/", "devices/open/serve_device.cpp",
    "devices/transport/pty_server.cpp", "devices/xcp/a2l_interface.cpp", "devices/xcp/a2l_parser.",
    "app/workspaces/actuators/registry/sample_recordings.cpp", "app/actuators/htm/amplifier_analysis.cpp", "app/actuators/htm/motor_analysis.cpp",
    "app/actuators/htm/motor_geometry_analysis.cpp",
    "app/actuators/htm/motor_contradictions.cpp", "app/actuators/spherical/sensing_contradictions.cpp")
# words of a notation
NO_SENTENCES = {"the board ran firmware '", "give them: --ran GAINS.json", "recorded move", "the same move with these gains", "{} Hz", "zeta, omega-rad-s", "ultimate-gain, ultimate-period", "phase-margin-deg, omega-rad-s", "max-sensitivity, current-limit-a, step-deg", "{}, seed, imperfections, chain",
                "value = {}", "--set {}", "ended by {}", "in use",
                "--rate_Hz F", "--time {}", "--unit {}={}", "--separator '{}'", "{}--decimal {}", "--header {}", "CR LF",
                "{}, from {}", ", byte order mark", "{} column{}:"}
# of these only texts with something filled in are messages; the others are help of the command line
ONLY_FILLED_IN = ("models/htm/htm_parameters.cpp", "models/planar/planar_parameters.cpp",
                  "models/spherical/spherical_parameters.cpp",
                  "app/procedures/excite/move_reference.cpp")

TOKEN = re.compile(r'R"([^(\s]*)\((.*?)\)\1"|//[^\n]*|/\*.*?\*/|^[ \t]*#[^\n]*|\'(?:[^\'\\\n]|\\.){1,4}\''
                   r'|"((?:[^"\\\n]|\\.)*)"', re.S | re.M)
JOINED = re.compile(r"\s*\+\s*[^\"+,;?:{}]+\s*\+\s*")  # "..." + value + "..."
NO_WORDS = re.compile(r"(\btr|NOOP|translate|QStringLiteral|QLatin1String|\bsetObjectName)\(\s*(\"[^\"]*\",\s*)?$")
FILLED_IN = re.compile(r"\{[0-9]*(:[^{}]*)?\}")
WORD = re.compile(r"[A-Za-z]{2}")


def literals(text):
    """(start, end, text) of each string; neighbours and what is joined by + are one."""
    found = []
    for match in TOKEN.finditer(text):
        if match.group(3) is None:
            continue
        between = text[found[-1][1]:match.start()] if found else ";"
        if not between.strip():
            found[-1] = (found[-1][0], match.end(), found[-1][2] + match.group(3))
        elif JOINED.fullmatch(between):
            found[-1] = (found[-1][0], match.end(), found[-1][2] + "{}" + match.group(3))
        else:
            found.append((match.start(), match.end(), match.group(3)))
    return found


def phrase(text, start, end, literal):
    """The text with {} for whatever is filled in; None when it is none for people."""
    before, after = text[:start].rstrip(), text[end:].lstrip()
    if NO_WORDS.search(before) or before.endswith("operator"):
        return None
    words = FILLED_IN.sub("{}", literal)
    if before.endswith("+"):
        words = "{}" + words
    if after.startswith("+"):
        words += "{}"
    plain = words.replace("{}", "")
    has_words = " " in (plain if "{}" in words else plain.strip()) and WORD.search(plain)
    is_other = words in NO_SENTENCES or re.search(r"%[0-9]|\\n|\{\{", words)
    return words if has_words and not is_other else None


def phrases(files, folders):
    found = {}
    for path, text in sorted(files.items()):
        if not is_source(path) or not path.startswith(folders) or path.startswith(NEVER_SHOWN):
            continue
        for start, end, literal in literals(text):
            words = phrase(text, start, end, literal)
            if words and ("{}" in words or not path.startswith(ONLY_FILLED_IN)):
                found.setdefault(words, path)
    return found


def table(name, words):
    lines = [f'    QT_TRANSLATE_NOOP("Phrases", "{each}"),' for each in words]
    return "\n".join(["// Written by tests/architecture/phrases.py --write from the sources: not for editing.",
                      '#include "widgets/language/phrases.h"', "", "#include <QtGlobal>", "", "namespace halbench::widgets {",
                      "", "// clang-format off", "namespace {", "", "constexpr const char* Table[] = {", *lines, "};", "",
                      "} // namespace", "// clang-format on", "",
                      f"std::span<const char* const> phrasesOf{name.capitalize()}() {{", "    return Table;", "}", "",
                      "} // namespace halbench::widgets", ""])


def tables(files):
    seen = {}
    for name, folders in TABLES.items():
        words = [each for each in phrases(files, folders) if each not in seen]
        seen.update(dict.fromkeys(words))
        yield f"widgets/language/phrases_{name}.cpp", table(name, words)


UNSAID = re.compile(r"fromStdString\((?:[^()]|\(\))*?(\.|->)(message|hint|faultText|help)\)")


def unsaid(files):
    """A place of the window that shows the English of the layers below."""
    for path, text in files.items():
        if path.startswith(("app/workspaces/", "app/wizards/", "app/window/", "widgets/")):
            for match in UNSAID.finditer(text):
                yield f"{path}:{line_of(text, match.start())}: say it with widgets::inWords()"


def show_samples():
    assert list(unsaid({"app/window/a.cpp": "x(QString::fromStdString(done.error().message));"}))
    source = ('failure(A, fmt::format("parameter \'{}\' = {:.3g} is out"\n  " of range", x), "allowed: " + keys);\n'
              '"a file " + name + " is gone"; tr("my words"); "word"; // "no text"')
    found = list(phrases({"control/a.cpp": source}, ("control/",)))
    assert found == ["parameter '{}' = {} is out of range", "allowed: {}", "a file {} is gone"], found


def main():
    show_samples()
    root = sys.argv[1]
    files = read_tree(root)
    found = list(unsaid(files))
    for path, text in tables(files):
        if "--write" in sys.argv:
            with open(os.path.join(root, path), "w", encoding="utf-8") as file:
                file.write(text)
        elif files.get(path) != text:
            found.append(f"{path} is not what the sources say: run tests/architecture/phrases.py . --write, "
                         "then lupdate and translate what is new")
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
