#!/bin/sh
# make_figures.sh [PROGRAM]: makes the figures of the manual and the README anew, from the meshes of CGAL's demos (Debian's
# libcgal-demo, or the folder REGION_SEGMENTATION_REAL_MESHES), by the program (default: build/bin/segment_mesh, where
# examples/run.sh puts it). Installs what is missing. Prints what the program says of each picture.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/.." && pwd)
program=${1:-$root/build/bin/segment_mesh}
figures=$here/Region_segmentation/fig

sh "$root/cmake/install_packages.sh" chromium imagemagick libcgal-demo optipng python3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
meshes=${REGION_SEGMENTATION_REAL_MESHES:-$work}
if [ "$meshes" = "$work" ]; then
  tar -xzf /usr/share/doc/libcgal-dev/data.tar.gz -C "$work"
fi
meshes=$meshes/data/meshes

# view NAME MESH AZIMUTH ELEVATION [OPTION...]: a picture of a mesh without the white around it. The y axis is up; the
# viewer stands at the azimuth around it, from the z axis, and at the elevation above, in degrees.
view() {
  name=$1 mesh=$2 azimuth=$3 elevation=$4
  shift 4
  printf '%s: ' "$name"
  "$program" --quiet "$meshes/$mesh.off" --view "$azimuth" "$elevation" "$@" -o "$work/$name.png" | sed 's/.*: //'
  convert "$work/$name.png" -trim +repage "$work/$name.png"
}

# crop NAME WIDTHxHEIGHT: the lower right part of a view.
crop() {
  convert "$work/$1.png" -gravity southeast -crop "$2+0+0" +repage "$work/$1.png"
}

# mark FILE KIND MESH NUMBER...: marks of mark_mesh.py.
mark() {
  file=$1 kind=$2 mesh=$3
  shift 3
  python3 "$here/mark_mesh.py" "$kind" "$meshes/$mesh.off" "$@" >"$work/$file"
}

# small FROM TO: in 192 colors.
small() {
  convert "$1" +dither -colors 192 "png8:$2"
  optipng -quiet -o5 -strip all "$2"
}

# row FIGURE HEIGHT VIEW...: views side by side, each scaled to one height in pixels.
row() {
  figure=$1 height=$2
  shift 2
  pictures=
  for name in "$@"; do
    pictures="$pictures $work/$name.png"
  done
  convert $pictures -resize "x$height" -bordercolor white -border 12x4 +append "$work/row.png"
  small "$work/row.png" "$figures/$figure.png"
}

rm -f "$figures"/*.png

view camel camel -60 15
view homer homer 20 10
view bear bear 15 10
view triceratops triceratops 30 15
row four_meshes 260 camel homer bear triceratops

view learned elephant 60 15 -k 10
view visibility elephant 60 15 -k 10 --method visibility
view two_step elephant 60 15 -k 10 --method two-step
row methods 260 learned visibility two_step

view too_few homer 20 10 -k 5
view chosen homer 20 10
view too_many homer 20 10 -k 40
row numbers 300 too_few chosen too_many

view k2 diplodocus 10 15 -k 2
view k4 diplodocus 10 15 -k 4
view k7 diplodocus 10 15 -k 7
view k16 diplodocus 10 15 -k 16
row nested 200 k2 k4 k7 k16

view regions480 bunny00 40 15 -k 480
view regions150 bunny00 40 15 -k 150
view regions60 bunny00 40 15 -k 60
view regions_chosen bunny00 40 15
row merging 240 regions480 regions150 regions60 regions_chosen

view joint_learned joint 50 25
view joint_smooth joint 50 25 --method smooth-faces
view anchor_smooth anchor -10 25 --method smooth-faces
view rotor rotor 60 20 --method smooth-faces
row machine_parts 240 joint_learned joint_smooth anchor_smooth rotor

view growing fandisk 30 25 --method two-step --features all --max-angle 20 -k 19
view creases couplingdown 30 25 --method two-step --features all --max-angle 20 -k 12
row features 240 growing creases

view coarse elephant 60 15 -k 12
view fine refined_elephant 60 15 -k 12
row resolution 260 coarse fine

view rough bunny00 40 15 -k 8 --method two-step
view smooth bunny00 40 15 -k 8 --method two-step --smooth-borders
crop rough 70%x60%
crop smooth 70%x60%
row borders 260 rough smooth

mark ring ring diplodocus 1 0.12 0.26 0.12 0.06 0.12
view unconstrained diplodocus 10 15 -k 4
view constrained diplodocus 10 15 -k 5 --constraints "$work/ring"
row constraints 240 unconstrained constrained

mark dabs dabs homer 0.03 0 -0.08 -0.3 0.15 1 0.08 -0.3 0.15 2 0 -0.02 0.15
view unseeded homer 20 10 -k 5
view seeded homer 20 10 -k 5 --seeds "$work/dabs"
row seeds 300 unseeded seeded

view mask nefertiti 20 10
view mask_few nefertiti 20 10 -k 6
row open_surfaces 240 mask mask_few

view sphere sphere -60 15 -k 2
view planes head -80 10
view noisy fandisk 30 25 --method smooth-faces
row failures 220 sphere planes noisy

# The page, as a browser shows it.
"$program" --quiet "$meshes/triceratops.off" -o "$work/triceratops.html" >"$work/page.txt"
chromium --headless=new --no-sandbox --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader --hide-scrollbars \
  --window-size=1100,700 --virtual-time-budget=30000 --screenshot="$work/page.png" "file://$work/triceratops.html"
small "$work/page.png" "$figures/page.png"

# web.png is a picture of the page of examples/web on which two strokes were drawn.
