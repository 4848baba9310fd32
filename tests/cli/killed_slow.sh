# An experiment that is killed with SIGKILL at 20 random moments of a sweep: resumed, it ends with
# the results that it would have had. COPPICE_KILLS=N kills it that often.
source "$(dirname "$0")/lib.bash"

RANDOM=42 # the moments are the same every time, as shares of a whole run
coppice generate spheres --triangles 3000 -o balls.ply >/dev/null
options=(--rates 50,20,5,1 --seeds 2 --threads 1)
stable() { cut -d, -f1-17,24-25 "$1"; } # all but the times

begin=$(date +%s%N)
coppice experiment balls.ply "${options[@]}" --out whole >/dev/null 2>&1
whole_microseconds=$((($(date +%s%N) - begin) / 1000))

resumed=0
for ((run = 0; run < ${COPPICE_KILLS:-20}; ++run)); do
    "$COPPICE" experiment balls.ply "${options[@]}" --out killed >/dev/null 2>&1 &
    pid=$!
    microseconds=$((whole_microseconds * (RANDOM % 1000) / 1000))
    sleep "$(printf '%d.%06d' $((microseconds / 1000000)) $((microseconds % 1000000)))"
    kill -KILL $pid 2>/dev/null || true # it may be done already
    wait $pid 2>/dev/null || true
    if [[ -e killed/unfinished.jsonl ]]; then
        expect_exit 0 coppice experiment --resume killed
        resumed=$((resumed + 1))
    elif [[ ! -e killed/results.csv ]]; then # before it had begun: there is nothing to go on with
        expect_exit 1 coppice experiment --resume killed
        expect_exit 0 coppice experiment balls.ply "${options[@]}" --out killed
    fi
    expect_equal "$(ls -A killed)" $'experiment.json\nreport.html\nresults.csv\nresults.json'
    expect_equal "$(stable killed/results.csv)" "$(stable whole/results.csv)"
    rm -r killed
done
((resumed > 0)) || fail 'no kill hit the sweep'
echo "$run kills, $resumed of them in the sweep: all with the results of a whole run"
