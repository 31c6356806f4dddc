"""A page for each object of the profiles, as Markdown: made of `canvoy profile N --json`, `canvoy eds export DEVICE` and the tables of
docs/ that say what a device of ours does with an object.

    pages = object_pages.make("build/canvoy")    # {"objects/419/6000.md": "# 6000h ...", "objects/419/index.md": ...}
"""

import collections
import concurrent.futures
import dataclasses
import json
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROFILES = ("301", "401", "402", "406", "407", "417-4", "418", "419", "447-3", "852")
# Pages whose tables have a row for each object: what is done with it, the reading taken, and the test at the wire.
TOLD_IN = {"401": "cia401.md", "407": "cia407-objects.md", "417-4": "cia417.md", "418": "cia418.md", "419": "cia419.md", "447-3": "cia447.md", "852": "cia852.md"}
PLAIN = ("", "here", "what it does, or our reading")  # headings that a line does without
# Where the rest is.
ABOUT = {"301": "decisions/canopen.md", "401": "cia401.md", "402": "profiles.md", "406": "profiles.md", "407": "cia407.md", "417-4": "cia417.md", "418": "cia418.md", "419": "cia419.md",
         "447-3": "cia447.md", "852": "cia852.md"}  # fmt: skip
VALUES_MOST = 64  # of a field, in its table
NAMES_MOST = 12  # of devices; of more, only their number is told


@dataclasses.dataclass
class Object:
    """What is known of an object, or of several that follow each other: rows of the JSON, by kind."""

    first: int
    last: int
    rows: dict = dataclasses.field(default_factory=lambda: collections.defaultdict(list))

    @property
    def title(self):
        entry = self.rows["entry"][0]
        return f"{place_text(self.first, self.last)} {entry['object']}"


def place_text(first, last):
    return f"{first:04X}h" if first == last else f"{first:04X}h to {last:04X}h"


def run(command, *arguments):
    return subprocess.run([command, *arguments], capture_output=True, text=True, check=True).stdout


def place_of(row):
    return int(row["index"], 16), int(row.get("index_last", row["index"]), 16)


def objects_of(rows):
    """The objects of a profile: entries whose indices overlap are of one page, and what is said of them as well."""
    found = []
    for first, last in sorted({place_of(row) for row in rows if row["kind"] == "entry"}):
        if found and first <= found[-1].last:
            found[-1].last = max(last, found[-1].last)
        else:
            found.append(Object(first, last))
    for row in rows:
        if "index" not in row or row["kind"] == "index_range":
            continue
        first, last = place_of(row)
        for each in found:
            if first <= each.last and each.first <= last:
                each.rows[row["kind"]].append(row)
    for row in (row for row in rows if row["kind"] == "pdo"):
        mapped = {int(each[:4], 16) for each in row.get("mapping", [])}
        for each in found:
            if any(each.first <= index <= each.last for index in mapped):
                each.rows["pdo"].append(row)
    return found


def devices_of_ours(command):
    """By profile and index: the devices of the catalogue that have the object, each with the PDOs that carry it by default."""
    listed = re.findall(r"(?m)^(\S+) +CiA (\S+)", run(command, "device", "--list"))
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        sheets = dict(zip(listed, pool.map(lambda each: run(command, "eds", "export", each[0]), listed)))
    found = collections.defaultdict(list)
    for (name, profile), sheet in sheets.items():
        indices = {int(each, 16) for each in re.findall(r"(?m)^\[([0-9A-Fa-f]{4})\]", sheet)}
        carried = pdos_of_sheet(sheet)
        for index in indices:
            of = profile if index >= 0x2000 else "301"
            found[of, index].append((name, sorted(carried.get(index, ()))))
    return found


def pdos_of_sheet(sheet):
    """By index: the PDOs that carry the object by default."""
    found = collections.defaultdict(set)
    for record, text in re.findall(r"(?ms)^\[(1[6-7A-B][0-9A-Fa-f]{2})sub[1-9A-F][0-9A-F]?\]\n(.*?)(?=^\[|\Z)", sheet):
        mapped = re.search(r"(?m)^DefaultValue=0x([0-9A-Fa-f]{8})$", text)
        if mapped and int(mapped[1], 16) >> 16 >= 0x2000:
            index, number = int(record, 16), 0
            kind, number = ("RPDO", index - 0x1600 + 1) if index < 0x1A00 else ("TPDO", index - 0x1A00 + 1)
            found[int(mapped[1], 16) >> 16].add(f"{kind} {number}")
    return found


