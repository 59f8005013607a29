#!/usr/bin/env bash
# Makes every picture of docs/pictures/ anew with the program: scripts/pictures.sh [FOLDER]
# Needs ImageMagick (`convert`) for making them smaller; everything else comes from the program.
# Look at each picture afterwards. None may be larger than 400 KiB.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
prelight=${PRELIGHT:-build/release/prelight}
out=${1:-docs/pictures}
if ! command -v convert >/dev/null; then
    echo "pictures: needs convert (Debian package imagemagick)" >&2
    exit 1
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$out"

shrink() { # NAME: half the size
    convert "$work/$1.png" -filter box -resize 50% -strip -define png:compression-level=9 "$out/$1.png"
}
keep() { # NAME
    convert "$work/$1.png" -strip -define png:compression-level=9 "$out/$1.png"
}
few_colours() { # NAME [WHAT BEFORE …]: with 256 of them, for pictures of textures
    convert "$work/$1.png" "${@:2}" -strip -dither FloydSteinberg -colors 256 -define png:compression-level=9 "PNG8:$out/$1.png"
}

# The city and all its buffers.
views=(depth normal roughness diffuse-light specular-light albedo light-count)
arguments=()
for view in "${views[@]}"; do
    arguments+=(--view "$view=$work/city-$view.png")
done
"$prelight" render city --lights 1024 --size 1280x720 -o "$work/city.png" "${arguments[@]}"
for view in "${views[@]}"; do
    shrink "city-$view"
done
convert "$work/city.png" -filter box -resize 50% -strip -define png:compression-level=9 "$out/city-final.png"
# At full size it fits 400 KiB with 256 colours and a little dithering.
convert "$work/city.png" -strip -dither FloydSteinberg -define dither:diffusion-amount=40% -colors 256 \
    -define png:compression-level=9 "PNG8:$out/city.png"

# The window, from its test: a selected light among the panels.
if tests/window/session.sh "$prelight" "$work/session" >/dev/null; then
    convert "$work/session/panels.png" -crop 800x500+0+0 +repage "$work/view.png"
    few_colours view
fi

# What deferred shading keeps of it.
"$prelight" render city --lights 1024 --size 1280x720 --renderer deferred -o "$work/deferred-final.png" \
    --view normal="$work/deferred-normal.png" --view albedo="$work/deferred-albedo.png" \
    --view specular="$work/deferred-specular.png"
for view in final normal albedo specular; do
    shrink "deferred-$view"
done

# A camera that flies past objects that move, bend and morph.
"$prelight" render motion --time 1.3 --camera flight --size 640x360 --renderer deferred -o "$work/deferred-moving.png" \
    --view motion="$work/deferred-motion.png"
keep deferred-moving
keep deferred-motion

# Few lights on a pixel: the circles in which volumes meet surfaces.
"$prelight" render lights --lights 256 --size 640x360 -o "$work/lights.png" \
    --view light-count="$work/lights-light-count.png"
keep lights
keep lights-light-count

# Edges as they come, blurred, and by SMAA.
for how in none edge-blur smaa; do
    "$prelight" render shadows --size 640x360 --set antialiasing=$how -o "$work/anti-aliasing-$how.png"
done
convert "$work"/anti-aliasing-{none,edge-blur,smaa}.png -crop 100x100+250+90 +repage -scale 300% \
    -bordercolor white -border 4x0 +append "$work/anti-aliasing.png"
keep anti-aliasing

# A street as it comes, by SMAA, and with four samples a pixel.
street() { "$prelight" render city --lights 256 --size 640x360 "$@"; }
street --msaa 1 -o "$work/street-one.png"
street --set antialiasing=smaa -o "$work/street-smaa.png"
street --msaa 4 --set msaa-light=pixel -o "$work/street-pixel.png"
street --msaa 4 -o "$work/street-edges.png"
convert "$work"/street-{one,smaa,pixel,edges}.png -crop 60x68+232+148 +repage -scale 400% \
    -bordercolor white -border 3x0 +append "$work/samples.png"
keep samples

# Leaves and wires, likewise, and from four times as many pixels.
"$(dirname "$prelight")/examples/example_edge_error" --scenes "$work"
zoom() { # SCENE WHERE
    local thin=("$prelight" render "$work/$1.glb")
    "${thin[@]}" --size 640x360 --msaa 1 -o "$work/$1-one.png"
    "${thin[@]}" --size 640x360 --set antialiasing=smaa -o "$work/$1-smaa.png"
    "${thin[@]}" --size 640x360 --msaa 4 -o "$work/$1-four.png"
    "${thin[@]}" --size 1280x720 --msaa 1 -o "$work/$1-twice.png"
    convert "$work/$1-twice.png" -colorspace RGB -filter box -resize 50% -colorspace sRGB "$work/$1-twice.png"
    convert "$work/$1"-{one,smaa,four,twice}.png -crop "$2" +repage -scale 400% \
        -bordercolor white -border 3x0 +append "$work/samples-$1.png"
    few_colours "samples-$1"
}
zoom leaves 60x68+240+100
zoom wires 60x68+510+160

