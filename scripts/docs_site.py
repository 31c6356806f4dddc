"""What MkDocs does not do by itself for the site (mkdocs.yml): the command reference, a page for each object of the profiles, pages of
all cases of `canvoy check`, the C++ API as Doxygen has made it, and links to files of the sources.

The reference is made of what the command prints: `canvoy VERB --help` and that of all verbs below it. CANVOY says where the
command is (default: build/canvoy).
"""

import os
import pathlib
import posixpath
import re
import shutil
import subprocess
import sys

import mkdocs.exceptions
from mkdocs.structure.files import File

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import check_pages
import object_pages

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCES = "https://github.com/canvoy/canvoy/blob/main/"
NO_PLAYGROUND = """<!doctype html>
<html lang="en"><meta charset="utf-8"><title>Canvoy: playground</title>
<p>This site was built without the playground: <code>make playground docs</code> builds both. <a href="../">Canvoy</a></p></html>
"""
LINK = re.compile(r"(?<=\]\()(\.\./[^)#\s]+)(?=[)#])")


def command():
    return os.environ.get("CANVOY", str(ROOT / "build" / "canvoy"))


def help_of(*verb):
    return subprocess.run([command(), *verb, "--help"], capture_output=True, text=True, check=True).stdout.rstrip()


def verbs_below(text):
    """The verbs that a help lists, with what they do."""
    _, found, listed = text.partition("\nSubcommands:\n")
    return re.findall(r"(?m)^  ([a-z][a-z-]*) +(\S.*)$", listed.split("\n\n")[0]) if found else []


def section(verb, depth):
    """A verb and those below it, as Markdown."""
    text = help_of(*verb)
    parts = [f"{'#' * depth} canvoy {' '.join(verb)}\n\n```text\n{text}\n```\n"]
    for name, _ in verbs_below(text):
        parts += section((*verb, name), depth + 1)
    return parts


def on_files(files, config):
    """Adds a page for each verb, and one that lists them."""
    overview = help_of()
    verbs = verbs_below(overview)
    if not verbs:
        raise mkdocs.exceptions.PluginError("canvoy --help lists no verbs")
    pages = {f"{name}.md": "\n".join(section((name,), 1)) for name, _ in verbs}
    rows = "\n".join(f"| [`{name}`]({name}.md) | {what} |" for name, what in verbs)
    pages["index.md"] = (
        "# Commands\n\nWhat the commands say of themselves; `man canvoy-VERB` says the same. "
        "[Ask and tell](../commands.md) has the grammar that they share.\n\n"
        f"| verb | |\n| --- | --- |\n{rows}\n\n```text\n{overview}\n```\n"
    )
    for name, text in pages.items():
        files.append(File.generated(config, f"reference/{name}", content=text))
    for path, text in {**object_pages.make(command()), **check_pages.make(command())}.items():
        files.append(File.generated(config, path, content=text))
    return files


def on_post_build(config):
    """The C++ API and the playground stand beside the pages."""
    playground = ROOT / "build" / "playground" / "site"
    place = pathlib.Path(config["site_dir"]) / "play"
    if (playground / "canvoy.wasm").exists():
        shutil.copytree(playground, place, dirs_exist_ok=True)
    else:
        place.mkdir(exist_ok=True)
        (place / "index.html").write_text(NO_PLAYGROUND)
    api = ROOT / "build" / "docs" / "api"
    if not (api / "index.html").exists():
        raise mkdocs.exceptions.PluginError("build/docs/api is not there: scripts/api-docs")
    shutil.copytree(api, pathlib.Path(config["site_dir"]) / "api" / "html", dirs_exist_ok=True)


def on_config(config):
    """The pages of the verbs stand below the one that lists them."""
    for entry in config["nav"]:
        for pages in entry.values():
            if isinstance(pages, list) and {"Commands": "reference/index.md"} in pages:
                place = pages.index({"Commands": "reference/index.md"})
                below = [f"reference/{name}.md" for name, _ in verbs_below(help_of())]
                pages[place] = {"Commands": ["reference/index.md", *below]}
    return config


def on_page_markdown(markdown, page, **_):
    """Links to files outside of docs lead to the repository, and have to be there."""

    def rewritten(match):
        path = posixpath.normpath(posixpath.join("docs", posixpath.dirname(page.file.src_uri), match.group(1)))
        if path.startswith("docs/"):
            return match.group(1)
        if not (ROOT / path).exists():
            raise mkdocs.exceptions.PluginError(f"docs/{page.file.src_uri}: {match.group(1)} is not there")
        return SOURCES + path

    return LINK.sub(rewritten, markdown)
