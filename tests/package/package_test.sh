#!/usr/bin/env bash
# Installs the built library, component by component, and Debian packages of it; then builds examples/embed on what was
# installed, as other projects do: by find_package and by pkg-config, shared and static. All of them must draw the same bytes.
#   tests/package/package_test.sh [BUILD]
# The Python module is used from its package.
# Needs everything built; nothing outside of a temporary folder changes.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=$(realpath "${1:-$root/build/release}")
folder=$(mktemp -d /tmp/prelight-package.XXXXXX)
trap 'rm -rf "$folder"' EXIT
log=$folder/log
example=$root/examples/embed
number() { sed -n "s/^#define PRELIGHT_$1 //p" "$root/include/prelight/version.hpp"; }
version=$(number VERSION_MAJOR).$(number VERSION_MINOR).$(number VERSION_PATCH)
soversion=$(number SOVERSION)
cd "$folder"

fail() {
    echo "FAILED: $1" >&2
    [ -s "$log" ] && tail -n 30 "$log" >&2
    exit 1
}
step() { # TEXT COMMAND…: a command that must succeed, without its words when it does
    "${@:2}" >"$log" 2>&1 || fail "$1"
    echo "$1"
}
refused() { # TEXT WHY COMMAND…: a command that must fail, and say why
    if "${@:3}" >"$log" 2>&1; then fail "$1: was not refused"; fi
    tr '\n' ' ' <"$log" | tr -s ' ' | grep -qF -- "$2" || fail "$1: without saying '$2'"
    echo "$1"
}
same_lines() { # TEXT EXPECTED ACTUAL
    diff <(echo "$2" | sort) <(echo "$3" | sort) >"$log" || fail "$1"
    echo "$1"
}
draw() { # PROGRAM NAME: the example's pictures, into pictures/NAME
    mkdir -p "pictures/$2"
    (cd "pictures/$2" && "$folder/$1")
}
needs() { readelf -d "$1" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p'; }

# 1. The binary interface.
step "rules of the binary interface" python3 "$root/tests/package/abi_test.py"
step "the shared library is what packaging/abi lists" "$root/scripts/abi.py" --library "$build/src/libprelight.so"
echo 'namespace prelight { int added() { return 1; } }' >other.cpp
g++ -shared -fPIC -o libprelight.so other.cpp
refused "another library is not" "+ symbol prelight::added()" "$root/scripts/abi.py" --library libprelight.so

# 2. What is installed. The folder is moved before it is used.
for component in runtime development program python; do
    step "cmake --install, $component" cmake --install "$build" --component $component --prefix "$folder/$component"
done
files() { (cd "$1" && find . ! -type d | sed 's|^\./||'); }
same_lines "what programs need to run" "lib/libprelight.so.$soversion
lib/libprelight.so.$version
share/doc/libprelight$soversion/copyright" "$(files runtime)"
same_lines "what developers need" "lib/libprelight.a
lib/libprelight.so
lib/pkgconfig/prelight.pc
$(printf 'lib/cmake/prelight/%s.cmake\n' prelightConfig prelightConfigVersion PrelightDependencies PrelightPackages \
    prelight-{static,shared}{,-release})
$(cd "$root" && find include/prelight -name '*.hpp')
share/doc/libprelight-dev/copyright" "$(files development)"
same_lines "the program" "bin/prelight
share/doc/prelight/copyright
share/man/man1/prelight.1
$(program/bin/prelight --help | sed -n '/^Commands:/,/^$/s|^  \([a-z][a-z]*\) .*|share/man/man1/prelight-\1.1|p')
share/bash-completion/completions/prelight
share/fish/vendor_completions.d/prelight.fish
share/zsh/vendor-completions/_prelight" "$(files program)"
step "completion for bash is a script" bash -n program/share/bash-completion/completions/prelight
for shell in zsh fish; do # where there is one
    [ -z "$(type -P $shell)" ] || step "completion for $shell is a script" $shell -n program/share/$shell/*/*prelight*
done
if type -P man groff >/dev/null; then
    for page in program/share/man/man1/*; do
        groff -man -ww -z -Tutf8 "$page" >"$log" 2>&1 || fail "$page"
        [ ! -s "$log" ] || fail "$page: warnings"
    done
    echo "manual pages"
fi
same_lines "the Python module" "share/doc/python3-prelight/copyright
$(printf 'lib/python3/dist-packages/prelight/%s\n' __init__.py _figures.pyi _prelight.pyi py.typed \
    "_prelight$(/usr/bin/python3 -c 'import sysconfig; print(sysconfig.get_config_var("EXT_SUFFIX"))')")" "$(files python)"
mkdir moved
cp -a runtime/. development/. program/. python/. moved/
rm -r runtime development program python
prefix=$folder/moved
if grep -rlF -e "$root/" -e "$build" "$prefix" >"$log"; then fail "what is installed names the folder it was built in"; fi
[ "$(needs "$prefix/bin/prelight" | grep -c prelight)" = 0 ] || fail "the program needs a library that is not in its package"
step "the installed program" "$prefix/bin/prelight" --version
grep -qx "prelight $version" "$log" || fail "the version of the installed program"

# 3. find_package.
export CMAKE_PREFIX_PATH=$prefix CMAKE_GENERATOR=Ninja
unset CMAKE_BUILD_TYPE BUILD_SHARED_LIBS
for form in shared static; do
    on=$([ $form = shared ] && echo ON || echo OFF)
    step "find_package, $form" cmake -S "$example" -B cmake-$form -DBUILD_SHARED_LIBS=$on -DCMAKE_EXPORT_COMPILE_COMMANDS=ON
    step "built with CMake, $form" cmake --build cmake-$form
    step "run, $form" draw cmake-$form/embed cmake-$form
done
needs cmake-shared/embed | grep -qx "libprelight.so.$soversion" || fail "linked to the shared library's SONAME"
if needs cmake-static/embed | grep -q prelight; then fail "linked to the archive"; fi
sed 's/find_package(prelight .*/find_package(prelight ${WANTED} REQUIRED)/' "$example/CMakeLists.txt" >CMakeLists.txt
cp "$example/main.cpp" .
refused "another minor version" "requested version \"0.1\"" cmake -S . -B refused -DWANTED=0.1
refused "an unknown form" "shared or static" cmake -S . -B refused "-DWANTED=COMPONENTS;dynamic"
mv "$prefix/lib/cmake/prelight/prelight-static.cmake" .
refused "a form that is not installed" "the static form of Prelight is not installed" \
    cmake -S . -B refused "-DWANTED=COMPONENTS;static"
mv prelight-static.cmake "$prefix/lib/cmake/prelight/"
refused "the static form without libraries that it is made of" "Prelight: spng is missing or too old: libspng-dev (Debian), libspng-devel (Fedora)" \
    env PKG_CONFIG_LIBDIR=/nowhere cmake -S . -B refused "-DWANTED=COMPONENTS;static"

# 4. Debian packages, unpacked beside the system.
step "cpack -G DEB" cpack -G DEB --config "$build/CPackConfig.cmake" -B "$folder/packages" -D CPACK_DEBIAN_COMPRESSION_TYPE=none
for package in libprelight$soversion libprelight-dev prelight python3-prelight; do
    deb=$(echo packages/${package}_*.deb)
    [ -f "$deb" ] || fail "$package: no package"
    [ "$(dpkg-deb -f "$deb" Version)" = "$version" ] || fail "$package: another version"
    step "$package: unpacked" dpkg -x "$deb" system
    dpkg-deb -f "$deb" Depends >"$package.depends"
done
same_lines "packages hold what is installed" "$(files "$prefix")" "$(files system/usr)"
grep -q 'libembree3' libprelight$soversion.depends || fail "libprelight$soversion: depends on its libraries"
grep -q "libprelight$soversion (= $version)" libprelight-dev.depends || fail "libprelight-dev: depends on the library"
if grep -q libprelight prelight.depends; then fail "prelight: needs no other package of ours"; fi
grep -q "libprelight$soversion (= $version)" python3-prelight.depends || fail "python3-prelight: depends on the library"
grep -q 'python3 (>= 3.*python3-numpy' python3-prelight.depends || fail "python3-prelight: depends on Python and numpy"
export LD_LIBRARY_PATH=$folder/system/usr/lib
step "the packaged program" system/usr/bin/prelight render lights --lights 16 --size 64x36 --msaa 1 -o program.png
step "the packaged program, city" system/usr/bin/prelight render city --lights 16 --size 64x36 --msaa 1 -o city.png
as_python() { # FOLDER SCENE PICTURE: a picture by the module that lies there, and nothing else of ours on Python's path
    env PYTHONPATH="$1" PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 -c "import prelight
assert prelight.__file__.startswith('$1/'), prelight.__file__
picture = prelight.render(prelight.make_scene('$2', lights=16), width=64, height=36)
prelight.save_png(picture, '$3')"
}
step "the packaged module, city" as_python "$folder/system/usr/lib/python3/dist-packages" city python.png
cmp -s city.png python.png || fail "the packaged module draws other bytes than the program"

# 5. pkg-config, on the unpacked packages. The archive may also become part of somebody's own shared library.
export PKG_CONFIG_PATH=$folder/system/usr/lib/pkgconfig
flags() { pkg-config "$@" prelight; }
[ "$(flags --modversion)" = "$version" ] || fail "pkg-config: another version"
[ "$(flags --cflags --libs | tr ' ' '\n' | grep -c .)" = 3 ] || fail "pkg-config: more than a program needs: $(flags --cflags --libs)"
for header in "$root"/include/prelight/*.hpp; do echo "#include <prelight/${header##*/}>"; done >headers.cpp
cat "$example/main.cpp" >>headers.cpp
step "all public headers, without a warning" g++ -std=c++20 -O1 -fPIC -Wall -Wextra -Wpedantic -Werror -c headers.cpp $(flags --cflags)
static=$(flags --static --libs)
static=${static/-lprelight/-l:libprelight.a}
refused "glm's types in another shape" "without GLM_FORCE_CTOR_INIT" \
    g++ -std=c++20 -fsyntax-only -DGLM_FORCE_CTOR_INIT main.cpp $(flags --cflags)
