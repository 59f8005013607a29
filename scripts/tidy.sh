#!/usr/bin/env bash
# Runs clang-tidy with .clang-tidy's list: scripts/tidy.sh [FILE…], by default every source of the library and the program
# (some 20 minutes on two cores, so not a part of scripts/test.sh). Needs clang and clang-tidy.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
for tool in clang++ clang-tidy; do
    command -v "$tool" >/dev/null || { echo "tidy: needs $tool (Debian package ${tool%++})" >&2; exit 1; }
done
build=build/tidy
# Each file by itself and without precompiled headers: clang-tidy reads what the compiler would.
cmake --preset clang -B "$build" -DPRELIGHT_UNITY=OFF -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DCMAKE_EXPORT_COMPILE_COMMANDS=ON >/dev/null
if [ $# = 0 ]; then
    mapfile -t files < <(git ls-files 'src/*.cpp' 'apps/*.cpp' 'tools/*.cpp')
else
    files=("$@")
fi
printf '%s\0' "${files[@]}" | xargs -0 -n 4 -P "$(nproc)" clang-tidy -p "$build" --quiet
