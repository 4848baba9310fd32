# What makes an experiment fail, and that it leaves nothing behind then.
source "$(dirname "$0")/lib.bash"

coppice generate terrain --triangles 300 -o good.obj >/dev/null
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n' >range.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n' >zero.obj
printf 'v 0 0 0\nv 1 x 0\n' >malformed.obj
printf 'v 0 0 0\nv 1 nan 0\nv 0 1 0\nf 1 2 3\n' >nan.obj
printf 'v 0 0 0\n' >faceless.obj
: >empty.obj
mkdir folder
printf 'ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x
property float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices
end_header\n123456' >truncated.ply
all_files() { find . -not -name .stdout -not -name .stderr | sort; }
before=$(all_files)

failing() { # failing PATTERN ARG...
    local pattern=$1
    shift
    expect_exit 1 coppice experiment "$@"
    expect_stderr_one_line
    expect_stderr "$pattern"
    expect_equal "$(all_files)" "$before"
}

failing '^coppice: range\.obj:4: ' range.obj
failing '^coppice: zero\.obj:4: ' zero.obj
failing '^coppice: malformed\.obj:2: ' malformed.obj
failing '^coppice: nan\.obj:2: ' nan.obj
failing '^coppice: faceless\.obj: ' faceless.obj
failing '^coppice: empty\.obj: ' empty.obj
failing '^coppice: truncated\.ply: ' truncated.ply
failing '^coppice: missing\.obj: ' missing.obj
failing '^coppice: folder: ' folder

# One bad scene among good ones: found before any tree is built.
failing '^coppice: range\.obj:4: ' good.obj range.obj --out results
expect_stdout_empty
failing '^coppice: missing\.obj: ' good.obj missing.obj --out results

# Where no results can be written: found before any work.
failing '^coppice: good\.obj: is not a folder' good.obj --out good.obj
expect_stdout_empty
failing '^coppice: good\.obj/below.*: ' good.obj --out good.obj/below/it
expect_stdout_empty
failing '^coppice: /proc/coppice: cannot make the folder' good.obj --out /proc/coppice
expect_stdout_empty
mkdir -p taken/report.html
before=$(all_files)
failing '^coppice: taken/report.html: ' good.obj --out taken

# A reader of the tables that goes away does not keep the files from being written.
expect_exit 0 bash -o pipefail -c '"$COPPICE" experiment good.obj --no-pictures --out kept | head -1'
expect_stderr_empty
expect_file kept/results.csv kept/results.json kept/report.html
