#!/bin/sh
# segment_many_test.sh SEGMENT_MESH MANUAL: runs the manual's lines of GNU parallel for many meshes. The run is killed
# in the middle and a mesh fails; the same lines then do what is left. Skips (77) without GNU parallel.
set -eu
segment_mesh=$1
manual=$2
command -v parallel >/dev/null || { echo "GNU parallel is not installed: skipped"; exit 77; }
export PARALLEL="--will-cite -j 1"

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

# The code blocks of the manual that call parallel, one after the other in files block1, block2.
awk '/^\\code/ { text = ""; inside = 1; next }
     /^\\endcode/ { if (inside && text ~ /parallel --/) { ++n; printf "%s", text >("block" n) } inside = 0 }
     inside { text = text $0 "\n" }' "$manual"
[ -e block1 ] && [ -e block2 ] && [ ! -e block3 ] || fail "the manual has not two blocks that call parallel"
grep -q "sshlogin :,alpha,beta" block2 || fail "the second block names no machines"

# The program, with a list of the meshes that it was called for. It hangs at the mesh that the file `hang` names.
mkdir bin meshes
cat >bin/segment_mesh <<END
#!/bin/sh
echo "\$1" >>"$folder/log"
if [ "\$1" = "\$(cat "$folder/hang")" ]; then
  echo \$\$ >"$folder/hanging.part"
  mv "$folder/hanging.part" "$folder/hanging"
  exec sleep 60
fi
exec "$segment_mesh" "\$@"
END
chmod +x bin/segment_mesh
PATH=$folder/bin:$PATH
: >hang
: >log

# What the calls since the last time were for.
calls() {
  tr '\n' ' ' <log
  : >log
}

many() { # BLOCK
  status=0
  sh "$1" >out 2>err || status=$?
}

for i in 1 2 3 4 5 6; do
  printf 'OFF\n4 4 0\n0 0 0\n%s 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n' "$i" >"meshes/m $i.off"
done
echo "not a mesh" >meshes/x.off

# Killed at the fourth mesh: three are done, of the fourth nothing is there.
echo "meshes/m 4.off" >hang
sed 's/^parallel/exec parallel/' block1 >killed
sh killed >out 2>err &
run=$!
i=0
while [ ! -e hanging ]; do
  i=$((i + 1))
  [ $i -lt 600 ] || fail "the fourth mesh was not reached: $(cat err)"
  sleep 0.1
done
kill -KILL $run "$(cat hanging)"
wait $run 2>wait.err || true
expect "meshes/m 1.off meshes/m 2.off meshes/m 3.off meshes/m 4.off " "$(calls)" "meshes before the kill"
expect 6 "$(ls -A parts | wc -l | tr -d ' ')" "outputs before the kill"

# The rest, and no more; the bad mesh fails without harm to the others.
: >hang
many block1
[ $status -ne 0 ] || fail "a bad mesh is no failure"
expect "meshes/m 4.off meshes/m 5.off meshes/m 6.off meshes/x.off " "$(calls)" "meshes after the kill"
expect "meshes/x.off:1: no OFF header" "$(grep x.off err | cut -c1-29)" "the word on the bad mesh"
expect "" "$(cat out)" "words of a run that is quiet"

# What failed, and nothing else; then nothing.
cp "meshes/m 1.off" meshes/x.off
many block1
expect "0 meshes/x.off " "$status $(calls)" "meshes after the repair"
many block1
expect "0 " "$status $(calls)" "meshes when all is done"

# The outputs are those of one run of the program; on several machines, too, all of which are this one here.
mkdir expected
"$segment_mesh" meshes/*.off -q -k 7 -o 'expected/{stem}.seg' -o 'expected/{stem}.ply'
diff -r parts expected || fail "other outputs than by one run"
rm -r parts/* jobs.log
sed 's/:,alpha,beta/:,:/' block2 >machines
many machines
expect 0 $status "exit status on several machines ($(cat err))"
diff -r parts expected || fail "other outputs on several machines"
expect 7 "$(calls | tr -dc / | wc -c | tr -d ' ')" "meshes on several machines"
echo "all as expected"
