#!/usr/bin/env bash
# Builds the program: scripts/build.sh [--tests] [PRESET]   (presets: release (default), develop, debug, asan)
# `release` compiles the files of a folder together, which takes a third of the time; `develop` each by itself, so that a change costs little.
# The program is then build/PRESET/prelight. With --tests the test binaries are built too.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

preset=release
target=prelight_app
tests=OFF
# An existing build folder keeps its tests: switching them off and on would configure it anew.
if pkg-config --exists gtest gmock 2>/dev/null; then
    tests=ON
fi
for argument in "$@"; do
    case $argument in
    --tests) target=all tests=ON ;;
    -*) echo "usage: scripts/build.sh [--tests] [PRESET]" >&2; exit 2 ;;
    *) preset=$argument ;;
    esac
done

log=build/$preset-configure.log
mkdir -p build
if ! cmake --preset "$preset" -DPRELIGHT_TESTS=$tests >"$log" 2>&1; then
    cat "$log" >&2
    exit 1
fi
echo "Building build/$preset"
if [ -t 1 ]; then
    cmake --build --preset "$preset" --target $target # one line that moves
else
    # A line for each tenth of the steps, and whatever a step says.
    cmake --build --preset "$preset" --target $target 2>&1 | awk '
        match($0, /^\[[0-9]+\/[0-9]+\]/) {
            split(substr($0, 2, RLENGTH - 2), step, "/")
            tenth = int(10 * step[1] / step[2])
            if (tenth > shown) { printf "  %3d %% of %d steps\n", 10 * tenth, step[2]; fflush(); shown = tenth }
            next
        }
        { print; fflush() }'
fi
