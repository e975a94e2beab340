#!/bin/sh
# bare_chroot.sh FOLDER [BASE]: what `cmake/release.sh FOLDER program wheel debian` made runs in a base system without compiler
# and CGAL: the program, the package of the program, and the wheel, from install to labels in less than 10 s each. BASE: an
# unpacked Debian with python3-numpy; by default debootstrap makes it in FOLDER/build.
#
# Exit status 77: a chroot is not possible here.
set -eu
out=$(cd "$1" && pwd)
base=${2:-$out/build/base}
data=$(cd "$(dirname "$0")/../../examples/data" && pwd)
if [ "$(id -u)" != 0 ] || { [ ! -d "$base" ] && ! command -v debootstrap >/dev/null; }; then
  echo "skipped: this needs root, and debootstrap (Debian: debootstrap) or a base system"
  exit 77
fi
if [ ! -d "$base" ]; then
  debootstrap --variant=minbase --include=python3-numpy bookworm "$base.part" >"$out/build/debootstrap.log"
  mv "$base.part" "$base"
fi
if ! chroot "$base" true; then
  echo "skipped: chroot is not possible"
  exit 77
fi
for tool in c++ cc cmake make; do
  if chroot "$base" sh -c "command -v $tool"; then
    echo "the base system is not bare" >&2
    exit 1
  fi
done
rm -rf "$base/take_home"
mkdir "$base/take_home"
cp "$data/figure.off" "$out"/segment_mesh-*-linux-* "$out"/*.whl "$out"/segment-mesh_*.deb "$base/take_home"

# in_base NAME COMMANDS: runs them in less than 10 s.
in_base() {
  begin=$(date +%s)
  chroot "$base" timeout 10 sh -euc "cd /take_home; $2"
  echo "$1: $(($(date +%s) - begin)) s"
}

in_base program 'chmod +x segment_mesh-*; ./segment_mesh-*-linux-* figure.off -o page.html -o one.seg -o one.3mf -o one.png'
in_base wheel 'python3 -m zipfile -e *.whl site
  PYTHONPATH=site python3 -c "
import region_segmentation
lines = [line.split() for line in open(\"figure.off\")]
points, faces = int(lines[1][0]), int(lines[1][1])
mesh = ([[float(x) for x in l] for l in lines[2 : 2 + points]], [[int(i) for i in l[1:]] for l in lines[2 + points :][:faces]])
labels = region_segmentation.segment(mesh)
assert len(region_segmentation.describe_segments(mesh, labels)) == labels.max() + 1
open(\"two.seg\", \"w\").writelines(f\"{x}\\n\" for x in labels)"'
chroot "$base" sh -c 'dpkg --unpack /take_home/segment-mesh_*.deb && apt-get -y -f install && segment_mesh --version' >"$out/build/apt.log" 2>&1 ||
  { cat "$out/build/apt.log" >&2; exit 1; }
in_base package 'segment_mesh figure.off -q -o three.seg'
cd "$base/take_home"
cmp one.seg two.seg
cmp one.seg three.seg
ls -l page.html one.3mf one.png