# Shadows where each surface of an edge is lit, and once a pixel.
for way in sample pixel; do
    "$prelight" render shadows --size 640x360 --msaa 4 --set shadows=on --set msaa-shadows=$way -o "$work/once-$way.png"
done
convert "$work"/once-{sample,pixel}.png -crop 60x40+130+130 +repage -scale 600% \
    -bordercolor white -border 3x0 +append "$work/samples-shadows.png"
keep samples-shadows

# Inferred lighting: what does not get better than the light's resolution.
street --msaa 1 --renderer inferred --set inferred-scale=1 -o "$work/inferred-street-one.png"
street --msaa 1 --renderer inferred --set inferred-scale=1/2 -o "$work/inferred-street-half.png"
layers() { "$prelight" render glass --lights 64 --size 640x360 --msaa 1 "$@"; }
layers --set transparency=lists -o "$work/inferred-glass-one.png"
layers --renderer inferred --set inferred-scale=1/2 -o "$work/inferred-glass-half.png"
pair() { # SCENE WHERE NAME
    convert "$work/inferred-$1-one.png" "$work/inferred-$1-half.png" -crop "$2" +repage -filter point -resize 300% \
        -bordercolor white -border 4x0 +append "$work/$3.png"
    keep "$3"
}
pair street 110x90+230+245 inferred-normals
pair glass 110x90+325+100 inferred-layers
pair glass 110x120+170+70 inferred-slots

# What the forward renderers have: depth, and colour that lights are added to.
for renderer in multipass z-prepass; do
    "$prelight" render lights --lights 64 --size 640x360 --renderer $renderer -o "$work/$renderer-final.png" \
        --view depth="$work/$renderer-depth.png" --view light-count="$work/$renderer-light-count.png"
    for view in final depth light-count; do
        keep "$renderer-$view"
    done
done

# Roughness from left to right, metalness from bottom to top; the light buffer has no materials.
"$prelight" render spheres --size 640x360 --exposure 0.5 -o "$work/spheres.png" \
    --view diffuse-light="$work/spheres-diffuse-light.png" \
    --view specular-light="$work/spheres-specular-light.png"
keep spheres
keep spheres-diffuse-light
keep spheres-specular-light
"$prelight" render spheres --size 640x360 --shading phong --exposure -1 -o "$work/spheres-phong.png"
keep spheres-phong

# Shadows of every kind of light, beside shadow rays; the filters at a place where things touch.
"$prelight" render shadows --size 640x360 --set shadows=on -o "$work/shadows.png"
"$prelight" render shadows --size 640x360 --set shadows=on --renderer reference -o "$work/shadows-reference.png"
for filter in pcf contact; do
    "$prelight" render shadows --camera pole --size 640x360 --set shadows=on --set shadow-filter=$filter -o "$work/shadows-$filter.png"
    keep shadows-$filter
done
keep shadows
keep shadows-reference
"$prelight" render city --set shadows=on --size 640x360 -o "$work/city-shadows.png"
few_colours city-shadows

# Cookies and profiles of lights.
"$prelight" render cookies --size 640x360 -o "$work/cookies.png"
"$prelight" render cookies --size 640x360 --renderer reference -o "$work/cookies-reference.png"
"$prelight" render cookies --size 640x360 --set shadows=on -o "$work/cookies-shadows.png"
"$prelight" render cookies --size 640x360 --camera wall -o "$work/cookies-wall.png"
for name in cookies cookies-reference cookies-shadows cookies-wall; do
    keep $name
done

# Blended surfaces; where panes cross, object by object beside the reference.
"$prelight" render glass --size 960x540 -o "$work/glass.png"
"$prelight" render glass --camera panes --size 640x360 -o "$work/panes-sorted.png"
"$prelight" render glass --camera panes --size 640x360 --renderer reference -o "$work/panes-layers.png"
convert "$work"/panes-{sorted,layers}.png -crop 320x360+160+0 +repage -bordercolor white -border 2x0 +append "$work/glass-order.png"
keep glass
keep glass-order

# Every built-in material on the same sphere; deferred shading knows one. And a user's own.
for renderer in light-prepass deferred; do
    "$prelight" render materials --size 960x540 --renderer $renderer -o "$work/materials-$renderer.png"
