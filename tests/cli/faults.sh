# What goes wrong around the program: disks that are full or read-only, pipes that close, names that
# are no text, scenes that come through a pipe, interrupts. Each is one line and an exit code; what
# is written is whole or not there.
source "$(dirname "$0")/lib.bash"

coppice generate spheres --triangles 2000 -o balls.ply >/dev/null
coppice generate terrain --triangles 300 -o hills.obj >/dev/null
coppice build balls.ply -o tree.cpk >/dev/null
quick=(--size 20x20 --spp 1)

failing() { # failing PATTERN CMD...
    local pattern=$1
    shift
    expect_exit 1 "$@"
    expect_stderr_one_line
    expect_stderr "$pattern"
}

# A scene from standard input, under either name, from a pipe or a file, gzipped or not.
whole=$(coppice info balls.ply --json | grep -v '"file"\|seconds\|"scene"')
gzip -k hills.obj
for how in 'cat balls.ply | coppice info - --json' 'coppice info - --json <balls.ply' \
    'cat balls.ply | coppice info /dev/stdin --json' 'gzip -c balls.ply | coppice info - --json'; do
    expect_exit 0 eval "$how"
    expect_stderr_empty
    expect_equal "$(grep -v '"file"\|seconds\|"scene"\|file_bytes' <<<"$stdout")" \
        "$(grep -v file_bytes <<<"$whole")"
done
expect_exit 0 eval 'cat hills.obj.gz | coppice build -'
expect_stdout '^stdin: auto \(quality\), 8-wide tree'
expect_exit 0 eval 'cat balls.ply | coppice render - -o piped.png "${quick[@]}"'
coppice render balls.ply -o named.png "${quick[@]}" >/dev/null
expect_same_file piped.png named.png
expect_exit 0 eval 'cat balls.ply | coppice check tree.cpk -'
expect_exit 0 eval 'cat hills.obj | coppice experiment - --rates 10 --no-pictures --out piped'
expect_file piped/results.json
expect_exit 0 eval 'cat balls.ply | coppice trace - --size 10 --rays primary'
expect_exit 0 eval 'coppice build <(cat balls.ply) <(gzip -c hills.obj)'
expect_stderr_empty
failing '^coppice: /dev/fd/99: ' coppice info /dev/fd/99
failing '^coppice: /dev/stdin: empty file$' coppice info - </dev/null
failing '^coppice: /dev/stdin: cannot read: Bad file descriptor$' eval 'coppice info - <&-'
failing '^coppice: /dev/stdin: the name has no extension, and the contents are not OBJ, PLY or OFF' \
    eval 'echo nonsense | coppice info -'
failing '^coppice: /dev/stdin: file ends at byte 5000' eval 'head -c 5000 balls.ply | coppice info -'
expect_exit 1 python3 "$tests/terminal.py" seen "$COPPICE" info -
grep -q '^coppice: /dev/stdin: is a terminal, not a scene' seen || fail 'it waits for a scene'

# Nobody reads the output: no failure. It cannot be written: one.
for how in 'list' 'info balls.ply hills.obj' 'build balls.ply hills.obj' '--help'; do
    expect_exit 0 bash -o pipefail -c "\"\$COPPICE\" $how | head -1"
    expect_stderr_empty
    expect_exit 0 bash -o pipefail -c "\"\$COPPICE\" $how | true"
    failing '^coppice: cannot write to standard output: ' eval "coppice $how >/dev/full"
    failing '^coppice: cannot write to standard output: ' eval "coppice $how >&-"
done

failing '^coppice: cannot write to standard output: ' \
    eval 'coppice experiment hills.obj --rates 100 --no-pictures --out piped >&-' # no file takes its number
is_json() { python3 -c 'import json, sys; json.loads(sys.stdin.buffer.read().decode("utf-8"))'; }
is_json <piped/results.json

# Names that are not UTF-8, names that are too long, folders that are not there.
name=$'\xff\xfe "x"'
coppice generate soup --triangles 100 -o "$name.ply" >/dev/null
expect_exit 0 coppice info "$name.ply" --json
is_json <.stdout
expect_exit 0 coppice build "$name.ply" --json -o "$name.cpk"
is_json <.stdout
expect_exit 0 coppice check "$name.cpk" "$name.ply" --json
is_json <.stdout
expect_exit 0 coppice render "$name.ply" -o "$name.png" --json "${quick[@]}"
is_json <.stdout
expect_exit 0 coppice trace "$name.ply" --size 10 --rays primary --json "$name.json"
is_json <"$name.json"
expect_exit 0 coppice bench "$name.ply" --runs 1 --size 10 --json bench.json
is_json <bench.json
expect_exit 0 coppice tune "$name.ply" --runs 1 --size 32 --json tune.json
is_json <tune.json
expect_exit 0 coppice experiment "$name.ply" --rates 50 --no-pictures --out "$name"
is_json <"$name/results.json"
expect_exit 0 coppice compare "$name" "$name"

# Such scenes are found again, and told from each other, by runs that go on or begin again.
coppice generate soup --triangles 90 -o $'\xfe.ply' >/dev/null
coppice generate soup --triangles 80 -o $'\xff.ply' >/dev/null
run=(coppice experiment $'\xfe.ply' $'\xff.ply' --primitives triangles --protocols fixed --rates 100 --no-pictures)
expect_exit 0 "${run[@]}" --out $'\xfe'
counts() { cut -d, -f2-3,6-11 "$1/results.csv"; }
expect_exit 0 coppice experiment --replay $'\xfe/experiment.json'
expect_equal "$(counts $'\xfe-replay')" "$(counts $'\xfe')"
(ulimit -f 64; "${run[@]}" --out cut) >/dev/null 2>&1 && fail 'no limit was met' # its journal is left
[[ -s cut/unfinished.jsonl ]] || fail 'nothing to resume'
expect_exit 2 coppice experiment $'\xfd.ply' --resume cut
expect_stderr_one_line
expect_exit 0 "${run[@]}" --resume cut
expect_equal "$(counts cut)" "$(counts $'\xfe')"

