#!/bin/sh
# check_format.sh CLANG_FORMAT: whether the sources are formatted as .clang-format says; release 14, since others differ.
set -eu
cd "$(dirname "$0")/.."
find include test examples \( -name '*.h' -o -name '*.cpp' \) ! -name learned_merge_model.h -print0 |
  xargs -0 "$1" --dry-run --Werror --style=file
