"""Rules about source text. A rule takes {path: text} and yields (path, line, message)."""
import re

from house import folder_of
from tree import code_only, comments, function_lengths, includes, is_product, is_source, line_of, type_names

# folder: the Qt modules that it may use; the longest matching folder counts.
WINDOW = ["QtCore", "QtGui", "QtSvg", "QtWidgets"]
QT = {
    "control": [],
    "models": [],
    "devices/firmware": [],
    "devices/transport": ["QtCore", "QtSerialPort"],
    "devices/xcp": [],
    "devices/simulated": [],
    "devices": ["QtCore"],
    "widgets": WINDOW,
    "app": WINDOW,
} | {f"app/{folder}": ["QtCore"] for folder in (
    "actuators", "procedures", "session", "cli", "documents", "experiments", "headless", "recordings", "tuning")}
C_HEADERS = {"stdint.h", "stddef.h", "string.h", "math.h", "stdbool.h", "limits.h", "float.h"}


def home(path):
    folders = [f for f in QT if path.startswith(f + "/")]
    return max(folders, key=len) if folders else None


def allowed_qt(files):
    for path, text in files.items():
        folder = home(path)
        if not (folder and is_product(path)):
            continue
        for line, mark, header in includes(text):
            module = header.split("/")[0]
            if mark == "<" and header.startswith("qwt") and not path.startswith(("widgets/", "app/report/")):
                yield path, line, f"{folder} may not use Qwt"
            if mark != "<" or not re.match(r"Q[A-Z]|Qt[A-Z]", header):
                continue
            if "/" not in header and "QtWidgets" in QT[folder]:
                continue
            if "/" not in header:
                yield path, line, f"write the module: <QtCore/{header}> or another"
            elif module not in QT[folder]:
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


def one_type_per_name(files):
    """Two types of one qualified name in one program are undefined behaviour that no compiler reports."""
    seen = {}
    for path, text in files.items():
        if path.endswith((".h", ".cpp")):
            for line, name in type_names(text):
                if seen.setdefault(name, path) != path:
                    yield path, line, f"{name} is defined in {seen[name]} too"


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
     "devices/simulated/loopback_transport", "tests/devices/firmware/line/board_line"), "no sleeping: time is the Clock's"),   # wall-clock pacing
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
                         "app/program/main.cpp")


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
    part = own_part(path)
    return {header for _, mark, header in includes(files.get(path, ""))
            if mark == '"' and part and header.startswith(part)}


def own_part(path):
    """Its folder; where parts are put together, all of them."""
    for place, part in ((PANELS, "app/"), ("devices/open/", "devices/"), ("widgets/", "widgets/")):
        if path.startswith(place):
            return part
    return f"{folder_of(path)}/" if folder_of(path) else None


# What moves the motor or judges it is asked for as a whole; a panel that took parts of it would give other numbers than
# the batch program.
PANELS = ("app/window/", "app/wizards/", "app/workbench/", "app/workspaces/")
PROCEDURES = ("runIdentify", "runFrequency", "runRelay", "runCalibrate", "runApply", "runLiveApply", "runTune",
              "runAnalysis", "runApplyAxes", "runAxesFrequency")
