# coppice experiment on a terminal: a progress line that is there, and gone at the end; Ctrl-C.
source "$(dirname "$0")/lib.bash"

coppice generate terrain --triangles 20000 -o hills.ply >/dev/null

export TERM=xterm
run() { expect_exit "$1" python3 "$tests/terminal.py" "$2" "$COPPICE" experiment hills.ply --no-pictures "${@:3}"; }
wipe=$'\r\e[K'

run 0 seen --rates 100,10 --out done
expect_file done/results.csv
progress=$(tr '\r' '\n' <seen)
grep -q 'hills: loading | 0 s' <<<"$progress" || fail 'no line while loading'
grep -q 'hills 1/12: points, fixed, 100 %, seed 1 | ' <<<"$progress" || fail 'no first row'
grep -qE 'hills 12/12: triangles, grown, 10 %, seed 1 \| .*, about [0-9]+ s left' \
    <<<"$progress" || fail 'no last row with remaining time'
grep -q 'writing the report' <<<"$progress" || fail 'no line while writing'
expect_equal "$(tail -c 4 seen)" "$wipe"
[[ $(wc -l <seen) -eq 0 ]] || fail 'the progress is more than one line'
! grep -q $'\e' seen.stdout || fail 'escape codes on stdout'

# A note does not get mixed up with the line.
run 0 seen --rates 10 --out done
python3 - <<'PY' || fail 'the note is mixed up with the line'
import re
assert re.search(rb'(^|\n|\r\x1b\[K)coppice: note: 100 %[^\r\n]*\r\n', open('seen', 'rb').read())
PY

# Nothing on a terminal that cannot wipe lines.
TERM=dumb run 0 seen --rates 100 --out done
expect_equal "$(<seen)" ''

# Ctrl-C: the shell's code for it, no results, only what --resume needs, a clean line.
INTERRUPT=', 4 %' run 130 seen --out interrupted
expect_equal "$(ls -A interrupted)" unfinished.jsonl
! ls -A | grep -q '^\.coppice' || fail 'a temporary folder is left'
grep -q "$(printf '\r\e\\[K')$" seen || fail 'the line is not wiped'
