#!/bin/sh
# make_figures.sh [PROGRAM]: makes the figures of the manual and the README anew, from the meshes of CGAL's demos (Debian's
# libcgal-demo, or the folder REGION_SEGMENTATION_REAL_MESHES), by the program (default: build/bin/segment_mesh, where
# examples/run.sh puts it) and the example mesh_to_step beside it. Installs what is missing. Prints what the program says of each picture.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/.." && pwd)
program=$(realpath "${1:-$root/build/bin/segment_mesh}")
figures=$here/Region_segmentation/fig

sh "$root/cmake/install_packages.sh" chromium g++ gmsh imagemagick libcgal-demo libcgal-dev optipng python3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
meshes=$(realpath "${REGION_SEGMENTATION_REAL_MESHES:-$work}")
if [ "$meshes" = "$work" ]; then
  tar -xzf /usr/share/doc/libcgal-dev/data.tar.gz -C "$work"
fi
cd "$meshes/data/meshes"

# view NAME FILE AZIMUTH ELEVATION [OPTION...]: a picture of a mesh without the white around it. The y axis is up; the
# viewer stands at the azimuth around it, from the z axis, and at the elevation above, in degrees.
view() {
  name=$1 mesh=$2 azimuth=$3 elevation=$4
  shift 4
  printf '%s: ' "$name"
  "$program" "$mesh" --view "$azimuth" "$elevation" "$@" -o "$work/$name.png" | sed "s/.*: //"
  convert "$work/$name.png" -trim +repage "$work/$name.png"
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

rm -f "$figures"/*.png "$figures"/*.gif

view camel camel.off -60 15
view homer homer.off 20 10
view bear bear.off 15 10
view triceratops triceratops.off 30 15
row four_meshes 300 camel homer bear triceratops

"$program" homer.off -k 480 -o "$work/superfacets.seg"
python3 "$here/mark_mesh.py" rays homer.off "$work/superfacets.seg" "$work/rays.seg" .15 -.05 .02 0 0 1 >"$work/rays.off"
view superfacets homer.off 20 10 --labels "$work/superfacets.seg"
view rays "$work/rays.off" 10 10 --labels "$work/rays.seg"
view regions60 homer.off 20 10 -k 60
row superfacets 480 superfacets rays regions60 homer

g++ -O2 -DNDEBUG "$here/segment_by_sdf.cpp" -o "$work/segment_by_sdf" -lgmp -lmpfr
for mesh in elephant camel; do
  "$work/segment_by_sdf" $mesh.off >"$work/$mesh.seg"
done
view elephant_sdf elephant.off 60 15 --labels "$work/elephant.seg"
view elephant elephant.off 60 15
view camel_sdf camel.off -60 15 --labels "$work/camel.seg"
row beside_sdf 320 elephant_sdf elephant camel_sdf camel

view default armadillo.off 200 10
view visibility elk.off 60 15 --method visibility
view two_step couplingdown.off 30 25 --method two-step --features all --max-angle 20 -k 12
view smooth_faces anchor.off -10 25 --method smooth-faces
row methods 300 default visibility two_step smooth_faces

view joint_learned joint.off 50 25
view joint_smooth joint.off 50 25 --method smooth-faces
view rotor rotor.off 60 20 --method smooth-faces
row machine_parts 280 joint_learned joint_smooth rotor

# A part as few triangles, and the solid that is made of them, in many.
to_step=$(dirname "$program")/mesh_to_step
"$to_step" joint.off "$work/joint.step"
gmsh "$work/joint.step" -2 -setnumber Mesh.MeshSizeFromCurvature 12 -o "$work/few.stl" >"$work/gmsh.log"
"$to_step" "$work/few.stl" "$work/solid.step"
gmsh "$work/solid.step" -2 -setnumber Mesh.MeshSizeFromCurvature 80 -o "$work/many.stl" >"$work/gmsh.log"
view few "$work/few.stl" 50 25 --method smooth-faces
view many "$work/many.stl" 50 25 --method smooth-faces
row solid 300 few many

view k2 diplodocus.off 10 15 -k 2
view k4 diplodocus.off 10 15 -k 4
view chosen diplodocus.off 10 15
view k16 diplodocus.off 10 15 -k 16
row numbers 300 k2 k4 chosen k16

# What the slider of the page shows.
for number in 2 3 4 5 6 7 8 10 12 14 16; do
  view "slider$number" diplodocus.off 10 15 -k $number
done
(cd "$work" && convert -delay 70 -loop 0 $(printf 'slider%s.png ' 2 3 4 5 6 7 8 10 12 14) -delay 200 slider16.png \
  -resize x300 +dither -colors 64 -layers optimize "$figures/slider.gif")

python3 "$here/mark_mesh.py" ring diplodocus.off 1 .12 .26 .12 .06 .12 >"$work/ring"
python3 "$here/mark_mesh.py" dabs homer.off .03 0 -.08 -.3 .15 1 .08 -.3 .15 2 0 -.02 .15 >"$work/dabs"
view constrained diplodocus.off 10 15 -k 5 --constraints "$work/ring"
view unseeded homer.off 20 10 -k 5
view seeded homer.off 20 10 -k 5 --seeds "$work/dabs"
row marks 360 k4 constrained unseeded seeded

boards='0 6 0 30 7 16 0 20 0 30 21 16 0 34 0 30 35 16 0 48 0 30 49 16'
posts='3 0 3 5 50 5 25 0 3 27 50 5 3 0 11 5 50 13 25 0 11 27 50 13'
python3 "$here/mark_mesh.py" boxes $boards $posts >"$work/shelf.off"
view sphere sphere.off -110 15 -k 2
view legs cow.off 60 10
view shelf "$work/shelf.off" 30 15
view mask nefertiti.off 20 10
row failures 300 sphere legs shelf mask

# The page, as a browser shows it.
"$program" triceratops.off -o "$work/triceratops.html"
chromium --headless=new --no-sandbox --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader --hide-scrollbars \
  --window-size=1100,700 --virtual-time-budget=30000 --screenshot="$work/page.png" "file://$work/triceratops.html" 2>/dev/null
small "$work/page.png" "$figures/page.png"
