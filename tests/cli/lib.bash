# Helpers of the command-line tests. A test is a script tests/cli/<name>.sh that begins with
#
#     source "$(dirname "$0")/lib.bash"
#
# and then runs in a fresh temporary folder, removed at its end. It has:
#
#     coppice ARG...            the program under test
#     $tests                    the folder tests/cli; terminal.py there runs a command on a terminal
#     $data                     the folder tests/data
#     $stdout $stderr           what the last expect_exit saw
#     expect_exit CODE CMD...   runs CMD, keeps its output, fails unless it exits with CODE
#     expect_stdout PATTERN     fails unless that output matches the extended regular expression
#     expect_stderr PATTERN     the same for stderr
#     expect_stdout_empty, expect_stderr_empty
#     expect_stderr_one_line    an error is one line, and is not empty
#     expect_file FILE...       each file exists and is not empty
#     expect_no_file FILE...    no such file
#     expect_same_file A B      equal bytes
#     expect_equal A B          equal strings
#     fail MESSAGE              ends the test
#
# Every failure names the script and line that asked.

set -euo pipefail
export LC_ALL=C

: "${COPPICE:?set COPPICE to the program under test}"
tests=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
data=$(cd "$tests/../data" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
stdout='' stderr=''
progress_line='^coppice: .* \| [0-9:]+( s)?(, about [0-9:]+( s)? left)?$'

coppice() { "$COPPICE" "$@"; }

fail() {
    # The outermost frame is the test script, whichever helper noticed the failure.
    echo "$(basename "$0"):${BASH_LINENO[-2]}: $*" >&2
    [[ -z $stdout ]] || sed 's/^/    stdout: /' <<<"$stdout" >&2
    [[ -z $stderr ]] || sed 's/^/    stderr: /' <<<"$stderr" >&2
    exit 1
}

expect_exit() {
    local expected=$1 code=0
    shift
    "$@" >.stdout 2>.stderr || code=$?
    # Where the machine is slow there is a line of progress every ten seconds: not what is tested.
    stdout=$(<.stdout) stderr=$(grep -avE "$progress_line" .stderr || true)
    ((code == expected)) || fail "exit code $code, expected $expected: $*"
}

expect_stdout() { grep -qE -e "$1" <<<"$stdout" || fail "stdout does not match: $1"; }
expect_stderr() { grep -qE -e "$1" <<<"$stderr" || fail "stderr does not match: $1"; }
expect_stdout_empty() { [[ -z $stdout ]] || fail "stdout is not empty"; }
expect_stderr_empty() { [[ -z $stderr ]] || fail "stderr is not empty"; }

expect_stderr_one_line() {
    [[ -n $stderr && $stderr != *$'\n'* ]] || fail "stderr is not one line"
}

expect_file() {
    local file
    for file in "$@"; do [[ -s $file ]] || fail "no such file, or an empty one: $file"; done
}

expect_no_file() {
    local file
    for file in "$@"; do [[ ! -e $file ]] || fail "file should not exist: $file"; done
}

expect_same_file() { cmp -s "$1" "$2" || fail "files differ: $1 $2"; }
expect_equal() { [[ $1 == "$2" ]] || fail "expected '$2', got '$1'"; }
