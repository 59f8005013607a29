#!/usr/bin/env python3
"""Draws which folders include which: scripts/draw_folders.py [--check]

Writes the Mermaid picture between the marks in OVERVIEW.md, from the #include lines of src/ and apps/; with --check,
fails where the picture there is another one, or where two folders include each other. An arrow that follows from
others is left out.
"""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BEGIN, END = "<!-- folders: scripts/draw_folders.py -->\n", "<!-- /folders -->\n"


def edges():
    """{folder: folders that it includes}: folders below src/, the public headers, and the program."""
    homes = {path.name: path for path in (ROOT / "src").iterdir() if path.is_dir()}
    homes["apps"] = ROOT / "apps" / "prelight"
    found = {name: set() for name in homes}
    for name, home in homes.items():
        for file in [*home.rglob("*.cpp"), *home.rglob("*.hpp")]:
            for folder in re.findall(r'^#include <(\w+)/', file.read_text(), re.M):
                if folder != name and (folder in homes or folder == "prelight"):
                    found[name].add(folder)
    return found


def reachable(graph, start):
    seen, todo = set(), [start]
    while todo:
        for after in graph.get(todo.pop(), ()):
            if after not in seen:
                seen.add(after)
                todo.append(after)
    return seen


def picture(graph):
    lines = ["```mermaid\n", "graph TD\n"]
    for name in sorted(graph):
        direct = graph[name]
        for other in sorted(direct):
            if not any(other in reachable(graph, between) for between in direct - {other}):
                label = "include/prelight" if other == "prelight" else other
                lines.append(f'    {name} --> {other}["{label}"]\n' if other == "prelight" else f"    {name} --> {label}\n")
    return "".join([*lines, "```\n"])


def main():
    graph = edges()
    circles = sorted(name for name in graph if name in reachable(graph, name))
    if circles:
        sys.exit(f"folders that include each other: {', '.join(circles)}")
    page = ROOT / "OVERVIEW.md"
    text = page.read_text()
    if text.count(BEGIN) != 1 or text.count(END) != 1:
        sys.exit("OVERVIEW.md: the two marks around the picture of folders are not there, once each")
    before, rest = text.split(BEGIN)
    old, after = rest.split(END)
    new = picture(graph)
    if "--check" in sys.argv:
        if old != new:
            sys.exit("OVERVIEW.md: the picture of folders is an old one: scripts/draw_folders.py")
    else:
        page.write_text(before + BEGIN + new + END + after)


main()
