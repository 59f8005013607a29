#!/usr/bin/env bash
# `pip install .` on an installed library, from Debian's packages alone; the module must draw what the program draws.
#   tests/package/pip_test.sh [BUILD]
# Compiles the module (a minute of one core), so `scripts/test.sh` runs it only when it is named. Nothing outside of a
# temporary folder changes.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=$(realpath "${1:-$root/build/release}")
folder=$(mktemp -d /tmp/prelight-pip.XXXXXX)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
fail() {
    echo "FAILED: $1" >&2
    exit 1
}

for component in runtime development; do
    cmake --install "$build" --component $component --prefix "$folder/installed" >log
done
export CMAKE_PREFIX_PATH=$folder/installed PRELIGHT_BUILD=$folder/build CMAKE_ARGS=-DCMAKE_CXX_FLAGS_RELEASE=-O0
/usr/bin/python3 -m pip install --no-build-isolation --no-deps --no-index --disable-pip-version-check --target site "$root" >log 2>&1 || {
    cat log >&2
    fail "pip install"
}
number() { sed -n "s/^#define PRELIGHT_$1 //p" "$root/include/prelight/version.hpp"; }
version=$(number VERSION_MAJOR).$(number VERSION_MINOR).$(number VERSION_PATCH)
[ "$(echo site/prelight-*.dist-info)" = "site/prelight-$version.dist-info" ] || fail "another version"
readelf -d site/prelight/_prelight*.so | grep -q "NEEDED.*libprelight.so.$(number SOVERSION)" || fail "not linked to the installed library"
PYTHONPATH=site /usr/bin/python3 -c "import prelight
assert prelight.__file__.startswith('$folder/site/') or prelight.__file__.startswith('site/'), prelight.__file__
picture = prelight.render(prelight.make_scene('lights', lights=16), width=64, height=36)
prelight.save_png(picture, 'pip.png')"
"$build/prelight" render lights --lights 16 --size 64x36 --msaa 1 -o program.png
cmp program.png pip.png || fail "the module draws other bytes than the program"
echo "the module that pip built draws what the program draws"
