"""Samples of use: those in comments of public headers, and the C++ of the documentation that is no whole program.

A sample is a piece of a program. What it names without declaring it (`node`, `hardware`, `show`) is a parameter of any type, so that
all else is checked: types, names and members of the library, and arguments where their types are known.
"""

import dataclasses
import pathlib
import re

# What stands in a comment and is indented by four blanks, as in Markdown.
COMMENTED = re.compile(r"\s*///? {5}(.*)$")
BLANK_COMMENT = re.compile(r"\s*///?\s*$")
OPEN, CLOSE = "([{", ")]}"
# What a sample may call its own objects although functions have these names, in a namespace of the library or in C.
READERS = ["battery", "charger", "close", "degrees", "device", "door", "fail", "index", "input", "load", "log", "open", "panel", "profile", "read",
           "send", "store", "time"]  # fmt: skip


@dataclasses.dataclass(frozen=True)
class Sample:
    """A piece of code, where it stands, and the namespace that it is written for."""

    path: str
    line: int  # of its first line, from 1
    text: str
    namespace: str

    @property
    def place(self):
        return f"{self.path}:{self.line}"


def samples_of_header(path, text):
    """What is indented in the comments of a header."""
    found, block, start = [], [], 0
    namespace = re.search(r"(?m)^namespace (canvoy[\w:]*) \{", text)
    lines = text.splitlines()
    for number, line in enumerate([*lines, ""], start=1):
        code = COMMENTED.match(line)
        if code and not BLANK_COMMENT.match(line):
            start = start if block else number
            block.append(code[1])
        elif block and BLANK_COMMENT.match(line) and number < len(lines) and COMMENTED.match(lines[number]):
            block.append("")
        elif block:
            found.append(Sample(path, start, "\n".join(block), namespace[1] if namespace else "canvoy"))
            block = []
    return found


def samples_of_page(path, text):
    """The blocks of C++ of a page that are not whole programs: those are compiled by tests/cli/docs_test.py."""
    found = []
    for block in re.finditer(r"(?ms)^```cpp\n(.*?)^```", text):
        if '#include "canvoy' not in block[1]:
            found.append(Sample(path, text.count("\n", 0, block.start()) + 2, block[1].rstrip("\n"), "canvoy"))
    return found


def without_comment(line):
    return re.sub(r'("(?:[^"\\]|\\.)*")|//.*', lambda match: match[1] or "", line).rstrip()


def with_ellipses_filled(text):
    """`...` stands for what the reader has: a value, or a body."""
    text = re.sub(r"\)\s*\.\.\.\s*$", ") {}", text, flags=re.M)
    text = re.sub(r"(?m)^\s*\.\.\.\s*;?\s*$", "", text)
    text = re.sub(r"\{\s*\.\.\.\s*\}", "{}", text)
    text = re.sub(r"(\.\w+ = [^{}]*),\s*\.\.\.(?=\s*\})", r"\1", text)
    text = re.sub(r"(?<=[;}])\s*\.\.\.(?=\s*\})", "", text)
    return re.sub(r"(?<=[=,({])\s*\.\.\.(?=\s*[,)};])", " any_value", text)


def with_semicolons(lines):
    """Each line that ends a statement ends with a semicolon; what is in brackets goes on."""
    depth, result = 0, []
    for line in lines:
        depth += sum(line.count(each) for each in OPEN) - sum(line.count(each) for each in CLOSE)
        ended = line.rstrip()
        result.append(f"{ended};" if depth == 0 and ended and ended[-1] not in ";{}(,=&|+<" else line)
    return result


def is_balanced(text):
    """Whether its brackets are closed: else it would take what follows it along."""
    bare = re.sub(r'"(?:[^"\\]|\\.)*"|\'(?:[^\'\\]|\\.)\'', "", text)
    stack = []
    for each in bare:
        if each in OPEN:
            stack.append(each)
        elif each in CLOSE:
            if not stack or OPEN.index(stack.pop()) != CLOSE.index(each):
                return False
    return not stack


def code_of(sample):
    """Its lines without comments and ellipses."""
    return with_ellipses_filled("\n".join(without_comment(line) for line in sample.text.splitlines())).split("\n")


def readers_objects(text):
    """The objects of the reader that have the name of a function in the library or in C."""
    return [name for name in READERS if re.search(rf"(?<![\w.:>&]){name}(?![\w(<:{{=]| =|::| \w)", text)
            and not re.search(rf"(?<![\w.:>&]){name}[<(]", text)]  # fmt: skip


def at_class_scope(text):
    """What stands outside of functions, as members of a class: constants are static there."""
    return re.sub(r"(?m)^(?:inline )?(?:constinit |(?=constexpr))", "inline static ", text)


def variants_of(sample, number, parameters):
    """The ways in which a sample can be read, by name: as statements, with semicolons, as declarations, as members of a class,
    as those and statements after an empty line, as a value."""
    lines = code_of(sample)
    text = "\n".join(lines)
    if not is_balanced(text) or text.count('"') % 2:
        return {}
    scope = re.sub(r"^canvoy", "", sample.namespace).strip(":")
    opening = f"namespace canvoy {{ {f'namespace {scope} {{' if scope else ''}"
    closing = "}}" if scope else "}"

    def read_as(name, body, members="", skipped=0):
        # What has members named by `::`, or a capital, is a class of the reader; all else an object, which a lambda need not capture.
        unknown = [*parameters.get((number, name), []), *readers_objects(text)]
        classes = [each for each in unknown if each[0].isupper() or re.search(rf"(?<![\w.:]){each}::", text)]
        names = [*dict.fromkeys(each for each in unknown if each not in classes), "any_value"]
        types = ", ".join(f"class {each}" for each in [*classes, *(f"T{index}" for index in range(len(names))), "Returned"])
        objects = " ".join(f"static T{index} {each};" for index, each in enumerate(names))
        place = f'#line {sample.line} "{number}/{name}"\n'
        # A member function: `*this` is the object of the reader.
        read = f'Returned read_sample() {{\n#line {sample.line + skipped} "{number}/{name}"\n{body}\n}}'
        return f"{opening} template <{types}> struct Sample_{number}_{name} {{ {objects}\n{place}{members}\n{read} }};{closing}\n"

    declarations = f'{opening} namespace sample_{number} {{\n#line {sample.line} "{number}/declared"\n{text}\n}}{closing}\n'
    ended = with_semicolons(lines)
    variants = {
        "stated": read_as("stated", text),
        "ended": read_as("ended", "\n".join(ended)),
        "declared": declarations,
        "members": read_as("members", "", at_class_scope(text)),
        "given": read_as("given", "any_value({" + "\n".join(lines).rstrip(" ;,") + "});"),
    }
    if "" in lines:
        gap = lines.index("")
        variants["parted"] = read_as("parted", "\n".join(ended[gap:]), at_class_scope("\n".join(lines[:gap])), gap)
    return variants
