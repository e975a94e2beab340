#!/bin/sh
# segment_many.sh FOLDER ENDING[,ENDING...] [OPTION...] < LIST: segments the meshes of a list, a file name
# on each line, by segment_mesh and GNU parallel. NAME.off, or NAME.off.gz, gives FOLDER/NAME.ENDING.
#
#   find meshes -name '*.off' | sh examples/segment_many.sh parts seg,ply -k 7
#
# The same line again goes on where a run was stopped, or a mesh failed. Outputs appear whole or not at all, so
# what is done is seen by its outputs: they are there and not older than the mesh. A journal of jobs would have
# to be kept with them, and would not fit a list that has changed. Other options want another FOLDER.
#
# GNU parallel takes its own options from PARALLEL: "-j 8", "--memfree 4G", or, where the machines share their
# files, "--sshloginfile FILE --workdir .". As a task of a Slurm array it takes its share of the list and its
# CPUs; every task gets the whole list, in the same order. `--threads 4` beside the options gives each mesh four.
#
#   sbatch --array=0-15 --cpus-per-task=4 --requeue --wrap \
#     "sh examples/segment_many.sh parts seg -k 7 < list.txt"
#
# SEGMENT_MESH names the program, otherwise it is the one that examples/run.sh builds, or an installed one.
# Exit status: 0 all is done, otherwise something is not.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)

fail() {
  echo "segment_many.sh: $1" >&2
  exit 2
}

[ $# -ge 2 ] || fail "usage: sh examples/segment_many.sh FOLDER ENDING[,ENDING...] [OPTION...] < LIST"
folder=$1
endings=$(echo "$2" | tr , ' ')
shift 2
[ -d "$folder" ] || fail "$folder: no such folder"

program=${SEGMENT_MESH:-$root/build/bin/segment_mesh}
[ -x "$program" ] || program=$(command -v segment_mesh) ||
  fail "no segment_mesh: sh examples/run.sh builds it"
command -v parallel >/dev/null || sh "$root/cmake/install_packages.sh" parallel

list=$(sed 's|^-|./-|') # no options
twice=$(printf '%s\n' "$list" | sed 's|.*/||; s|\.gz$||; s|\.[^.]*$||' | sort | uniq -d | head -n 1)
[ -z "$twice" ] || fail "two meshes would be written to $folder/$twice"

share() {
  printf '%s\n' "$list" |
    awk -v n="${SLURM_ARRAY_TASK_COUNT:-1}" -v i="${SLURM_ARRAY_TASK_ID:-0}" 'NF && NR % n == i % n'
}

# The meshes of this share that lack an output, or have one that is older than the mesh.
left() {
  share | while IFS= read -r mesh; do
    name=${mesh##*/}
    name=${name%.gz}
    for ending in $endings; do
      output=$folder/${name%.*}.$ending
      if [ ! -e "$output" ] || [ "$mesh" -nt "$output" ]; then
        printf '%s\n' "$mesh"
        break
      fi
    done
  done
}

todo=$(left)
[ -n "$todo" ] || exit 0
for ending in $endings; do
  set -- "$@" -o "$folder/{stem}.$ending"
done
[ -z "${SLURM_CPUS_PER_TASK:-}" ] || PARALLEL="-j $SLURM_CPUS_PER_TASK ${PARALLEL:-}"
[ ! -t 2 ] || PARALLEL="--bar ${PARALLEL:-}"
export PARALLEL="${PARALLEL:-}"
# In the place of this shell, so that who ends the script ends the work.
exec parallel --will-cite --quote "$program" {} --threads 1 "$@" <<END
$todo
END
