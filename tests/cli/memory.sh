# Limits on memory: that of --memory-limit, told before the build; that of the system, an error.
source "$(dirname "$0")/lib.bash"

coppice generate spheres --triangles 30000 -o balls.ply >/dev/null

refused() { # refused PATTERN CMD...
    expect_exit 1 "${@:2}"
    expect_stdout_empty
    expect_stderr_one_line
    expect_stderr "$1"
    expect_no_file a.cpk a.png
}
size='[0-9.]+ (KiB|MiB)'
for method in sampled quality; do
    refused "^coppice: (the build|quality) would take about $size of memory beside the $size of its primitives; the limit is 2.00 MiB$" \
        coppice build balls.ply --method $method --memory-limit 2M -o a.cpk
done
refused '^coppice: even fast would take about ' coppice build balls.ply --memory-limit 1000kb
refused '^coppice: even fast would take about ' coppice trace balls.ply --memory-limit 1mib
refused '^coppice: even fast would take about ' \
    coppice render balls.ply -o a.png --memory-limit 0.001g
refused '^coppice: balls, exact: the build would take about ' \
    coppice bench balls.ply --methods exact --peers embree-medium --runs 1 --size 20 --memory-limit 2M
refused '^coppice: balls, binned: the build would take about ' \
    coppice tune balls.ply --runs 1 --size 20 --memory-limit 2M

# An experiment goes on without the trees that would take more, also when it is resumed or replayed.
count_rows() { grep -c '^balls,triangles,fixed,' "$1/results.csv" || true; }
run=(coppice experiment balls.ply --primitives triangles --protocols fixed --rates 100,1 --no-pictures)
expect_exit 0 "${run[@]}" --out all
expect_equal "$(count_rows all)" 2
expect_exit 0 "${run[@]}" --out some --memory-limit 3M
expect_stderr_one_line
expect_stderr "^coppice: note: balls, triangles, fixed, 100 %, seed 1: the build would take about $size .*; this tree has no row$"
expect_equal "$(count_rows some)" 1
expect_exit 0 coppice experiment --replay some/experiment.json --out again
expect_equal "$(count_rows again)" 1
expect_exit 0 "${run[@]}" --out none --memory-limit 1K
expect_equal "$(count_rows none)" 0

# `auto` takes less if it must, and says so; what it took is within the limit.
peak() { # peak ARG...: scene and build together
    python3 -c '
import json, sys
scene = json.load(sys.stdin)["scenes"][0]
report = scene["report"]
print(report["preset"], scene["scene_bytes"] + report["peak_bytes"])' <<<"$stdout"
}
expect_exit 0 coppice build balls.ply --json --memory-limit 1T
expect_stderr_empty
read -r preset bytes <<<"$(peak)"
expect_equal "$preset" quality
expect_exit 0 coppice build balls.ply --json --memory-limit $((bytes * 97 / 100))
expect_stderr_one_line
expect_stderr "^coppice: note: quality would take about $size of memory beside .*; building with fast instead$"
read -r preset less <<<"$(peak)"
expect_equal "$preset" fast
((less <= bytes * 97 / 100)) || fail "$less bytes"
expect_exit 0 coppice render balls.ply -o a.png --size 40x30 --spp 1 --memory-limit $((bytes * 97 / 100))
expect_stderr ' building with fast instead$'

for wrong in 0 -1 x 1X '' 0.1 nan inf 1e30; do
    expect_exit 2 coppice build balls.ply --memory-limit="$wrong"
    expect_stderr_one_line
    [[ -z $wrong ]] || expect_stderr \
        "^coppice: --memory-limit: '$wrong' is not a size of at least 1 byte; example: --memory-limit 2G$"
done
expect_exit 2 coppice trace balls.ply --tree a.cpk --memory-limit 1G
expect_stderr '^coppice: --memory-limit: has no effect on the tree that --tree loads'

# Sanitizers themselves take more than any of what follows.
[[ $(ldd "$COPPICE") != *lib[at]san* ]] || exit 0

# What the program counts is what the system counts, but for the program itself.
coppice generate terrain --triangles 400000 -o large.ply >/dev/null
for method in fast sampled binned; do
    expect_exit 0 coppice build large.ply --method $method --json
    expect_equal "$(python3 -c '
import json, sys
scene = json.load(sys.stdin)["scenes"][0]
counted = scene["scene_bytes"] + scene["report"]["peak_bytes"]
held = scene["process_peak_bytes"]
print(counted < held < 1.1 * counted + 25e6 or (counted, held))' <<<"$stdout")" True
done

# Little memory is an error, not a crash.
for kilobytes in {60000..360000..60000}; do
    for method in exact sampled auto; do
        code=0
        (ulimit -v "$kilobytes"; coppice build large.ply --method $method) >.stdout 2>.stderr || code=$?
        ((code == 0 || code == 1 || code == 127)) ||
            fail "exit code $code of $method with $kilobytes KiB: $(<.stderr)"
        ((code != 1)) || grep -q '^coppice: .*\(memory\|cannot\)' .stderr || fail "$(<.stderr)"
    done
done
