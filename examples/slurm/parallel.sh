#!/bin/bash
# The same on one machine with GNU parallel: TASKS (default 4) shards, JOBS (default 2) of them at a time. A shard that fails is tried
# twice more, and goes on where it stopped.
#   TASKS=6 parallel.sh SCENE -o FOLDER/out.####.png [options of `prelight sequence`]
set -euo pipefail
tasks=${TASKS:-4} jobs=${JOBS:-2}
processors=$(nproc)
export LP_NUM_THREADS=$((processors > jobs ? processors / jobs : 1))
seq "$tasks" | parallel --will-cite --quote --line-buffer --jobs "$jobs" --retries 3 \
    "${PRELIGHT:-prelight}" sequence "$@" --skip-existing --shard "{}/$tasks"
