#!/usr/bin/env python3
"""Holds README and docs against the program: scripts/check-docs.sh runs this.

    check_docs.py --program build/release/prelight [--update] [FILE.md …]

Links: every relative link names a file that git knows, and an anchor that is a heading there.

Tests: where a page names tests (`test_render --gtest_filter=…`), there are such.

Figures: a page names a command and the figures that it prints.

    <!-- figures a: prelight render lights --lights 1024 --size 1280x720 -o PICTURE --stats STATS -->
    A frame has <!--= a.draws -->266<!--/--> objects.

The command is run as a reader would run it, with STATS and PICTURE in a temporary folder; after `=` stands a
Python expression over the JSON it wrote. The figure's own digits say how it is rounded. Without --update a figure that
differs is an error; with it the figure is written anew. Only what does not depend on the machine is
written this way: counts and sizes, never times.
"""
import argparse
import concurrent.futures
import json
import math
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import types

ROOT = pathlib.Path(__file__).resolve().parent.parent
LINK = re.compile(r"(?<!\\)!?\[[^\]\[]*(?:\[[^\]]*\][^\]\[]*)*\]\(([^()\s]*(?:\([^()\s]*\))?[^()\s]*)\)")
COMMAND = re.compile(r"<!-- figures (\w+): (.*?) -->", re.S)
FIGURE = re.compile(r"<!--= (.*?) -->(.*?)<!--/-->", re.S)
NUMBER = re.compile(r"-?\d[\d,]*(?:\.(\d+))?")


def pages():
    listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard", "*.md"],
                            cwd=ROOT, capture_output=True, check=True, text=True).stdout
    return [ROOT / name for name in listed.split("\0") if name and (ROOT / name).exists()]


def without_code(text):
    """The page with its code blanked, so that no bracket in it is taken for a link. Lines stay where they are."""
    def blank(match):
        return re.sub(r"[^\n]", " ", match.group(0))
    text = re.sub(r"^```.*?^```", blank, text, flags=re.S | re.M)
    text = re.sub(r"(?<=\n\n)(?: {4,}.*\n)+", blank, text)
    return re.sub(r"`[^`\n]*`", blank, text)


def anchors(page, known={}):
    """What GitHub makes of the page's headings."""
    if page not in known:
        found, fenced = [], re.sub(r"^```.*?^```", "", page.read_text(), flags=re.S | re.M)
        for heading in re.findall(r"^#{1,6} +(.*?) *#*$", fenced, re.M):
            heading = re.sub(r"<!--.*?-->", "", heading)
            heading = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)
            slug = re.sub(r"[^\w\- ]", "", heading.replace("`", "").lower()).strip().replace(" ", "-")
            found.append(slug if slug not in found else f"{slug}-{found.count(slug)}")
        known[page] = found
    return known[page]


def check_links(page):
    text = without_code(page.read_text())
    for match in LINK.finditer(text):
        target = match.group(1)
        if re.match(r"[a-z]+:", target):
            continue
        path, _, anchor = target.partition("#")
        file = (page.parent / path).resolve() if path else page
        where = f"{page.relative_to(ROOT)}:{text.count(chr(10), 0, match.start()) + 1}"
        if not file.exists():
            yield f"{where}: link to {target}: no such file"
        elif anchor and file.suffix == ".md" and anchor not in anchors(file):
            yield f"{where}: link to {target}: no such heading"


def check_tests(page, build):
    """A filter that no test matches proves nothing."""
    text = page.read_text()
    for match in re.finditer(r"test_(\w+) --gtest_filter=(?:'([^']+)'|([^\s`]+))", text):
        binary, where = build / f"tests/test_{match.group(1)}", text.count(chr(10), 0, match.start()) + 1
        found = subprocess.run([binary, "--gtest_list_tests", f"--gtest_filter={match.group(2) or match.group(3)}"],
                               capture_output=True, text=True).stdout if binary.exists() else ""
        if not re.search("^  ", found, re.M):
            yield f"{page.relative_to(ROOT)}:{where}: {match.group(0)}: no such test"


