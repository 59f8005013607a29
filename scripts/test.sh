#!/usr/bin/env bash
# Every test: installs what is missing, builds Release and the fuzz target, runs all test binaries.
#   scripts/test.sh [NAME…]   only these, of: format image scene reference gpu render cli python slurm gpu-report package clang docs sanitized …
#                             and pip and tidy, which only run when they are named
# One line for each binary; the last line counts the tests. "sanitized": the fastest binary and the fuzz targets under the address
# and undefined-behaviour sanitizers. Fuzz targets do a fixed number of runs from a fixed seed: scripts/fuzz.sh fuzzes freely.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
root=$PWD
build=$root/build/release
logs=$build/test-logs
# One more than there are cores: a test of pictures often leaves one idle, while it uploads, compares or waits for the other.
jobs=$(($(nproc) + 1))

if ! scripts/setup.sh --tests || ! scripts/build.sh --tests; then
    echo "0 passed, 1 failed" # nothing could be run
    exit 1
fi
if [ -f tests/oracle/package.json ]; then
    # The oracles are extra witnesses: without a network their tests say that they were skipped.
    if ! (cd tests/oracle && npm ci --no-audit --no-fund --silent >"$build/npm.log" 2>&1); then
        echo "SKIPPED npm ci in tests/oracle failed (see $build/npm.log): no oracle tests"
    fi
fi

# Mesa's compiled shaders, shared by all tests; and nothing in the user's own cache folder.
export MESA_SHADER_CACHE_DIR=$root/build/shader-cache
export XDG_CACHE_HOME=$root/build/test-cache
mkdir -p "$MESA_SHADER_CACHE_DIR" "$XDG_CACHE_HOME" "$logs"
rm -f "$logs"/*

# What takes a second or two says first whether anything works; then long ones before short ones, so that both cores
# are busy to the end. Binaries that are not named here come after those that are.
declare -a names=() known=(image render cli scene gpu reference)
for name in "${known[@]}"; do
    [ -x "$build/tests/test_$name" ] && names+=("$name")
    [ "$name" = cli ] && [ -f scripts/fuzz.sh ] && names+=(sanitized)
done
for binary in "$build"/tests/test_*; do
    name=${binary##*/test_}
    [[ -x $binary && " ${known[*]} " != *" $name "* ]] && names+=("$name")
