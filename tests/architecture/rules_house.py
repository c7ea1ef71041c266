"""Rules about the folders of the house (house.py). A rule takes {path: text} and yields (path, line, message)."""
import re
from collections import Counter, defaultdict

from house import MAY_INCLUDE, ONLY_HEADERS, cycles, folder_of, folders_in
from tree import includes, is_product

PAGE = "resources/help/architecture.md"
SMALL_ACTUATOR = "tests/conformance/actuator/"
SMALL_ACTUATOR_LINES = 250
SMALL_ACTUATOR_COLUMNS = 120
MOST_FILES = 60


def allowed_includes(files):
    for path, text in files.items():
        if not is_product(path):
            continue
        folder = folder_of(path)
        if folder is None:
            yield path, 1, "this folder is not in the table of tests/architecture/house.py"
            continue
        allowed = folders_in(MAY_INCLUDE[folder]) | {folder}
        for line, mark, header in includes(text):
            place = folder_of(header)
            only = ONLY_HEADERS.get((folder, place), "")
            if mark == '"' and not (place in allowed and re.match(only, header)):
                yield path, line, f"{folder} may not include {header}"


def no_two_folders_include_each_other(files):
    """Nor over others: each folder, sub-folders too, by what its files include."""
    arrows, seen = defaultdict(set), {}
    for path, text in files.items():
        if is_product(path):
            here = path.rpartition("/")[0]
            for line, mark, header in includes(text):
                there = header.rpartition("/")[0]
                if mark == '"' and there != here:
                    arrows[here].add(there)
                    seen.setdefault((here, there), (path, line))
    for group in cycles(arrows):
        for (here, there), (path, line) in seen.items():
            if here in group and there in group:
                yield path, line, f"{here} and {there} include each other: {', '.join(group)}"


def folder_sizes(files):
    count = Counter(path.rpartition("/")[0] for path in files if is_product(path))
    for folder, number in count.items():
        if number > MOST_FILES:
            yield folder, 1, f"{number} files; a folder fails beyond {MOST_FILES}: split it by topic"


def small_actuator_stays_small(files):
    """The actuator of the conformance test shows what one costs: all its files but the tests, in lines of usual length."""
    own = {path: text for path, text in files.items() if path.startswith(SMALL_ACTUATOR) and not path.endswith("_test.cpp")}
    lines = sum(text.count("\n") for text in own.values())
    if lines > SMALL_ACTUATOR_LINES:
        yield SMALL_ACTUATOR, 1, f"{lines} lines; it fails beyond {SMALL_ACTUATOR_LINES}: what any actuator needs belongs to a shared module"
    for path, text in own.items():
        for number, line in enumerate(text.split("\n"), 1):
            if len(line) > SMALL_ACTUATOR_COLUMNS:
                yield path, number, f"{len(line)} columns; at most {SMALL_ACTUATOR_COLUMNS}"


def page_shows_the_house(files):
    """The table of the page: | `folder` | holds | may include | ... |"""
    if PAGE not in files:
        return
    shown = {}
    for number, line in enumerate(files[PAGE].split("\n"), 1):
        cells = [cell.strip() for cell in line.strip("|").split(" | ")]
        name = re.fullmatch(r"`([a-z_/]+?)(/\*\.h)?`", cells[0])
        if name and len(cells) >= 3 and name.group(1).split("/")[0] in ("control", "models", "devices", "widgets", "app"):
            shown[name.group(1)] = number
            due = MAY_INCLUDE.get(name.group(1))
            if due is None:
                yield PAGE, number, f"there is no folder {name.group(1)} in the table of the rules"
            elif cells[2] != (due or "nothing"):
                yield PAGE, number, f"{name.group(1)} may include: {due or 'nothing'}"
    for folder in MAY_INCLUDE:
        if folder not in shown:
            yield PAGE, 1, f"the table of the page lacks {folder}"


RULES = {rule.__name__: rule for rule in (
    allowed_includes, no_two_folders_include_each_other, folder_sizes, small_actuator_stays_small,
    page_shows_the_house)}
