#!/usr/bin/env bash
# Which suites of tests take how long, by the logs of the last scripts/test.sh, and writes those above two seconds into
# tests/suite_seconds.txt, by which scripts/test.sh makes parts of about the same length.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
cat build/release/test-logs/*.log | awk '
    match($0, /^\[       OK \] .* \([0-9]+ ms\)$/) {
        split($4, name, "."); milliseconds = $0
        sub(/.*\(/, "", milliseconds)
        sum[name[1]] += milliseconds
    }
    END {
        for (suite in sum)
            if (sum[suite] >= 2000)
                printf "%s %.0f\n", suite, sum[suite] / 1000
    }' | LC_ALL=C sort >tests/suite_seconds.txt
sort -k 2 -n -r tests/suite_seconds.txt
