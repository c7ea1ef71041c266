"""Rules about source text. A rule takes {path: text} and yields (path, line, message)."""
import re

from tree import code_only, comments, function_lengths, includes, is_product, is_source, line_of

EVERY_DEVICE_HEADER = r"devices/[a-z_]+\.h"
DEVICE_ONLY = ["control/", EVERY_DEVICE_HEADER]

# folder: (project headers it may include, Qt modules it may use); the longest matching folder counts.
# The same as the table of resources/help/architecture.md, section 1.
HOUSE = {
    "control/base": (["control/base/"], []),
    "control/lti": (["control/(base|lti)/"], []),
    "control/analysis": (["control/(base|lti|analysis)/"], []),
    "control/signals": (["control/(base|signals)/"], []),
    "control/history": (["control/(base|signals|history)/"], []),
    "control/identify": (["control/(base|identify)/"], []),
    "control/law": (["control/(base|lti|analysis|law)/"], []),
    "control/assess": (["control/(base|lti|analysis|law|assess|robustness)/"], []),
    "control/robustness": (["control/(base|lti|analysis|law|assess|robustness)/"], []),
    "control/design": (["control/(base|lti|analysis|law|assess|design)/"], []),
    "models/fields": (["control/base/", "models/fields/"], []),
    "models/sensors": (["control/base/", "models/sensors/"], []),
    "models/drives": (["control/base/", "models/drives/"], []),
    "models/thermal": (["models/thermal/"], []),
    "models/estimators": (["control/base/", "models/(fields|estimators)/"], []),
    "models/planar": (["control/base/", "models/(planar|fields|sensors|drives|thermal)/"], []),
    "models/spherical": (["control/base/", "models/(spherical|fields)/"], []),
    "models": (["control/", "models/"], []),
    "devices/firmware": (["devices/firmware/"], []),
    "devices/transport": (["control/base/", "devices/transport/"], ["QtCore", "QtSerialPort"]),
    "devices/xcp": (["control/base/", "devices/xcp/", "devices/transport/transport.h", EVERY_DEVICE_HEADER], []),
    "devices/simulated": (["control/", "models/", "devices/"], []),
    "devices/recording": (["control/base/", "devices/recording/", EVERY_DEVICE_HEADER], ["QtCore"]),
    "devices/acquisition": (["control/base/", "devices/(acquisition|recording)/", EVERY_DEVICE_HEADER], ["QtCore"]),
    "devices/formats": (["control/base/", "devices/(acquisition|formats|recording)/", EVERY_DEVICE_HEADER], ["QtCore"]),
    "devices/history": (["control/base/", "devices/history/", EVERY_DEVICE_HEADER], ["QtCore"]),
    "devices": (["control/base/", "devices/"], ["QtCore"]),
    "app/actuators": (["control/", "models/", "devices/simulated/", EVERY_DEVICE_HEADER, "app/procedures/", "app/actuators/"],
                      ["QtCore"]),
    "app/procedures": (["control/", "models/", "devices/acquisition/", "devices/recording/", EVERY_DEVICE_HEADER,
                        "app/procedures/"], ["QtCore"]),
    "app/session": (["control/", "devices/(acquisition|open|recording)/", EVERY_DEVICE_HEADER, "app/procedures/",
                     "app/session/"], ["QtCore"]),
    "app/figures": (["control/", EVERY_DEVICE_HEADER, "app/procedures/", "app/figures/", "widgets/"],
                    ["QtCore", "QtGui", "QtSvg", "QtWidgets"]),
    "app/report": (["control/", "models/", EVERY_DEVICE_HEADER, "app/procedures/", "app/actuators/", "app/figures/",
                    "app/report/", "widgets/"], ["QtCore", "QtGui", "QtSvg", "QtWidgets"]),
    "widgets": (["control/", "models/", "widgets/"], ["QtCore", "QtGui", "QtSvg", "QtWidgets"]),
    "app": (["control/", "models/", "devices/", "app/", "widgets/"], ["QtCore", "QtGui", "QtSvg", "QtWidgets"]),
} | {f"app/{folder}": (["control/", "models/", "devices/", "app/(procedures|actuators|figures|report)/",
                        "app/(cli|documents|experiments|headless|recordings|tuning)/"], ["QtCore"])
     for folder in ("cli", "documents", "experiments", "headless", "recordings", "tuning")}
