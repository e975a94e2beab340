#!/bin/sh
# run.sh DIR TARGET [LIBFUZZER OPTION...]: runs a fuzz target of what reads; all of them for TARGET "all".
#
# Builds the targets into DIR with clang, its sanitizers and CGAL's checks. A target starts from seeds that the
# project makes; what it finds on the way is kept in DIR/corpus/TARGET, an input that fails in the current folder.
# Without options a fixed number of runs, always the same ones; the long form is, for example,
#
#   sh test/fuzz/run.sh build-fuzz all -max_total_time=3600
#
# Exit status 77: clang or its runtime is missing (Debian: clang libclang-rt-14-dev).
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1"
dir=$(cd "$1" && pwd)
targets=$2
shift 2
[ "$targets" != all ] || targets="read_off read_obj read_ply read_stl read_gltf read_three_mf read_labels command_line"

compiler=${CLANGXX:-clang++}
if ! printf 'extern "C" int LLVMFuzzerTestOneInput(const char*, unsigned long) { return 0; }' |
  "$compiler" -x c++ -fsanitize=fuzzer,address,undefined -o "$dir/probe" - 2>"$dir/probe.log"; then
  echo "Skipped: $compiler with its runtime for fuzzing is missing (Debian: clang libclang-rt-14-dev)"
  exit 77
fi
cmake -S "$here" -B "$dir" -DCMAKE_CXX_COMPILER="$compiler" >/dev/null
cmake --build "$dir" --target write_seeds $targets >/dev/null
rm -rf "$dir/seeds" # libFuzzer adds to the first folder that it is given
"$dir/bin/write_seeds" "$dir/seeds"

for target in $targets; do
  runs=50000
  [ "$target" != command_line ] || runs=3000
  echo "fuzz target $target"
  # By default libFuzzer exits with 77, too.
  common="-error_exitcode=1 -timeout_exitcode=1 -max_len=2000 -timeout=60 -rss_limit_mb=1000 -print_final_stats=1 -artifact_prefix=$target-"
  if [ $# -eq 0 ]; then
    "$dir/bin/$target" $common -runs=$runs -seed=1 "$dir/seeds/$target"
  else
    mkdir -p "$dir/corpus/$target"
    "$dir/bin/$target" $common "$@" "$dir/corpus/$target" "$dir/seeds/$target"
  fi
done
