# coppice list: every name that an option takes, as text and as JSON.
source "$(dirname "$0")/lib.bash"

expect_exit 0 coppice list
expect_stderr_empty
for name in points triangles fixed scaled grown sah median midpoint uniform \
    terrain spheres soup city; do
    expect_stdout "^  $name +[a-z]"
done

expect_exit 0 coppice list --json
expect_equal "$(python3 -c '
import json, sys
for key, entries in json.load(sys.stdin).items():
    if key == "peers":
        continue  # depends on whether there is an Embree
    print(key, *(entry["name"] for entry in entries if entry["summary"]))
' <<<"$stdout")" 'primitives points triangles
protocols fixed scaled grown
methods exact binned sampled subsampled adaptive sweep fast balanced quality auto
integrators whitted ao path normal depth cost
rays primary shadow diffuse random axis grazing
splits sah median midpoint exact binned subsampled adaptive
samplers uniform stratified weighted
procedural_scenes terrain spheres soup city'

# A reader that goes away is no failure; a full disk is.
expect_exit 0 bash -o pipefail -c '"$COPPICE" list | head -0'
expect_stderr_empty
expect_exit 1 bash -c '"$COPPICE" list >/dev/full'
expect_stderr_one_line
expect_stderr 'cannot write to standard output'