done
names=(format "${names[@]}" package clang docs slurm gpu-report python)
if [ $# -gt 0 ]; then
    names=("$@")
fi

# The picture tests take longer than all others together: in parts, so that several run at a time and end together.
declare -a parts=()
render_parts=8
for name in "${names[@]}"; do
    if [ "$name" = render ]; then
        for ((k = 1; k <= render_parts; ++k)); do parts+=("render-${k}of$render_parts"); done
    else
        parts+=("$name")
    fi
done
names=("${parts[@]}")

# The K-th of N parts of a GoogleTest binary, as a filter: neighbouring suites, about as long in each part, by the seconds in
# tests/suite_seconds.txt (scripts/suite_seconds.sh writes it); suites that are not there take a fifth of a second a test.
# Not GoogleTest's own shards, which deal out the tests of a suite one by one: each process would then make the pipelines of
# all of them.
part_of() { # BINARY K N
    "$1" --gtest_list_tests | awk -v k="$2" -v n="$3" '
        NR == FNR { seconds[$1 "."] = $2; next }
        /^[^ ]+\.( |$)/ { suite[++suites] = $1; next }
        /^  / { ++tests[suites] }
        END {
            for (s = 1; s <= suites; ++s)
                all += weight[s] = suite[s] in seconds ? seconds[suite[s]] : tests[s] / 5
            for (s = 1; s <= suites; ++s) {
                if (int((before + weight[s] / 2) * n / all) == k - 1)
                    printf "%s*:", suite[s]
                before += weight[s]
            }
        }' "$root/tests/suite_seconds.txt" -
}

# Runs one GoogleTest binary, or a part of it (NAME-KofN), and writes "PASSED FAILED SKIPPED" to $logs/NAME.count. A test that
# began and has no result (a crash, a timeout) counts as failed, and so does a binary that ran none.
run_gtest() { # NAME [BINARY]
    local log=$logs/$1.log status=0 announced passed failed skipped binary=${2:-$build/tests/test_${1%-*of*}}
    if [[ $1 =~ -([0-9]+)of([0-9]+)$ ]]; then
        GTEST_FILTER=$(part_of "$binary" "${BASH_REMATCH[1]}" "${BASH_REMATCH[2]}")
        export GTEST_FILTER
        # A software device's images come and go by hundreds of megabytes, and the system clears each page of new memory.
        export GLIBC_TUNABLES=glibc.malloc.mmap_threshold=536870912:glibc.malloc.trim_threshold=4294967296
    fi
    (cd "$root" && timeout --kill-after=10 2400 "$binary" >"$log" 2>&1) || status=$?
    announced=$(sed -n 's/^\[==========\] Running \([0-9]*\) test.*/\1/p' "$log" | head -n 1)
    announced=${announced:-0}
    passed=$(grep -c '\[       OK \] .* ([0-9]* ms)$' "$log" || true)
    skipped=$(grep -c '\[  SKIPPED \] .* ([0-9]* ms)$' "$log" || true)
    failed=$((announced - passed - skipped))
    if [ "$failed" -le 0 ] && { [ "$status" != 0 ] || [ "$announced" = 0 ]; }; then
        failed=1
    fi
    [ "$status" = 124 ] && echo "timed out" >>"$log"
    [ "$status" -gt 128 ] && echo "ended by signal $((status - 128))" >>"$log"
    echo "$passed $failed $skipped" >"$logs/$1.count"
}

# Builds with clang and sanitizers. Runs the fastest test binary (test_scene takes minutes and has bounds on time), and each fuzz target as often as always, on its seeds and all
# earlier finds: one test a target.
run_sanitized() {
    local log=$logs/sanitized.log target passed=0 failed=0 skipped=0
    if ! command -v clang++ >/dev/null; then
        echo "clang++ is missing" >"$log"
        echo "0 0 1" >"$logs/sanitized.count"
        return
    fi
    : >"$log"
    if cmake --preset fuzz >>"$log" 2>&1 && ninja -C build/fuzz test_image >>"$log" 2>&1; then
        # A limit on address space leaves no room for the sanitizer's own.
        GTEST_FILTER=-SpareMemory.FollowsTheLimitsOfTheProcess run_gtest sanitized-image "$root/build/fuzz/tests/test_image"
        cat "$logs/sanitized-image.log" >>"$log"
        read -r passed failed skipped <"$logs/sanitized-image.count"
        [ "$failed" = 0 ] || explain_failure "$logs/sanitized-image.log" >>"$logs/sanitized.failed"
    else
        failed=1
        tail -n 30 "$log" >>"$logs/sanitized.failed"
    fi
    for target in gltf:20000 pictures:40000 ies:40000; do
        if timeout --kill-after=10 1500 sh scripts/fuzz.sh --runs "${target#*:}" "${target%:*}" \
            >"$logs/fuzz_${target%:*}.log" 2>&1; then
            passed=$((passed + 1))
        else
            failed=$((failed + 1))
            { echo "--- fuzz_${target%:*}"; tail -n 30 "$logs/fuzz_${target%:*}.log"; } >>"$logs/sanitized.failed"
        fi
    done
    echo "$passed $failed $skipped" >"$logs/sanitized.count"
}

# A command that passes or fails: one test.
run_command() { # NAME COMMAND…
    local counts="1 0 0"
    "${@:2}" >"$logs/$1.log" 2>&1 || counts="0 1 0"
    echo "$counts" >"$logs/$1.count"
}

# The tests of the Python module, by the system's interpreter.
run_python() {
    local log=$logs/python.log status=0 total bad skipped
    (cd "$root/tests/python" && PYTHONPATH=$build/python PYTHONDONTWRITEBYTECODE=1 timeout --signal=ABRT --kill-after=10 600 \
        /usr/bin/python3 -X faulthandler -m unittest discover -p '*_test.py' >"$log" 2>&1) || status=$?
    total=$(sed -n 's/^Ran \([0-9]*\) tests\? in .*/\1/p' "$log" | tail -n 1)
    skipped=$(sed -n 's/.*(.*skipped=\([0-9]*\).*)$/\1/p' "$log" | tail -n 1)
    bad=$(grep -c -E '^(FAIL|ERROR): ' "$log" || true)
    if [ "$bad" = 0 ] && { [ "$status" != 0 ] || [ "${total:-0}" = 0 ]; }; then
        bad=1
        total=$((${total:-0} + 1))
    fi
    echo "$((total - bad - ${skipped:-0})) $bad ${skipped:-0}" >"$logs/python.count"
}

# What the failed tests wrote, and the end of the log when that says nothing (a crash, the fuzzer).
explain_failure() { # LOG
    local text
    text=$(awk '/\[ RUN      \]/ { test = "" } { test = test $0 "\n" }
                /\[  FAILED  \].*ms\)$/ { printf "%s", test; test = "" }' "$1" |
        cut -c 1-400 | head -n 150)
    if [ -z "$text" ] || ! grep -q '^\[==========\].* ran' "$1"; then
        text+=$(printf '\n--- end of %s\n' "$1"; tail -n 30 "$1")
    fi
    echo "$text"
}

