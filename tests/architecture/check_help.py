"""The help pages of every language say the same: resources/help/<language>/PAGE.md has the parts of resources/help/PAGE.md,
section by section (headings, paragraphs, items, tables, code, pictures, links, figures), and calls what can be pressed as
the window of that language does (translations/halbench_<language>.ts).

usage: check_help.py ROOT   (the source tree); without it the rules are shown wrong samples
"""
import os
import re
import sys
import xml.etree.ElementTree as ElementTree
from collections import Counter

from rules_data import anchor, headings, resolve

LANGUAGES = ("de", "zh_CN")
WITHOUT_SPACES = ("zh_CN",)
PAGES = ("index.md", "monitor.md", "identification.md", "tuning.md", "projects.md")  # what is read in the window
CODE = re.compile(r"`[^`]*`")
LINK = re.compile(r"(!?)\[[^\]]*\]\(([^)\s]+)\)")
EMPHASIS = re.compile(r"(\*\*|\*)(?=[^\s*])(.+?)(?<=[^\s*])\1")
FIGURE = re.compile(r"\d+(?:[.,]\d+)*")


def sections(text):
    """[heading, lines below it], the first one before any heading."""
    found = [["", []]]
    for line in text.split("\n"):
        if line.startswith("#"):
            found.append([line, []])
        else:
            found[-1][1].append(line)
    return found


def blocks(lines):
    return [block for block in re.split(r"\n\s*\n", "\n".join(lines).strip("\n")) if block.strip()]


def is_code(block):
    return block.startswith("    ")


def words_of(lines):
    """What is read as words: no code, emphasis kept, a line a paragraph."""
    prose = [block for block in blocks(lines) if not is_code(block)]
    return "\n".join(CODE.sub("``", re.sub(r"\n\s*(?![-|]|\d+\. )", " ", block)) for block in prose)


def emphases(lines):
    return [match.group(2) for match in EMPHASIS.finditer(LINK.sub("", words_of(lines)))]


def unreadable(lines):
    """Markdown takes no mark between a letter and a punctuation mark: where words are not parted by spaces, it happens."""
    words = words_of(lines)
    for match in EMPHASIS.finditer(words):
        before, after = words[match.start() - 1:match.start()], words[match.end():match.end() + 1]
        first, last = match.group(2)[0], match.group(2)[-1]
        if re.match(r"\w", before) and re.match(r"\W", first) or re.match(r"\W", last) and re.match(r"\w", after):
            yield match.group(0)


def figures(text):
    """Of words and code; how a language parts decimals and thousands is its own."""
    text = LINK.sub("", text).replace("1/min", "r/min").replace("Pos1", "Home")
    return Counter(re.sub("[.,]", "", figure) for figure in FIGURE.findall(text))


def targets(files, path, text):
    """Where links and pictures lead, whatever the headings there are called."""
    found = Counter()
    folder = path.rsplit("/", 1)[0] + "/"
    for is_picture, target in LINK.findall(text):
        name, _, place = target.partition("#")
        page = path if not name else resolve(folder + name)
        places = [anchor(heading) for heading in headings(files.get(page, ""))]
        found[is_picture, page.rsplit("/", 1)[-1], places.index(place) if place in places else place] += 1
    return found


def parts(files, path, heading, lines):
    text = "\n".join(lines)
    numbers = re.match(r"#+ ?(\d[\d.]*)?", heading)
    return {
        "heading": numbers.group(0) if numbers else "",
        "paragraphs, lists, tables and code": [block[:1] if block[:1] in "|- " else "" for block in blocks(lines)],
        "items": [len(re.findall(r"^ *(?:- |\d+\. )", block, re.M)) for block in blocks(lines)],
        "cells": [line.replace("\\|", "").count("|") for line in lines if line.startswith("|")],
        "lines of code": sum(block.count("\n") + 1 for block in blocks(lines) if is_code(block)),
        "links and pictures": targets(files, path, text),
        "code": Counter(CODE.findall("\n".join(block for block in blocks(lines) if not is_code(block)))),
        "figures": figures(text),
        "emphasised words": len(emphases(lines)),
    }


def difference(here, there):
    if isinstance(here, Counter):
        return f"left out {dict(there - here)}, too many {dict(here - there)}"
    return f"{there} in English, {here} here"


def broken(lines):
    """Markdown makes a space of the end of a line, which has no place in the middle of a Chinese sentence."""
    for block in blocks(lines):
        for line in block.split("\n")[1:]:
            if not is_code(block) and not re.match(r" *(?:- |\d+\. |\|)", line):
                yield line.strip()