PROCEDURE_DOORS = {"app/procedures/" + name + ".h" for name in (
    "base/procedure", "identify/identify_procedure", "identify/identify_plan", "frequency/frequency_procedure",
    "frequency/frequency_plan", "frequency/frequency_board", "relay/relay_procedure", "relay/relay_plan",
    "base/coil_forecast", "frequency/measured_loop", "calibrate/calibrate_procedure", "apply/apply_procedure",
    "tune/tune", "tune/loop_verdict", "excite/move_reference", "calibrate/ellipse_shape",
    "tune/loop_uncertainty",  # the motors that runTune draws, for the pictures
    "tune/disturbance",  # a prediction, as the step of runAnalysis
    "apply/live_apply_procedure", "move/what_if",
    "identify/axes_identification", "base/axis_model", "tune/tune_axes", "apply/apply_axes",  # several axes
    "frequency/axes_frequency",
    "base/doubtful_source",  # of a verdict: nothing moves
    "base/axis_choice",  # which axes a device has: nothing moves
    "tune/position_law_parameters",  # a law as parameters and back: nothing moves, nothing is judged
    "base/axis_choice",  # the axes of a device by name: nothing moves
    "base/coil_temperature_monitor",  # temperatures are read: nothing moves
    "excite/move_reference_keys", "excite/table_reference", "excite/travel_reference",  # what a motion will be: nothing moves
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


COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.S)
REGISTRIES = {"devices": "devices/simulated/registry/simulated_models.cpp", "app": "app/actuators/registry/actuators.cpp"}
ACTUATOR = re.compile(r"(devices|app)/(?:simulated|firmware|actuators)/(\w+)/")
# Analyses of the motor that have no row of the table yet.
ANALYSES = re.compile(r"app/actuators/htm/(?:amplifier_analysis|known_motor|motor_analysis|motor_geometry_analysis)\.h")


def actuators_stay_in_their_folders(files):
    """An actuator (a folder of devices/simulated) is known to its own folders and to one registry below the app and one in it."""
    actuators = {path.split("/")[2] for path in files if re.match(r"devices/simulated/(?!registry/)\w+/", path)}
    for path, text in files.items():
        layer = path.split("/")[0]
        if not is_product(path) or layer not in REGISTRIES or path == REGISTRIES[layer]:
            continue
        for line, _, header in includes(text):
            named = ACTUATOR.match(header)
            if named and named[2] in actuators and f"/{named[2]}/" not in path and "/boards/" not in path and not ANALYSES.match(header):
                yield path, line, f"{header}: only {REGISTRIES[layer]} names an actuator"


# Actuators that live in their folders alone; the motor's name still stands in its presets and analyses.
NAMED_ONCE = re.compile(r"\b(?:planar|spherical)\b")
NAMED_IN = re.compile(r"/planar/|/spherical/|/registry/|^widgets/language/|^models/")


def actuators_are_named_in_their_folders(files):
    """No code beside an actuator's folders and the registries knows its name, not even in a text."""
    for path, text in files.items():
        if not is_product(path) or NAMED_IN.search(path):
            continue
        code = COMMENT.sub(lambda match: re.sub(r"[^\n]", " ", match.group()), text)
        for match in NAMED_ONCE.finditer(code):
            yield path, line_of(code, match.start()), f"'{match.group()}' is known to its folders and the registries only"


# Classes that still wait for their collaborators, with the sources they may have: no number grows, no name is added.
SEVERAL_SOURCES = {
    "MainWindow": 4, "CalibratePanel": 2, "DrivePanel": 3, "MonitorPanel": 3, "RecordingsPanel": 2,
    "FilterEditor": 2, "LoopView": 2, "SampleHistory": 4, "PageFile": 2, "A2lParser": 3,
    "XcpMaster": 3, "RotorView": 2, "FigureView": 3, "LivePlot": 4, "LivePlotStack": 11, "ParameterTable": 2,
    "ParameterTableModel": 2,
}
MEMBER = re.compile(r"^(?:[A-Za-z][^\n;=(]*?\b)?([A-Z]\w+)::~?\w+\(", re.MULTILINE)


def one_source_per_class(files):
    """A class has one header and one .cpp; one that wants a second lacks a collaborator with a name of its own."""
    sources = {}
    for path, text in sorted(files.items()):
        if is_product(path) and path.endswith(".cpp"):
            folder = path.rpartition("/")[0]
            for name in set(MEMBER.findall(code_only(text))):
                sources.setdefault((folder, name), []).append(path)
    for (_, name), paths in sorted(sources.items()):
        allowed = SEVERAL_SOURCES.get(name, 1)
        if len(paths) > allowed:
            yield paths[-1], 1, f"{name} is written in {len(paths)} sources, {allowed} at most"


RULES = {rule.__name__: rule for rule in (
    allowed_qt, firmware_is_plain_c, firmware_has_its_licence, one_type_per_name, file_sizes, function_sizes,
    forbidden_words, nothing_unfinished, names_and_guards, cites_only_what_is_here, every_source_has_its_test,
    one_source_per_class, panels_run_whole_procedures, actuators_stay_in_their_folders, actuators_are_named_in_their_folders)}
