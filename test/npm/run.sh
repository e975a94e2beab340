#!/bin/sh
# run.sh DIR SEGMENT_MESH: makes the npm package, installs it into a fresh folder below DIR without
# a network, and tests it there.
#
# Exit status 77: something that it needs is missing.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$1/user"
mkdir -p "$1/user"
INSTALL_PACKAGES=no sh "$here/../../examples/npm/build.sh" "$1/package"
cd "$1/user"
npm install --offline --no-audit --no-fund --loglevel=error "$1"/package/region-segmentation-*.tgz
"$2" --demo -q -o demo.off
meshes=$PWD/demo.off
if [ -n "${REGION_SEGMENTATION_REAL_MESHES:-}" ]; then
  folder=$(cd "$REGION_SEGMENTATION_REAL_MESHES" && pwd)
  meshes="$meshes $(find "$folder" -name elephant.off -o -name fandisk.off)"
fi
cp "$here/npm_test.mjs" "$here/types_test.mts" .
node npm_test.mjs "$2" "$PWD" $meshes
if command -v tsc >/dev/null; then
  tsc --noEmit --strict --target es2020 --moduleResolution node16 --module node16 types_test.mts
else
  echo "The types are not tested: there is no tsc (Debian: node-typescript)"
fi
