# Shared by the bash tools: `source "$(dirname "$0")/lib.bash"`. Puts the working folder at the
# project's root, where every path of the tools begins.

set -euo pipefail
tool_path=$(realpath "$0")
tool=$(basename "$0")
pause_seconds=10 # between two lines on how far something is
cd "$(dirname "${BASH_SOURCE[0]}")/.."

say() { echo "coppice $tool: $*"; }
die() {
    echo "coppice $tool: $*" >&2
    exit 1
}

# The text of the comment at the head of a tool is its --help.
print_help() {
    sed -n '2,/^[^#]/{/^#/s/^# \{0,1\}//p}' "$tool_path"
}

# as_root CMD...: a clear refusal is better than a password prompt in the middle of a build, so
# sudo is used only where it asks nothing or there is someone to ask.
as_root() {
    if ((EUID == 0)); then
        "$@"
    elif command -v sudo >/dev/null && { (: </dev/tty) || sudo -n true; } 2>/dev/null; then
        sudo "$@"
    else
        echo "E: needs root: run as root or with sudo" >&2
        return 1
    fi
}

# apt_get [as_root] ARG...: asks nothing, and gives up soon when there is no network.
apt_get() {
    local run=()
    [[ $1 != as_root ]] || { run=(as_root) && shift; }
    "${run[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y \
        -o Acquire::Retries=1 -o Acquire::http::Timeout=5 -o Acquire::https::Timeout=5 \
        -o DPkg::Lock::Timeout=120 -o APT::Sandbox::User=root "$@"
}

# logged LOG CMD...: runs CMD with its words going to LOG. Where that takes long, a line every
# `pause_seconds` tells how long already and the last of those words.
logged() {
    local log=$1 code=0 ticker
    shift
    : >"$log"
    report_every "$pause_seconds" "$log" &
    ticker=$!
    "$@" >"$log" 2>&1 </dev/null || code=$?
    kill $ticker 2>/dev/null || true
    wait $ticker 2>/dev/null || true
    return $code
}

# report_every SECONDS LOG: as long as the tool runs.
report_every() {
    local never since=$SECONDS
    exec {never}<> <(:) # nothing is ever read from it: a pause that leaves no process behind
    while read -rt "$1" -u "$never" || kill -0 $$ 2>/dev/null; do
        say "$((SECONDS - since)) s: $(tail -n1 "$2" | cut -c1-70)"
    done
}

# The line of a log that says why: what could not be fetched, else the first error, else its end.
reason() {
    { grep -m1 -E '^[EW]: Failed to fetch' "$1" ||
        grep -m1 -E '^(E:|npm (ERR!|error)) ' "$1" || tail -n1 "$1"; } | cut -c1-200
}

# list_files PATTERN...: the project's files, committed or not, each ended by a zero byte.
list_files() {
    local file
    git ls-files -z --cached --others --exclude-standard -- "$@" |
        while read -rd '' file; do
            [[ ! -e $file ]] || printf '%s\0' "$file" # git still lists what was just removed
        done
}

# build_folder PRESET: where it is built. The preset `demo` is a part of `release`.
build_folder() {
    if [[ $1 == demo ]]; then echo build/release; else echo "build/$1"; fi
}

# configure PRESET: quiet unless it fails. `preset` in the folder says which one it was.
configure() {
    local folder log
    folder=$(build_folder "$1")
    log=$folder/configure.log
    mkdir -p "$folder"
    cmake --preset "$1" >"$log" 2>&1 || { cat "$log" >&2; die "cannot configure the preset $1"; }
    echo "$1" >"$folder/preset"
}

# thin SECONDS: of ninja's status lines at most one in that time, but all other lines, each below
# the status line of what it is about.
thin() {
    local pause=$1 line part='' status='' shown='' since=$SECONDS
    while true; do
        if IFS= read -rt 1 line; then
            line=$part$line part=''
            if [[ $line == \[+([0-9])/+([0-9])\]* ]]; then
                status=$line
            elif [[ $line != 'ninja: no work to do.' ]]; then
                [[ $status == "$shown" ]] || echo "$status"
                echo "$line"
                shown=$status
            fi
        elif (($? > 128)); then # nothing came, or the beginning of a line
            part+=$line
        else
            [[ -z $part$line ]] || echo "$part$line"
            break
        fi
        if ((SECONDS - since >= pause)); then
            [[ -z $status ]] || echo "$status"
            shown=$status since=$SECONDS
        fi
    done
}
