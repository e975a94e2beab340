#!/bin/sh
# plot_speed.sh FIGURE.png: seconds by faces, from the table of doc/performance.md: smooth meshes, Surface_mesh, one thread.
# Needs gnuplot.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Columns are found by their names; "whole" is in nanoseconds a face.
curve() {
  awk -F ' *[|] *' -v what="$1" '
    $2 == "mesh" { for (i = 2; i < NF; ++i) column[$i] = i }
    $2 == "smooth" && $column["type"] == "Surface_mesh" && $column["threads"] == 1 && $column["what"] == what {
      print $column["faces"], $column["faces"] * $column["whole"] * 1e-9
    }' "$here/performance.md" | sort -n
}

curves=
add() { # add WHAT TITLE COLOR
  file=$work/$(printf %s "$1" | tr -c 'a-z_\n' '-')
  curve "$1" >"$file"
  if [ -s "$file" ]; then
    curves="$curves${curves:+, }'$file' with linespoints linewidth 2 pointtype 7 linecolor rgb '$3' title '$2'"
  fi
}
add 'sdf_values + segmentation' 'SDF segmentation of CGAL' '#BBBBBB'
add learned 'Learned\_merging' '#EE6677'
add visibility 'Visibility\_merging' '#4477AA'
add two-step 'Two\_step' '#228833'

gnuplot <<END
set terminal pngcairo size 720, 420 font 'sans,11'
set output '$1'
set logscale xy
set format x '10^{%T}'
set format y '10^{%T}'
set xlabel 'faces'
set ylabel 'seconds from the mesh to the labels'
set grid
set key right bottom
plot $curves
END
