#!/usr/bin/env bash
# A real window, on a screen of its own: input by xdotool, a screenshot that has to hold the bytes that the recording
# gives without a window; a lost surface and a lost device. Exit status 77: a program that this needs is not there.
#   tests/window/session.sh PRELIGHT FOLDER      FOLDER keeps screenshots and recordings
set -euo pipefail
prelight=$(realpath "$1")
here=$(dirname "$(realpath "$0")")
mkdir -p "$2"
cd "$2"
for program in Xvfb xdotool xprop python3 import convert compare; do
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
grep -Eq 'first picture after [0-9]+ ms \(window [0-9]+, scene [0-9]+, renderer [0-9]+, picture [0-9]+\)' view.log ||
    fail "nothing says what the first picture took"
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
number=$(xdotool search --name '^prelight$' | head -n 1)
xdotool windowsize "$number" 700 460
settle
xdotool key Delete
settle 0.5
"$prelight" make spheres --lights 2 -o 'a scene.glb' >/dev/null
"$here/drop.py" "$number" 'a scene.glb' || fail "no file can be dropped"
xdotool key g
rm -f prelight-*.png
xdotool key p # which is there when all before it has been done
for _ in $(seq 600); do
    [ -e prelight-1.png ] && break
    sleep 0.1
done
settle
import -window root last.png
xdotool key Escape
finish
sed -n 's/.* pictures; input was on the screen after \([0-9]*\) at most$/\1/p' view.log >lag
[ -s lag ] || fail "nobody has counted pictures between input and what shows it"
[ "$(cat lag)" -le 2 ] || fail "input was seen $(cat lag) pictures later"

# The picture's bytes are those of the same input without a window.
"$prelight" view multipass --play session.txt -o played.png >/dev/null
for picture in last.png played.png; do # without the message that the screenshot is written
    convert $picture -crop 700x370+0+0 +repage -depth 8 seen-$picture
done
different=$(compare -metric AE seen-last.png seen-played.png null: 2>&1 || true)
[ "$different" = 0 ] || fail "$different pixels of the window differ from those of the recording"
cmp prelight-1.png played.png || fail "the window's own screenshot differs from the recording's"
[ "$(compare -metric AE panels.png normals.png null: 2>&1 || true)" != 0 ] || fail "key 2 shows nothing else"
grep -q 'button left down' session.txt && grep -q 'wheel' session.txt && grep -q 'resize 700 460' session.txt &&
    grep -q 'drop .*a scene.glb' session.txt ||
    fail "not all input was recorded"

# 2. Losses: each is recovered from once. The last step's screenshot is not lost, and is the recording's: also of a
# picture large enough to begin with a draft.
# The wheel goes by where the mouse is, which is also a real one here.
printf '%s\n' 'prelight view 1' 'size 800x500' '20 lose surface' '21 move 500 200' '21 wheel 0 1' '60 lose device' \
    '61 move 500 200' '61 wheel 0 1' '119 screenshot last.png' >loss.txt
# All on a screen of 144 dots an inch, where panels are larger, and pictures are not.
xprop -root -f RESOURCE_MANAGER 8s -set RESOURCE_MANAGER $'Xft.dpi:\t144\n'
mkdir -p losses without
rm -f losses/last.png without/last.png
(cd losses && exec timeout --kill-after=10 120 "$prelight" view multipass --size 800x500 --play ../loss.txt --frames 120 --validate) >view.log 2>&1 ||
    fail "the window of losses ended with $?"
grep -q 'in full after' view.log || fail "no draft came first"
(cd without && exec timeout --kill-after=10 120 "$prelight" view multipass --play ../loss.txt --frames 120 -o played.png) >/dev/null 2>&1 ||
    fail "the recording of losses cannot be played"
cmp losses/last.png without/last.png || fail "the screenshot of the last step is not the recording's"
echo "session: as it should be"
