# An option that has no effect with the others given is an error that says why; where that depends
# on the scene, it stands in the report.
source "$(dirname "$0")/lib.bash"

coppice generate spheres --triangles 1000 -o balls.ply >/dev/null

vain() { # vain OPTION REASON ARG...: the arguments have the option in vain
    local option=$1 reason=$2
    shift 2
    expect_exit 2 coppice "$@"
    expect_stdout_empty
    expect_stderr_one_line
    expect_stderr "^coppice: $option: it has no effect: .*$reason"
}

# Samples that are not drawn.
vain --sampler 'no sample is drawn with --method exact;' build balls.ply --method exact --sampler weighted
vain --seed 'no sample is drawn with --method quality;' build balls.ply --method quality --seed 2
vain --sampler '--method auto --sample 100%;' build balls.ply --sample 100% --sampler weighted
vain --sampler '--sample' trace balls.ply --method exact --sampler weighted
vain --sampler '--sample' render balls.ply -o a.png --method exact --sampler weighted
expect_exit 0 coppice build balls.ply --method exact --sample 10% --sampler weighted --seed 2
expect_exit 0 coppice build balls.ply --sampler weighted --seed 2
expect_exit 0 coppice trace balls.ply --size 4 --method exact --seed 2 # of the rays

# Builders that do not go by it.
vain --expected-rays 'only --method auto' build balls.ply --method fast --expected-rays 1e9
vain --empty-bonus '--method fast builds by constants' build balls.ply --method fast --empty-bonus 0.1
vain --traversal-cost '--method auto builds by constants' trace balls.ply --traversal-cost 2
expect_exit 0 coppice build balls.ply --method fast --traversal-cost 2 # it is measured by that
expect_exit 0 coppice trace balls.ply --size 4 --method exact --traversal-cost 2

# Rays that do not begin at a camera, or have no random directions.
vain --eye 'no rays begin at the camera' trace balls.ply --rays random --eye 1,2,3
vain --seed 'diffuse' bench balls.ply --rays primary --seed 2
vain --seed 'diffuse' tune balls.ply --kinds shadow --seed 2
vain --rates 'takes a sample' tune balls.ply --methods exact,quality --rates 5
vain --size 'no rays are traced' experiment balls.ply --size 10
vain --fov 'no rays begin' experiment balls.ply --fov 10
vain --samplers '100 %' experiment balls.ply --rates 100 --samplers weighted
vain --no-clip 'points are not cut' experiment balls.ply --primitives points --no-clip
if coppice list --json | grep -q embree-high; then
    expect_exit 0 coppice bench balls.ply --size 4 --runs 1 --methods exact --batched
else
    vain --batched 'one by one' bench balls.ply --methods exact --batched
fi

# Pictures: what is for another integrator, or another kind of file.
render() { vain "$1" "$2" render balls.ply -o "${@:3}"; }
render --exposure '.exr and .pfm' a.exr --exposure 1
render --exposure 'shows no light' a.png --exposure 1 --integrator normal
render --cost-scale 'only --integrator cost' a.png --cost-scale 9
render --cost-scale '.exr and .pfm' a.pfm --integrator cost --cost-scale 9
render --light 'shows no light' a.png --integrator ao --light 1,2,3
render --sky 'shows no light' a.png --integrator depth --sky 1,1,1
render --max-depth 'shows no light' a.png --integrator cost --max-depth 2
render --light-radius 'no lamp' a.png --light none --light-radius 1
render --ao-distance 'only --integrator ao' a.png --ao-distance 1
expect_no_file a.png a.exr a.pfm
quick=(--size 8x8 --spp 1)
expect_exit 0 coppice render balls.ply -o a.png "${quick[@]}" --exposure 1 --light 9,9,9 --light-radius 1
expect_exit 0 coppice render balls.ply -o a.png "${quick[@]}" --integrator ao --ao-distance 1

# What depends on the scene: this one is too small for a sample.
expect_exit 0 coppice build balls.ply --sample 5%
expect_stderr_empty
expect_stdout '^  note     sample.rate: the scene has [0-9]+ triangles; scenes of fewer than 200000 are not sampled'
expect_exit 0 coppice build balls.ply --sample 5% --json
expect_equal "$(python3 -c '
import json, sys
report = json.load(sys.stdin)["scenes"][0]["report"]
print(report["options"]["sample"]["rate"], report["sample"]["rate"],
      [note["option"] for note in report["notes"]])' <<<"$stdout")" "0.05 1.0 ['sample.rate']"
expect_exit 0 coppice render balls.ply -o a.png "${quick[@]}" --sample 5%
expect_stderr '^coppice: note: sample.rate: the scene has '
expect_exit 0 coppice trace balls.ply --size 4 --sample 5% --seed 2
expect_stderr '^coppice: note: sample.rate: the scene has '
expect_stderr_one_line
expect_exit 0 coppice render balls.ply -o a.png "${quick[@]}" --method fast # whose sample that is
expect_stderr_empty
