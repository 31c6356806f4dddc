"""All mutations of a source in one text: each becomes `canvoy_mutant(n) ? mutated : original`, chosen when the program runs.

The environment's CANVOY_MUTANT is the number of the mutation that is on; without it, none is. Where the environment has
CANVOY_REACHED, the numbers of those whose places were reached are added to that file when the program ends.
"""

import dataclasses
import re

from mutation.places import NOTHING, without_comments

HEADER = "canvoy/mutation.hpp"
HEADER_TEXT = """#pragma once

#include <cstdio>
#include <cstdlib>

namespace canvoy_mutation {

// Before all that is initialised when a program starts.
inline constinit int chosen = -1;
inline constinit bool reached[COUNT] = {};

inline void tell() {
  std::FILE* const file = std::fopen(std::getenv("CANVOY_REACHED"), "a");
  if (file == nullptr) return;
  for (int number = 0; number < COUNT; ++number) {
    if (reached[number]) std::fprintf(file, "%d\\n", number);
  }
  std::fclose(file);
}

inline void begin() {
  const char* const wanted = std::getenv("CANVOY_MUTANT");
  chosen = wanted == nullptr ? 0 : std::atoi(wanted);
  if (std::getenv("CANVOY_REACHED") != nullptr) std::atexit(&tell);
}

}  // namespace canvoy_mutation

inline bool canvoy_mutant(int number) {
  if (canvoy_mutation::chosen < 0) canvoy_mutation::begin();
  canvoy_mutation::reached[number] = true;
  return number == canvoy_mutation::chosen;
}
"""

LOOSEST, TERNARY, ASSIGNING = -2, -1, 0
LEVELS = ("||", "&&", "|", "^", "&", "== !=", "< > <= >=", "<=>", "<< >>", "+ -", "* / %")
PRECEDENCE = {operator: level for level, row in enumerate(LEVELS, 1) for operator in row.split()}
PRECEDENCE |= {"?": TERNARY, ":": TERNARY}
PRECEDENCE |= {operator: ASSIGNING for operator in "= += -= *= /= %= &= |= ^= <<= >>=".split()}
# A branch that `if constexpr` takes is not constant itself.
CONSTANT = re.compile(r"(?<!if )\bconstexpr\b|\bif constexpr $|\b(consteval|constinit|static_assert|enum)\b")
OPEN, CLOSED = "([{", ")]}"


@dataclasses.dataclass(frozen=True)
class Edit:
    """What stands from `start` to `end` of a text becomes `text`; lines count from 0."""

    start: int
    end: int
    text: str
    first_line: int
    last_line: int


def words_right(code, at):
    """(start, end) of what spaces separate after `at`, brackets with all that is in them being part of a word, up to a
    comma, a semicolon or the end of the brackets around."""
    start = None
    depth = 0
    for position in range(at, len(code)):
        char = code[position]
        ends = depth == 0 and (char in ",;" or char in CLOSED)
        if start is not None and depth == 0 and (char.isspace() or ends):
            yield start, position
            start = None
        if ends:
            return
        if start is None and not char.isspace():
            start = position
        depth += (char in OPEN) - (char in CLOSED)


def words_left(code, at):
    """The same before `at`, the nearest first."""
    end = None
    depth = 0
    for position in range(at - 1, -1, -1):
        char = code[position]
        ends = depth == 0 and (char in ",;" or char in OPEN)
        if end is not None and depth == 0 and (char.isspace() or ends):
            yield position + 1, end
            end = None
        if ends:
            return
        if end is None and not char.isspace():
            end = position + 1
        depth += (char in CLOSED) - (char in OPEN)


def operand(code, words, binds, edge):
    """The edge (0: start, 1: end) of an operand: words, with operators between them that bind closer."""
    found = None
    wants_operator = False
    for word in words:
        text = code[word[0] : word[1]]
        level = PRECEDENCE.get(text)
        if (level is not None) != wants_operator or (level is not None and not binds(level)):
            break
        if not wants_operator:
            found = word[edge]
        wants_operator = not wants_operator
    return found


def span_of_operator(code, start, end, operator):
    """From the start of an operator's left operand to the end of its right one."""
    own = PRECEDENCE[operator]
    if own == ASSIGNING:
        left = operand(code, words_left(code, start), lambda level: False, 0)
        right = operand(code, words_right(code, end), lambda level: True, 1)
    else:
        left = operand(code, words_left(code, start), lambda level: level >= own, 0)
        right = operand(code, words_right(code, end), lambda level: level > own, 1)
    return (left, right) if left is not None and right is not None else None


def end_of_word(code, start):
    """Where an operand without operators ends, its calls and indices included."""
    return next((end for _, end in words_right(code, start)), start)


def span_of(mutation, code, start):
    """What is written twice; None where that cannot be told."""
    end = start + len(mutation.old)
    if mutation.new == NOTHING:
        return start, end
    if mutation.old in PRECEDENCE:
        return span_of_operator(code, start, end, mutation.old)
    if mutation.old == "!" or mutation.old.startswith("std::"):
        return start, end_of_word(code, start)
    # A number with its suffix, or with its fraction.
    return start, start + len(re.match(r"[\w.']+", code[start:]).group())


def is_constant(code, at):
    """True in what must be known to the compiler: the statements around `at`, up to the file's own, tell."""
    while at > 0:
        depth = 0
        start = at
        while start > 0 and not (depth == 0 and code[start - 1] in "([{;}"):
            start -= 1
            depth += (code[start] in ")]") - (code[start] in "([")
        if CONSTANT.search(code[start:at]):
            return True
        depth = 0
        while start > 0 and not (depth == 0 and code[start - 1] in OPEN):
            start -= 1
            depth += (code[start] in CLOSED) - (code[start] in OPEN)
        at = start - 1
    return False


def edit_of(mutation, number, text):
    """How a mutation becomes a choice in its source, or None. The lines of the original stay where they are."""
    code = without_comments(text)
    shape = without_comments(text, literal="_")
    begin = sum(len(line) + 1 for line in text.split("\n")[: mutation.line]) + mutation.column
    span = span_of(mutation, shape, begin)
    if span is None or is_constant(shape, begin):
        return None
    start, end = span
    lines = text.count("\n", 0, start), text.count("\n", 0, end)
    original = text[start:end]
    if mutation.new == NOTHING:
        return Edit(start, end, f"if (!canvoy_mutant({number})) {{ {original.strip()} }}", *lines)
    changed = code[start:begin] + mutation.new + code[begin + len(mutation.old) : end]
    changed = re.sub(r"\s*\n\s*", " ", changed)
    return Edit(start, end, f"(canvoy_mutant({number}) ? ({changed}) : ({original}))", *lines)


def with_choices(text, edits):
    """The text with all edits, none of which overlaps another, under the header that they need."""
    for edit in sorted(edits, key=lambda each: each.start, reverse=True):
        text = text[: edit.start] + edit.text + text[edit.end :]
    return f'#include "{HEADER}"\n#line 1\n{text}'


def overlaps(edit, others):
    return any(edit.start < other.end and other.start < edit.end for other in others)
