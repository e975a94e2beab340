#!/bin/sh
# run.sh [--quick] [OPTION...]: measures speed and memory; writes speed.csv and speed.md where it is called.
#
# --quick takes minutes: up to 160,000 faces, no rests. Without it, up to 16 million faces, it takes hours
# and about 12 GiB. --huge 100000000 adds a mesh of so many faces, in less than 24 GiB; alone, with
# --benchmark_filter=torus, the peak at the head of the table is its own. Other options: --sizes, --noisy-sizes
# (numbers of faces, about), --seconds for each line, --note, -o STEM, and those of Google Benchmark.
# PARALLEL=ON adds the runs with CGAL::Parallel_tag.
set -eu
root=$(cd "$(dirname "$0")/../../.." && pwd)

sh "$root/cmake/install_packages.sh" g++ make cmake git libcgal-dev libcgal-demo libeigen3-dev libopenmesh-dev \
  libcli11-dev libtbb-dev libbenchmark-dev libmetis-dev libmeshoptimizer-dev

sizes=10000,40000,160000,1000000,4000000,16000000
noisy_sizes=1000000,4000000,16000000
if [ "${1:-}" = --quick ]; then
  shift
  sizes=10000,160000
  noisy_sizes=160000
  set -- --seconds 0 "$@"
fi
case " $* " in *" --sizes"*) ;; *) set -- --sizes "$sizes" "$@" ;; esac
case " $* " in *" --noisy-sizes"*) ;; *) set -- --noisy-sizes "$noisy_sizes" "$@" ;; esac

build=$root/build-benchmark
meshes=$build/real_meshes
if [ ! -d "$meshes" ]; then
  mkdir -p "$meshes.part"
  tar -xzf /usr/share/doc/libcgal-dev/data.tar.gz -C "$meshes.part"
  mv "$meshes.part" "$meshes"
fi

cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE="-O3 -DNDEBUG" \
  -DREGION_SEGMENTATION_BUILD_PROGRAM=OFF -DREGION_SEGMENTATION_BUILD_EXAMPLES=OFF \
  -DREGION_SEGMENTATION_BUILD_TESTS=OFF -DREGION_SEGMENTATION_BUILD_BENCHMARKS=ON \
  -DREGION_SEGMENTATION_BENCHMARK_PARALLEL="${PARALLEL:-OFF}" >/dev/null
cmake --build "$build" --target speed_benchmark >&2

commit=$(git -C "$root" rev-parse --short HEAD 2>/dev/null || echo unknown)
[ -z "$(git -C "$root" status --porcelain -- include test 2>/dev/null)" ] || commit="$commit, with changes"
exec "$build/bin/speed_benchmark" --meshes "$meshes" --commit "$commit" "$@"
