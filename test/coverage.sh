#!/bin/sh
# coverage.sh [FOLDER]: lines and branches of include/ and of the program that the tests execute, by gcov, as a table of
# files and two totals; built and run in FOLDER (default: build-coverage/). COVERAGE_TARGETS="TARGET...": these tests
# alone. What gcov says goes to FOLDER/gcov_errors. Where a test fails, as that of a limit on threads may when all is so slow, the table is
# printed all the same, and the exit status is 1.
set -eu
status=0
root=$(cd "$(dirname "$0")/.." && pwd)
work=${1:-$root/build-coverage}
cmake -S "$root" -B "$work" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS="--coverage -O1 -g0 -DNDEBUG -fno-inline" >/dev/null
export GCOV_ERROR_FILE="$work/gcov_errors"
find "$work" -name '*.gcda' -exec rm {} +
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
exit $status
