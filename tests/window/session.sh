#!/usr/bin/env bash
# A real window, on a screen of its own: input by xdotool, a screenshot that has to hold the bytes that the recording
# gives without a window; a lost surface and a lost device. Exit status 77: a program that this needs is not there.
#   tests/window/session.sh PRELIGHT FOLDER      FOLDER keeps screenshots and recordings
set -euo pipefail
prelight=$(realpath "$1")
mkdir -p "$2"
cd "$2"
for program in Xvfb xdotool import convert compare; do
    command -v $program >/dev/null || { echo "session: $program is not installed"; exit 77; }
done

exec 3<>display
rm display
Xvfb -displayfd 3 -screen 0 1280x800x24 -nolisten tcp >xvfb.log 2>&1 &
xvfb=$!
window=
stop() {
    [ -z "$window" ] || kill "$window" 2>/dev/null || true
    kill $xvfb 2>/dev/null || true
}
trap stop EXIT
fail() {
    echo "session: $*"
    cat view.log || true
    exit 1
}
for _ in $(seq 100); do
    number=$(head -n 1 /proc/self/fd/3 2>/dev/null || true)
    [ -n "$number" ] && break
    sleep 0.1
done
export DISPLAY=:$number

# Waits for the line that the window's first picture prints.
start() {
    "$prelight" view "$@" --validate >view.log 2>&1 &
    window=$!
    for _ in $(seq 600); do
        grep -q 'first picture' view.log && return
        kill -0 $window 2>/dev/null || fail "ended before its first picture"
        sleep 0.1
    done
    fail "no picture"
}
# The window has ended as it should.
finish() {
    for _ in $(seq 300); do
        if ! kill -0 $window 2>/dev/null; then
            wait $window || fail "exit status $?"
            window=
            return
        fi
        sleep 0.1
    done
    fail "did not end"
}
settle() { sleep "${1:-1.5}"; }

# 1. Input.
start multipass --size 800x500 --record session.txt
xdotool mousemove 600 250
settle 0.5
xdotool mousedown 1
settle 0.3
xdotool mousemove 640 260
settle 0.3
xdotool mousemove 680 240
settle 0.3
xdotool mouseup 1
xdotool click 4
xdotool key Insert
settle
import -window root panels.png
xdotool key 2
settle
import -window root normals.png
xdotool key 2
xdotool key question
settle
import -window root help.png
xdotool key question
xdotool windowsize "$(xdotool search --name '^prelight$' | head -n 1)" 700 460
settle
xdotool key Delete
xdotool key g
settle 2
import -window root last.png
xdotool key Escape
finish

# The picture's bytes are those of the same input without a window.
"$prelight" view multipass --play session.txt -o played.png >/dev/null
convert last.png -crop 700x460+0+0 +repage -depth 8 last.png
different=$(compare -metric AE last.png played.png null: 2>&1 || true)
[ "$different" = 0 ] || fail "$different pixels of the window differ from those of the recording"
[ "$(compare -metric AE panels.png normals.png null: 2>&1 || true)" != 0 ] || fail "key 2 shows nothing else"
grep -q 'button left down' session.txt && grep -q 'wheel' session.txt && grep -q 'resize 700 460' session.txt ||
    fail "not all input was recorded"

# 2. Losses: each is recovered from once.
printf 'prelight view 1\nsize 500x300\n20 lose surface\n21 wheel 0 1\n60 lose device\n61 wheel 0 1\n150 panels off\n' >loss.txt
start multipass --size 500x300 --play loss.txt
settle 5
import -window root lost.png
xdotool mousemove 250 150 key Escape
finish
echo "session: as it should be"
