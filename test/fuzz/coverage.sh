#!/bin/sh
# coverage.sh DIR [TARGET...]: what the corpora in DIR, see run.sh, and the seeds reach of the readers and of the library.
#
# Builds the targets, all of them if none is named, a second time, into DIR/coverage. Needs Debian's llvm.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
dir=$(cd "$1" && pwd)
shift
targets=${*:-read_off read_obj read_ply read_stl read_labels command_line segment_soup segment_mesh use_segments}

cmake -S "$here" -B "$dir/coverage" -DCMAKE_CXX_COMPILER="${CLANGXX:-clang++}" \
  -Dcoverage="-fprofile-instr-generate;-fcoverage-mapping" >/dev/null
cmake --build "$dir/coverage" --target write_seeds $targets >/dev/null
LLVM_PROFILE_FILE=/dev/null "$dir/coverage/bin/write_seeds" "$dir/coverage/seeds"

rm -f "$dir"/coverage/*.profraw
objects=
for target in $targets; do
  mkdir -p "$dir/corpus/$target"
  LLVM_PROFILE_FILE="$dir/coverage/$target.profraw" "$dir/coverage/bin/$target" -runs=0 \
    "$dir/corpus/$target" "$dir/coverage/seeds/$target" 2>/dev/null
  objects="$objects -object $dir/coverage/bin/$target"
done
llvm-profdata merge -o "$dir/coverage/all.profdata" "$dir"/coverage/*.profraw
# Its first file has no option.
llvm-cov report ${objects#*-object } -instr-profile "$dir/coverage/all.profdata" "$root/examples/segment_mesh/io" \
  "$root/examples/segment_mesh/soup" "$root/examples/segment_mesh/command_line" "$root/include"