run_one() { # NAME: runs it, then prints its line
    local began=$SECONDS passed failed skipped
    if [ "$1" = sanitized ]; then
        run_sanitized
    elif [ "$1" = docs ]; then # README and docs against the program
        run_command docs scripts/check-docs.sh
    elif [ "$1" = python ]; then # the Python module
        run_python
    elif [ "$1" = slurm ]; then # a sequence as a job array, with tasks that are killed
        run_command slurm tests/slurm/slurm_test.sh
    elif [ "$1" = gpu-report ]; then # packed and run, on a software device
        run_command gpu-report tests/gpu_report/gpu_report_test.sh
    elif [ "$1" = package ]; then # what is installed, used as other projects do
        run_command package tests/package/package_test.sh
    elif [ "$1" = clang ]; then # library and program, built by clang, which warns of other things
        run_command clang tests/compilers/clang_test.sh
    elif [ "$1" = pip ]; then # the Python module, built by pip
        run_command pip tests/package/pip_test.sh
    elif [ "$1" = tidy ]; then # clang-tidy with .clang-tidy's list
        run_command tidy scripts/tidy.sh
    elif [ "$1" = format ]; then # all C++ as .clang-format says
        run_command format scripts/format.sh --check
    else
        run_gtest "$1"
    fi
    read -r passed failed skipped <"$logs/$1.count"
    local line
    line=$(printf '%-12s %4d passed, %d failed, %d skipped  (%d s)' \
        "$1" "$passed" "$failed" "$skipped" $((SECONDS - began)))
    if [ "$failed" != 0 ]; then
        line+=$'\n'$(if [ -f "$logs/$1.failed" ]; then cat "$logs/$1.failed"; else explain_failure "$logs/$1.log"; fi)
    elif [ "$skipped" != 0 ]; then
        line+=$'\n'$(grep -A 1 'Skipped$' "$logs/$1.log" | grep -v -e 'Skipped$' -e '^--$' |
            sort | uniq -c | sed 's/^/  skipped: /' || true)
    fi
    echo "$line"
}

for name in "${names[@]}"; do
    while [ "$(jobs -rp | wc -l)" -ge $jobs ]; do
        wait -n || true
    done
    run_one "$name" &
done
wait

passed=0 failed=0 skipped=0
for name in "${names[@]}"; do
    read -r p f s <"$logs/$name.count" || { p=0 f=1 s=0; }
    passed=$((passed + p)) failed=$((failed + f)) skipped=$((skipped + s))
done
line="$passed passed, $failed failed"
[ "$skipped" != 0 ] && line+=", $skipped skipped"
echo "$line"
[ "$failed" = 0 ] && [ "$passed" != 0 ]
