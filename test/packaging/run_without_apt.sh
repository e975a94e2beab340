#!/bin/sh
# run_without_apt.sh SOURCE: examples/run.sh where there is no apt. A mesh that cannot be read, and that CLI11 is missing, are
# said in one sentence before anything is built; before the program is compiled the script says so.
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

# with_cmake CONFIGURE: what runs in place of `cmake -S ...`; in place of a build an error with the exit status 3.
with_cmake() {
  cat >"$folder/bin/cmake" <<END
#!/bin/sh
export PATH="$PATH"
[ "\$1" = -S ] && exec $1
echo "cmake \$*: was to be built" >&2
exit 3
END
  chmod +x "$folder/bin/cmake"
}

# expect STATUS LINES REGEX ARGUMENT...: the exit status of run.sh, the number of lines on stderr, and how the first begins.
expect() {
  wanted=$1 lines=$2 begin=$3 status=0
  shift 3
  PATH="$folder/bin" sh "$folder/package/examples/run.sh" "$@" >"$folder/out" 2>"$folder/err" || status=$?
  if [ $status -ne "$wanted" ] || [ "$(wc -l <"$folder/err")" -ne "$lines" ] || ! head -n 1 "$folder/err" | grep -q "^$begin"; then
    echo "exit status $status"
    cat "$folder/out" "$folder/err"
    exit 1
  fi
}

with_cmake 'cmake "$@" -DCMAKE_DISABLE_FIND_PACKAGE_CLI11=ON'
expect 1 1 "no_such_mesh.off cannot be read" no_such_mesh.off
expect 1 1 "CLI11::CLI11 not found: segment_mesh is not built (Debian: libcli11-dev"
with_cmake true
expect 3 2 "The program segment_mesh is compiled now, once, in "
