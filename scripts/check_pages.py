"""Pages of all cases of `canvoy check`, with their clauses, as Markdown: made of `canvoy check --list`.

    pages = check_pages.make("build/canvoy")    # {"cases/index.md": "# Conformance cases ...", "cases/419.md": ...}
"""

import json
import pathlib
import subprocess
import tempfile

PROFILES = ("401", "407", "417-4", "418", "419", "447-3", "852")
OF_PROFILES = ("profile", "behaviour")


def cases_of(command, *arguments):
    with tempfile.NamedTemporaryFile() as file:
        subprocess.run([command, "check", "--list", *arguments, "--json", file.name], check=True)
        return [json.loads(line) for line in pathlib.Path(file.name).read_text().splitlines()]


def cell(text):
    return text.replace("\\", "\\\\").replace("\n", "\\\\n").replace("|", "\\|")


def tables_of(cases):
    """A table for each class, in the order in which they are tried."""
    parts = []
    for name in dict.fromkeys(case["class"] for case in cases):
        own = [case for case in cases if case["class"] == name]
        rows = "".join(
            f"| `{case['case']}` | {' | '.join(cell(case[key]) for key in ('title', 'sends', 'expects', 'clause'))} |\n" for case in own
        )
        parts.append(f"## {name[0].upper()}{name[1:]}: {len(own)}\n\n| case | | sends | expects | clause |\n| --- | --- | --- | --- | --- |\n{rows}")
    return "\n".join(parts)


def make(command):
    """All pages, by their paths below docs."""
    base = cases_of(command)
    links = ", ".join(f"[CiA {profile}]({profile}.md)" for profile in PROFILES)
    pages = {
        "cases/index.md": f"# Conformance cases\n\nWhat `canvoy check` tries with each device: CiA 301, 302, 305 and 306, {len(base)} cases. "
        f"Of the profiles: {links}. [How to test a device](../how-to/check.md).\n\n{tables_of(base)}"
    }
    for profile in PROFILES:
        own = [case for case in cases_of(command, "--profile", profile) if case["class"] in OF_PROFILES]
        pages[f"cases/{profile}.md"] = (
            f"# CiA {profile}: conformance cases\n\nWhat `canvoy check` tries with a device of CiA {profile}, beside [those of each device]"
            f"(index.md): {len(own)} cases.\n\n{tables_of(own)}"
        )
    return pages
