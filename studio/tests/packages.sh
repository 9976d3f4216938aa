# What the scripts beside this file share, which source it in the root of the repository: they fail with a reason, install what is missing
# where that can be, and leave no process behind.

fail() {
    echo "error: $*" >&2
    exit 1
}

# Installs these packages of Debian, where that can be.
install_packages() {
    [[ $(id -u) == 0 ]] && command -v apt-get >/dev/null ||
        fail "this needs $*: install them, or run this as root where there is apt-get"
    { apt-get update && apt-get install -y "$@"; } >/dev/null || fail "cannot install $*"
}

processes=()
# Ends them one after the other, the last first, and waits until each is gone: a display that still ends takes its socket away from the
# next one of the same number.
end_processes() {
    local at
    for ((at = ${#processes[@]} - 1; at >= 0; at--)); do
        end_process "${processes[at]}"
    done
}
end_process() {
    kill "$1" 2>/dev/null || return 0
    for _ in {1..50}; do
        kill -0 "$1" 2>/dev/null || return 0
        sleep 0.1
    done
    kill -9 "$1" 2>/dev/null || true
}
trap end_processes EXIT
