# coppice trace: rays of all kinds against one tree, counted and checked.
source "$(dirname "$0")/lib.bash"

mkdir new
coppice generate spheres --triangles 1000 -o balls.ply >/dev/null
coppice generate city --triangles 300 -o town.obj >/dev/null

# Against every triangle, for a k-d tree and an 8-wide one.
for method in sampled fast; do
    expect_exit 0 coppice trace balls.ply town.obj --size 20 --method $method --check brute
    expect_stderr_empty
    expect_stdout "^balls: [0-9]+ triangles; $method built in "
    expect_stdout "^town: [0-9]+ triangles; $method built in "
    for kind in primary shadow diffuse random axis grazing; do
        expect_stdout "^$kind +400 +[1-9][0-9]* +[0-9.]+$"
        expect_stdout "^$kind +0 +0 +0 +0 +0 +0$"
    done
done

# Counts, as text and in the JSON; kinds in the order asked for.
expect_exit 0 coppice trace balls.ply --size 10 --rays axis,primary,axis --method exact --count \
    --seed 3 --eye 50,60,70 --look-at 0,0,0 --json new/trace.json
expect_stdout '^axis +nodes +[0-9]+\.[0-9]+ +[0-9]+ +[0-9]+ +[0-9]+ +[0-9]+$'
expect_stdout '^primary +primitives +[0-9]'
expect_stdout '^written: new/trace.json$'
expect_equal "$(python3 - <<'PY'
import json
trace = json.load(open("new/trace.json"))
assert list(trace) == ["machine", "options", "scenes"], list(trace)
scene, = trace["scenes"]
for row in scene["rows"]:
    assert row["rays"] == 100 and row["hits"] <= 100 and row["mrays"] > 0
    for what in "nodes leaves primitives".split():
        of = row["counts"][what]
        assert of["mean"] <= of["max"] and of["p50"] <= of["p90"] <= of["p99"] <= of["max"], of
    print(row["kind"], "comparison" in row)
print(trace["options"]["method"], trace["options"]["seed"], scene["camera"]["eye"])
PY
)" "axis False
primary False
exact 3 [50.0, 60.0, 70.0]"

expect_exit 0 coppice trace balls.ply --size 10 --rays shadow,grazing --method fast --count
expect_stdout '^shadow +nodes +[1-9]'
expect_stdout '^grazing +primitives +[1-9]'

# Embree, where the program has it.
if coppice list --json | grep -q embree-robust; then
    expect_exit 0 coppice trace town.obj --size 40 --check embree --threads 1 --json e.json
    expect_stdout '^compared +ties +hit/miss +distance +ours right +embree right +ours wrong$'
    expect_equal "$(python3 -c '
import json
for row in json.load(open("e.json"))["scenes"][0]["rows"]:
    of = row["comparison"]
    assert of["ours_right"] == of["hit_miss"] + of["distance"] and of["ours_wrong"] == 0, of
    assert len(of["examples"]) == min(5, of["ours_right"]), of
    assert all(each["ours"]["right"] for each in of["examples"]), of
')" ''
else
    expect_exit 2 coppice trace town.obj --check embree
    expect_stderr 'built without Embree'
fi

expect_exit 0 coppice trace balls.ply --size 4 --rays all --json all.json
expect_equal "$(python3 -c 'import json; print(len(json.load(open("all.json"))["scenes"][0]["rows"]))')" 6

# Failures: one line, and nothing written.
expect_exit 1 coppice trace missing.obj --json failed.json
expect_stderr_one_line
expect_stderr 'missing.obj'
expect_no_file failed.json
printf 'v 0 0 0\nv 1 2 3\n' >points.obj
expect_exit 1 coppice trace points.obj
expect_stderr 'points.obj'
for wrong in '--check what' '--rays sun' '--rays' '--size 0' '--size 9000' '--method none' \
    '--json folder/' '--count=3' '--sample 0' '--what'; do
    # shellcheck disable=SC2086
    expect_exit 2 coppice trace balls.ply $wrong
    expect_stderr_one_line
done
expect_exit 2 coppice trace --count
expect_stderr_one_line
expect_stderr 'no scene is given'
