"""Where sources can be broken in a small way, and how places are drawn."""

import dataclasses
import difflib
import random
import re

SWAPS = {
    "comparison": {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "=="},
    "logic": {"&&": "||", "||": "&&"},
    "flag": {"|=": "&=", "&=": "|=", "|": "&", "&": "|"},
    "sum": {"+": "-", "-": "+", "+=": "-=", "-=": "+="},
    "toggle": {"true": "false", "false": "true"},
    "bound": {"std::min": "std::max", "std::max": "std::min"},
}
# clang-format sets spaces around binary operators, and none around those of templates, references and signs.
OPERATOR = re.compile(r"(?<=\s)(<=|>=|==|!=|&&|\|\||\|=|&=|\+=|-=|<|>|\||&|\+|-)(?=\s)")
WORD = re.compile(r"\b(true|false|std::min|std::max)\b")
NEGATION = re.compile(r"(?<=[\s(])!(?=[A-Za-z_(])")
NUMBER = re.compile(r"(?<![\w.'])(0x[0-9A-Fa-f']+|0|[1-9][\d']*)(?=([uU]?)\b|(us|ms|s|min|h)\b)")
DURATION = re.compile(r"(?<![\w.'])(\d[\d']*)(us|ms|s|min|h)\b")
TIMER = re.compile(r"^\s*[\w.()\->]*\b(dis)?arm\(.*\);$")
ASSIGNMENT = re.compile(r"^\s*[\w.\->\[\]]+_ = (?!\[).*;$")
EARLY_RETURN = re.compile(r"^\s*if \(.*\) return\b.*;$")
NO_CODE = re.compile(r"^\s*(#|//|static_assert|template|namespace|using|case\b.*:$|enum|struct|class)")
NOTHING = ";"  # what a whole statement becomes

LITERAL = r'"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\''
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/|(" + LITERAL + ")", re.DOTALL)


@dataclasses.dataclass(frozen=True)
class Mutation:
    """One place in one line: `old`, at `column`, becomes `new`."""

    path: str
    line: int  # from 0
    column: int
    kind: str
    old: str
    new: str

    def apply(self, text):
        lines = text.split("\n")
        line = lines[self.line]
        assert line[self.column : self.column + len(self.old)] == self.old
        lines[self.line] = line[: self.column] + self.new + line[self.column + len(self.old) :]
        return "\n".join(lines)

    def diff(self, text):
        lines = difflib.unified_diff(
            text.split("\n"), self.apply(text).split("\n"), f"a/{self.path}", f"b/{self.path}", n=2, lineterm=""
        )
        return "\n".join("    " + line for line in lines)

    def __str__(self):
        return f"{self.path}:{self.line + 1}: {self.kind}: {self.old.strip()} -> {self.new.strip() or 'nothing'}"


def blank(text):
    return re.sub(r"[^\n]", " ", text)


def without_comments(text, literal=None):
    """The text in which these are blank, so that lines and columns stay; and its literals are so many of a letter."""

    def instead(found):
        if found.group(1) is None:
            return blank(found.group())
        return literal * len(found.group()) if literal else found.group()

    return COMMENT.sub(instead, text)


def number_after(text):
    value = int(text.replace("'", ""), 0) + 1
    return hex(value) if text.startswith("0x") else str(value)


def mutations_of_line(line):
    """(kind, column, old, new) of all that can be broken in a line of code."""
    if NO_CODE.match(line):
        return
    for found in [*OPERATOR.finditer(line), *WORD.finditer(line)]:
        for kind, swaps in SWAPS.items():
            if found.group(1) in swaps:
                yield kind, found.start(1), found.group(1), swaps[found.group(1)]
    for found in NEGATION.finditer(line):
        yield "toggle", found.start(), "!", ""
    for found in DURATION.finditer(line):
        yield "timer", found.start(), found.group(), str(2 * int(found.group(1).replace("'", "")) + 1) + found.group(2)
    for found in NUMBER.finditer(line):
        if not found.group(3):
            yield "bound", found.start(), found.group(1), number_after(found.group(1))
    for kind, whole in (("timer", TIMER), ("flag", ASSIGNMENT), ("bound", EARLY_RETURN)):
        if whole.match(line):
            yield kind, 0, line, NOTHING


def mutations_of(path, text):
    for number, line in enumerate(without_comments(text, literal=" ").split("\n")):
        original = text.split("\n")[number]
        for kind, column, old, new in mutations_of_line(line):
            if original[column : column + len(old)] == old:
                yield Mutation(path, number, column, kind, old, new)


def sources_of(folder):
    return sorted(path for path in folder.rglob("*.cpp") if not path.name.endswith("_test.cpp"))


def drawn(tree, folders, seed):
    """All mutations, in an order that the seed gives: one of each line before another of any."""
    places = []
    for folder in folders:
        for path in sources_of(tree / folder):
            places += mutations_of(str(path.relative_to(tree)), path.read_text())
    random.Random(seed).shuffle(places)
    seen = {}
    turns = []
    for place in places:
        seen[place.path, place.line] = seen.get((place.path, place.line), -1) + 1
        turns.append(seen[place.path, place.line])
    return [place for _, place in sorted(zip(turns, places), key=lambda pair: pair[0])]


def moved(mutation, line_text, text):
    """The same mutation where its line stands in another version of the source; None where it does not."""
    lines = text.split("\n")
    found = [number for number, line in enumerate(lines) if line == line_text]
    if not found:
        return None
    return dataclasses.replace(mutation, line=min(found, key=lambda number: abs(number - mutation.line)))
