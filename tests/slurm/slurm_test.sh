#!/usr/bin/env bash
# Starts Slurm on this machine and draws 24 frames in 6 tasks of a job array. Two tasks are killed after two of their four frames;
# the job is submitted again; then all frames must be there, with the bytes of one run. The same frames once more with GNU parallel.
#   tests/slurm/slurm_test.sh [PROGRAM]
# Daemons, their keys and their files live in a temporary folder and listen on 127.0.0.1; nothing of them stays.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
PRELIGHT=$(realpath "${1:-$root/build/release/prelight}")
export PRELIGHT
export PATH=$PATH:/usr/sbin # where daemons are
folder=$(mktemp -d /tmp/prelight-slurm.XXXXXX)
daemons=()

stop_daemons() {
    local pid
    for pid in "${daemons[@]}"; do
        kill "$pid" 2>/dev/null || true
    done
    for pid in "${daemons[@]}"; do
        wait "$pid" 2>/dev/null || true
    done
}
clean_up() {
    if [ "${SLURM_CONF:-}" = "$folder/slurm.conf" ]; then # never the jobs of a cluster that this machine belongs to
        scancel --user "$(id -un)" 2>/dev/null || true
        eventually 10 no_jobs || true
    fi
    stop_daemons
    rm -rf "$folder"
}

fail() {
    {
        echo "FAILED: $1"
        for log in "$folder"/*.log; do
            echo "--- end of ${log##*/}"
            tail -n 15 "$log"
        done
    } >&2
    exit 1
}

eventually() { # SECONDS COMMAND…: until it succeeds
    local end=$((SECONDS + $1))
    until "${@:2}" >/dev/null 2>&1; do
        [ $SECONDS -lt $end ] || return 1
        sleep 0.02
    done
}
no_jobs() { [ -z "$(squeue --noheader 2>/dev/null)" ]; }
node_is_idle() { sinfo --noheader --format %T | grep -qx idle; }

free_ports() { # COUNT
    python3 -c "import socket
sockets = [socket.socket() for _ in range($1)]
for s in sockets: s.bind(('127.0.0.1', 0))
print(*[s.getsockname()[1] for s in sockets])"
}

start_slurm() {
    local host ports user
    host=$(hostname -s) user=$(id -un)
    read -r -a ports < <(free_ports 2)
    mkdir -p "$folder/munge" "$folder/controller" "$folder/node"
    head -c 128 /dev/urandom >"$folder/munge/key"
    chmod 700 "$folder/munge"
    chmod 600 "$folder/munge/key"
    chmod 755 "$folder"
    export SLURM_CONF=$folder/slurm.conf
    cat >"$SLURM_CONF" <<CONF
ClusterName=prelight
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=${ports[0]}
SlurmdPort=${ports[1]}
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket
StateSaveLocation=$folder/controller
SlurmdSpoolDir=$folder/node
SlurmctldPidFile=$folder/controller/pid
SlurmdPidFile=$folder/node/pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SchedulerType=sched/builtin
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
ReturnToService=2
KillWait=2
NodeName=node NodeHostname=$host NodeAddr=127.0.0.1 CPUs=2
PartitionName=all Nodes=node Default=YES MaxTime=INFINITE State=UP
CONF
    munged --foreground --force --key-file="$folder/munge/key" --socket="$folder/munge/socket" \
        --pid-file="$folder/munge/pid" --seed-file="$folder/munge/seed" --log-file="$folder/munged.log" \
        >"$folder/munged-start.log" 2>&1 &
    daemons+=($!)
    eventually 10 test -S "$folder/munge/socket" || fail "munged does not start"
    slurmctld -D -c >"$folder/slurmctld.log" 2>&1 &
    daemons+=($!)
    slurmd -D -N node >"$folder/slurmd.log" 2>&1 &
    daemons+=($!)
    eventually 40 node_is_idle || fail "Slurm does not start"
}

scene=(motion --size 160x90 --fps 6 --frames-at 0-23)

job_is_over() { ! squeue --noheader --job "$1" | grep -q .; }

# Submits the job array and waits. Polls by itself: `sbatch --wait` looks again after 2, 4, 8, 16 and 32 s.
submit() { # FOLDER: prints how many tasks ended with status 0
    local job
    job=$(cd "$folder" && sbatch --parsable --chdir="$folder" --output="$folder/task-%A_%a.log" \
        "$root/examples/slurm/sequence.sbatch" "${scene[@]}" -o "$1/out.####.png")
    eventually 120 job_is_over "$job" || fail "job $job does not end"
    scontrol show job "$job" | grep -c JobState=COMPLETED || true
}

frame_file() { printf '%s/frames/out.%04d.png' "$folder" "$1"; } # NUMBER

# Task I of 6 draws the frames I - 1, I + 5, I + 11, I + 17. In the place of the third lies a full pipe, at which it waits until it is
# killed, so that no kill comes too late.
stop_at_third_frame() { # TASK
    local pipe
    mkfifo "$(frame_file $(($1 + 11)))"
    exec {pipe}<>"$(frame_file $(($1 + 11)))"
    head -c 65536 /dev/zero >&"$pipe"
}
kill_after_second_frame() { # TASK
    local pid
    eventually 60 test -f "$(frame_file $(($1 + 5)))" || return 1
    pid=$(pgrep -f -- "$folder/frames/.* --shard $1/6\$") || return 1
    kill -KILL "$pid"
}

same_frames() { # FOLDER: as in the one run
    [ "$(find "$1" -name 'out.*.png' | wc -l)" = 24 ] || fail "$1: not 24 frames"
    local file
    for file in "$folder"/one/out.*.png; do
        cmp "$file" "$1/${file##*/}" || fail "$1: not the bytes of one run"
    done
}

trap clean_up EXIT
mkdir "$folder/one" "$folder/frames" "$folder/parallel"
start_slurm
echo "Slurm runs after $SECONDS s"

stop_at_third_frame 2
stop_at_third_frame 5
kill_after_second_frame 2 &
killer_2=$!
kill_after_second_frame 5 &
killer_5=$!
completed=$(submit "$folder/frames")
wait $killer_2 || fail "task 2 was not there to be killed"
wait $killer_5 || fail "task 5 was not there to be killed"
[ "$completed" = 4 ] || fail "$completed of 6 tasks ended with status 0, 4 should have"
rm "$(frame_file 13)" "$(frame_file 16)"
echo "two of six tasks killed after $(find "$folder/frames" -name 'out.*.png' | wc -l) of 24 frames, $SECONDS s"

[ "$(submit "$folder/frames")" = 6 ] || fail "the job that was submitted again failed"
"$PRELIGHT" sequence "${scene[@]}" -o "$folder/one/out.####.png" >"$folder/one.log" 2>&1 || fail "the one run failed"
same_frames "$folder/frames"
echo "24 frames with the bytes of one run, $SECONDS s"

TASKS=6 "$root/examples/slurm/parallel.sh" "${scene[@]}" -o "$folder/parallel/out.####.png" >"$folder/parallel.log" 2>&1 ||
    fail "GNU parallel failed"
same_frames "$folder/parallel"
echo "the same with GNU parallel, $SECONDS s"
