#!/usr/bin/env bash
# Runs clang-tidy with .clang-tidy's list over the library, the program and the tools: scripts/tidy.sh [FILE…], with files only
# what is compiled together with them. Needs clang and clang-tidy, and nothing built. Five minutes of processor time, three by the
# clock on two cores, and no check takes more than a sixth of that: not a part of what scripts/test.sh runs by itself.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
for tool in clang++ clang-tidy; do
    command -v "$tool" >/dev/null || { echo "tidy: needs $tool (Debian package ${tool%++})" >&2; exit 1; }
done
build=$PWD/build/tidy
# Most of a file's time goes into the headers it includes: the files of a folder are checked together. Without precompiled
# headers, which are another compiler's.
cmake --preset clang-check -B "$build" -DPRELIGHT_SHADERS_OF= -DPRELIGHT_EXAMPLES=OFF -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON \
    -DCMAKE_EXPORT_COMPILE_COMMANDS=ON >"$build.log" || { cat "$build.log" >&2; exit 1; }
sed -n 's/^ *"file": "\(.*\)",\?$/\1/p' "$build/compile_commands.json" | sort -u >"$build/compiled"
grep '/Unity/' "$build/compiled" >"$build/together"
xargs sed -n 's/^#include "\(.*\)"$/\1/p' <"$build/together" >"$build/included"
# Sources of the repository that are compiled by themselves, and by no other unit with others.
git ls-files 'src/*.cpp' 'apps/*.cpp' 'tools/*.cpp' | sed "s|^|$PWD/|" >"$build/sources"
grep -Fxf "$build/sources" "$build/compiled" | grep -Fxvf "$build/included" >"$build/alone"
if missing=$(grep -Fxvf "$build/included" "$build/sources" | grep -Fxvf "$build/alone"); then
    echo "tidy: not compiled here, and not checked: ${missing//$PWD\//}" >&2
fi
if [ $# = 0 ]; then
    mapfile -t units < <(xargs ls -S <"$build/together"; cat "$build/alone") # long ones first
else
    units=()
    for file in "$@"; do
        path=$(realpath "$file")
        unit=$(xargs grep -lFx "#include \"$path\"" <"$build/together" || grep -Fx "$path" "$build/compiled") ||
            { echo "tidy: $file: not a source of the library, the program or the tools" >&2; exit 2; }
        units+=("$unit")
    done
    mapfile -t units < <(printf '%s\n' "${units[@]}" | sort -u)
fi
# It counts what it leaves out of other people's headers.
printf '%s\0' "${units[@]}" | xargs -0 -n 1 -P "$(nproc)" clang-tidy -p "$build" --quiet 2> >(grep -v 'warnings\? generated' >&2)
echo "tidy: nothing found in ${#units[@]} units"
