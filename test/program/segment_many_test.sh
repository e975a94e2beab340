#!/bin/sh
# segment_many_test.sh SEGMENT_MESH SCRIPT: kills examples/segment_many.sh in the middle, lets a mesh fail, starts
# it again, and looks what was done anew. Skips (77) without GNU parallel.
set -eu
segment_mesh=$1
script=$2
command -v parallel >/dev/null || { echo "GNU parallel is not installed: skipped"; exit 77; }
unset SLURM_ARRAY_TASK_ID SLURM_ARRAY_TASK_COUNT SLURM_CPUS_PER_TASK
export PARALLEL="-j 1"

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

fail() {
  echo "FAILED: $1" >&2
  exit 1
}

expect() { # EXPECTED FOUND WHAT
  [ "$1" = "$2" ] || fail "$3: expected '$1', found '$2'"
}

# The program, with a list of the meshes that it was called for. It hangs at the mesh that the file `hang` names.
cat >logged <<END
#!/bin/sh
echo "\$1" >>"$folder/log"
if [ "\$1" = "\$(cat "$folder/hang")" ]; then
  echo \$\$ >"$folder/hanging.part"
  mv "$folder/hanging.part" "$folder/hanging"
  exec sleep 60
fi
exec "$segment_mesh" "\$@"
END
chmod +x logged
export SEGMENT_MESH="$folder/logged"
: >hang

# What the calls since the last time were for.
calls() {
  tr '\n' ' ' <log
  rm -f log
}

many() { # OUTPUTS...
  status=0
  sh "$script" "$@" -k 2 <list >out 2>err || status=$?
}

mkdir meshes parts
for i in 1 2 3 4 5 6 7 8; do
  printf 'OFF\n4 4 0\n0 0 0\n%s 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n' "$i" >"meshes/m $i.off"
  echo "meshes/m $i.off"
done >list
echo "meshes/bad.off" >>list
echo "not a mesh" >meshes/bad.off

# Killed at the fourth mesh: three are done, of the fourth nothing is there.
echo "meshes/m 4.off" >hang
sh "$script" parts seg,ply -k 2 <list >out 2>err &
run=$!
i=0
while [ ! -e hanging ]; do
  i=$((i + 1))
  [ $i -lt 600 ] || fail "the fourth mesh was not reached"
  sleep 0.1
done
kill -KILL $run "$(cat hanging)"
wait $run 2>wait.err || true
expect "meshes/m 1.off meshes/m 2.off meshes/m 3.off meshes/m 4.off " "$(calls)" "meshes before the kill"
expect 6 "$(ls -A parts | wc -l | tr -d ' ')" "outputs before the kill"
ls -i parts >before

# The rest, and no more; the bad mesh fails without harm to the others.
: >hang
many parts seg,ply
[ $status -ne 0 ] || fail "a bad mesh is no failure"
expect "meshes/m 4.off meshes/m 5.off meshes/m 6.off meshes/m 7.off meshes/m 8.off meshes/bad.off " "$(calls)" \
  "meshes after the kill"
grep -q "^meshes/bad.off:1: no OFF header" err || fail "no word on the bad mesh: $(cat err)"
ls -i parts >after
expect "" "$(grep -vxF -f after before || true)" "outputs that were made anew"
expect 16 "$(ls -A parts | wc -l | tr -d ' ')" "outputs after all"

# What failed, and nothing else; then what has changed or lacks an output.
cp "meshes/m 1.off" meshes/bad.off
many parts seg,ply
expect 0 $status "exit status ($(cat err))"
expect "meshes/bad.off " "$(calls)" "meshes after the repair"
many parts seg,ply
expect "0 0" "$status $(cat log 2>/dev/null | wc -l | tr -d ' ')" "a run when all is done"
rm "parts/m 2.ply"
touch -d '2001-01-01' "parts/m 7.seg"
many parts seg,ply
expect "meshes/m 2.off meshes/m 7.off " "$(calls)" "meshes that changed"

# The outputs are those of one run of the program.
mkdir expected
"$segment_mesh" meshes/*.off -k 2 -o 'expected/{stem}.seg' -o 'expected/{stem}.ply' >out
diff -r parts expected || fail "other outputs than by one run"

# Compressed, and of a name that starts like an option.
mkdir packed
gzip -c "meshes/m 1.off" >packed.off.gz
cp "meshes/m 2.off" -- -k.off
printf 'packed.off.gz\n-k.off\n' >special
"$segment_mesh" packed.off.gz ./-k.off -k 2 -o 'packed/{stem}.seg' >out
ls packed >names
rm packed/*
for round in "packed.off.gz ./-k.off " ""; do
  status=0
  sh "$script" packed seg -k 2 <special >out 2>err || status=$?
  expect 0 $status "exit status ($(cat err))"
  expect "$round" "$([ ! -e log ] || calls)" "special names"
done
expect "$(cat names)" "$(ls packed)" "outputs of special names"

# The tasks of an array share the list, whatever number they start from.
for first in 0 1; do
  mkdir "share$first"
  for i in 0 1 2; do
    export SLURM_ARRAY_TASK_COUNT=3 SLURM_ARRAY_TASK_ID=$((first + i)) SLURM_CPUS_PER_TASK=1
    many "share$first" seg
    expect 0 $status "exit status of a task"
    expect 3 "$(calls | tr -dc / | wc -c | tr -d ' ')" "meshes of a task"
  done
  expect "$(cd expected && cat *.seg)" "$(cd "share$first" && cat *.seg)" "outputs of the array"
done
unset SLURM_ARRAY_TASK_COUNT SLURM_ARRAY_TASK_ID SLURM_CPUS_PER_TASK

# Wrong usage is told before the work.
many none seg
expect "2 segment_many.sh: none: no such folder" "$status $(cat err)" "a folder that is not there"
echo "other/m 3.off" >>list
many parts seg
expect "2 segment_many.sh: two meshes would be written to parts/m 3" "$status $(cat err)" "two meshes of one name"
[ ! -e log ] || fail "work was done on wrong usage"
echo "all as expected"
