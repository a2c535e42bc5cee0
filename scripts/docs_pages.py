# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""A hook of MkDocs: pages, and parts of pages, made of what is elsewhere in the repository."""

import re
import subprocess
from pathlib import Path

from mkdocs.structure.files import File

ROOT = Path(__file__).parents[1]
PROGRAM = ROOT / "build" / "taut"
NOTEBOOKS = ROOT / "build" / "python" / "notebooks"
APP = ROOT / "build" / "app" / "taut.html"
SAMPLE = ROOT / "build" / "docs" / "sample"
HERE = """Or take it from here: [taut.html](app/taut.html), to open or to save, with files to drop onto it:
[net.json](app/net.json) and [survey.csv](app/survey.csv)."""
MODULES = ROOT / "build" / "docs" / "node_modules"
KATEX = MODULES / "katex" / "dist"
RENDER = """
document.addEventListener("DOMContentLoaded", () => renderMathInElement(document.body, {
  delimiters: [
    {left: "$", right: "$", display: false},
    {left: "\\\\(", right: "\\\\)", display: false},
    {left: "\\\\[", right: "\\\\]", display: true},
  ],
}));
"""
COMMANDS = """# Commands

Which options does a command have? This is what `taut --help` and `taut COMMAND --help` print.
[On the command line](command-line.md) shows how the commands go together.

"""


def help_of(*command):
    shown = subprocess.run([PROGRAM, *command, "--help"], capture_output=True, text=True, check=True)
    return shown.stdout.strip()


def commands():
    """Each command with its help."""
    overview = help_of()
    names = re.findall(r"^  ([a-z]+) ", overview, re.MULTILINE)
    page = ["```", overview, "```"]
    for name in names:
        page += [f"## taut {name}", "```", help_of(name), "```"]
    return "\n\n".join(page).replace("```\n\n", "```\n").replace("\n\n```", "\n```") + "\n"


def sample(folder):
    """Files to drop onto the app: a net, and a survey of it as it might be built."""
    folder.mkdir(parents=True, exist_ok=True)
    for words in (
        "example hilo-quarter -o net.json",
        "form net.json --prior uniform:5mm --seed 7 -o built.csv",
        "survey net.json built.csv --noise 0.5mm --drop 10% --seed 2 -o survey.csv",
    ):
        subprocess.run([PROGRAM, *words.split()], cwd=folder, capture_output=True, check=True)


def on_files(files, config):
    app = (ROOT / "docs" / "app.md").read_text(encoding="utf-8")
    if APP.exists():
        app = app.replace("<!-- site: here -->", HERE)
        sample(SAMPLE)
        for path in [APP, SAMPLE / "net.json", SAMPLE / "survey.csv"]:
            files.append(File.generated(config, f"app/{path.name}", abs_src_path=str(path)))
    pages = {
        "app.md": app,
        "commands.md": COMMANDS + commands(),
        "linking.md": re.sub(  # the site has the reference of the headers
            r"`make reference`",
            '<a href="cpp/index.html">`make reference`</a>',
            (ROOT / "docs" / "linking.md").read_text(encoding="utf-8"),
        ),
        "changelog.md": re.sub(
            r"\]\(docs/", "](", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
        ),
        "katex/render.js": RENDER,
        "katex/page.css": ".katex-display {font-size: 0.8em; overflow: auto hidden}",
    }
    for name, content in pages.items():
        if file := files.get_file_from_path(name):
            files.remove(file)
        files.append(File.generated(config, name, content=content))
    for file in files:
        if file.src_uri.endswith(".ipynb"):  # as the tests ran it
            file.abs_src_path = str(NOTEBOOKS / Path(file.src_uri).name)
    for path in [KATEX / "katex.min.css", KATEX / "katex.min.js"]:
        files.append(File.generated(config, f"katex/{path.name}", abs_src_path=str(path)))
    for name, path in {
        "katex/auto-render.min.js": KATEX / "contrib" / "auto-render.min.js",
        "search/iframe-worker.js": MODULES / "iframe-worker" / "shim" / "index.js",
        # Their licences ask to go with every copy.
        "katex/LICENSE": MODULES / "katex" / "LICENSE",
        "search/iframe-worker.LICENSE": MODULES / "iframe-worker" / "LICENSE",
    }.items():
        files.append(File.generated(config, name, abs_src_path=str(path)))
    for path in sorted((KATEX / "fonts").glob("*.woff2")):
        files.append(File.generated(config, f"katex/fonts/{path.name}", abs_src_path=str(path)))
    return files
