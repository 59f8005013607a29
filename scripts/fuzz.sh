#!/bin/sh
# scripts/fuzz.sh [SECONDS [TARGET]]: fuzzes a reader freely for so long (60 s), with the address and undefined-behaviour sanitizers,
# from small valid files and all earlier finds. TARGET: gltf (default), pictures or ies. What it finds lies in build/fuzz/finds; the exit
# status is then not 0. A find is kept by moving it to tests/fuzz/finds/TARGET. The corpus grows in build/fuzz/corpus.
# scripts/fuzz.sh --runs N [TARGET]: N runs from a fixed seed, on nothing left over from earlier ones: always the same, for scripts/test.sh.
set -eu
cd "$(dirname "$0")/.."
runs=
if [ "${1:-}" = --runs ]; then
    runs=${2:?--runs N}
    shift
fi
seconds=${1:-60}
target=${2:-gltf}
cmake --preset fuzz >/dev/null
ninja -C build/fuzz fuzz_"$target" fuzz_seeds
build/fuzz/tests/fuzz/fuzz_seeds build/fuzz/seeds
finds=tests/fuzz/finds/$target
fuzz=build/fuzz/tests/fuzz/fuzz_$target
# CPU time of one input is bounded like its memory: 10 s even under the sanitizers.
limits="-timeout=10 -rss_limit_mb=3072 -max_len=65536 -dict=tests/fuzz/$target.dict -print_final_stats=1"
mkdir -p build/fuzz/finds
if [ -n "$runs" ]; then
    # In the order of their names, not of a folder, and at the same addresses each time where the system allows that: what
    # the fuzzer does next depends on both.
    inputs=$(find build/fuzz/seeds/"$target" "$finds" -type f 2>/dev/null | LC_ALL=C sort | paste -sd, -)
    fixed=
    if setarch -R true 2>/dev/null; then
        fixed="setarch -R"
    fi
    # shellcheck disable=SC2086
    exec $fixed "$fuzz" $limits -runs="$runs" -seed=1 -artifact_prefix=build/fuzz/finds/ -seed_inputs="$inputs"
fi
corpus=build/fuzz/corpus/$target
mkdir -p "$corpus" "$finds"
# shellcheck disable=SC2086
exec "$fuzz" $limits -max_total_time="$seconds" -artifact_prefix=build/fuzz/finds/ "$corpus" build/fuzz/seeds/"$target" "$finds"
