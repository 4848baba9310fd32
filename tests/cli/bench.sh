# coppice bench: a table and a JSON file of what was measured.
source "$(dirname "$0")/lib.bash"

coppice generate spheres --triangles 1000 -o balls.ply >/dev/null
coppice generate terrain --triangles 300 -o hills.obj >/dev/null

quick=(--size 16 --runs 1)
expect_exit 0 coppice bench balls.ply "${quick[@]}" --threads 1 --methods sweep,sampled
expect_stderr_empty
expect_stdout '^balls: [0-9]+ triangles; seen from '
expect_stdout '^rays: 256 primary, [1-9][0-9]* shadow, [1-9][0-9]* diffuse; '
expect_stdout '^sweep +1 +[0-9]'
expect_stdout '^sampled +1 +[0-9]'
expect_equal "$(ls)" $'balls.ply\nhills.obj'

# The JSON has the agreed keys; rows by scene, threads and contestant, in the order asked for.
mkdir new
expect_exit 0 coppice bench balls.ply hills.obj "${quick[@]}" --threads 2,1 --methods sweep,exact \
    --rays diffuse --batched --eye 50,60,70 --look-at 0,0,0 --up=0,0,-1 --fov 60 --seed 3 --json new/b.json
expect_stdout '^written: new/b.json$'
expect_equal "$(ls -A new)" b.json
expect_equal "$(python3 - <<'PY'
import json
bench = json.load(open("new/b.json"))
assert list(bench) == ["machine", "options", "rows"], list(bench)
keys = """scene triangles method peer threads build_seconds build_seconds_first build_cpu_seconds
bytes_per_triangle peak_bytes_per_triangle sah_cost references_per_triangle primary_mrays
shadow_mrays diffuse_mrays mismatches""".split()
for row in bench["rows"]:
    assert list(row) == keys, row
    assert row["primary_mrays"] is None and row["shadow_mrays"] is None
    assert row["build_seconds"] > 0 and row["bytes_per_triangle"] > 0
    assert (row["sah_cost"] is None) == row["peer"]
    if not row["peer"]:
        print(row["scene"], row["threads"], row["method"])
options = bench["options"]
print(options["eye"], options["up"], options["fov"], options["seed"], options["rays"], options["batched"])
print(*(view["scene"] for view in options["views"]))
PY
)" "balls 2 sweep
balls 2 exact
balls 1 sweep
balls 1 exact
hills 2 sweep
hills 2 exact
hills 1 sweep
hills 1 exact
[50.0, 60.0, 70.0] [0.0, 0.0, -1.0] 60.0 3 ['diffuse'] True
balls hills"

# Embree, where the program has it: its figures, hits that agree, and ratios.
peers=$(coppice list --json | python3 -c '
import json, sys
print(",".join(peer["name"] for peer in json.load(sys.stdin)["peers"]))')
if [[ -n $peers ]]; then
    expect_exit 0 coppice bench balls.ply hills.obj "${quick[@]}" --peers "$peers" \
        --methods sweep --threads 1 --json b.json
    expect_stdout 'compared with embree-robust$'
    expect_stdout '^Times faster than in the same run: building than embree-medium'
    expect_stdout '^sweep +1 geometric mean +[0-9]'
    expect_equal "$(python3 -c '
import json
rows = json.load(open("b.json"))["rows"]
print(sum(row["peer"] for row in rows), max(row["mismatches"] for row in rows) < 3)
')" '8 True'
else
    expect_exit 2 coppice bench balls.ply --peers embree-high
    expect_stderr 'built without Embree'
fi

# Failures: one line, and nothing written.
printf 'v 0 0 0\nv 1 2 3\n' >points.obj
for file in missing.obj points.obj; do
    expect_exit 1 coppice bench "$file" --json failed.json
    expect_stderr_one_line
    expect_stderr "$file"
    expect_no_file failed.json
done
mkdir folder
expect_exit 1 coppice bench balls.ply "${quick[@]}" --json folder
expect_stderr_one_line
expect_exit 1 coppice bench balls.ply "${quick[@]}" --eye 0,5,0 --look-at 0,0,0 --up 0,1,0
expect_stderr_one_line
expect_stderr 'up vector'
