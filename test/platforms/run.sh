#!/bin/sh
# run.sh [PLATFORM...]: shows that labels are the same on every machine. Builds hash_labels for the
# machine itself and for the named platforms, or for all, by Debian's compilers, runs it on the same
# meshes, and prints a table: a hash of the labels of each method, a row a platform, and the seconds
# to build and to run. Where a row differs from the first, the meshes and methods in question follow.
#
# The meshes are those of the examples, and CGAL's small ones where the environment variable
# REGION_SEGMENTATION_REAL_MESHES names their folder; with PLATFORMS_STEP=N each N-th one of all.
# PLATFORMS_DIR is where it builds, by default build-platforms/; CXXFLAGS are added to the options
# of the compilers. With INSTALL_PACKAGES=no nothing is installed. Each compiler must also see
# -ffast-math refused.
#
# Exit status: 0 all rows are equal; 1 one differs, or a platform cannot be built or run; 77 packages
# are absent.
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
work=${PLATFORMS_DIR:-$root/build-platforms}

# platform | packages                               | compiler and options                                | what runs the program
platforms='
native     | g++                                    | g++ -O1                                             |
native-O0  | g++                                    | g++ -O0                                             |
x86-64-v3  | g++                                    | g++ -O3 -march=x86-64-v3                            |
clang      | clang                                  | clang++ -O1                                         |
clang-v3   | clang                                  | clang++ -O3 -march=x86-64-v3                        |
i686       | g++-i686-linux-gnu qemu-user-static    | i686-linux-gnu-g++ -O1 -msse2 -mfpmath=sse -static  | qemu-i386-static
aarch64    | g++-aarch64-linux-gnu qemu-user-static | aarch64-linux-gnu-g++ -O1 -static                   | qemu-aarch64-static
riscv64    | g++-riscv64-linux-gnu qemu-user-static | riscv64-linux-gnu-g++ -O1 -static                   | qemu-riscv64-static
s390x      | g++-s390x-linux-gnu qemu-user-static   | s390x-linux-gnu-g++ -O1 -static                     | qemu-s390x-static
windows    | g++-mingw-w64-x86-64-posix wine64      | x86_64-w64-mingw32-g++-posix -O1 -static            | /usr/lib/wine/wine64
wasm       | emscripten nodejs                      | em++ -O1 -fexceptions -sALLOW_MEMORY_GROWTH -sNODERAWFS -sSINGLE_FILE | node
'
column() { echo "$platforms" | awk -F ' *[|] *' -v name="$1" -v i="$2" '$1 == name { print $i }'; }

[ $# != 0 ] || set -- $(echo "$platforms" | cut -d '|' -f 1 | grep -v -x 'native *')
set -- native "$@"
packages="libboost-dev libcgal-dev libeigen3-dev"
for name; do
  if [ -z "$(column "$name" 3)" ]; then
    echo "unknown platform $name; known are:$(echo "$platforms" | cut -d '|' -f 1 | tr -s ' \n' ' ')" >&2
    exit 2
  fi
  packages="$packages $(column "$name" 2)"
done
sh "$root/cmake/install_packages.sh" $packages

# The headers alone: beside them in /usr/include are those of the C library of this machine.
mkdir -p "$work/include"
work=$(cd "$work" && pwd)
ln -sfn /usr/include/CGAL /usr/include/boost /usr/include/eigen3/Eigen "$work/include"

cd "$root"
meshes=$(find examples/data ${REGION_SEGMENTATION_REAL_MESHES:+"$REGION_SEGMENTATION_REAL_MESHES"} -name '*.off' -size -130k |
  LC_ALL=C sort | awk -v step="${PLATFORMS_STEP:-1}" 'NR % step == 0')

# build NAME ENDING: hash_labels for a platform. CMake's target CGAL::Region_segmentation has
# -ffp-contract=off, too.
build()
{
  echo '#include <CGAL/Region_segmentation/Support/Double_3.h>' >"$work/$1/refused.cpp"
  ! $(column "$1" 3) -ffast-math -fsyntax-only -I include "$work/$1/refused.cpp" 2>"$work/$1/refused" &&
    grep 'compile without -ffast-math' "$work/$1/refused" || return 1
  $(column "$1" 3) -std=c++17 -ffp-contract=off -DNDEBUG -DCGAL_DISABLE_GMP -DCGAL_NO_GMP ${CXXFLAGS:-} \
    -I include -isystem "$work/include" test/platforms/hash_labels.cpp -o "$work/$1/hash_labels$2"
}

# run NAME ENDING: its output, which ends with a line `done`.
run()
{
  output=$(WINEDEBUG=-all $(column "$1" 4) "$work/$1/hash_labels$2" $meshes | tr -d '\r')
  [ "${output##*
}" = "done" ] && printf '%s\n' "$output"
}

methods="learned visibility two-step smooth-faces"
printf '%-10s %-9s %-11s %-9s %-13s %6s %8s %5s\n' platform $methods meshes build/s run/s
status=0
for name; do
  ending=
  case $name in
    windows) ending=.exe ;;
    wasm) ending=.js ;;
  esac
  mkdir -p "$work/$name"
  start=$(date +%s)
  if ! build "$name" "$ending" >"$work/$name/log" 2>&1 || ! built=$(date +%s) ||
     ! run "$name" "$ending" 2>>"$work/$name/log" >"$work/$name/hashes"; then
    echo "$name: FAILED; the end of $work/$name/log:"
    tail -5 "$work/$name/log"
    status=1
    continue
  fi
  row=
  for method in $methods; do
    row="$row $(awk -v method=$method '$2 == method' "$work/$name/hashes" | md5sum | cut -c 1-8)"
  done
  printf '%-10s %-9s %-11s %-9s %-13s %6s %8s %5s\n' "$name" $row \
    "$(grep -c ' learned ' "$work/$name/hashes")" $((built - start)) $(($(date +%s) - built))
  if ! cmp -s "$work/native/hashes" "$work/$name/hashes"; then
    diff "$work/native/hashes" "$work/$name/hashes" | awk '$1 == ">" { print "  differs:", $2, $3 }'
    status=1
  fi
done
exit $status