def rows_told(page):
    """By index: the rows of a page's tables that are about it, as their headings and cells."""
    found = collections.defaultdict(list)
    headings = []
    for line in (ROOT / "docs" / page).read_text().splitlines():
        if not line.startswith("|"):
            headings = []
            continue
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if not headings:
            headings = cells
        elif not set(line) <= set("|-: "):
            for first, last in re.findall(r"\b([0-9A-F]{4})h(?: to ([0-9A-F]{4})h)?", cells[0]):
                for index in range(int(first, 16), int(last or first, 16) + 1):
                    found[index].append(list(zip(headings[1:], cells[1:])))
    return found


def table(headings, rows):
    rows = [[str(cell).replace("|", "\\|").replace("\n", " ") or " " for cell in row] for row in rows]
    lines = [" | ".join(headings), " | ".join("---" for _ in headings), *(" | ".join(row) for row in rows)]
    return "\n".join(f"| {line} |" for line in lines)


def sub_text(row):
    first, last = row.get("sub", "00"), row.get("sub_last", row.get("sub", "00"))
    return f"{first}h" if first == last else f"{first}h to {last}h"


def place_cell(row, each):
    first, last = place_of(row)
    return sub_text(row) if (first, last) == (each.first, each.last) else f"{place_text(first, last)} {sub_text(row)}"


def shown(value):
    if value is None:
        return "-"
    return " to ".join(map(str, value)) if isinstance(value, list) else str(value)


def descriptions_of(each):
    return list(dict.fromkeys(row["description"] for row in each.rows["entry"] if "description" in row))


def entries_section(each):
    def cells(row):
        access = row["access"] + (f", consumer {row['consumer_access']}" if "consumer_access" in row else "")
        category = row["entry_category"] + (f": {row['entry_condition']}" if "entry_condition" in row else "")
        return [place_cell(row, each), row["entry"], row["type"], access, row["pdo"], shown(row["default"]), shown(row["range"]), category]

    headings = ["sub-index", "name", "type", "access", "PDO mapping", "default", "range (raw)", "category"]
    if len(descriptions_of(each)) < 2:
        return table(headings, map(cells, each.rows["entry"]))
    return table([*headings, ""], ([*cells(row), row.get("description", "")] for row in each.rows["entry"]))


def values_text(values):
    listed = list(values.items())
    text = ", ".join(f"`{raw}` {meaning}" for raw, meaning in listed[:VALUES_MOST])
    return text + (f", and {len(listed) - VALUES_MOST} more" if len(listed) > VALUES_MOST else "")


def fields_section(each):
    def cells(row):
        bits = f"{row['lsb']}" if row["width"] == 1 else f"{row['lsb']} to {row['lsb'] + row['width'] - 1}"
        name = row["field"] + (f" (where {row['when']})" if "when" in row else "")
        return [place_cell(row, each), bits, name, values_text(row.get("values", {}))]

    return table(["sub-index", "bits", "field", "values (hexadecimal)"], map(cells, each.rows["field"]))


def quantities_section(each):
    def cells(row):
        offset = f" {'+' if row['offset'] > 0 else '-'} {abs(row['offset']):g}" if row["offset"] else ""
        name = " ".join(filter(None, (row["field"], row.get("piece", ""))))
        by = f", scaled by {row['step']}" if "step" in row else ""
        return [place_cell(row, each), name, f"raw x {row['factor']:g}{offset} {row['unit']}{by}", f"{row['min_raw']} to {row['max_raw']}", values_text(row.get("sentinels", {}))]

    return table(["sub-index", "field", "value", "raw numbers", "special values"], map(cells, each.rows["quantity"]))


def devices_section(each):
    def cells(row):
        name = f"{row['device']} ({row['code']}h)" + (f", class {row['class']}" if row.get("class") else "") + (f", subclass {row['subclass']}" if row.get("subclass") else "")
        category = row["category"] + (f": {row['condition']}" if "condition" in row else "")
        return [name, "consumes" if row.get("consumed") else "provides", row.get("access", "-"), category, row["clause"]]

    return table(["virtual device", "", "access", "category", "clause"], map(cells, each.rows["device"]))