def unlike(files, path, english):
    """What a translated page has that the English one has not, and the other way round."""
    mine, theirs = sections(files[path]), sections(files[english])
    if len(mine) != len(theirs):
        yield f"{path}: {len(theirs) - 1} headings in English, {len(mine) - 1} here"
    for (heading, lines), (known, known_lines) in zip(mine, theirs):
        for phrase in unreadable(lines):
            yield f"{path}, {heading!r}: {phrase} is not read as emphasis; put a space outside of it"
        for line in broken(lines) if path.split("/")[-2] in WITHOUT_SPACES else ():
            yield f"{path}, {heading!r}: the line {line!r} belongs to the line above"
        here, there = parts(files, path, heading, lines), parts(files, english, known, known_lines)
        for part in there:
            if here[part] != there[part]:
                yield f"{path}, {heading!r}: other {part}: {difference(here[part], there[part])}"


def plain(phrase):
    """A button's words without access key and dots."""
    return re.sub(r"\(&\w\)|&|\s*(?:…|\.\.\.)$", "", phrase).strip()


def window_words(text):
    """{English words: what the window says}"""
    words = {}
    for message in ElementTree.fromstring(text.encode()).iter("message"):
        translation = message.find("translation")
        words.setdefault(plain(message.find("source").text or ""), set()).add(plain(translation.text or ""))
    return words


def other_words(files, path, english, words):
    """What can be pressed is called as the window calls it."""
    for (heading, lines), (_, known_lines) in zip(sections(files[path]), sections(files[english])):
        said = [plain(phrase) for phrase in emphases(lines)]
        for phrase in emphases(known_lines):
            called = words.get(plain(phrase))
            if phrase[:1].isupper() and called and not any(word == name for word in said for name in called):
                yield f"{path}, {heading!r}: the window calls '{phrase}' {' or '.join(sorted(called))}"


def faults(files, phrases):
    for language in LANGUAGES:
        for page in PAGES:
            path, english = f"resources/help/{language}/{page}", f"resources/help/{page}"
            if path not in files:
                yield f"{path} is missing"
                continue
            yield from unlike(files, path, english)
            yield from other_words(files, path, english, window_words(phrases[language]))


def show_wrong_samples():
    english = "# One\n\nPress *Go*, 0.5 s, [there](b.md#two).\n\n- `x`\n\n| a | b |\n"
    german = "# Eins\n\nDrücken Sie *Los*, 0,5 s, [dort](b.md#zwei).\n\n- `x`\n\n| a | b |\n"
    other = {"resources/help/b.md": "# One\n# Two", "resources/help/de/b.md": "# Eins\n# Zwei"}
    words = {"Go": {"Los"}}

    def found(text):
        files = other | {"resources/help/a.md": english, "resources/help/de/a.md": text}
        path = ("resources/help/de/a.md", "resources/help/a.md")
        return [*unlike(files, *path), *other_words(files, *path, words)]

    assert not found(german), found(german)
    assert list(broken(["eins", "zwei"])) and not list(broken(["eins", "", "- zwei"]))
    for wrong, right in (("# Eins", "## Eins"), ("# Eins\n", "# Eins\n# Zwei\n"), ("*Los*", "*Geh*"), ("*Los*", "Los"), ("0,5", "0,6"),
                         ("#zwei", ""), ("#zwei", "#eins"), ("- `x`", "- `x`\n- y"), ("`x`", "`y`"), ("| a | b |", "| a |"),
                         ("\n\n- ", "\n\nMehr.\n\n- "), ("\n\n- ", "\n\n    0.5\n\n- "), ("*Los*, ", "*Los*, *…*dann, ")):
        assert found(german.replace(wrong, right)), right


def read(root, folder):
    for place, _, names in os.walk(os.path.join(root, folder)):
        for name in names:
            path = os.path.join(place, name)
            if name.endswith((".md", ".ts")):
                with open(path, encoding="utf-8") as file:
                    yield os.path.relpath(path, root).replace(os.sep, "/"), file.read()


def main():
    show_wrong_samples()
    if len(sys.argv) < 2:
        return 0
    root = sys.argv[1]
    texts = dict(read(root, "translations"))
    phrases = {language: texts[f"translations/halbench_{language}.ts"] for language in LANGUAGES}
    found = list(faults(dict(read(root, "resources")), phrases))
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
