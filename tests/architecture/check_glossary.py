"""The terms of the trade are said in one way in each language: translations/glossary.tsv has them in English, German and
Chinese. Wherever an English text has a term, its translation has one of the renderings and none of the refused ones. A
longer term counts before the shorter one in it ("gain margin" before "gain"); names of options, keys and signals are none.

usage: check_glossary.py ROOT   (the source tree); without it the rules are shown wrong samples
"""
import os
import re
import sys
import xml.etree.ElementTree as ElementTree

LANGUAGES = ("de", "zh_CN")
COLUMNS = 2 * len(LANGUAGES) + 1
# 'limit.current', --pre-trigger, [monitor.trigger], hold_off_s, K_f/phi, KEY=VALUE: written as they are in every language
NAME = re.compile(r"""(?<!\w)'[^']*'|"[^"]*"|`[^`]*`|\[\[?[\w.]+\]\]?|--[\w-]+|\b[\w-]+(?:[._=][\w.=-]+)+|\{[a-z]+\}""")
ENDING = r"(?:s|es|d|ed|ing)?\b"


def terms(text):
    """[(pattern, {language: (renderings, refused)}, term)], the longest term first."""
    found = []
    for line in text.splitlines():
        if not line.strip() or line.startswith("#"):
            continue
        columns = (line.split("\t") + [""] * COLUMNS)[:COLUMNS]
        choices = [[each for each in column.split("|") if each] for column in columns[1:]]
        known = dict(zip(LANGUAGES, zip(choices[:len(LANGUAGES)], choices[len(LANGUAGES):])))
        stem = columns[0].endswith("-")
        word = re.escape(columns[0].rstrip("-"))
        found.append((re.compile(rf"\b{word}" + (r"\w*" if stem else ENDING), re.I), known, columns[0]))
    return sorted(found, key=lambda each: -len(each[2]))


def faults_of_table(text):
    """Each line has a term and a rendering in every language, and no term stands twice."""
    seen = set()
    for pattern, known, term in terms(text):
        for language in LANGUAGES:
            renderings, refused = known[language]
            if not renderings or set(renderings) & set(refused):
                yield f"glossary: '{term}' has no rendering in {language}, or refuses its own"
        if term.lower() in seen:
            yield f"glossary: '{term}' stands twice"
        seen.add(term.lower())


def plain(text):
    """Without access keys, mark-up and soft hyphens."""
    return re.sub(r"</?[a-z]+>|\(&\w\)|&(?=\S)|\u00ad", "", text).casefold()


def said(message):
    """The translations of a message, plural forms too."""
    translation = message.find("translation")
    forms = [form.text or "" for form in translation.findall("numerusform")]
    return forms or [translation.text or ""]


def faults(language, glossary, text):
    for context in ElementTree.fromstring(text.encode()).findall("context"):
        for message in context.findall("message"):
            source = message.find("source").text or ""
            for translation in said(message):
                yield from differences(context.find("name").text, source, translation, language, glossary)


def differences(place, source, translation, language, glossary):
    words, there = NAME.sub(" ", source.replace("&", "")), plain(translation)
    for pattern, known, term in glossary:
        match = pattern.search(words)
        if not match:
            continue
        words = pattern.sub(" ", words)
        renderings, refused = known[language]
        is_name = re.search(rf"(?<!\w){re.escape(match.group(0))}(?!\w)", translation)  # of a method: bandwidth, hysteresis
        if not is_name and not any(each.casefold() in there for each in renderings):
            yield f"{language}: {place}: {source!r} has '{term}', {translation!r} none of {', '.join(renderings)}"
        rest = re.sub("|".join(re.escape(each.casefold()) for each in renderings), " ", there)
        for each in refused:
            if each.casefold() in rest:
                yield f"{language}: {place}: {source!r}: '{term}' is not called '{each}' ({', '.join(renderings)})"


SAMPLE = "gain margin\tAmplitudenreserve\t幅值裕度\tVerstärkungsreserve\t增益裕度\ngain\tVerstärkung|Reglerparameter\t增益\t\t\ncalibrat-\tkalibrier\t标定"


def sample(source, translation):
    return (f"<TS><context><name>C</name><message><source>{source}</source><translation>{translation}</translation>"
            f"</message></context></TS>")


def show_wrong_samples():
    glossary = terms(SAMPLE)
    assert not list(faults_of_table(SAMPLE))
    for wrong in ("gain\tVerstärkung\t", "gain\t\t增益", "gain\tA\t增益\nGain\tA\t增益", "gain\tA\t增益\tA"):
        assert list(faults_of_table(wrong)), wrong
    for source, right, wrong in (
            ("Gain margin", "Amplituden\u00adreserve", "Amplitudenrand"), ("gain margin", "Amplitudenreserve", "Amplitudenreserve (Verstärkungsreserve)"),
            ("the gains", "die Reglerparameter", "die Faktoren"), ("Ga&amp;in", "Ver&amp;stärkung", "Faktor"),
            ("calibrates the gain", "kalibriert die Verstärkung", "misst die Verstärkung")):
        assert not list(faults("de", glossary, sample(source, right))), right
        assert list(faults("de", glossary, sample(source, wrong))), wrong
    for source, right, wrong in (("gain", "增益", "放大"), ("gain margin", "幅值裕度", "增益裕度")):
        assert not list(faults("zh_CN", glossary, sample(source, right))), right
        assert list(faults("zh_CN", glossary, sample(source, wrong))), wrong
    assert not list(faults("de", glossary, sample("use gain", "gain verwenden")))
    for name in ("--gain", "'gain.kp'", "[monitor.gain]", "gain_A_per_rad"):
        assert not list(faults("de", glossary, sample(name, "x"))), name


def main():
    show_wrong_samples()
    if len(sys.argv) < 2:
        return 0
    folder = os.path.join(sys.argv[1], "translations")
    with open(os.path.join(folder, "glossary.tsv"), encoding="utf-8") as file:
        table = file.read()
    found, glossary = list(faults_of_table(table)), terms(table)
    for language in LANGUAGES:
        with open(os.path.join(folder, f"halbench_{language}.ts"), encoding="utf-8") as file:
            found += faults(language, glossary, file.read())
    print("\n".join(dict.fromkeys(found)))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
