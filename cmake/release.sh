#!/bin/sh
# release.sh [FOLDER [PART...]]: makes the packages of a release from this tree in FOLDER (default: build-packages/), and
# prints their sizes. The parts, all by default: source, program (one static file), wheel (with the source distribution),
# npm, debian, page (the program in a browser), manual (HTML).
#
# Installs what is missing (by apt). What is built on the way is kept in FOLDER/build.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
mkdir -p "${1:-$root/build-packages}"
out=$(cd "${1:-$root/build-packages}" && pwd)
[ $# -eq 0 ] || shift
parts=${*:-source program wheel npm debian page manual}
work=$out/build
mkdir -p "$work"
version=$(sed -n 's/.*SEGMENTATION_VERSION "\(.*\)"/\1/p' "$root/include/CGAL/Region_segmentation/Support/version.h")
machine=$(uname -m)

of_program="binutils cmake g++ libboost-iostreams-dev libcgal-dev libcli11-dev libeigen3-dev libexpat1-dev libjs-three
  libminizip-dev libpng-dev make nlohmann-json3-dev zlib1g-dev"
install_packages() { sh "$root/cmake/install_packages.sh" "$@"; }

make_source() {
  install_packages git
  git -C "$root" archive --prefix="region-segmentation-$version/" -o "$out/region-segmentation-$version-source.tar.gz" HEAD
}

# build FOLDER TARGET OPTION...: configures the package without tests and examples, and builds a target.
build() {
  folder=$work/$1 target=$2
  shift 2
  cmake -S "$root" -B "$folder" -DCMAKE_BUILD_TYPE=Release -DREGION_SEGMENTATION_BUILD_TESTS=OFF \
    -DREGION_SEGMENTATION_BUILD_EXAMPLES=OFF "$@" >/dev/null
  cmake --build "$folder" -j "${JOBS:-2}" --target "$target"
}

make_program() {
  install_packages $of_program libgmp-dev libmpfr-dev
  build static segment_mesh -DCMAKE_PROJECT_INCLUDE="$root/cmake/static_program.cmake"
  program=$out/segment_mesh-$version-linux-$machine
  cp "$work/static/bin/segment_mesh" "$program"
  if ldd "$program" >/dev/null 2>&1; then
    echo "$program is not static" >&2
    exit 1
  fi
}

# The platform of PEP 600: the release of glibc that has the newest symbol which a library needs.
manylinux_of() {
  newest=$(objdump -T "$1" | grep -o 'GLIBC_[0-9.]*' | sort -V | tail -n 1)
  echo "manylinux_$(echo "${newest#GLIBC_}" | cut -d . -f 1-2 | tr . _)_$machine"
}

make_wheel() {
  install_packages binutils g++ libcgal-dev libeigen3-dev python3-dev python3-numpy python3-pybind11 python3-setuptools \
    python3-wheel
  rm -rf "$work/wheel"
  mkdir "$work/wheel"
  cd "$root/examples/python"
  python=/usr/bin/python3
  $python setup.py --quiet egg_info --egg-base "$work/wheel" sdist --dist-dir "$out"
  tar -xzf "$out/region-segmentation-$version.tar.gz" -C "$work/wheel"
  cd "$work/wheel/region-segmentation-$version"
  export REGION_SEGMENTATION_PORTABLE=1
  $python setup.py --quiet build
  library=$(find build -name '_core*.so')
  if readelf -d "$library" | grep NEEDED | grep -v '\[\(libm\|libc\|libgcc_s\|ld-linux-.*\)[.]so'; then
    echo "the wheel needs these libraries" >&2
    exit 1
  fi
  $python setup.py --quiet bdist_wheel --skip-build --plat-name "$(manylinux_of "$library")" --dist-dir "$out"
}

make_npm() {
  INSTALL_PACKAGES=${INSTALL_PACKAGES:-yes} sh "$root/examples/npm/build.sh" "$work/npm"
  cp "$work/npm/region-segmentation-$version.tgz" "$out/region-segmentation-$version-npm.tgz"
}

make_debian() {
  install_packages $of_program dpkg-dev libmeshoptimizer-dev libtbb-dev
  build shared segment_mesh
  cpack -G DEB --config "$work/shared/CPackConfig.cmake" -B "$work/debian" \
    -D CPACK_PACKAGE_CONTACT="${PACKAGE_CONTACT:-the contributors of CGAL_Region_segmentation}" >/dev/null
  cp "$work"/debian/*.deb "$out"
}

make_page() {
  sh "$root/examples/web/build.sh" "$work/page"
  cp "$work/page/segment_mesh.html" "$out/segment_mesh-$version.html"
}

make_manual() {
  install_packages cmake doxygen g++ libcgal-dev libjs-mathjax make
  build manual doc -DREGION_SEGMENTATION_BUILD_PROGRAM=OFF
  tar -czf "$out/region-segmentation-$version-manual.tar.gz" -C "$work/manual/doc" --transform 's,^html,manual,' html
}

for part in $parts; do
  echo "$part"
  make_"$part" >"$work/$part.log" 2>&1 &
  wait $! || {
    status=$?
    tail -n 5 "$work/$part.log" >&2
    [ $status -eq 77 ] || exit $status # 77: something that it needs is not there
  }
done
cd "$out"
find . -maxdepth 1 -type f -exec du -h {} + | sort -k 2