long=$(printf '%010000d' 0)
for how in "info $long.ply" "info $(printf '%0100d/' {1..99})x.ply" "build balls.ply -o $long.cpk" \
    "render balls.ply -o $long.png" "check $long balls.ply" "check tree.cpk $long" \
    "trace balls.ply --json $long" "trace balls.ply --tree $long" "generate spheres -o $long.ply" \
    "experiment balls.ply --out $long" "experiment --resume $long" "compare $long $long"; do
    # shellcheck disable=SC2086 # several arguments
    failing '(File name too long|no such file|cannot open the file)' coppice $how
    expect_stdout_empty # found out before any work
done
for how in 'build balls.ply -o none/a.cpk' 'render balls.ply -o none/a.png' \
    'trace balls.ply --json none/a.json' 'bench balls.ply --json none/a.json' \
    'tune balls.ply --json none/a.json'; do
    # shellcheck disable=SC2086 # several arguments
    failing '^coppice: none/a\.[a-z]+: cannot write the file: make this folder first: none$' coppice $how
    expect_stdout_empty # found out before any work
done
expect_no_file none
# A limit on the size of files is a failed write, not the end of the program.
coppice generate soup --triangles 3000 -o soup.ply >/dev/null
before=$(ls -A)
for how in 'build soup.ply -o big.cpk' 'render soup.ply -o big.exr --size 300x300 --spp 1' \
    'generate soup --triangles 3000 -o big.ply'; do
    # shellcheck disable=SC2086 # several arguments
    (ulimit -f 20 && failing 'File too large' coppice $how) || exit
done
expect_equal "$(ls -A)" "$before"
mkfifo pipe pipe.png
for how in 'trace balls.ply --json pipe' 'bench balls.ply --json pipe' 'tune balls.ply --json pipe' \
    'render balls.ply -o pipe.png' 'build balls.ply -o pipe'; do
    # shellcheck disable=SC2086 # several arguments
    failing '^coppice: pipe(\.png)?: not a regular file$' coppice $how
    expect_stdout_empty
done
[[ -p pipe && -p pipe.png ]] || fail 'a pipe was replaced'
rm pipe pipe.png

# A disk that is full, and one that may not be written to. Needs the right to mount.
export name
if unshare -rm mount -t tmpfs none /mnt 2>/dev/null; then
    unshare -rm bash -e <<'END' || fail 'on the small disk'
mkdir disk
mount -t tmpfs -o size=64k none disk
expect() { # expect PATTERN CMD...
    local code=0
    "$COPPICE" "${@:2}" >.stdout 2>.stderr || code=$?
    ((code == 1)) || { echo "exit code $code: ${*:2}"; cat .stderr; exit 1; }
    grep -qE "$1" .stderr || { echo "another error: ${*:2}"; cat .stderr; exit 1; }
    (($(wc -l <.stderr) == 1)) || { echo "several lines: ${*:2}"; cat .stderr; exit 1; }
    rm -f disk/results/unfinished.jsonl # finished trees are kept, to be resumed elsewhere
    rmdir disk/results 2>/dev/null || true
    [[ -z $(ls -A disk) ]] || { echo "left behind: ${*:2}"; ls -A disk; exit 1; }
}
for reason in 'No space left on device' 'Read-only file system'; do
    expect "$reason" build balls.ply -o disk/a.cpk
    expect "$reason" generate terrain --triangles 10000 -o disk/a.ply
    expect "$reason" render balls.ply -o disk/a.pfm --size 200x200 --spp 1
    expect "$reason" experiment hills.obj --no-pictures --out disk/results
    TMPDIR=disk expect "$reason" info - < <(head -c 200000 /dev/zero)
    mount -o remount,ro disk
done
umount disk
END
else
    echo 'skipped: full and read-only disks, for want of the right to mount one' >&2
fi

# Ctrl-C and SIGTERM stop a build, which says so and leaves nothing; in the terminal it is shown.
export TERM=xterm
coppice generate terrain --triangles 150000 -o large.ply >/dev/null
rm -f .stdout .stderr seen*
before=$(ls -A)
for how in 'build large.ply --method exact -o large.cpk' 'render large.ply --method exact -o large.png'; do
    # shellcheck disable=SC2086 # several arguments
    INTERRUPT='building [' expect_exit 1 python3 "$tests/terminal.py" seen "$COPPICE" $how
    grep -q 'coppice: interrupted: the tree is not finished, nothing is written' seen ||
        fail 'no word of the interruption'
    rm -f .stdout .stderr seen*
    expect_equal "$(ls -A)" "$before"
done
"$COPPICE" build large.ply --method exact -o large.cpk >term.out 2>term.err &
sleep 0.4
kill -TERM $! 2>/dev/null || true # it may be done already
code=0
wait $! || code=$?
case $code in
    0) expect_file large.cpk ;;
    1 | 143) expect_no_file large.cpk ;; # 143: while it still loaded
    *) fail "exit code $code after SIGTERM" ;;
esac
