#!/usr/bin/env bash
# Figures from a machine with a GPU, made without building anything there.
#   scripts/gpu-report.sh pack FILE.tar.gz [SCENE.glb…]    here, after scripts/build.sh --tests: the program, the picture tests, the libraries they need, and scenes
#   ./gpu-report.sh run [OPTIONS]                          there, in the unpacked folder: picture tests, then benches, then one JSON and a page
#     --device NAME       as prelight takes it (auto)        --budget SECONDS   for all of it (440)
#     --out FOLDER        what is written (report)           --size WxH         of the benches (1280x720)
#     --frames N          of each contender, at most (100)
#     --parts LIST        of: pictures lights culling shading city files shadows geometry
#     --tests FILTER      of the picture tests, as GoogleTest has it
# The other machine needs a Vulkan driver and a C library as new as this one's. The validation layer goes along where it is here.
# Exit status: 0 the report is written, whatever it says; 1 it is not; 2 wrong usage.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

usage() {
    echo "gpu-report: $1" >&2
    sed -n '2,11s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
    exit 2
}

# Those a program is linked to, but for the C library's own and the driver's side of Vulkan.
libraries_of() {
    ldd "$@" | sed -n 's/.* => \(\/[^ ]*\) .*/\1/p' | sort -u | grep -vE '/(libc|libm|libdl|librt|libpthread|libvulkan)\.so'
}