done
mv "$work/materials-light-prepass.png" "$work/materials.png"
keep materials
keep materials-deferred
# The first GLSL of the page, as a reader types it.
awk '/^```/ { if (inside) exit; inside = /glsl/; next } inside' docs/materials.md > "$work/toon.glsl"
"$prelight" render materials --size 640x360 --material metallic-roughness="$work/toon.glsl" \
    --material skin="$work/toon.glsl" --material "normal map=$work/toon.glsl" -o "$work/materials-toon.png"
keep materials-toon

# Decals.
for camera in front close; do
    "$prelight" render decals --camera $camera --time 1 --size 960x540 -o "$work/decals-$camera.png"
done
mv "$work/decals-front.png" "$work/decals.png"
keep decals
shrink decals-close

# Sparks, and fake indirect light.
for time in 1 1.8; do
    "$prelight" render city-sparks --time $time --size 960x540 -o "$work/sparks-$time.png"
    convert "$work/sparks-$time.png" -crop 560x330+180+210 +repage -strip -dither FloydSteinberg -colors 256 \
        -define png:compression-level=9 "PNG8:$work/small-$time.png"
done
mv "$work/small-1.png" "$out/city-sparks.png"
mv "$work/small-1.8.png" "$out/city-sparks-later.png"
"$prelight" render city-smoke --time 3 --size 960x540 -o "$work/city-smoke.png"
shrink city-smoke
"$prelight" render bounce --set shadows=on --size 960x540 -o "$work/bounce.png"
"$prelight" render bounce --set shadows=on --lights 1 --size 960x540 -o "$work/bounce-without.png"
shrink bounce
shrink bounce-without
# A sky that ImageMagick paints: roughness from left to right, metalness from bottom to top, and no lamp.
convert \( -size 1024x256 gradient:'#2f5fb0-#dfe8f2' \) \( -size 1024x256 gradient:'#6a5f50-#2e2a25' \) -append \
    -fill white -draw 'circle 660,130 676,130' -blur 0x2 -depth 8 "$work/sky.png"
"$prelight" render spheres --lights 1 --environment "$work/sky.png" --size 640x360 --exposure 0.5 -o "$work/environment.png"
keep environment

# Ambient occlusion of the city from depth and normals, and below it by rays.
"$prelight" render city --lights 1 --size 640x360 --set ssao=half -o "$work/unused.png" --view ambient-occlusion="$work/ssao-half.png"
"$prelight" render city --lights 1 --size 640x360 --renderer reference -o "$work/unused.png" --view ambient-occlusion="$work/ssao-rays.png"
convert "$work/ssao-half.png" "$work/ssao-rays.png" -append "$work/ssao.png"
keep ssao

"$prelight" sequence city-sparks --frames-at 80 --size 480x270 -o "$out/moving-sparks.png"

# Every scene that others made, as it shows without an option.
shared=${PRELIGHT_SHARED_SCENES:-../shared/scenes}
if [ -d "$shared" ]; then
    tiles=()
    for file in "$shared"/*.glb; do
        name=$(basename "$file" .glb)
        "$prelight" render "$file" --size 480x270 -o "$work/$name.png" 2> /dev/null > "$work/said"
        label=$name$(sed -n 's/^exposure: auto is --exposure /, EV /p; s/^environment: studio.*/, studio/p' "$work/said" | tr -d '\n')
        tiles+=(-label "$label" "$work/$name.png")
    done
    "$prelight" sequence "$shared/CesiumMan.glb" --lights 256 --environment studio --exposure -1 --frames-at 20 --size 480x270 \
        -o "$out/moving-walk.png"
    "$prelight" render "$shared/LightsPunctualLamp.glb" -o "$work/whole-lamp.png"
    convert "$work/whole-lamp.png" -gravity center -crop 480x640+0+0 +repage "$work/lamp.png"
    keep lamp
    hall=$(dirname "$prelight")/examples/example_shadowed_hall
    "$hall" "$shared/sponza-512.glb" "$work/sponza-shadows.png"
    "$hall" "$shared/sponza-512.glb" "$work/sponza-shadows-reference.png" reference
    few_colours sponza-shadows -filter box -resize 50%
    few_colours sponza-shadows-reference -filter box -resize 50%
    montage "${tiles[@]}" -resize 240x135 -geometry +4+4 -tile 6x -background '#202020' -fill '#c8c8c8' -font DejaVu-Sans -pointsize 10 "$work/sheet.png"
    convert "$work/sheet.png" -strip -dither FloydSteinberg -define dither:diffusion-amount=40% -colors 256 \
        -define png:compression-level=9 "PNG8:$out/contact-sheet.png"
fi

too_large=$(find "$out" -name '*.png' -size +400k)
if [ -n "$too_large" ]; then
    printf 'pictures: larger than 400 KiB:\n%s\n' "$too_large" >&2
    exit 1
fi
