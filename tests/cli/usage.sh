# Wrong use: exit code 2 and one line on what is wrong and how to mend it.
source "$(dirname "$0")/lib.bash"

wrong() { # wrong PATTERN ARG...
    local pattern=$1
    shift
    expect_exit 2 coppice "$@"
    expect_stdout_empty
    expect_stderr_one_line
    expect_stderr '^coppice: '
    expect_stderr "$pattern"
}

# No arguments: the short help.
expect_exit 2 coppice
expect_stdout_empty
expect_stderr '^Usage: coppice COMMAND'
expect_stderr '^  experiment '

# Every command has help with an example; help is not an error.
for command in experiment build bench tune compare render info list generate; do
    expect_exit 0 coppice "$command" --help
    expect_stderr_empty
    expect_stdout "^Usage: coppice $command"
    expect_stdout '^Examples:'
    expect_stdout "^  coppice $command "
    expect_equal "$(awk 'length > 100' <<<"$stdout")" ''
    expect_exit 0 coppice "$command" -h
done
expect_exit 0 coppice --help
expect_stdout '^  coppice experiment '
expect_exit 0 coppice --version
expect_stdout '^coppice 0\.1\.0 \(revision [0-9a-z-]+, (GCC|Clang) [0-9.]+, '

# Unknown commands and options, with the nearest name.
wrong "unknown command 'frobnicate'.*--help" frobnicate
wrong "unknown command 'experimnt' \(did you mean 'experiment'\?\)" experimnt x.obj --rates 5
wrong "unknown option '--foo'" --foo
wrong "unknown option '--ratse' \(did you mean '--rates'\?\)" experiment --ratse 5 x.obj
wrong "unknown option '--ratse' \(did you mean '--rates'\?\)" experiment --ratse=5
wrong "unknown option '-q'" experiment x.obj -q
wrong "unexpected argument 'foo'.*coppice list --help" list foo

# Missing, repeated and superfluous values.
wrong 'no scene is given; example: coppice experiment ' experiment
wrong 'no scene is given; example: coppice info ' info --json
wrong '--rates: the value is missing' experiment x.obj --rates
wrong '--max-leaf: given twice' experiment x.obj --max-leaf 1 --max-leaf 2
wrong '--no-clip: takes no value' experiment x.obj --no-clip=yes
wrong '--out: the value is empty' experiment x.obj --out ''

# Values out of range; the option's range and an example are named.
refused() { # refused OPTION RANGE VALUE...
    local option=$1 range=$2 value
    shift 2
    for value in "$@"; do
        wrong "^coppice: $option: '$value' is not $range; example: $option " \
            experiment x.obj "$option=$value"
    done
}
refused --rates 'a percentage in \(0, 100\]' abc 0 -1 100.1 nan inf 5x 0x10 %
refused --seeds 'a whole number in \[1, 1000\]' 0 1001 1.5 x
refused --max-depth 'a whole number in \[0, 60\]' -1 61 ' 5'
refused --max-leaf 'a whole number in \[1, 4294967295\]' 0 4294967296 99999999999999999999
refused --bad-refines 'a whole number in \[1, 2147483647\]' 0 -3
refused --threads 'a whole number in \[0, 1024\]' -1 1025 two
refused --traversal-cost 'a finite number >= 0' -0.1 nan inf 1e400
refused --intersection-cost 'a finite number > 0' 0 -1 inf
refused --empty-bonus 'a number in \[0, 1\)' 1 -0.5 nan
refused --rates 'a list with commas between its items' 50,,1 , 50,

# Wrong names: those that exist are listed.
wrong "^coppice: --primitives: unknown name 'lines'; there are: points, triangles$" \
    experiment x.obj --primitives points,lines
wrong "--protocols: unknown name 'grwon' \(did you mean 'grown'\?\); there are: fixed, scaled, grown$" \
    experiment x.obj --protocols grwon
wrong "--split: unknown name 'sha' \(did you mean 'sah'\?\); there are: sah, median, midpoint," \
    experiment x.obj --split sha
wrong "--sampler: unknown name 'best'; there are: uniform" experiment x.obj --sampler best
wrong "--method: unknown name 'fsat' \(did you mean 'fast'\?\); there are: exact, binned, sampled," \
    build x.obj --method fsat
wrong "--methods: unknown name 'embree'; there are: exact," bench x.obj --methods exact,embree
wrong "--rays: unknown name 'ambient'; there are: all, primary, shadow, diffuse$" \
    bench x.obj --rays ambient
wrong "KIND: unknown name 'teapot'; there are: terrain, spheres, soup, city$" \
    generate teapot -o x.obj
wrong 'no KIND is given; there are: terrain' generate
wrong '--out: no file is given; example: ' generate soup
wrong "--triangles: '0' is not a whole number in \[1, 100000000\]" \
    generate soup --triangles 0 -o x.obj
wrong "--seed: '-1' is not " generate soup --seed -1 -o x.obj

wrong 'no scene is given; example: coppice build ' build --json
wrong 'no scene is given; example: coppice bench ' bench
for share in 0 0% 101% 1.5 -1% x %; do
    wrong "--sample: '$share' is not a share in \(0, 1\] or \(0%, 100%\]; example: --sample 1%$" \
        build x.obj --sample="$share"
done
for point in 1,2 1,2,3,4 1,,3 a,b,c 1,2,inf 1,2,nan; do
    wrong "--eye: '$point' is not three finite numbers with commas between; example: --eye " \
        bench x.obj --eye="$point"
done
wrong "--threads: '0' is not a whole number in \[1, 1024\]" bench x.obj --threads 1,0
wrong "--runs: '0' is not a whole number in \[1, 1000\]" bench x.obj --runs 0
wrong "--size: '9000' is not a whole number in \[1, 8192\]" bench x.obj --size 9000
wrong "--fov: '180' is not a number in \(0, 180\)" bench x.obj --fov 180
wrong '--json: no file is named; example: ' bench x.obj --json folder/

# Nothing of all this has written anything.
expect_equal "$(ls)" ''
