# coppice build: the report of one build, as text and as JSON.
source "$(dirname "$0")/lib.bash"

coppice generate spheres --triangles 2000 -o balls.ply >/dev/null
coppice generate terrain --triangles 300 -o hills.obj >/dev/null

expect_exit 0 coppice build balls.ply
expect_stderr_empty
expect_stdout '^balls: '
for stage in sample build empty refill refine total; do
    expect_stdout "^  $stage +[0-9]+\.[0-9]+ +[0-9]+\.[0-9]+"
done
expect_stdout '^  tree +[0-9]+ nodes, '
expect_stdout '^  cost +[0-9]+\.[0-9]+, '
expect_stdout '^  memory +[0-9]+ bytes kept '
expect_equal "$(ls)" $'balls.ply\nhills.obj' # nothing is written

# Every method builds; several scenes; JSON.
methods=$(coppice list --json | python3 -c '
import json, sys
print(*(method["name"] for method in json.load(sys.stdin)["methods"]))')
for method in $methods; do
    expect_exit 0 coppice build balls.ply hills.obj --method "$method" --threads 1 --json
    expect_stderr_empty
    expect_equal "$(python3 -c '
import json, sys
for scene in json.load(sys.stdin)["scenes"]:
    report = scene["report"]
    assert report["method"] == sys.argv[1]
    assert report["options"]["threads"] == 1
    assert 0 < report["tree_bytes"] <= report["peak_bytes"]
    assert report["statistics"]["sah_cost"] > 0
    assert report["stages"]["total"]["wall_seconds"] > 0
    assert report["stages"]["sample"]["items"] == report["sample_count"]
    assert report["estimate"]["references"] > 0
    print(scene["scene"], scene["file"], report["primitive_count"] > 100)
' "$method" <<<"$stdout")" $'balls balls.ply True\nhills hills.obj True'
done

# Options reach the build; a share is written either way.
option() { # option KEY... ARG...: a value of the report's options
    python3 -c '
import functools, json, sys
options = json.load(sys.stdin)["scenes"][0]["report"]["options"]
print(functools.reduce(lambda value, key: value[key], sys.argv[1:], options))' "$@" <<<"$stdout"
}
for share in 5% 0.05 ' 5 %'; do
    expect_exit 0 coppice build balls.ply --method sampled --sample "$share" --seed 7 \
        --sampler uniform --traversal-cost 15 --intersection-cost 20 --empty-bonus 0.2 --json
    expect_equal "$(option sample rate)" 0.05
    expect_equal "$(option sample seed)" 7
    expect_equal "$(option cost traversal)" 15.0
    expect_equal "$(option cost empty_bonus)" 0.2
done

expect_exit 0 coppice build balls.ply --method exact --traversal-cost 15 --json
expect_equal "$(option cost traversal) $(option cost empty_bonus)" '15.0 0.2' # else the method's

# The method auto goes by the rays that are expected for a triangle, and says what it chose.
preset_for() {
    coppice build balls.ply --expected-rays "$1" --json |
        python3 -c 'import json, sys; print(json.load(sys.stdin)["scenes"][0]["report"]["preset"])'
}
triangles=$(coppice build balls.ply --json |
    python3 -c 'import json, sys; print(json.load(sys.stdin)["scenes"][0]["report"]["primitive_count"])')
expect_equal "$(preset_for $((30 * triangles - 1))) $(preset_for $((30 * triangles)))" 'fast quality'
expect_exit 0 coppice build balls.ply --expected-rays 0
expect_stdout '^balls: auto \(fast\), 8-wide tree, '
expect_exit 2 coppice build balls.ply --expected-rays -1
expect_stderr_one_line
expect_stderr 'expected-rays'

# The same seed gives the same tree, another seed another.
statistics() {
    coppice build balls.ply --method sampled --sample 5% --json "$@" | python3 -c '
import json, sys
print(json.load(sys.stdin)["scenes"][0]["report"]["statistics"])'
}
expect_equal "$(statistics --threads 1)" "$(statistics --threads 2)"
[[ $(statistics) != "$(statistics --seed 2)" ]] || fail 'the seed does not matter'

# A point cloud has no triangles: an empty tree.
expect_exit 1 coppice build missing.obj
expect_stderr_one_line
expect_stderr 'missing.obj'
