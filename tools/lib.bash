# Shared by the bash tools: `source "$(dirname "$0")/lib.bash"`. Puts the working folder at the
# project's root, where every path of the tools begins.

set -euo pipefail
tool_path=$(realpath "$0")
tool=$(basename "$0")
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
    "${run[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -y \
        -o Acquire::Retries=1 -o Acquire::http::Timeout=5 -o Acquire::https::Timeout=5 \
        -o DPkg::Lock::Timeout=120 -o APT::Sandbox::User=root "$@"
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

# configure PRESET: quiet unless it fails.
configure() {
    local log=build/$1/configure.log
    mkdir -p "build/$1"
    cmake --preset "$1" >"$log" 2>&1 || { cat "$log" >&2; die "cannot configure the preset $1"; }
}