def tree(value):
    """JSON whose members are read as a.b, so that expressions stay short."""
    if isinstance(value, dict):
        names = {re.sub(r"\W", "_", key): tree(member) for key, member in value.items()}
        return types.SimpleNamespace(**names)
    return [tree(member) for member in value] if isinstance(value, list) else value


def run(command, program):
    """What the command writes to its STATS."""
    words = shlex.split(command)
    if words[:1] != ["prelight"] or "STATS" not in words:
        raise ValueError(f"'{command}': a command begins with prelight and writes STATS")
    with tempfile.TemporaryDirectory() as folder:
        files = {"STATS": f"{folder}/stats.json", "PICTURE": f"{folder}/picture.png"}
        words = [program] + [files.get(word, word) for word in words[1:]]
        done = subprocess.run(words, capture_output=True, text=True, timeout=600)
        if done.returncode != 0:
            raise ValueError(f"'{command}' ended with status {done.returncode}: {done.stderr.strip()}")
        return tree(json.loads(pathlib.Path(files["STATS"]).read_text()))


def written_like(old, value):
    """The value with as many decimals as the old figure, and a comma between thousands."""
    match = NUMBER.search(old)
    decimals = len(match.group(1) or "") if match else 0
    new = f"{value:,.{decimals}f}"
    return (old[:match.start()] + new + old[match.end():]) if match else new


def check_figures(page, program, results, update):
    text = page.read_text()
    commands = {name: " ".join(command.split()) for name, command in COMMAND.findall(text)}
    failures = []
    scope = {"ceil": math.ceil, "floor": math.floor, "round": round, "sum": sum, "len": len, "max": max, "min": min}
    for name, command in commands.items():
        try:
            scope[name] = results[command].result()
        except (ValueError, OSError, subprocess.TimeoutExpired) as error:
            return [f"{page.relative_to(ROOT)}: figures {name}: {error}"]

    def replace(match):
        expression, old = match.group(1), match.group(2)
        where = f"{page.relative_to(ROOT)}:{text.count(chr(10), 0, match.start()) + 1}"
        try:
            new = written_like(old, eval(expression, {"__builtins__": {}}, scope))
        except Exception as error:  # whatever a page may hold
            failures.append(f"{where}: {expression}: {error}")
            return match.group(0)
        if new != old and not update:
            failures.append(f"{where}: {expression} is {new}, and the page says {old}")
        return match.group(0).replace(f"-->{old}<!--", f"-->{new}<!--")

    new_text = FIGURE.sub(replace, text)
    if update and new_text != text:
        page.write_text(new_text)
        print(f"{page.relative_to(ROOT)}: figures written anew")
    return failures


def main():
    parser = argparse.ArgumentParser(description="Checks links and figures of README and docs.")
    parser.add_argument("--program", default=str(ROOT / "build/release/prelight"))
    parser.add_argument("--update", action="store_true", help="write figures that differ instead of failing")
    parser.add_argument("pages", nargs="*", type=pathlib.Path)
    options = parser.parse_args()
    chosen = [page.resolve() for page in options.pages] or pages()

    build = pathlib.Path(options.program).parent
    failures = [failure for page in chosen for failure in [*check_links(page), *check_tests(page, build)]]
    texts = {page: page.read_text() for page in chosen}
    commands = {" ".join(command.split()) for text in texts.values() for _, command in COMMAND.findall(text)}
    figures = sum(len(FIGURE.findall(text)) for text in texts.values())
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        results = {command: pool.submit(run, command, options.program) for command in sorted(commands)}
        for page in chosen:
            failures += check_figures(page, options.program, results, options.update)
    for failure in failures:
        print(failure, file=sys.stderr)
    print(f"{len(chosen)} pages, {len(commands)} commands, {figures} figures: {len(failures)} wrong")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