def pdos_section(each):
    def cells(row):
        number = row["number"] if row["number"] == row.get("number_last", row["number"]) else f"{row['number']} to {row['number_last']}"
        return [f"{row['direction'].upper()} {number}", row["cob_id"], " ".join(row["mapping"]), row["transmission_type"], row.get("clause", "-")]

    return table(["PDO", "COB-ID", "mapping", "transmission type", "clause"], map(cells, each.rows["pdo"]))


def ours_section(profile, each, ours, told):
    """What the devices of the catalogue do with it."""
    parts, seen = [], []
    for index in range(each.first, each.last + 1):
        for name, pdos in ours.get((profile, index), ()):
            text = f"`{name}`" + (f" ({', '.join(pdos)})" if pdos else "")
            if text not in seen:
                seen.append(text)
    if len(seen) > NAMES_MOST:
        parts.append(f"{len(seen)} devices of `canvoy device` have it.")
    else:
        parts.append(f"Devices of `canvoy device` that have it: {', '.join(seen)}." if seen else "No device of `canvoy device` has it at this index.")
    lines = []
    for index in range(each.first, each.last + 1):
        for row in told.get(index, ()):
            text = "; ".join(cell if heading in PLAIN else f"{heading}: {cell}" for heading, cell in row if cell)
            text = re.sub(r"\]\((?!https?:|#)([^)]*)\)", r"](../../\1)", re.sub(r"\]\(#", f"](../../{TOLD_IN[profile]}#", text))
            if text and f"- {text}" not in lines:
                lines.append(f"- {text}")
    parts += ["\n".join(lines)] if lines else []
    parts.append(f"[More about CiA {profile}](../../{ABOUT[profile]}).")
    return "\n\n".join(parts)


def page_of(profile, each, ours, told):
    entry = each.rows["entry"][0]
    facts = [f"**{entry['category']}**" + (f": {entry['condition']}" if "condition" in entry else ""), entry["code"], ", ".join(filter(None, (f"CiA {profile}", entry["clause"])))]
    if "errata" in entry:
        facts.append(f"contradictions: {entry['errata']}")
    said = descriptions_of(each)
    parts = [f"# {each.title}", " · ".join(facts), said[0] if len(said) == 1 else "", "## Entries", entries_section(each)]
    for kind, title, section in (("field", "Fields and states", fields_section), ("quantity", "Units and scales", quantities_section), ("device", "Virtual devices", devices_section),
                                 ("pdo", "Predefined PDOs", pdos_section)):  # fmt: skip
        if each.rows[kind]:
            parts += [f"## {title}", section(each)]
    refused = [f"- `{row['code']}`: {row['when']} ({row['clause']})" for row in each.rows["abort"]]
    parts += ["## Abort codes", "\n".join(refused)] if refused else []
    parts += ["## In Canvoy's devices", ours_section(profile, each, ours, told)]
    parts += [f"`canvoy profile {profile} {each.first:04X}` shows the same on the terminal."]
    return "\n\n".join(part for part in parts if part) + "\n"


def index_of(profile, title, found):
    rows = [[f"[{place_text(each.first, each.last)}]({each.first:04X}.md)", each.rows["entry"][0]["object"], each.rows["entry"][0]["clause"]] for each in found]
    return f"# CiA {profile}: objects\n\n{title}\n\n{table(['object', 'name', 'clause'], rows)}\n"


def make(command):
    """All pages, by their paths below docs."""
    ours, pages = devices_of_ours(command), {}
    for profile in PROFILES:
        rows = [json.loads(line) for line in run(command, "profile", profile, "--json").splitlines()]
        told = rows_told(TOLD_IN[profile]) if profile in TOLD_IN else {}
        found = objects_of(rows)
        for each in found:
            pages[f"objects/{profile}/{each.first:04X}.md"] = page_of(profile, each, ours, told)
        title = next((row.get("title", "") for row in rows if row["kind"] == "profile"), "")
        pages[f"objects/{profile}/index.md"] = index_of(profile, title, found)
    return pages
