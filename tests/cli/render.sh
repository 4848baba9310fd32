# coppice render: pictures as files, the same for any threads and tree; what it tells; Ctrl-C.
source "$(dirname "$0")/lib.bash"

coppice generate spheres --triangles 1000 -o balls.ply >/dev/null
quick=(--size 40x30 --spp 2)

expect_exit 0 coppice render balls.ply -o a.png "${quick[@]}"
expect_stderr_empty
expect_stdout '^balls: [0-9,]+ triangles, loaded in '
expect_stdout '^  tree    auto, 8-wide tree, built in [0-9.]+ s, SAH cost '
expect_stdout '^  image   40 x 30 pixels of 2 samples, whitted, seed 1, '
expect_stdout '^  rays    2,400 primary, [0-9,]+ shadow$'
expect_stdout '^  traced  [0-9,]+ rays in [0-9.]+ s, [0-9.]+ Mrays/s$'
expect_stdout '^written: a.png$'
expect_equal "$(head -c 24 a.png | od -An -tx1 | tr -d ' \n')" \
    89504e470d0a1a0a0000000d494844520000002800""00001e

# The camera and the light that were chosen give the same picture again.
camera=$(sed -n 's/^  camera  \(.*\)  (chosen)$/\1/p' <<<"$stdout")
light=$(sed -n 's/^  light   \(.*\)  (chosen)$/\1/p' <<<"$stdout")
read -ra again <<<"$camera $light"
expect_exit 0 coppice render balls.ply -o b.png "${quick[@]}" "${again[@]}"
expect_same_file a.png b.png
! grep -q '(chosen)' <<<"$stdout" || fail 'what was given is called chosen'

# Any threads, any tree: the same image. Another seed, another one (all is open to ao here).
for integrator in whitted ao path normal depth; do
    shown=("${quick[@]}" --integrator "$integrator")
    coppice render balls.ply -o 1.pfm "${shown[@]}" --threads 1 >/dev/null
    coppice render balls.ply -o 2.pfm "${shown[@]}" --threads 2 --method sweep --sample 1% >/dev/null
    expect_same_file 1.pfm 2.pfm
    coppice render balls.ply -o 3.pfm "${shown[@]}" --seed 2 >/dev/null
    [[ $integrator == ao ]] || ! cmp -s 1.pfm 3.pfm || fail "$integrator: seed 2 gives the image of seed 1"
    coppice render balls.ply -o "$integrator.exr" "${shown[@]}" >/dev/null
    expect_file "$integrator.exr"
done

# The same as data.
mkdir new
expect_exit 0 coppice render balls.ply -o new/a.png "${quick[@]}" --integrator path --json \
    --method sampled --eye 50,60,70 --fov 30 --light none --sky 1,1,1
expect_equal "$(python3 -c '
import json, sys
report = json.load(sys.stdin)
rays = report["rays"]
assert rays["total"] == rays["primary"] + rays["diffuse"] and rays["primary"] == 2400, rays
assert rays["shadow"] == 0 and report["light"] is None and report["sky"] == [1.0, 1.0, 1.0]
assert report["build_seconds"] > 0 and report["trace_seconds"] > 0, report
assert report["mrays_per_second"] > 0 and report["build"]["sample_count"] > 0
camera = report["camera"]
print(report["method"], report["tree"], report["complete"], camera["eye"], camera["chosen"],
      report["output"])' <<<"$stdout")" 'sampled kd True [50.0, 60.0, 70.0] False new/a.png'
expect_file new/a.png

# Cost: the steps of a ray, with a scale that is chosen or given.
expect_exit 0 coppice render balls.ply -o cost.png --size 200x100 --spp 1 --integrator cost \
    --method sampled
expect_stdout '^  steps   [0-9.]+ inner nodes, [0-9.]+ leaves, [0-9.]+ primitives a ray; --cost-scale=[0-9]+$'
scale=$(sed -n 's/.*\(--cost-scale=.*\)/\1/p' <<<"$stdout")
coppice render balls.ply -o again.png --size 200x100 --spp 1 --integrator cost --method sampled \
    "$scale" >/dev/null
expect_same_file cost.png again.png

# Materials: without their file grey, and a warning.
expect_exit 0 coppice render "$data/tetrahedron.obj" -o a.png "${quick[@]}"
expect_stderr_one_line
expect_stderr 'warning: .*none.mtl: no such file; its materials are grey'

# Failures: one line, and nothing written. What cannot be written is found out before any work.
rm -f ./*.png
printf 'ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n' >points.ply
printf 'property float z\nend_header\n0 0 0\n' >>points.ply
for arguments in 'missing.obj' 'points.ply' 'balls.ply --eye 0,5,0 --look-at 0,0,0 --up 0,1,0'; do
    # shellcheck disable=SC2086 # several arguments
    expect_exit 1 coppice render $arguments -o failed.png
    expect_stderr_one_line
    expect_no_file failed.png
done
mkdir folder.png
expect_exit 1 coppice render missing.obj -o folder.png
expect_stderr_one_line
expect_stderr 'folder.png: is a directory, not a file'

expect_exit 1 coppice render balls.ply -o none/a.png
expect_stderr '^coppice: none/a.png: cannot write the file: make this folder first: none$'
expect_no_file none

# Wrong use.
wrong() { # wrong PATTERN ARG...
    expect_exit 2 coppice render "${@:2}"
    expect_stderr_one_line
    expect_stderr "^coppice: $1"
}
wrong 'render: no scene is given; example: coppice render ' -o a.png
wrong "render takes one scene; leave 'b.obj' out" a.obj b.obj -o a.png
wrong '--out: no file is given; example: --out image.png' a.obj
wrong "--out: 'a.jpg' ends in none of .png, .exr and .pfm" a.obj -o a.jpg
wrong "--integrator: unknown name 'pat' \(did you mean 'path'\?\)" a.obj --integrator pat
for size in 12 0x5 5x0 5x 16385x1 x -1x5 5x5x5 '5 x5'; do
    wrong "--size: '$size' is not a width and a height in \[1, 16384\] pixels; example: --size 1280x720" \
        a.obj --size="$size"
done
wrong "--spp: '0' is not a whole number in \[1, 65536\]" a.obj --spp 0
wrong "--max-depth: '-1' is not a whole number" a.obj --max-depth=-1
wrong "--light: 'here' is not " a.obj --light here
wrong "--sky: '0,-1,0' has a negative number" a.obj --sky 0,-1,0
wrong "--ao-distance: '0' is not a finite number > 0; example: --ao-distance 0.5" \
    a.obj --ao-distance 0

# On a terminal: a bar that is gone at the end. Ctrl-C writes what is done.
export TERM=xterm
expect_exit 0 python3 "$tests/terminal.py" seen "$COPPICE" render balls.ply -o a.png --size 64x64
grep -qE 'balls: rendering \[=* *\] [0-9]+ % \| ' <(tr '\r' '\n' <seen) || fail 'no progress bar'
expect_equal "$(tail -c 4 seen)" $'\r\e[K'
export INTERRUPT='rendering ['
expect_exit 1 python3 "$tests/terminal.py" seen "$COPPICE" render balls.ply -o cut.png \
    --spp 10000 --size 256x256
grep -qE 'coppice: interrupted: [0-9.]+ % of the pixels are done and written to cut.png' seen ||
    fail 'no word of the interruption'
expect_file cut.png
grep -q '^written: cut.png$' seen.stdout || fail 'no report of the part'
