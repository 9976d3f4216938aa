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
end_processes() {
    local process
    for process in "${processes[@]}"; do
        kill "$process" 2>/dev/null || true
    done
}
trap end_processes EXIT
