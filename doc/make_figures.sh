#!/bin/sh
# make_figures.sh [PROGRAM]: makes the figures of the manual and the README anew, from the meshes of CGAL's demos (Debian's
# libcgal-demo, or the folder REGION_SEGMENTATION_REAL_MESHES), by the program (default: build/bin/segment_mesh, where
# examples/run.sh puts it). Installs what is missing.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
program=${1:-$root/build/bin/segment_mesh}
figures=$root/doc/Region_segmentation/fig

sh "$root/cmake/install_packages.sh" chromium libcgal-demo imagemagick optipng
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
meshes=${REGION_SEGMENTATION_REAL_MESHES:-$work}
if [ "$meshes" = "$work" ]; then
  tar -xzf /usr/share/doc/libcgal-dev/data.tar.gz -C "$work"
fi

# view NAME MESH METHOD [OPTION...]: a picture of a mesh, the y axis up, without the white around it.
view() {
  name=$1 mesh=$2 method=$3
  shift 3
  "$program" --quiet "$meshes/data/meshes/$mesh.off" --method "$method" "$@" -o "$work/$name.png"
  convert "$work/$name.png" -trim +repage "$work/$name.png"
}

# row FIGURE HEIGHT VIEW...: views side by side, at one height in pixels, in 192 colors.
row() {
  figure=$1 height=$2
  shift 2
  pictures=
  for name in "$@"; do
    pictures="$pictures $work/$name.png"
  done
  convert $pictures -resize "x$height" -bordercolor white -border 12x4 +append \
    +dither -colors 192 "png8:$figures/$figure.png"
  optipng -quiet -o5 -strip all "$figures/$figure.png"
}

rm -f "$figures"/*.png

view camel camel learned
view homer homer learned
view bear bear learned
view triceratops triceratops learned
row four_meshes 260 camel homer bear triceratops

view learned elephant learned -k 10
view visibility elephant visibility -k 10
view two_step elephant two-step -k 10
row methods 260 learned visibility two_step

view too_few homer learned -k 5
view too_many homer learned -k 40
row numbers 300 too_few homer too_many

view k2 diplodocus learned -k 2
view k4 diplodocus learned -k 4
view k7 diplodocus learned -k 7
view k16 diplodocus learned -k 16
row nested 170 k2 k4 k7 k16

view regions800 bunny00 learned -k 800
view regions150 bunny00 learned -k 150
view regions60 bunny00 learned -k 60
view regions_chosen bunny00 learned
row merging 240 regions800 regions150 regions60 regions_chosen

view joint_learned joint learned
view joint_smooth joint smooth-faces
view anchor_smooth anchor smooth-faces
view rotor rotor smooth-faces
row machine_parts 240 joint_learned joint_smooth anchor_smooth rotor

view growing fandisk two-step --features all --max-angle 20 -k 19
view creases couplingdown two-step --features all --max-angle 20 -k 12
row features 240 growing creases

view coarse elephant learned -k 12
view fine refined_elephant learned -k 12
row resolution 260 coarse fine

view mask nefertiti learned
view mask_few nefertiti learned -k 6
row open_surfaces 240 mask mask_few

view sphere sphere learned -k 2
view planes head learned
view noisy fandisk smooth-faces
row failures 220 sphere planes noisy

# The page, as a browser shows it.
"$program" --quiet "$meshes/data/meshes/triceratops.off" -o "$work/triceratops.html"
chromium --headless=new --no-sandbox --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader --hide-scrollbars \
  --window-size=1100,700 --virtual-time-budget=30000 --screenshot="$work/page.png" "file://$work/triceratops.html"
convert "$work/page.png" +dither -colors 192 "png8:$figures/page.png"
optipng -quiet -o5 -strip all "$figures/page.png"
