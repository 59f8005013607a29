#!/usr/bin/env bash
# From a fresh machine to a picture: installs what is missing, builds Release, and renders the
# built-in city with 1,024 lights and the buffers it is made of into out/demo/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/setup.sh
scripts/build.sh

out=out/demo
mkdir -p $out
build/release/prelight render city --lights 1024 --size 1280x720 --frames 3 -o $out/city.png \
    --view depth=$out/depth.png --view normal=$out/normal.png \
    --view diffuse-light=$out/diffuse-light.png --view specular-light=$out/specular-light.png \
    --stats $out/city.json

cat <<END

The picture:     $PWD/$out/city.png
depth:           $PWD/$out/depth.png
normals:         $PWD/$out/normal.png
diffuse light:   $PWD/$out/diffuse-light.png
specular light:  $PWD/$out/specular-light.png
figures:         $PWD/$out/city.json
END