step "linked with pkg-config, shared" g++ -o pkg-shared headers.o $(flags --libs)
step "linked with pkg-config, static" g++ -o pkg-static headers.o $static
if needs pkg-static | grep -q prelight; then fail "linked to the archive"; fi
step "the archive in a shared library" g++ -shared -o libtheirs.so headers.o $static -Wl,-z,defs
for form in shared static; do
    step "run, pkg-config, $form" draw pkg-$form pkg-$form
done
for picture in pictures/*/*.png; do
    cmp -s "$picture" "pictures/cmake-shared/${picture##*/}" || fail "$picture: other bytes than pictures/cmake-shared"
done
[ "$(echo pictures/*/*.png | wc -w)" = 8 ] || fail "not all have drawn"
echo "eight pictures, the same bytes from every form"

# 6. add_subdirectory.
# What the build is made of, each thing hidden: a line each, with the package that scripts/packages.txt installs.
hidden=(-DCMAKE_IGNORE_PATH="/usr/lib/$(gcc -print-multiarch);/lib/$(gcc -print-multiarch)" -DPRELIGHT_WINDOW=ON)
for name in glm Vulkan fmt simdjson draco meshoptimizer embree OpenEXR SPNG libdeflate JPEG WebP nlohmann_json CLI11 glfw3 \
    imgui GTest ZLIB unofficial-shaderc; do
    hidden+=("-DCMAKE_DISABLE_FIND_PACKAGE_$name=ON")
