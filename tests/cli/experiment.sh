# coppice experiment: tables, files, and their agreement.
source "$(dirname "$0")/lib.bash"

header='scene,primitives,protocol,split,sampler,sample_percent,seed,primitive_count,sample_count'
header+=',node_count,inner_count,leaf_count,single_primitive_leaf_count,empty_leaf_count'
header+=',reference_count,max_level,mean_leaf_size,sample_seconds,build_seconds,empty_seconds'
header+=',refill_seconds,refine_seconds,total_seconds,sah_cost,relative_cost'

coppice generate spheres --triangles 2000 -o balls.ply >/dev/null
mkdir scenes
coppice generate terrain --triangles 300 -o scenes/hills.obj >/dev/null
gzip scenes/hills.obj

# The default run: both kinds, three protocols, eleven rates, one seed.
expect_exit 0 coppice experiment balls.ply
expect_stderr_empty # and so no progress line
expect_equal "$(ls -A out/balls)" $'experiment.json\nreport.html\nresults.csv\nresults.json'
expect_equal "$(head -1 out/balls/results.csv)" "$header"
expect_equal "$(wc -l <out/balls/results.csv)" 67
expect_equal "$(tr -d '\n -~' <<<"$stdout")" '' # no escape codes
# The report's pictures: the scene, heat maps of two trees and their difference; the trees in boxes.
expect_equal "$(grep -o 'src="data:image/png;base64,iVBOR' out/balls/report.html | wc -l)" 4
grep -q 'data-inspector="scene-1-inspector-data"' out/balls/report.html || fail 'no tree inspector'
expect_stdout '^balls, points: '
expect_stdout '^balls, triangles: '
expect_stdout '^\* recommended: the smallest sample whose cost is within 2 % of the full tree'
expect_stdout '^knee: .*Kneedle'
for file in results.csv results.json report.html experiment.json; do
    expect_stdout "^written: out/balls/$file$"
done

# Several scenes and lists; rates with and without a percent sign, in the order given, each once.
expect_exit 0 coppice experiment balls.ply scenes/hills.obj.gz --no-pictures --primitives points,points \
    --protocols grown --protocols fixed --rates 0.5,100% --rates 20,100 --seeds 2 --split median \
    --traversal-cost 15 --intersection-cost 20 --empty-bonus 0.2 --max-depth 12 --max-leaf 4 \
    --bad-refines 2 --threads 1 --out some/where
expect_equal "$(cut -d, -f1-7 some/where/results.csv | sed 1d)" "$(
    for scene in balls hills; do
        for protocol in grown fixed; do
            for seed in 1 2; do
                for percent in 0.5 100 20; do
                    echo "$scene,points,$protocol,median,uniform,$percent,$seed"
                done
            done
        done
    done
)"
expect_equal "$(python3 - <<'PY'
import csv, json
results = json.load(open("some/where/results.json"))
rows = [row for scene in results["scenes"] for row in scene["rows"]]
for line, row in zip(csv.DictReader(open("some/where/results.csv")), rows, strict=True):
    assert list(line) == list(row), (line, row)
    for key, value in row.items():
        assert line[key] == value if isinstance(value, str) else float(line[key]) == value, key
full = {}
for row in rows:
    if row["sample_percent"] == 100:
        full[row["scene"], row["protocol"], row["seed"]] = row["sah_cost"]
for row in rows:
    cost = full[row["scene"], row["protocol"], row["seed"]]
    assert row["relative_cost"] == row["sah_cost"] / cost
    assert row["max_level"] <= 12
options = results["options"]
options.pop("scenes")
print(options)
print([len(scene["recommended"]) for scene in results["scenes"]], results["command"][1])
PY
)" "$(tr -d '\n' <<<"{'bad_refines': 2, 'clipping': 'perfect', 'empty_bonus': 0.2, \
'intersection_cost': 20.0, 'max_depth': 12, 'max_leaf': 4, 'methods': [], 'out': 'some/where', \
'pictures': False, 'primitives': ['points'], 'protocols': ['grown', 'fixed'], \
'rates': [0.5, 100.0, 20.0], 'rays': [], 'samplers': ['uniform'], 'seeds': 2, 'split': 'median', 'threads': 1, 'tolerance': 2.0, 'traversal_cost': 15.0}")
[2, 2] experiment"

# The reference tree is built even if it is not asked for, and this is said.
expect_exit 0 coppice experiment balls.ply --no-pictures --rates 10 --primitives triangles --out ten
expect_stderr_one_line
expect_stderr '^coppice: note: 100 % '
expect_equal "$(wc -l <ten/results.csv)" 4

# The same run gives the same trees, for any number of threads; old results are replaced.
stable() { cut -d, -f1-17,24-25 "$1"; } # all but the times
coppice experiment balls.ply --no-pictures --rates 100,10 --seeds 2 --threads 1 --out twice >/dev/null
first=$(stable twice/results.csv)
coppice experiment balls.ply --no-pictures --rates 100,10 --seeds 2 --threads 2 --out twice >/dev/null
expect_equal "$(stable twice/results.csv)" "$first"
expect_equal "$(ls -A twice | wc -l)" 4

# A point cloud: points only, and it says so, unless triangles were asked for.
printf 'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y
property float z\nend_header\n0 0 0\n1 2 3\n4 5 6\n' >cloud.ply
expect_exit 0 coppice experiment cloud.ply --no-pictures
expect_stderr_one_line
expect_stderr 'cloud.ply: .*only points are run'
expect_equal "$(cut -d, -f2 out/cloud/results.csv | sort -u)" $'points\nprimitives'
expect_exit 1 coppice experiment cloud.ply --primitives triangles --out cloud
expect_stderr_one_line
expect_stderr '^coppice: cloud.ply: .*--primitives points'
expect_no_file cloud

# Odd but legal scenes.
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >one.obj
printf 'v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n' >equal.obj
for scene in one equal; do
    expect_exit 0 coppice experiment "$scene.obj" --max-leaf 1
    expect_equal "$(grep -ciE ',(-?nan|-?inf|null),?' "out/$scene/results.csv" || true)" 0
done

# A name that CSV must quote.
cp one.obj 'a, "b".obj'
expect_exit 0 coppice experiment 'a, "b".obj' --no-pictures --rates 100 --out quoted
expect_equal "$(sed -n 2p quoted/results.csv | cut -c1-22)" '"a, ""b""",points,fixe'
