#!/bin/sh
# coverage.sh [FOLDER]: lines and branches of include/ and of the program that the tests execute, by gcov, as a table of
# files and two totals; built and run in FOLDER (default: build-coverage/). COVERAGE_TARGETS="TARGET...": these tests
# alone. What gcov says goes to FOLDER/gcov_errors. Where a test fails, the table is printed all the same, and the
# exit status is 1; so it is where counts were damaged, and are too low.
#
# Branches are decisions of the source: neither those of calls that may throw nor those of what the compiler does after an
# exception count (coverage.py says how they are told). Runs that end by a signal or _Exit() are not counted.
set -eu
status=0
root=$(cd "$(dirname "$0")/.." && pwd)
work=${1:-$root/build-coverage}
cmake -S "$root" -B "$work" -DCMAKE_BUILD_TYPE=Debug -DREGION_SEGMENTATION_ALL_TESTS=ON -DCMAKE_CXX_FLAGS="--coverage -O1 -g0 -DNDEBUG -fno-inline" >/dev/null
export GCOV_ERROR_FILE="$work/gcov_errors"
find "$work" -name '*.gcda' -exec rm {} +
rm -f "$GCOV_ERROR_FILE"
if [ -n "${COVERAGE_TARGETS:-}" ]; then
  for target in $COVERAGE_TARGETS; do
    cmake --build "$work" -j 2 --target "$target"
    "$work/bin/$target" --gtest_brief=1 || status=1
  done
else
  cmake --build "$work" -j 2
  ctest --test-dir "$work" -j 2 -LE build -E instruction || status=1
fi
python3 "$root/test/coverage.py" "$root" "$work"
if grep -qs "Merge mismatch" "$GCOV_ERROR_FILE"; then
  echo "some counts were damaged: $GCOV_ERROR_FILE" >&2
  status=1
fi
exit $status
