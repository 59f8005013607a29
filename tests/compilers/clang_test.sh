#!/usr/bin/env bash
# Builds library, program and two examples with clang, warnings as errors, and holds what that program makes to what GCC's
# made: the same bytes. Not optimised, and with the shaders of GCC's build, which it is written beside.
#   tests/compilers/clang_test.sh
# Needs build/release.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
folder=$(mktemp -d /tmp/prelight-clang.XXXXXX)
trap 'rm -rf "$folder"' EXIT
fail() {
    echo "FAILED: $1" >&2
    exit 1
}
cmake --preset clang-check >"$folder/log" 2>&1 || { cat "$folder/log" >&2; fail "configuring"; }
ninja -C build/clang-check prelight_app prelight_shared example_embed example_window_lights >"$folder/log" 2>&1 ||
    { grep -A 8 -e '^FAILED' -e 'error:' "$folder/log" >&2 || tail -n 30 "$folder/log" >&2; fail "building with $(clang++ --version | head -n 1)"; }
grep -qa 'clang version' <(readelf -p .comment build/clang-check/prelight) || fail "the program is not clang's"

same() { # FILE ARGUMENTS…: both programs, with the same arguments, write the same FILE
    for compiler in release clang-check; do
        "build/$compiler/prelight" "${@:2}" -o "$folder/$1" >"$folder/log" 2>&1 ||
            { cat "$folder/log" >&2; fail "prelight ${*:2}, $compiler"; }
        mv "$folder/$1" "$folder/$compiler-$1"
    done
    cmp "$folder/release-$1" "$folder/clang-check-$1" >&2 || fail "prelight ${*:2}: other bytes than GCC's"
    echo "prelight ${*:2}"
}
# What comes from a seed, in an order that is not the compiler's to choose; then a device and the reference.
for scene in city lights spheres motion shadows cookies materials decals glass round2 multipass bounce city-sparks city-smoke city-glass; do
    same scene.glb make $scene --lights 16
done
same device.png render cookies --lights 64 --size 160x90 --set shadows=on
same rays.png render glass --renderer reference --size 64x36
