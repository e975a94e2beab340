#!/bin/sh
# coverage.sh [FOLDER]: lines and branches of include/ and of the program that the tests execute, by gcov, as a table of
# files and two totals; built and run in FOLDER (default: build-coverage/). COVERAGE_TARGETS="TARGET...": these tests
# alone. A test that compares what the program says, or kills it, may fail here, since gcov writes to the same output: the table
# is printed all the same, and the exit status is 1.
set -eu
status=0
root=$(cd "$(dirname "$0")/.." && pwd)
work=${1:-$root/build-coverage}
cmake -S "$root" -B "$work" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS="--coverage -O0 -g0 -DNDEBUG -fno-inline" >/dev/null
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
