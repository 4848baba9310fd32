# coppice experiment --resume: a run that was killed ends with the results it would have had.
source "$(dirname "$0")/lib.bash"

coppice generate terrain --triangles 20000 -o hills.ply >/dev/null
options=(--no-pictures --rates 50,1 --seeds 2)
stable() { cut -d, -f1-17,24-25 "$1"; } # all but the times

coppice experiment hills.ply "${options[@]}" --out whole >/dev/null 2>&1
expect_equal "$(ls -A whole)" $'experiment.json\nreport.html\nresults.csv\nresults.json'

# Killed after a few trees, in the midst of a line.
"$COPPICE" experiment hills.ply "${options[@]}" --out killed >/dev/null 2>&1 &
pid=$!
until [[ -e killed/unfinished.jsonl && $(wc -l <killed/unfinished.jsonl) -ge 5 ]]; do
    kill -0 "$pid" || fail 'it ended before it could be killed'
    sleep 0.01
done
kill -KILL "$pid"
wait "$pid" 2>/dev/null || true
expect_equal "$(ls -A killed)" unfinished.jsonl
printf '{"scene": "hil' >>killed/unfinished.jsonl
cp -r killed again

# Options that are not those of the run are refused.
expect_exit 2 coppice experiment hills.ply --no-pictures --rates 50,2 --seeds 2 --resume killed
expect_stderr '^coppice: --resume: the run in killed was started with rates \[50.0,1.0\], not \[50.0,2.0\]; '
expect_exit 2 coppice experiment --seeds 2 --resume killed
expect_stderr '^coppice: --seeds: --resume uses the options '
expect_exit 2 coppice experiment --resume killed --out other
expect_stderr_one_line

expect_exit 0 coppice experiment --resume killed
expect_stderr '^coppice: note: killed: reusing [1-9][0-9]* finished trees$'
expect_equal "$(ls -A killed)" $'experiment.json\nreport.html\nresults.csv\nresults.json'
expect_equal "$(stable killed/results.csv)" "$(stable whole/results.csv)"
expect_equal "$(python3 - <<'PY'
import json
a, b = (json.load(open(f"{d}/results.json")) for d in ("whole", "killed"))
keys = ["created", "command"]
def strip(value):  # what a clock or the folder's name is in
    if isinstance(value, dict):
        return {k: strip(v) for k, v in value.items()
                if "seconds" not in k and "time" not in k and k not in
                ("created", "command", "out", "recommended", "knees")}
    return [strip(v) for v in value] if isinstance(value, list) else value
print(strip(a) == strip(b), b["command"][1:3])
# What was finished is kept to the bit.
finished = [json.loads(line) for line in open("again/unfinished.jsonl").read().split("\n")[1:-1]]
rows = {(r["primitives"], r["protocol"], r["sample_percent"], r["seed"]): r
        for r in b["scenes"][0]["rows"]}
for row in finished:
    if row["sample_percent"] == 100: continue
    stages = row["report"]["stages"]
    kept = rows[row["primitives"], row["protocol"], row["sample_percent"], row["seed"]]
    assert abs(kept["build_seconds"] - stages["build"]["wall_seconds"]) < 1e-6
PY
)" "True ['experiment', 'hills.ply']"

# The same options may be given again; nothing is done twice; a run without --resume says so.
expect_exit 0 coppice experiment hills.ply "${options[@]}" --resume again
expect_equal "$(stable again/results.csv)" "$(stable whole/results.csv)"
expect_exit 0 coppice experiment --resume again
expect_stdout '^again: the experiment is finished$'
expect_exit 1 coppice experiment --resume nowhere
expect_stderr_one_line
expect_stderr 'there is no unfinished experiment'
