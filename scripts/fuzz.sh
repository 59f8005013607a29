#!/bin/sh
# scripts/fuzz.sh [SECONDS [gltf|ies]]: builds the libFuzzer target of the glTF reader, or of the reader of IES
# files, with the address and undefined-behaviour sanitizers and runs it (60 s), starting from small valid files. What it finds
# lies in build/fuzz/finds; the exit status is then not 0. The corpus grows in build/fuzz/corpus.
set -eu
cd "$(dirname "$0")/.."
seconds=${1:-60}
target=${2:-gltf}
cmake --preset fuzz >/dev/null
ninja -C build/fuzz fuzz_"$target" fuzz_seeds
corpus=build/fuzz/corpus seeds=build/fuzz/seeds
if [ "$target" = ies ]; then
    corpus=build/fuzz/corpus-ies seeds=build/fuzz/seeds/ies
fi
mkdir -p "$corpus" build/fuzz/finds
build/fuzz/tests/fuzz/fuzz_seeds build/fuzz/seeds
# CPU time of one input is bounded like its memory: 10 s even under the sanitizers.
exec build/fuzz/tests/fuzz/fuzz_"$target" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=3072 \
    -max_len=65536 -dict=tests/fuzz/"$target".dict -artifact_prefix=build/fuzz/finds/ \
    -print_final_stats=1 "$corpus" "$seeds"
