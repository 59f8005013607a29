#!/usr/bin/env bash
# Holds README and docs against the program: links, commands, and every figure that a command prints
# (scripts/check_docs.py says how a page marks one); the picture of folders, and the one that knows the operating system, against
# the code; and public headers to be documented, all that they have.
#   scripts/check-docs.sh            fails where a page says something else
#   scripts/check-docs.sh --update   writes such figures anew
# Needs the program and test_cli: scripts/build.sh --tests.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=build/release
status=0
if [[ " $* " == *" --update "* ]]; then
    python3 scripts/draw_folders.py
else
    python3 scripts/draw_folders.py --check || status=1
fi
python3 scripts/check_platform.py || status=1
mkdir -p "$build/docs/api"
doxygen "$build/Doxyfile" || status=1
python3 scripts/check_docs.py --program "$PWD/$build/prelight" "$@" || status=1
"$build/tests/test_cli" --gtest_filter='Docs.*' --gtest_brief=1 || status=1
exit $status
