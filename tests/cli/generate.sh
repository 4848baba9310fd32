# coppice generate: procedural scenes as files.
source "$(dirname "$0")/lib.bash"

for kind in terrain spheres soup city; do
    expect_exit 0 coppice generate "$kind" --triangles 1000 -o "$kind.obj"
    expect_stderr_empty
    expect_stdout "^written: $kind.obj \([0-9]+ triangles, [0-9]+ vertices\)$"
    expect_exit 0 coppice generate "$kind" --triangles 1000 --seed 1 --out "$kind.ply"
    expect_file "$kind.obj" "$kind.ply"
    # Both formats hold the same scene.
    count() { coppice info "$1" --json | python3 -c '
import json, sys
scene = json.load(sys.stdin)["scenes"][0]
print(scene["triangle_count"], scene["vertex_count"], scene["bounds"])'; }
    expect_equal "$(count "$kind.obj")" "$(count "$kind.ply")"
done

# The same arguments give the same file, another seed another.
coppice generate soup --triangles 1000 -o again.obj >/dev/null
expect_same_file soup.obj again.obj
coppice generate soup --triangles 1000 --seed 2 -o other.obj >/dev/null
! cmp -s soup.obj other.obj || fail 'seed 2 gives the scene of seed 1'

# What cannot be written: one line, nothing left behind.
mkdir folder && cd folder
failing() {
    expect_exit 1 coppice generate soup --triangles 100 -o "$1"
    expect_stdout_empty
    expect_stderr_one_line
    expect_stderr "^coppice: $1: "
}
failing soup.xyz
failing no/such/folder/soup.obj
failing /proc/soup.ply
expect_equal "$(ls)" ''