C_HEADERS = {"stdint.h", "stddef.h", "string.h", "math.h", "stdbool.h", "limits.h", "float.h"}


def home(path):
    folders = [f for f in HOUSE if path.startswith(f + "/")]
    return max(folders, key=len) if folders else None


def allowed_includes(files):
    for path, text in files.items():
        folder = home(path)
        if folder and is_product(path):
            for line, mark, header in includes(text):
                if mark == '"' and not any(re.match(p, header) for p in HOUSE[folder][0]):
                    yield path, line, f"{folder} may not include {header}"


def allowed_qt(files):
    for path, text in files.items():
        folder = home(path)
        if not (folder and is_product(path)):
            continue
        for line, mark, header in includes(text):
            module = header.split("/")[0]
            if mark == "<" and header.startswith("qwt") and folder not in ("widgets", "app/report"):
                yield path, line, f"{folder} may not use Qwt"
            if mark != "<" or not re.match(r"Q[A-Z]|Qt[A-Z]", header):
                continue
            if "/" not in header and "QtWidgets" in HOUSE[folder][1]:
                continue
            if "/" not in header:
                yield path, line, f"write the module: <QtCore/{header}> or another"
            elif module not in HOUSE[folder][1]:
                yield path, line, f"{folder} may not use {module}"


def firmware_is_plain_c(files):
    for path, text in files.items():
        if not path.startswith("devices/firmware/") or not is_source(path):
            continue
        if path.endswith(".cpp"):
            yield path, 1, "the board's code is C"
        for line, mark, header in includes(text):
            if mark == "<" and header not in C_HEADERS and not header.startswith(("avr/", "util/")):
                yield path, line, f"<{header}> is not for a board without an operating system"
        for match in re.finditer(r"\b(malloc|calloc|realloc|free|s?n?printf|double\s+\w+\s*=\s*malloc)\s*\(",
                                 code_only(text)):
            yield path, line_of(text, match.start()), f"{match.group(1)} on the board"


def firmware_has_its_licence(files):
    for path, text in files.items():
        if path.startswith("devices/firmware/") and is_source(path):
            if "SPDX-License-Identifier: MIT" not in text.split("\n", 1)[0]:
                yield path, 1, "the first line names the licence: SPDX-License-Identifier: MIT"


def file_sizes(files):
    for path, text in files.items():
        if is_source(path) and text.count("\n") > 600:
            yield path, 600, f"{text.count(chr(10))} lines; a file fails at 600"


def function_sizes(files):
    for path, text in files.items():
        if is_source(path):
            for line, length in function_lengths(text):
                if length > 80:
                    yield path, line, f"function of {length} lines; fails at 80"


