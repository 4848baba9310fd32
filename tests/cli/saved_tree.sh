# coppice build -o, check, and --tree of trace and render.
source "$(dirname "$0")/lib.bash"

coppice generate spheres --triangles 2000 -o balls.ply >/dev/null
coppice generate terrain --triangles 300 -o hills.obj >/dev/null

for method in fast sampled; do
    expect_exit 0 coppice build balls.ply --method $method --threads 1 -o tree.cpk
    expect_stderr_empty
    expect_stdout '^written: tree.cpk$'
    coppice build balls.ply --method $method --threads 2 -o twin.cpk >/dev/null
    expect_same_file tree.cpk twin.cpk

    expect_exit 0 coppice check tree.cpk balls.ply
    expect_stdout '^  tree       sound$'
    expect_exit 0 coppice check tree.cpk balls.ply --json
    expect_equal "$(python3 -c '
import json, sys
c = json.load(sys.stdin)
print(c["method"], c["sound"], c["findings"], "threads" in c["options"])' <<<"$stdout")" "$method True [] False"

    expect_exit 0 coppice trace balls.ply --tree tree.cpk --size 30 --check brute --rays random
    expect_stdout "$method loaded in"
    expect_exit 0 coppice render balls.ply --tree tree.cpk --size 40x30 --spp 1 -o loaded.pfm
    expect_stdout "^  tree    $method, .* loaded from tree.cpk in "
    coppice render balls.ply --method $method --size 40x30 --spp 1 -o built.pfm >/dev/null
    expect_same_file loaded.pfm built.pfm
done

# What is refused, in one line that names the file and the reason.
refused() { # refused PATTERN CMD...
    local pattern=$1
    shift
    expect_exit 1 "$@"
    expect_stderr_one_line
    expect_stderr "$pattern"
    expect_stdout_empty
}
refused 'tree.cpk: built for another mesh: [0-9]+ primitives, not ' coppice check tree.cpk hills.obj
refused 'tree.cpk: built for another mesh: ' coppice trace hills.obj --tree tree.cpk
refused 'tree.cpk: built for another mesh: ' coppice render hills.obj --tree tree.cpk -o x.png
refused 'balls.ply: not a coppice tree file' coppice trace balls.ply --tree balls.ply
refused 'none.cpk: no such file' coppice check none.cpk balls.ply
refused 'tree.cpk: ' coppice check balls.ply tree.cpk
head -c 1000 tree.cpk >cut.cpk
refused 'cut.cpk: truncated: 1000 of [0-9]+ bytes' coppice check cut.cpk balls.ply
{ head -c 999 tree.cpk && printf '\x55\xaa' && tail -c +1002 tree.cpk; } >flipped.cpk
refused 'flipped.cpk: damaged: the checksum of the nodes is wrong' coppice check flipped.cpk balls.ply
refused '/dev/full: not a regular file' coppice build balls.ply -o /dev/full
refused "none/tree.cpk|cannot" coppice build balls.ply -o /proc/none/tree.cpk
expect_no_file x.png

# Wrong use.
wrong() {
    local pattern=$1
    shift
    expect_exit 2 "$@"
    expect_stderr_one_line
    expect_stderr "$pattern"
}
wrong '--out takes the tree of one scene' coppice build balls.ply hills.obj -o a.cpk
wrong 'is the scene itself' coppice build balls.ply -o ./balls.ply
wrong '^coppice: --method: .*--tree' coppice trace balls.ply --tree tree.cpk --method fast
wrong '^coppice: --expected-rays: .*--tree' coppice trace balls.ply --tree tree.cpk --expected-rays 1e6
wrong '--tree is the tree of one scene' coppice trace balls.ply hills.obj --tree tree.cpk
wrong 'no tree is given' coppice check
wrong 'no scene is given' coppice check tree.cpk
wrong "unexpected argument 'c'" coppice check tree.cpk balls.ply c
expect_no_file a.cpk

# Names need not be UTF-8; a scene that was overwritten would not load.
name=$'\xff tree.cpk'
expect_exit 0 coppice build balls.ply -o "$name" --json
expect_exit 0 coppice check "$name" balls.ply --json
expect_exit 0 coppice info balls.ply

# Little memory is an error, not a crash. Sanitizers themselves take more than any of this.
limits=(60000 90000 120000 200000)
[[ $(ldd "$COPPICE") != *lib[at]san* ]] || limits=()
for kilobytes in "${limits[@]}"; do
    code=0
    (ulimit -v $kilobytes; coppice check tree.cpk balls.ply) >.stdout 2>.stderr || code=$?
    ((code == 0 || code == 1 || code == 127)) || fail "exit code $code with $kilobytes KiB"
done