pack() {
    [ $# -ge 1 ] || usage "pack: where to?"
    local out=$1 build=$here/../build/release scene
    shift
    for program in prelight tests/test_render; do
        [ -x "$build/$program" ] || { echo "gpu-report: $build/$program is not there: scripts/build.sh --tests builds it" >&2; exit 1; }
    done
    for scene in "$@"; do
        [ -f "$scene" ] || { echo "gpu-report: $scene: no such file" >&2; exit 1; }
    done
    folder=$(mktemp -d)
    trap 'rm -rf "$folder"' EXIT
    mkdir -p "$folder/prelight-gpu-report"/{bin,lib,scenes}
    local from=$PWD
    cd "$folder/prelight-gpu-report"
    cp "$build/prelight" "$build/tests/test_render" bin/
    ! command -v strip >/dev/null || strip bin/*
    libraries_of bin/prelight bin/test_render | xargs -r cp -Lt lib/
    local manifest layer
    manifest=$(find "$build/share/prelight/layers" -name '*.json' 2>/dev/null | head -n 1)
    layer=$(sed -n 's/.*"library_path": *"\(.*\)".*/\1/p' "${manifest:-/dev/null}")
    if [ -f "$layer" ]; then # the program looks for it here
        mkdir -p share/prelight/layers
        cp -L "$layer" lib/
        sed "s|\(\"library_path\": *\"\).*\"|\1../../../lib/${layer##*/}\"|" "$manifest" >share/prelight/layers/layer.json
    fi
    cp "$here/gpu-report.sh" .
    cd "$from"
    [ $# = 0 ] || cp "$@" "$folder/prelight-gpu-report/scenes/"
    tar -C "$folder" -cf - prelight-gpu-report | gzip -3 >"$out.part"
    mv "$out.part" "$out"
    echo "$out: $(du -h "$out" | cut -f1); there: tar xzf, then prelight-gpu-report/gpu-report.sh run"
}

# name, share of the time that is left, what is timed: the arguments of `prelight bench`
parts_of_bench() {
    local prepass=light-prepass
    cat <<END
lights 20 lights --renderers $prepass,deferred,z-prepass@lights=grid,multipass --light-counts 16,256,1024,4096,16384 --limit
culling 12 lights --light-counts 64,1024 --renderers $prepass@light-culling=tiles,$prepass@light-culling=clusters,$prepass@light-culling=volumes,$prepass@light-culling=stencil,$prepass@light-culling=rectangles,$prepass@light-culling=fullscreen
shading 10 lights --light-counts 1024,4096 --renderers $prepass@list-shading=fragment@tile-size=8,$prepass@list-shading=fragment@tile-size=16,$prepass@list-shading=fragment@tile-size=32,$prepass@list-shading=compute@tile-size=8,$prepass@list-shading=compute@tile-size=16
city 12 city --light-counts 64,1024,8192 --renderers $prepass,deferred,z-prepass@lights=grid
shadows 8 city --light-counts 64 --renderers $prepass,$prepass@shadows=on@shadow-filter=hard,$prepass@shadows=on@shadow-filter=pcf,$prepass@shadows=on@shadow-filter=contact
geometry 10 city --light-counts 256 --renderers $prepass,$prepass@index-trimming=host,$prepass@index-trimming=device,$prepass@occlusion=queries,$prepass@material-trimming=depth,$prepass@draws=direct,$prepass@draws=instanced
END
    local scene
    for scene in "$here"/scenes/*.gl*; do
        [ ! -f "$scene" ] || echo "files 8 $scene --light-counts 16,1024 --renderers $prepass,$prepass@texture-filter=trilinear,$prepass@texture-filter=anisotropic,deferred"
    done
}

json_text() { sed 's/\\/\\\\/g; s/"/\\"/g; s/\t/ /g' | tr -d '\r' | tr '\n' ' ' | sed 's/ *$//; s/^/"/; s/$/"/'; }
html_text() { sed 's/&/\&amp;/g; s/</\&lt;/g; s/>/\&gt;/g'; }
now() { date +%s; }

# The picture tests for so many seconds; writes pictures.json.
run_pictures() { # SECONDS
    local log=$out/pictures.log validation=on announced passed failed skipped state=done
    "$prelight" render spheres --size 16x16 --device "$device" --validate -o "$out/probe.png" >"$out/probe.log" 2>&1 || validation=off
    rm -f "$out/probe.png"
    PRELIGHT_TEST_DEVICE=$device PRELIGHT_TEST_VALIDATION=$validation timeout -k 5 "$1" "$here/bin/test_render" --gtest_filter="$tests" \
        --gtest_color=no >"$log" 2>&1 || [ $? != 124 ] || state=cut
    announced=$(sed -n 's/^\[==========\] Running \([0-9]*\) tests*.*/\1/p' "$log" | head -n 1)
    passed=$(grep -c '^\[       OK \] .* ([0-9]* ms)$' "$log" || true)
    failed=$(grep -c '^\[  FAILED  \] .* ([0-9]* ms)$' "$log" || true)
    skipped=$(grep -c '^\[  SKIPPED \] .* ([0-9]* ms)$' "$log" || true)
    [ $state = cut ] || [ $((passed + failed + skipped)) = "${announced:-0}" ] && [ "${announced:-0}" -gt 0 ] || state=failed # it ended early
    [ "$state" = cut ] && left_out+=("$((announced - passed - failed - skipped)) of $announced picture tests: no time was left")
    [ "$state" = failed ] && left_out+=("picture tests: ended early, $(tail -n 1 "$log")")
    {
        printf '{"state": "%s", "validation": "%s", "announced": %s, "passed": %s, "failed": %s, "skipped": %s, "failures": [' \
            $state $validation "${announced:-0}" "$passed" "$failed" "$skipped"
        sed -n 's/^\[  FAILED  \] \(.*\) ([0-9]* ms)$/"\1"/p' "$log" | paste -sd,
        printf ']}\n'
    } >"$out/pictures.json"
    echo "pictures: $passed passed, $failed failed, $skipped skipped of ${announced:-0}; validation $validation"
}

# One bench for about so many seconds; writes NAME.json where it has anything.
run_bench() { # NAME SECONDS SCENE OPTIONS…
    local name=$1 seconds=$2 state=done
    shift 2
    timeout -k 5 $((seconds + 30)) "$prelight" bench "$@" --device "$device" --size "$size" --frames "$frames" --budget "$seconds" --json "$out/$name.json" \
        >"$out/$name.log" 2>&1 || state=failed
    if [ ! -s "$out/$name.json" ]; then
        left_out+=("$name: $(grep -v '^$' "$out/$name.log" | tail -n 1)")
        return
    fi
    files+=("$out/$name.json")
    [ $state = done ] || left_out+=("$name, in part: $(grep -v '^$' "$out/$name.log" | tail -n 1)")
    echo "$name: $state"
}

write_report() {
    local file comma=
    {
        printf '{"prelight_gpu_report": 1, "version": %s, "device": %s,\n "date": "%s", "budget_seconds": %s, "spent_seconds": %s,\n' \
            "$("$prelight" --version | json_text)" "$(json_text <"$out/devices.txt")" "$(date -u +%Y-%m-%dT%H:%M:%SZ)" "$budget" $(($(now) - start))
        printf ' "left_out": ['
        for file in "${left_out[@]}"; do printf '%s%s' "$comma" "$(json_text <<<"$file")" && comma=', '; done
        printf '],\n "pictures": '
        if [ -f "$out/pictures.json" ]; then cat "$out/pictures.json"; else echo null; fi
        printf ', "benches": {'
        comma=
        for file in "${files[@]}"; do
            printf '%s\n"%s": ' "$comma" "$(basename "$file" .json)"
            cat "$file"
            comma=,
        done
        printf '}}\n'
    } >"$out/report.json.part"
    mv "$out/report.json.part" "$out/report.json"
    [ ${#files[@]} = 0 ] || "$prelight" bench report "${files[@]}" -o "$out/benches.html" >>"$out/page.log" 2>&1 || left_out+=("benches.html: $(tail -n 1 "$out/page.log")")
    {
        echo '<!doctype html><meta charset="utf-8"><title>Prelight: GPU report</title><style>body{font:16px/1.5 sans-serif;margin:2rem;max-width:70rem}iframe{width:100%;height:80vh;border:1px solid #999}</style>'
        echo "<h1>GPU report</h1><pre>$(html_text <"$out/devices.txt")</pre>"
        [ ! -f "$out/pictures.json" ] || echo "<h2>Picture tests</h2><pre>$(html_text <"$out/pictures.json")</pre>"
        echo "<h2>Left out</h2><ul>"
        for file in "${left_out[@]}"; do echo "<li>$(html_text <<<"$file")"; done
        echo "</ul>"
        [ ! -f "$out/benches.html" ] || echo '<h2>Benches</h2><iframe src="benches.html"></iframe>'
    } >"$out/report.html"
    echo "report: $out/report.json, $out/report.html"
}

run() {
    device=auto budget=440 out=report size=1280x720 frames=100 parts="pictures lights culling shading city files shadows geometry"
    tests='*RandomScenes.*:*Transparency*:Billboards.*:LayerDecals.*:*Decals.*:Transmission*:*Samples*:*Shadows.*:*Environment*:*Inferred*-*Swift*:*SharedScenes*'
    while [ $# -gt 0 ]; do
        [ $# -ge 2 ] || usage "$1: needs a value"
        case $1 in
        --device) device=$2 ;;
        --budget) [[ $2 =~ ^[1-9][0-9]*$ ]] || usage "--budget $2: not a whole number of seconds" && budget=$2 ;;
        --out) out=$2 ;;
        --size) size=$2 ;;
        --frames) frames=$2 ;;
        --parts) parts=$2 ;;
        --tests) tests=$2 ;;
        *) usage "$1: no such option" ;;
        esac
        shift 2
    done
    local part
    for part in $parts; do
        case " pictures lights culling shading city files shadows geometry " in *" $part "*) ;; *) usage "--parts: $part is none" ;; esac
    done
    prelight=$here/bin/prelight
    export LD_LIBRARY_PATH=$here/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH} XDG_CACHE_HOME=$here/cache
    mkdir -p "$out"
    out=$(cd "$out" && pwd)
    start=$(now)
    left_out=() files=()
    "$prelight" devices >"$out/devices.txt" 2>&1 || { echo "gpu-report: $(tail -n 1 "$out/devices.txt")" >&2; exit 1; }

    local name share rest weight=0 left benches
    benches=$(parts_of_bench)
    wanted() { case " $parts " in *" $1 "*) return 0 ;; *) return 1 ;; esac; }
    while read -r name share rest; do wanted "$name" && weight=$((weight + share)); done <<<"$benches"
    if wanted pictures; then # two fifths of the time, or all of it
        run_pictures $((weight > 0 ? budget * 2 / 5 : budget))
    fi
    local number=0 arguments
    while read -r name share rest; do
        wanted "$name" || continue
        left=$((budget - ($(now) - start)))
        if [ $left -lt 3 ]; then
            left_out+=("$name: no time was left")
            continue
        fi
        read -ra arguments <<<"$rest"
        [ "$name" != files ] || { number=$((number + 1)) && name=file-$number; }
        run_bench "$name" $((left * share / weight > 2 ? left * share / weight : 2)) "${arguments[@]}"
        weight=$((weight - share))
    done <<<"$benches"
    write_report
}

case ${1-} in
pack | run) command=$1 && shift && $command "$@" ;;
*) usage "pack or run?" ;;
esac
