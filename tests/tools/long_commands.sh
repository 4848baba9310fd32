# What the tools say while something takes long: tools/lib.bash.
source "$(dirname "$0")/../../tools/lib.bash"

fail() {
    echo "$(basename "$0"): $*" >&2
    exit 1
}
expect_equal() { [[ $1 == "$2" ]] || fail "expected '$2', got '$1'"; }

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# thin: of ninja's status lines the last one after each pause, all other lines below their own.
lines() {
    echo '[1/9] one'
    echo '[2/9] two'
    echo 'a warning of two'
    echo 'another'
    echo '[3/9] three'
    sleep 2.5
    echo '[4/9] four'
    echo 'ninja: no work to do.'
    printf 'no end of line'
}
expect_equal "$(lines | thin 2)" '[2/9] two
a warning of two
another
[3/9] three
no end of line'
expect_equal "$(printf '[1/2] one\n[2/2] two\n' | thin 60)" ''

# logged: the words of a command in its log, its exit code, and a line after each pause.
slow() {
    echo 'first'
    echo 'second' >&2
    sleep "$1"
    return 3
}
code=0
said=$(logged "$work/log" slow 0) || code=$?
expect_equal "$code $said" '3 '
expect_equal "$(<"$work/log")" $'first\nsecond'
pause_seconds=1
said=$(logged "$work/log" slow 2.5) || true
[[ $(head -n1 <<<"$said") =~ ^'coppice long_commands.sh: '[0-9]+' s: second'$ ]] || fail "said '$said'"