# pattern in code (comments and strings do not count), where it is allowed, message
FORBIDDEN = (
    (r"\bconnect\s*\([^;]*\b(SIGNAL|SLOT)\s*\(", (), "connect with pointers to members"),
    (r"\bsetStyleSheet\s*\(", ("widgets/theme/theme",), "setStyleSheet only in the theme"),
    (r"\bQFileDialog::(get\w+|save\w+)\s*\(", (), "file dialogs carry a STOP: app/window/file_dialogs"),
    (r"\bsleep_for\b|\bsleep_until\b|\busleep\s*\(|\bnanosleep\s*\(|\bQThread::m?sleep", ("devices/transport/",
     "devices/simulated/loopback_transport", "tests/devices/firmware/avr/simavr/avr_line"), "no sleeping: time is the Clock's"),   # wall-clock pacing
    (r"\bDISABLED_\w+|\bGTEST_SKIP\b|\bQSKIP\b", (), "a test is run or removed"),
    (r"\bstd::(normal|uniform_\w+|exponential)_distribution\b|\bstd::random_device\b|\bstd::mt19937|\bs?rand\s*\(\s*\)",
     (), "random numbers come from control/base/random.h"),
    (r"\bsystem_clock\b|\bQDateTime::currentDateTime|\bstd::time\s*\(|\bgettimeofday\b",
     ("app/documents/result_header", "app/workbench/wall_clock"), "no wall time in results"),   # `started` of a real device
    (r"\bstd::(views|ranges::views|format)\b", (), "not in GCC 12 and clang 14 alike"),
    (r"\busing\s+namespace\s+(?!std::(string_view_)?literals|std::chrono_literals)[\w:]*;.*$", (".cpp", ),
     "no using namespace in a header"),
    (r"\bassert\s*\(", ("devices/firmware/",), "HB_ASSERT is always on"),
    (r"\b(?:QLocale\(\)|QLocale::c\(\)|locale)\.toString\s*\((?![^;]*(?:Format|\.time\(\)))",
     ("widgets/language/display_units.cpp", "widgets/figure/figure_axis.cpp",   # the report's numbers too
      "app/session/", "tests/"), "numbers on the screen are written by widgets/language/display_units"),   # QtCore alone
    (r"\bsetlocale\s*\([^)]*\"\"|\bstd::locale\s*\(\s*\"\"", (), "numbers are written in the C locale"),
    (r"\bstatic\s+(?!const|constexpr|inline|_Static|cast)\w[\w:<>]*\s+\w+\s*(=|;)", ("tests/",
     "widgets/figure/offscreen_application",   # QApplication keeps its argc by reference
     "devices/firmware/boards/"), "no globals or hidden state"),   # an interrupt handler has no argument
)


def forbidden_words(files):
    for path, text in files.items():
        if not is_source(path):
            continue
        code = code_only(text)
        for pattern, places, message in FORBIDDEN:
            if any(path.startswith(p) or path.endswith(p) for p in places):
                continue
            for match in re.finditer(pattern, code, re.M):
                yield path, line_of(code, match.start()), f"{message}: {' '.join(match.group(0).split())[:50]}"


UNFINISHED = re.compile(r"\b(TODO|FIXME|XXX|HACK)\b(?!\(\S+\))")


def nothing_unfinished(files):
    for path, text in files.items():
        if is_source(path):
            for line, comment in comments(text):
                if UNFINISHED.search(comment):
                    yield path, line, "finish it, or name the issue: TODO(issue)"


def names_and_guards(files):
    for path, text in files.items():
        if not is_source(path):
            continue
        name = path.rsplit("/", 1)[1]
        if not re.fullmatch(r"[a-z][a-z0-9_]*\.(h|cpp|c)", name):
            yield path, 1, "files are snake_case"
        if path.endswith(".h") and not re.search(r"^#pragma once$|^#ifndef \w+$", text, re.M):
            yield path, 1, "a header is guarded"


# Pages that are not part of the repository, and places of one machine.
FOREIGN_PLACES = re.compile(r"(\.\./shared|(?<![\w/])physics/[a-z*]+|\b(design|cli|style|user-wishes|performance|"
                            r"virtual-hardware|look)\.md|(?<!\w)/home/\w+/)")
SELF = "tests/architecture/"


def cites_only_what_is_here(files):
    for path, text in files.items():
        if path.startswith(SELF):
            continue
        for number, line in enumerate(text.split("\n"), 1):
            found = FOREIGN_PLACES.search(line)
            if found:
                yield path, number, f"{found.group(0)} is not part of the repository"


