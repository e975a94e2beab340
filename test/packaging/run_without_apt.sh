#!/bin/sh
# run_without_apt.sh SOURCE: examples/run.sh where there is no apt and CLI11 is missing: one
# sentence says so.
set -eu
source=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

mkdir "$folder/package" "$folder/bin"
for entry in CMakeLists.txt cmake doc examples include test; do # what it builds is not built in the source
  ln -s "$source/$entry" "$folder/package/$entry"
done
for tool in sh dirname grep make c++; do
  ln -s "$(command -v $tool)" "$folder/bin/$tool"
done
cat >"$folder/bin/cmake" <<END
#!/bin/sh
export PATH="$PATH"
[ "\$1" = -S ] && exec cmake "\$@" -DCMAKE_DISABLE_FIND_PACKAGE_CLI11=ON
echo "cmake \$*: was to be built" >&2
exit 3
END
chmod +x "$folder/bin/cmake"

status=0
PATH="$folder/bin" sh "$folder/package/examples/run.sh" >"$folder/out" 2>"$folder/err" || status=$?
if [ $status -ne 1 ] || [ "$(wc -l <"$folder/err")" -ne 1 ] ||
   ! grep -q "^CLI11::CLI11 not found: segment_mesh is not built (Debian: libcli11-dev" "$folder/err"; then
  echo "exit status $status"
  cat "$folder/out" "$folder/err"
  exit 1
fi
