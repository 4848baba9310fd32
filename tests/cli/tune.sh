# coppice tune: a table, one sentence with the answer, a JSON file.
source "$(dirname "$0")/lib.bash"

mkdir new
coppice generate spheres --triangles 500 -o balls.ply >/dev/null
quick=(--size 16 --runs 1 --threads 1)

expect_exit 0 coppice tune balls.ply "${quick[@]}" --rays 1e6 --methods sampled,exact --rates 5,100 \
    --json new/tune.json
expect_stderr_empty
expect_stdout '^  ?method +sample +s +s +ns'
expect_stdout '^[* ] sampled +[0-9.]+ % +[0-9]'
expect_stdout '^balls: for 1e\+06 rays use `(sampled|exact)` .*\.$'
expect_stdout '^written: new/tune.json$'
expect_equal "$(python3 - <<'PY'
import json
tune = json.load(open("new/tune.json"))
assert tune["options"]["rays"] == 1e6 and tune["options"]["rates"] == [5, 100]
[scene] = tune["scenes"]
for row in scene["rows"]:
    print(row["method"], round(row["sample_percent"]))
    total = row["build_seconds"] + 1e6 * row["ray_seconds"]
    assert abs(total - row["total_seconds"]) < 1e-9 * total
assert scene["recommended"] == min(scene["rows"], key=lambda row: row["total_seconds"])
for pair in scene["break_even"]:
    a, b = (next(row for row in scene["rows"]
                 if all(row[key] == pair[side][key] for key in pair[side]))
            for side in ("sooner", "later"))
    n = (a["build_seconds"] - b["build_seconds"]) / (b["ray_seconds"] - a["ray_seconds"])
    assert n > 0 and abs(n - pair["rays"]) < 1e-9 * n
PY
)" $'sampled 5\nsampled 100\nexact 100'

expect_exit 2 coppice tune
expect_stderr 'no scene is given; example: coppice tune '
for rays in 0 -1 x nan inf; do
    expect_exit 2 coppice tune balls.ply --rays="$rays"
    expect_stderr_one_line
    expect_stderr "^coppice: --rays: '$rays' is not a finite number >= 1; example: --rays 1e8"
done
expect_exit 1 coppice tune missing.obj --json failed.json
expect_stderr_one_line
expect_no_file failed.json
expect_exit 1 coppice tune balls.ply "${quick[@]}" --methods fast --kinds shadow \
    --eye 1000,1000,1000 --look-at 2000,1000,1000
expect_stderr_one_line
expect_stderr 'balls.ply: the camera sees no surface'
