#!/bin/sh
# scripts/fuzz.sh [SECONDS]: builds the libFuzzer target of the glTF reader with the address and
# undefined-behaviour sanitizers and runs it (60 s), starting from small valid files. What it finds
# lies in build/fuzz/finds; the exit status is then not 0. The corpus grows in build/fuzz/corpus.
set -eu
cd "$(dirname "$0")/.."
seconds=${1:-60}
cmake --preset fuzz >/dev/null
ninja -C build/fuzz fuzz_gltf fuzz_seeds
mkdir -p build/fuzz/corpus build/fuzz/finds
build/fuzz/tests/fuzz/fuzz_seeds build/fuzz/seeds
# CPU time of one input is bounded like its memory: 10 s even under the sanitizers.
exec build/fuzz/tests/fuzz/fuzz_gltf -max_total_time="$seconds" -timeout=10 -rss_limit_mb=3072 \
    -max_len=65536 -dict=tests/fuzz/gltf.dict -artifact_prefix=build/fuzz/finds/ \
    -print_final_stats=1 build/fuzz/corpus build/fuzz/seeds
