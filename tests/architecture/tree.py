"""The tree as data: {path: text} of what we wrote, and what rules need to know about C and C++ text."""
import os
import re

FOLDERS = ("app", "cmake", "control", "devices", "models", "resources", "tests", "widgets")
ROOT_FILES = ("CMakeLists.txt", "CMakePresets.json", "LICENSE", "README.md", "dev")
SKIPPED = {"__pycache__", "corpus"}
SOURCE = (".h", ".cpp", ".c")


def read_tree(root):
    files = {}
    for name in ROOT_FILES:
        read_one(root, name, files)
    for folder in FOLDERS:
        for place, folders, names in os.walk(os.path.join(root, folder)):
            folders[:] = [f for f in folders if f not in SKIPPED]
            for name in names:
                read_one(root, os.path.relpath(os.path.join(place, name), root), files)
    return files


def read_one(root, path, files):
    full = os.path.join(root, path)
    if os.path.isfile(full):
        with open(full, encoding="utf-8", errors="replace") as file:
            files[path.replace(os.sep, "/")] = file.read()


def is_source(path):
    return path.endswith(SOURCE)


def is_product(path):
    return is_source(path) and not path.startswith("tests/")


def blank(match):
    return re.sub(r"[^\n]", " ", match.group(0))


RAW_STRING = re.compile(r'R"([^(\s]*)\(.*?\)\1"', re.S)
COMMENT_OR_STRING = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.){1,4}\'', re.S)


def code_only(text):
    """Comments and literals blanked; lines and columns stay."""
    text = RAW_STRING.sub(blank, text)
    text = re.sub(r"(?<=\d)'(?=\d)", " ", text)
    return COMMENT_OR_STRING.sub(blank, text)


def comments(text):
    """(line, text) of every comment."""
    for match in COMMENT_OR_STRING.finditer(RAW_STRING.sub(blank, text)):
        if match.group(0).startswith(("//", "/*")):
            yield line_of(text, match.start()), match.group(0)


def line_of(text, position):
    return text.count("\n", 0, position) + 1


def includes(text):
    """(line, "path" or <path>) of every include."""
    for match in re.finditer(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', text, re.M):
        yield line_of(text, match.start()), match.group(1), match.group(2)


SCOPE = re.compile(r"\b(namespace|class|struct|union|enum|extern)\b[^()=]*$")


def function_lengths(text):
    """(line, lines) of every function body: outermost braces that are neither a scope nor a table."""
    code = re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", blank, code_only(text), flags=re.M)
    stack, head_start = [], 0
    for match in re.finditer(r"[{};]", code):
        position, mark = match.start(), match.group(0)
        if mark == "{":
            head = code[head_start:position]
            inside_function = any(kind == "function" for kind, _ in stack)
            kind = "inner" if inside_function else kind_of(head)
            stack.append((kind, position))
        elif mark == "}" and stack:
            kind, start = stack.pop()
            if kind == "function":
                yield line_of(code, start), line_of(code, position) - line_of(code, start) + 1
        head_start = position + 1


TYPE_OR_BRACE = re.compile(
    r"\bnamespace\s*([\w:]*)\s*\{"
    r"|\b(?:struct|class|union|enum(?:\s+(?:class|struct))?)\s+(?:\[\[\w+\]\]\s*)?(\w+)(?:\s+final)?\s*(?::(?!:)[^;{}()]*)?\{"
    r"|([{}])")


def type_names(text):
    """(line, qualified name) of every type defined outside of functions and unnamed namespaces."""
    code, scopes = code_only(text), []
    for match in TYPE_OR_BRACE.finditer(code):
        space, name, brace = match.groups()
        if brace == "}":
            scopes = scopes[:-1]
        elif brace == "{":
            scopes.append(None)
        elif name:
            if None not in scopes:
                yield line_of(code, match.start()), "::".join([*scopes, name])
            scopes.append(None if None in scopes else name)
        else:
            scopes.append(space or None)


def kind_of(head):
    if not head.strip():
        return "function"                        # the body after a constructor's `: a{1}`
    if SCOPE.search(head):
        return "scope"
    without_arguments = re.sub(r"\([^()]*\)", "", re.sub(r"\([^()]*\)", "", head))
    if "=" in without_arguments and "operator" not in head:
        return "table"
    return "function" if "(" in head else "table"
