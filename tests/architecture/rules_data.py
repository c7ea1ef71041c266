"""Rules about resources and help pages. A rule takes {path: text} and yields (path, line, message)."""
import json
import re
import tomllib

from tree import is_source


def data_parses(files):
    for path, text in files.items():
        if not path.startswith("resources/") and path != "CMakePresets.json":
            continue
        try:
            if path.endswith(".json"):
                json.loads(text, parse_constant=refuse_constant, object_pairs_hook=unique_keys)
            elif path.endswith(".toml"):
                tomllib.loads(text)
        except ValueError as error:
            yield path, getattr(error, "lineno", 1), str(error)


def refuse_constant(word):
    raise ValueError(f"{word} is not JSON")


def unique_keys(pairs):
    keys = [key for key, _ in pairs]
    doubled = {key for key in keys if keys.count(key) > 1}
    if doubled:
        raise ValueError(f"key {sorted(doubled)[0]} twice")
    return dict(pairs)


def parsed(files, folder, extension):
    for path, text in files.items():
        if path.startswith(folder) and path.endswith(extension):
            try:
                yield path, json.loads(text) if extension == ".json" else tomllib.loads(text)
            except ValueError:
                pass                             # data_parses reports it


def board_names(files):
    """Every name in quotes in the board's tables and the simulation's extra signals."""
    names = set()
    for path, text in files.items():
        if is_source(path) and path.startswith(("devices/firmware/", "devices/simulated/")):
            names |= set(re.findall(r'"([a-z][a-z0-9_]*(?:\.[a-z0-9_]+)*)"', text))
    return names


def profile_roles_exist(files):
    known = board_names(files)
    for path, profile in parsed(files, "resources/devices/", ".json"):
        for table in ("signal_roles", "parameter_roles"):
            for role, name in profile.get(table, {}).items():
                if name not in known:
                    yield path, 1, f"role {role}: the board has no {name}"
        for name in profile.get("default_signals", []):
            if name not in known:
                yield path, 1, f"default signal {name} is not the board's"


def preset_keys_exist(files):
    known = board_names(files)
    for path, profile in parsed(files, "resources/devices/", ".json"):
        for preset, values in presets_of(profile):
            for key in values:
                if key not in known:
                    yield path, 1, f"preset {preset}: the board has no parameter {key}"


def presets_of(profile):
    presets = profile.get("presets", {})
    items = presets.items() if isinstance(presets, dict) else ((p.get("name"), p) for p in presets)
    for name, preset in items:
        values = preset.get("values", preset.get("parameters", preset))
        if isinstance(values, dict):
            yield name, values


def closed_units(files):
    text = files.get("control/base/units.cpp", "")
    return set(re.findall(r'Unit\{"([^"]*)",', text))


def units_are_known(files):
    units = closed_units(files)
    for path, profile in parsed(files, "resources/", ".json"):
        if not path.startswith(("resources/schemas/", "resources/samples/")):  # a recording has those of its board
            for where, unit in units_in(profile, ""):
                if unit not in units:
                    yield path, 1, f"{where}: unit {unit!r} is not in control/base/units.cpp"


def units_in(value, where):
    if isinstance(value, dict):
        for key, inner in value.items():
            if key == "unit" and isinstance(inner, str):
                yield where, inner
            else:
                yield from units_in(inner, f"{where}.{key}")
    elif isinstance(value, list):
        for index, inner in enumerate(value):
            yield from units_in(inner, f"{where}[{index}]")


def unit_suffixes_are_unique(files):
    text = files.get("control/base/units.cpp", "")
    suffixes = re.findall(r'Unit\{"([^"]*)", "([^"]*)",', text)
    for symbol, suffix in suffixes:
        if not re.fullmatch(r"[A-Za-z0-9_]*", suffix):
            yield "control/base/units.cpp", 1, f"suffix {suffix!r} of {symbol} cannot be part of an identifier"
        if suffixes.count((symbol, suffix)) > 1 or sum(s == symbol for s, _ in suffixes) > 1:
            yield "control/base/units.cpp", 1, f"unit {symbol} twice"


def luminance(colour):
    """Relative luminance of WCAG 2.1."""
    channels = [int(colour[i:i + 2], 16) / 255 for i in (1, 3, 5)]
    linear = [c / 12.92 if c <= 0.03928 else ((c + 0.055) / 1.055) ** 2.4 for c in channels]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(one, other):
    light, dark = sorted((luminance(one), luminance(other)), reverse=True)
    return (light + 0.05) / (dark + 0.05)


def themes_are_complete(files):
    themes = {path: theme.get("colors", theme) for path, theme in parsed(files, "resources/themes/", ".json")}
    keys = set().union(*themes.values()) if themes else set()
    for path, theme in themes.items():
        for key in sorted(keys - set(theme)):
            yield path, 1, f"{key} is missing"
        background = theme.get("background")
        for key, colour in theme.items():
            if background and re.search(r"(^|[._])text\b", key) and contrast(colour, background) < 4.5:
                yield path, 1, f"{key} on background: contrast {contrast(colour, background):.1f}, needs 4.5"


def headings(text):
    return [line.lstrip("#").strip() for line in text.split("\n") if line.startswith("#")]


def anchor(heading):
    kept = re.sub(r"[^\w\- ]", "", heading.replace("`", "").lower())
    return kept.replace(" ", "-")


def help_links_lead_somewhere(files):
    for path, text in files.items():
        if not path.endswith(".md"):
            continue
        folder = path.rsplit("/", 1)[0] + "/" if "/" in path else ""
        for number, line in enumerate(text.split("\n"), 1):
            for target in re.findall(r"\]\(([^)\s]+)\)", line):
                message = broken_link(files, path, folder, target)
                if message:
                    yield path, number, message


def broken_link(files, path, folder, target):
    if re.match(r"[a-z]+:", target):
        return None
    name, _, place = target.partition("#")
    page = path if not name else resolve(folder + name)
    if page not in files:
        return None if any(f.startswith(page.rstrip("/") + "/") for f in files) else f"{target} does not exist"
    if place and place not in map(anchor, headings(files[page])):
        return f"{page} has no heading for #{place}"
    return None


def resolve(path):
    parts = []
    for part in path.split("/"):
        if part == "..":
            parts.pop()
        elif part != ".":
            parts.append(part)
    return "/".join(parts)


CITATION = re.compile(r"(?:resources/help/)?\b((?:htm-theory|protocol|architecture|command-line|identification|tuning|"
                      r"firmware-guide)\.md)(?:,? (?:section |sections )?(\d+(?:\.\d+)*))?")


def citations_exist(files):
    """A comment that names a help page, and perhaps a section of it, names something that is there."""
    sections = {path.rsplit("/", 1)[1]: {h.split()[0].rstrip(".") for h in headings(text) if h[:1].isdigit()}
                for path, text in files.items() if re.fullmatch(r"resources/help/[^/]+", path)}
    sections.get("htm-theory.md", set()).update(re.findall(r"^\| (6\.\d+) \|",
                                                           files.get("resources/help/htm-theory.md", ""), re.M))
    for path, text in files.items():
        if not is_source(path):
            continue
        for number, line in enumerate(text.split("\n"), 1):
            for page, section in CITATION.findall(line):
                if page not in sections:
                    yield path, number, f"resources/help/{page} does not exist"
                elif section and sections[page] and section not in sections[page]:
                    yield path, number, f"{page} has no section {section}"


RULES = {rule.__name__: rule for rule in (
    data_parses, profile_roles_exist, preset_keys_exist, units_are_known, unit_suffixes_are_unique,
    themes_are_complete, help_links_lead_somewhere, citations_exist)}