done
refused "a build without all that it is made of" \
    "draco is missing or too old: libdraco-dev (Debian), draco-devel (Fedora), draco (Arch), draco (Homebrew), draco (vcpkg)" \
    env PKG_CONFIG_LIBDIR=/nowhere cmake -S "$root" -B hidden "${hidden[@]}"
sed -n 's/^ *Prelight: .* is missing or too old: \([^ ]*\) (Debian).*/\1/p' "$log" >missing
[ "$(wc -l <missing)" = 19 ] || fail "not a line for each"
while read -r package; do
    grep -q "^$package\b" "$root/scripts/packages.txt" || fail "$package: is not in scripts/packages.txt"
done <missing
same_lines "docs/building.md has the packages of cmake/PrelightPackages.cmake" \
    "$(sed -n 's/^    "\([^"]*\)")*$/\1/p' "$root/cmake/PrelightPackages.cmake" | tr -s ' ')" \
    "$(sed -n '/^## What it is made of/,/^## What was run/s/^| \([a-zA-Z0-9-]*\) |[^|]*| \(.*\) |$/\1 \2/p' "$root/docs/building.md" |
        sed 's/[`|]//g; s/–/-/g' | tr -s ' ' | sed '/^---/d')"
step "a library without a config for CMake, by pkg-config" cmake -S "$root" -B by-module -DCMAKE_DISABLE_FIND_PACKAGE_fmt=ON \
    -DCMAKE_DISABLE_FIND_PACKAGE_CLI11=ON -DPRELIGHT_TESTS=OFF
for form in static shared; do
    on=$([ $form = shared ] && echo ON || echo OFF)
    step "add_subdirectory, $form" cmake -S "$root/tests/package/subproject" -B sub-$form -DPRELIGHT="$root" -DBUILD_SHARED_LIBS=$on
    same_lines "only targets that the library needs, $form" "compile_shaders
prelight_flags
prelight_image
prelight_materials
prelight_options
prelight_reference
prelight_render
prelight_scene
prelight_$form
prelight_platform
prelight_precompiled
prelight_text
prelight_timing" "$(tr ';' '\n' <sub-$form/targets.txt)"
done
same_lines "the caller's variables are as they were" "CMAKE_CXX_STANDARD=
CMAKE_CXX_FLAGS_RELEASE=-O3 -DNDEBUG
CMAKE_MODULE_PATH=
CMAKE_FIND_PACKAGE_TARGETS_GLOBAL=" "$(cat sub-static/variables.txt)"
same_lines "the caller's flags are its own" "-I$root/include
-std=gnu++20" "$(python3 -c '
import json, re
for entry in json.load(open("sub-static/compile_commands.json")):
    if entry["file"].endswith("examples/embed/main.cpp"):
        command = re.sub(r" -o .*", "", entry["command"]).split()
        print("\n".join(word for word in command if word.startswith("-")))')"
