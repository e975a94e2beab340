#!/bin/sh
# install_packages.sh PACKAGE...: sees to it that the Debian packages are installed.
#
# Where apt is there, installs those that are missing (as root, or with sudo); elsewhere names them and
# fails. Does nothing, and needs no network, when all are there. With INSTALL_PACKAGES=no nothing is
# installed: exit status 77, which CTest takes for a skipped test, says that some are missing.
set -eu

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  if [ "${INSTALL_PACKAGES:-yes}" = no ]; then
    echo "skipped: there is no apt"
    exit 77
  fi
  # No apt: a compiler and CMake are the least; CMake itself names the libraries that it misses.
  for tool in cmake c++ make; do
    command -v "$tool" >/dev/null || missing="${missing:-} $tool"
  done
  if [ -n "${missing:-}" ]; then
    echo "This needs:$missing, and what these Debian packages hold: $*" >&2
    exit 1
  fi
  exit 0
fi

missing=
for package in "$@"; do
  state=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$state" = installed ] || missing="$missing $package"
done
[ -n "$missing" ] || exit 0
if [ "${INSTALL_PACKAGES:-yes}" = no ]; then
  echo "skipped: missing packages:$missing"
  exit 77
fi

if [ "$(id -u)" = 0 ]; then
  as_root=
elif command -v sudo >/dev/null; then
  as_root=sudo
else
  echo "Missing packages, and neither root nor sudo to install them:$missing" >&2
  exit 1
fi
echo "Installing:$missing" >&2
export DEBIAN_FRONTEND=noninteractive
# A machine that never fetched the lists of packages, or whose lists are old, does so first.
$as_root apt-get install -y --no-install-recommends $missing >/dev/null 2>&1 ||
  { $as_root apt-get update -qq >&2 &&
    $as_root apt-get install -y --no-install-recommends $missing >&2; }
