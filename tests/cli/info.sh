# coppice info: counts, bounds, areas and issues, as text and as JSON.
source "$(dirname "$0")/lib.bash"

cat >odd.obj <<'OBJ'
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 0
v 7 7 7
f 1 2 3 4
f -6 -5 -2
OBJ

expect_exit 0 coppice info odd.obj
expect_stderr_empty
expect_stdout '^odd$'
expect_stdout '^  file +odd.obj \(obj, [0-9]+ bytes, loaded in '
expect_stdout '^  vertices +6, at 5 distinct positions$'
expect_stdout '^  triangles +3$'
expect_stdout '^  bounds +\(0, 0, 0\) to \(7, 7, 7\)$'
expect_stdout 'triangle areas +total 1, '
expect_stdout 'polygons, cut into triangles +1  \(faces 0\)'
expect_stdout 'triangles without area, kept +1  \(triangles 2\)'
expect_stdout 'repeated vertices, kept +1  \(vertices 4\)'
expect_stdout 'vertices of no triangle, kept +1  \(vertices 5\)'
expect_stdout 'relative \(negative\) indices +3$'

# What lies behind the last row is counted.
coppice generate soup --triangles 10 -o soup.ply >/dev/null
cat soup.ply soup.ply >twice.ply
expect_exit 0 coppice info twice.ply
expect_stdout "bytes behind the last row, unread +$(wc -c <soup.ply)\$"

# A scene without issues says so; several scenes follow each other.
coppice generate terrain --triangles 1000 -o terrain.ply >/dev/null
expect_exit 0 coppice info odd.obj terrain.ply
expect_stdout '^terrain$'
expect_stdout '^  issues +none$'
expect_equal "$(tr -d '\n -~' <<<"$stdout")" '' # plain text

expect_exit 0 coppice info --json odd.obj terrain.ply
expect_equal "$(python3 -c '
import json, sys
scenes = json.load(sys.stdin)["scenes"]
odd = scenes[0]
print(len(scenes), odd["scene"], odd["file"], odd["vertex_count"], odd["distinct_vertex_count"])
print(odd["areas"]["zero_count"], odd["areas"]["total"], odd["bounds"]["upper"])
print(odd["load_report"]["negative_index_count"], odd["load_report"]["unused_vertices"])
' <<<"$stdout")" "2 odd odd.obj 6 5
1 1.0 [7.0, 7.0, 7.0]
3 {'count': 1, 'first': [5]}"

# A name that looks like an option.
cp odd.obj ./-odd.obj
expect_exit 0 coppice info -- -odd.obj
expect_stdout '^-odd$'

# Bad files.
printf 'v 0 0 0\nv 1 0 0\nf 1 2 9\n' >broken.obj
: >empty.obj
failing() {
    expect_exit 1 coppice info "$1"
    expect_stdout_empty
    expect_stderr_one_line
    expect_stderr "$2"
}
failing broken.obj '^coppice: broken.obj:3: '
failing empty.obj '^coppice: empty.obj: '
failing missing.obj '^coppice: missing.obj: '
failing . '^coppice: \.: '
expect_exit 1 coppice info --json odd.obj broken.obj
expect_stdout_empty