# Run as a whole by the program tests, not linked into a unit test.
TESTED_BY_THE_PROGRAM = ("app/cli/program", "app/cli/command", "app/headless/command", "app/headless/interrupt", "app/headless/console",
                         "app/main.cpp")


def every_source_has_its_test(files):
    """A test includes its header, or that of the unit of the same folder which it is a part of."""
    tested = tested_headers(files)
    for path, text in files.items():
        if not is_product(path) or path.endswith(".h") or "/boards/" in path or path.startswith(TESTED_BY_THE_PROGRAM):
            continue
        own = re.sub(r"\.(cpp|c)$", ".h", path)
        headers = {own} if own in files else own_includes(files, path)
        if not headers & tested:
            yield path, 1, f"no test includes {' or '.join(sorted(headers)) or own}, nor the unit it is a part of"


def tested_headers(files):
    """Headers that tests include, and the parts these and their sources are made of."""
    waiting = [header for path, text in files.items() if path.startswith("tests/") and is_source(path)
               for _, _, header in includes(text)]
    tested = set()
    while waiting:
        header = waiting.pop()
        if header not in tested and header in files:
            tested.add(header)
            for part in (header, header[:-2] + ".cpp", header[:-2] + ".c"):
                waiting += own_includes(files, part)
    return tested


def own_includes(files, path):
    """What a file includes from its own part of the house."""
    folder = home(path)
    return {header for _, mark, header in includes(files.get(path, ""))
            if mark == '"' and folder and header.startswith(folder + "/")}


# What moves the motor or judges it is asked for as a whole; a panel that took parts of it would give other numbers than
# the batch program.
PANELS = ("app/window/", "app/wizards/", "app/workbench/", "app/workspaces/")
PROCEDURES = ("runIdentify", "runFrequency", "runRelay", "runCalibrate", "runApply", "runLiveApply", "runTune",
              "runAnalysis")
PROCEDURE_DOORS = {"app/procedures/" + name + ".h" for name in (
    "base/procedure", "identify/identify_procedure", "identify/identify_plan", "frequency/frequency_procedure",
    "frequency/frequency_plan", "frequency/frequency_board", "relay/relay_procedure", "relay/relay_plan",
    "base/coil_forecast", "frequency/measured_loop", "calibrate/calibrate_procedure", "apply/apply_procedure",
    "tune/tune", "tune/loop_verdict", "excite/move_reference", "calibrate/ellipse_shape",
    "tune/loop_uncertainty",  # the motors that runTune draws, for the pictures
    "tune/disturbance",  # a prediction, as the step of runAnalysis
    "apply/live_apply_procedure", "move/what_if",
    "base/coil_watch",  # temperatures are read: nothing moves
    "record/capture_orders")}  # the board captures: nothing moves, nothing is judged
FITS = r"control/identify/|models/estimators/"
PARTS_OF_PROCEDURES = r"\b(run(?!Procedure\b|Step\b|Window\b)[A-Z]\w*|identifyRecording|performMove)\s*\("


def panels_run_whole_procedures(files):
    for path, text in files.items():
        if not path.startswith(PANELS):
            continue
        for line, _, header in includes(text):
            if re.match(FITS, header) or header.startswith("app/procedures/") and header not in PROCEDURE_DOORS:
                yield path, line, f"{header} is a part of a procedure; panels use {', '.join(PROCEDURES)}"
        code = code_only(text)
        for match in re.finditer(PARTS_OF_PROCEDURES, code):
            if match.group(1) not in PROCEDURES:
                yield path, line_of(code, match.start()), f"{match.group(1)}: panels use {', '.join(PROCEDURES)}"


RULES = {rule.__name__: rule for rule in (
    allowed_includes, allowed_qt, firmware_is_plain_c, firmware_has_its_licence, file_sizes, function_sizes,
    forbidden_words, nothing_unfinished, names_and_guards, cites_only_what_is_here, every_source_has_its_test,
    panels_run_whole_procedures)}
