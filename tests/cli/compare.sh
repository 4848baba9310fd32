# coppice compare: exit code 0 for equal results, 1 where the second is worse.
source "$(dirname "$0")/lib.bash"

coppice generate spheres --triangles 300 -o balls.ply >/dev/null
coppice experiment balls.ply --no-pictures --rates 100,10 --protocols fixed --primitives triangles --out a >/dev/null
python3 - <<'PY'
import json
results = json.load(open("a/results.json"))
results["scenes"][0]["rows"][1]["sah_cost"] *= 1.5
json.dump(results, open("worse.json", "w"))
PY

expect_exit 0 coppice compare a a/results.json
expect_stderr_empty
expect_stdout '^2 rows are in both, 0 only in A, 0 only in B$'
expect_stdout '^4 figures compared: 0 worse, 0 better in B, 4 within noise$'
expect_exit 1 coppice compare a worse.json --json c.json
expect_stdout '^worse +balls, triangles, fixed, 10 % +sah_cost .* 1\.5000 '
expect_stderr '^coppice: 1 figure is worse in worse.json$'
expect_equal "$(python3 -c 'import json; print(json.load(open("c.json"))["worse"])')" 1
expect_exit 0 coppice compare worse.json a
expect_stdout '^better +balls, triangles, fixed, 10 % +sah_cost '
expect_exit 0 coppice compare a worse.json --tolerance 60%

for files in '' a 'a a a'; do
    # shellcheck disable=SC2086
    expect_exit 2 coppice compare $files
    expect_stderr_one_line
done
expect_exit 2 coppice compare a a --tolerance=-1
expect_stderr "^coppice: --tolerance: '-1' is not a finite number of percent >= 0; example: "
expect_exit 1 coppice compare a missing.json
expect_stderr '^coppice: missing.json: cannot open the file'
expect_exit 1 coppice compare balls.ply a
expect_stderr '^coppice: balls.ply: is not JSON'
