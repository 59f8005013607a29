#!/usr/bin/env bash
# scripts/gpu-report.sh packs, and what it packed runs by itself and reports, on a software device.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() {
    echo "FAILED: $1" >&2
    exit 1
}
refuses() { # WHAT ARGUMENTS…
    local status=0
    "$root/scripts/gpu-report.sh" "${@:2}" >"$folder/refused" 2>&1 || status=$?
    [ $status = 2 ] || fail "$1: exit status $status"
}
refuses "no command"
refuses "an option that is none" run --speed 3
refuses "a budget that is none" run --budget soon
refuses "a part that is none" run --parts "pictures stars"

"$root/scripts/gpu-report.sh" pack "$folder/report.tar.gz"
tar -C "$folder" -xzf "$folder/report.tar.gz"
cd "$folder/prelight-gpu-report"
if LD_LIBRARY_PATH=lib ldd bin/prelight bin/test_render | grep "not found"; then fail "libraries are missing"; fi
./gpu-report.sh run --device cpu --budget 150 --frames 1 --size 96x54 --parts "pictures culling" --tests 'Billboards.Soft*:Billboards.ACamera*'
python3 - <<'END'
import json

report = json.load(open("report/report.json"))
pictures = report["pictures"]
assert pictures["passed"] == pictures["announced"] == 2 and pictures["failed"] == 0, pictures
assert pictures["validation"] == "on", pictures
assert set(report["benches"]) == {"culling"}, report["benches"].keys()
for bench in report["benches"].values():
    assert bench["runs"], bench
assert "llvmpipe" in report["device"], report["device"]
assert report["left_out"] == [], report["left_out"]
END
grep -q "GPU report" report/report.html || fail "the page"
[ -s report/benches.html ] || fail "the page of the benches"

# A test that fails, and time that is not there, are told and end nothing.
./gpu-report.sh run --device cpu --budget 2 --size 96x54 --parts "pictures culling" --tests 'No.Such' --out other
python3 - <<'END'
import json

report = json.load(open("other/report.json"))
assert report["pictures"]["state"] == "failed", report["pictures"]
assert any("picture tests" in line for line in report["left_out"]), report["left_out"]
END
echo "gpu-report: passed"
