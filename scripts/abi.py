#!/usr/bin/env python3
"""Holds the shared library to its binary interface: scripts/abi.py [--update] [--library FILE]

packaging/abi/MAJOR.MINOR.txt lists, for each minor version, what programs that were built against it rely on: the
SOVERSION, the exported symbols, and of each public class the size and the number of virtual functions, as the compiler
sees them in include/prelight/. Without --update the built library must be what the list of its version says. With it the list is
written anew, unless

  - that version has been released (CHANGELOG.md has a heading of its name): raise the minor version;
  - something of the last released list is gone or another, and SOVERSION (include/prelight/version.hpp) is still that
    list's: raise it. What is only added needs no new SOVERSION.

Not seen: members and virtual functions that only change places, and numbers of enumerators.
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent


def symbols(library):
    """The library's exported symbols, demangled. Constructors and destructors have several of one name."""
    listed = subprocess.run(["nm", "--dynamic", "--defined-only", "--demangle", "--format=posix", library],
                            capture_output=True, check=True, text=True).stdout
    return {"symbol " + re.sub(r" [A-Za-z](?: [0-9a-f]+)* *$", "", line) for line in listed.splitlines()}


def classes(headers):
    """Size, alignment and length of the virtual table of the public headers' classes."""
    with tempfile.TemporaryDirectory() as folder:
        source, dump = pathlib.Path(folder, "all.cpp"), pathlib.Path(folder, "all.class")
        source.write_text("".join(f"#include <prelight/{header.name}>\n" for header in sorted(headers)
                                  if header.name != "glfw.hpp"))  # is part of the program that includes it
        subprocess.run(["g++", "-std=c++20", "-I", headers[0].parent.parent, "-c", source,
                        "-o", "/dev/null", f"-fdump-lang-class={dump}"], check=True)
        found = set()
        for block in dump.read_text().split("\n\n"):
            size = re.match(r"Class (prelight::\S+)\n +size=(\d+) align=(\d+)", block)
            if size:
                found.add("class %s: %s bytes, alignment %s" % size.groups())
            table = re.match(r"Vtable for (prelight::\S+)\n", block)
            if table:
                found.add("virtual %s: %s entries" % (table[1], re.search(r": (\d+) entries", block)[1]))
    return found


def version_of(header):
    text = header.read_text()
    return {name: int(re.search(rf"^#define PRELIGHT_{name} (\d+)$", text, re.M)[1])
            for name in ("VERSION_MAJOR", "VERSION_MINOR", "VERSION_PATCH", "SOVERSION")}


def read_list(file):
    """Of a list: its SOVERSION and its lines."""
    lines = [line for line in file.read_text().splitlines() if not line.startswith("#")]
    return int(lines[0].split()[1]), set(lines[1:])


def released(changelog):
    """The minor versions that were released, as pairs of numbers."""
    return {(int(major), int(minor)) for major, minor in re.findall(r"^## (\d+)\.(\d+)\.\d+\b", changelog, re.M)}


def fault(version, now, lists, versions_released):
    """Why `now`, the lines of this version, may not be its list; None: it may. `lists`: (major, minor) → (SOVERSION, lines)."""
    this = (version["VERSION_MAJOR"], version["VERSION_MINOR"])
    if this in versions_released and this in lists and lists[this] != (version["SOVERSION"], now):
        return f"{this[0]}.{this[1]} has been released with another interface: raise the minor version"
    before = [other for other in lists if other < this and other in versions_released]
    if before:
        soversion, lines = lists[max(before)]
        gone = sorted(lines - now)
        if gone and version["SOVERSION"] <= soversion:
            return (f"{len(gone)} lines of {max(before)[0]}.{max(before)[1]} are gone or changed ({gone[0]}): "
                    f"raise SOVERSION, which is still {version['SOVERSION']}")
    return None


def main():
    options = argparse.ArgumentParser(description="Holds the shared library to the list of its interface.")
    options.add_argument("--update", action="store_true")
    options.add_argument("--library", default=ROOT / "build/release/src/libprelight.so", type=pathlib.Path)
    options.add_argument("--root", default=ROOT, type=pathlib.Path, help=argparse.SUPPRESS)
    asked = options.parse_args()
    if not asked.library.exists():
        sys.exit(f"{asked.library}: is not built")
    version = version_of(asked.root / "include/prelight/version.hpp")
    now = symbols(asked.library) | classes(sorted((asked.root / "include/prelight").glob("*.hpp")))
    folder = asked.root / "packaging/abi"
    lists = {}
    for file in folder.glob("*.txt"):
        lists[tuple(int(number) for number in file.stem.split("."))] = read_list(file)
    why_not = fault(version, now, lists, released((asked.root / "CHANGELOG.md").read_text()))
    this = (version["VERSION_MAJOR"], version["VERSION_MINOR"])
    file = folder / f"{this[0]}.{this[1]}.txt"
    soversion, listed = lists.get(this, (None, set()))
    same = (soversion, listed) == (version["SOVERSION"], now)
    if not same and (why_not or not asked.update):
        for line in sorted(now - listed):
            print("+", line)
        for line in sorted(listed - now):
            print("-", line)
    if why_not:
        sys.exit(f"{asked.library.name}: {why_not}")
    if asked.update:
        file.write_text("# The binary interface of this version: scripts/abi.py --update writes it.\n"
                        f"soversion {version['SOVERSION']}\n" + "\n".join(sorted(now)) + "\n")
    elif not same:
        sys.exit(f"{asked.library.name}: not the interface of {file.relative_to(asked.root)}; if it is meant to change, scripts/abi.py "
                 "--update writes it, or says what the version must say first")


if __name__ == "__main__":
    main()
