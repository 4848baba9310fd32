# coppice experiment: methods, samplers and rays beside the protocols, and running it all again.
source "$(dirname "$0")/lib.bash"

coppice generate spheres --triangles 3000 -o balls.ply >/dev/null
expect_exit 0 coppice experiment balls.ply --protocols fixed,scaled,grown --rates 100,10 \
    --methods exact,binned,sampled,fast --samplers uniform,weighted --rays primary,shadow,axis \
    --size 16 --eye=-0.5,2,3 --no-pictures --out lab
expect_stderr "^coppice: note: balls: fast draws the same sample at 10 % as at another rate"
expect_stdout '^grown, weighted sample: '
expect_stdout '^binned: '
expect_stdout '^balls, rays through each tree of triangles \(points are not traced\): 256 primary'
expect_stdout 'kd trees, all rays: -?[01]\.[0-9]+ with the time of a ray'
expect_stdout 't_trav = [0-9.e+-]+ ns, t_isect = [0-9.e+-]+ ns; R\^2 = .*, RMS = .*, n = '
python3 - <<'PY' || fail 'the results are not what they should be'
import csv, json, math
document = json.load(open("lab/results.json"))
scene = document["scenes"][0]
lines = list(csv.DictReader(open("lab/results.csv")))
assert [list(line) for line in lines] == [list(row) for row in scene["rows"]]
steps = [f"{k}_{w}" for k in ("primary", "shadow", "axis")
         for w in ("mrays", "nodes", "leaves", "primitives")]
for line in lines:
    is_traced = line["primitives"] == "triangles"
    assert all((line[key] != "") == is_traced for key in steps + ["ray_nanoseconds"]), line
    assert line["mismatches"] == ("0" if is_traced else ""), line
    assert (line["sampler"] == "") == (line["protocol"] in ("exact", "binned")), line
    assert (line["split"] == "") == (line["protocol"] == "fast"), line
assert {line["primitives"] for line in lines if line["protocol"] == "fast"} == {"triangles"}
assert scene["errors"] == []
samplers = {(r["protocol"], r["sampler"]) for r in scene["recommended"]}
assert {("grown", "uniform"), ("grown", "weighted"), ("sampled", "weighted")} <= samplers, samplers

# Calibration by the same least squares as anybody's, and break-evens by their formula.
rays = scene["rays"]
traced = [r for r in scene["rows"] if r["split"] and r["ray_nanoseconds"]]
points = [(r[k + "_nodes"], r[k + "_primitives"], 1e3 / r[k + "_mrays"])
          for r in traced for k in ("primary", "shadow", "axis")]
found = rays["calibrations"][0]
assert found["count"] == len(points) and found["residuals"] == "absolute"
def squares(a, b): return sum((t - a * n - b * p) ** 2 for n, p, t in points)
a, b = found["traversal_nanoseconds"], found["intersection_nanoseconds"]
assert a >= 0 and b >= 0
assert math.isclose(math.sqrt(squares(a, b) / len(points)), found["rms_nanoseconds"], rel_tol=1e-6)
for da, db in ((0.01, 0), (-0.01, 0), (0, 0.01), (0, -0.01)):
    if a + da >= 0 and b + db >= 0:
        assert squares(a + da, b + db) >= squares(a, b) * (1 - 1e-9)
times = {(t["protocol"], t["sampler"], t["sample_percent"]): t for t in rays["trees"]}
for pair in rays["break_even"]:
    x, y = (times[tuple(pair[k].values())] for k in ("sooner", "later"))
    rays_needed = (x["build_seconds"] - y["build_seconds"]) / (y["ray_seconds"] - x["ray_seconds"])
    assert x["build_seconds"] < y["build_seconds"]
    assert math.isclose(pair["rays"], rays_needed, rel_tol=1e-9)
assert rays["fastest"][0]["from_rays"] == 0 and rays["fastest"][-1]["to_rays"] is None
for parts in scene["decomposition"]:
    whole = sum(parts[k] for k in ("early_stop", "empty_cells", "duplicates", "plane_error",
                                   "uneven_leaves"))
    assert abs(whole - parts["excess"]) < 1e-9
assert len(scene["decomposition"]) == 2 * 3 * 2
PY

# Again, from its record: the same but for times. Not if the scene has changed.
stable() { cut -d, -f1-17,24-25,27,29-31,33-35,37-39 "$1"; }
expect_exit 0 coppice experiment --replay lab/experiment.json
expect_equal "$(stable lab-replay/results.csv)" "$(stable lab/results.csv)"
mv balls.ply moved.ply
expect_exit 1 coppice experiment --replay lab/experiment.json --out again
expect_stderr '^coppice: balls.ply: cannot read the file'
expect_no_file again
expect_exit 0 coppice experiment moved.ply --replay lab/experiment.json --out again
printf 'x' >>moved.ply
expect_exit 1 coppice experiment moved.ply --replay lab/experiment.json
expect_stderr '^coppice: moved.ply: the file has changed since the experiment .* cannot be replayed$'
expect_exit 2 coppice experiment --replay lab/experiment.json --seeds 2
expect_stderr '^coppice: --seeds: --replay takes all options from its file; '
expect_exit 2 coppice experiment --replay lab/experiment.json --resume lab
expect_stderr_one_line
expect_exit 1 coppice experiment --replay lab/results.csv
expect_stderr '^coppice: lab/results.csv: is not the record of an experiment'

# Points are not traced, and no 8-wide trees are built over them.
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >one.obj
expect_exit 0 coppice experiment one.obj --primitives points --methods fast,exact --rays all --no-pictures --out p
expect_stderr 'one: rays are traced through triangles only'
expect_stderr 'one: fast is built over triangles only'
expect_exit 0 coppice experiment one.obj --rates 100 --rays all --size 4 --no-pictures --out one
expect_stdout 'rank-deficient|not defined'

# Wrong use.
expect_exit 2 coppice experiment one.obj --methods fsat
expect_stderr "^coppice: --methods: .*fsat.*did you mean 'fast'"
expect_exit 2 coppice experiment one.obj --rays all,green
expect_stderr '^coppice: --rays: .*green'
expect_exit 2 coppice experiment one.obj --sampler uniform --samplers weighted
expect_stderr '^coppice: --sampler: '
