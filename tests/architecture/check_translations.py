"""Every word of the window is translated: a copy of each translations/halbench_*.ts is brought up to date by lupdate,
then nothing may be missing, left over, or differ in placeholders, mark-up and access keys.

usage: check_translations.py LUPDATE ROOT   (ROOT is the source tree); without ROOT the rules are shown wrong samples
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

FOLDERS = ("widgets", "app")
PLACEHOLDER = re.compile(r"%(?:L?\d+|n)")
MARK_UP = re.compile(r"</?[a-z]+>")
FILLED_IN = re.compile(r"\{(\d*)\}")  # of a phrase of the layers below (phrases.py); {1} where the order changes
ACCESS_KEY = re.compile(r"&(?=[^&\s])")


def updated(lupdate, root, path, folder):
    copy = os.path.join(folder, os.path.basename(path))
    shutil.copy(path, copy)
    options = ["-pluralonly"] if path.endswith("_en.ts") else []
    done = subprocess.run([lupdate, "-silent", "-I", ".", "-locations", "none", *options, *FOLDERS, "-ts", copy],
                          cwd=root, capture_output=True, text=True, check=True)
    return open(copy, encoding="utf-8").read(), done.stderr.strip()


def phrases(message):
    translation = message.find("translation")
    forms = translation.findall("numerusform")
    return [form.text or "" for form in forms] if message.get("numerus") else [translation.text or ""]


def faults(text):
    """What is wrong with the messages of one updated file."""
    for context in ElementTree.fromstring(text.encode()).findall("context"):
        for message in context.findall("message"):
            source = message.find("source").text or ""
            place = f"{context.find('name').text}: {source!r}"
            state = message.find("translation").get("type")
            if state in ("vanished", "obsolete"):
                yield f"{place} is no longer in the sources: take it out"
            elif state or not all(phrases(message)):
                yield f"{place} is not translated"
            else:
                yield from differences(place, source, phrases(message))


def differences(place, source, translations):
    for phrase in translations:
        if set(PLACEHOLDER.findall(phrase)) != set(PLACEHOLDER.findall(source)):
            yield f"{place}: other placeholders in {phrase!r}"
        holes, known = FILLED_IN.findall(phrase), source.count("{}")
        if len(holes) != known if not any(holes) else not all(hole and int(hole) < known for hole in holes):
            yield f"{place}: other {{}} in {phrase!r}"
        if sorted(MARK_UP.findall(phrase)) != sorted(MARK_UP.findall(source)):
            yield f"{place}: other mark-up in {phrase!r}"
        if len(ACCESS_KEY.findall(phrase)) != len(ACCESS_KEY.findall(source)):
            yield f"{place}: other number of access keys in {phrase!r}"


def sample(translation, source="&amp;Save %1", state=""):
    return (f"<TS><context><name>C</name><message><source>{source}</source>"
            f"<translation{state}>{translation}</translation></message></context></TS>")


def show_wrong_samples():
    assert not list(faults(sample("&amp;Sichern %1")))
    for wrong in (sample(""), sample("&amp;Sichern %1", state=' type="unfinished"'),
                  sample("&amp;Sichern %1", state=' type="vanished"'), sample("&amp;Sichern"), sample("Sichern %1"),
                  sample("&amp;Sichern %1 %2"), sample("A", source="A {}"), sample("{2}", source="{} {}"), sample("K", source="K&lt;sub&gt;P&lt;/sub&gt;")):
        assert list(faults(wrong)), wrong


def main():
    show_wrong_samples()
    if len(sys.argv) < 3:
        return 0
    lupdate, root = sys.argv[1:3]
    folder = os.path.join(root, "translations")
    found = []
    with tempfile.TemporaryDirectory() as scratch:
        for name in sorted(name for name in os.listdir(folder) if name.endswith(".ts")):
            text, remark = updated(lupdate, root, os.path.join(folder, name), scratch)
            found += [f"{name}: {fault}" for fault in faults(text)]
            found += [f"lupdate: {line}" for line in remark.splitlines()]
    print("\n".join(dict.fromkeys(found)))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
