# A virtual display for the scripts beside this file, which source it: `begin_display SIZE` starts one, and `shot NAME` takes a screenshot
# into the folder `$shots`. Installs what is missing where it can.

# shellcheck source=packages.sh
. studio/tests/packages.sh

# Installs what is needed besides Rust: each by the program or library that tells whether it is there.
install_display() {
    local missing=() need libraries
    for need in Xvfb:xvfb xdotool:xdotool import:imagemagick convert:imagemagick; do
        command -v "${need%%:*}" >/dev/null || missing+=("${need##*:}")
    done
    libraries=$(ldconfig -p 2>/dev/null || /sbin/ldconfig -p)
    for need in libX11.so.6:libx11-6 libX11-xcb.so.1:libx11-xcb1 libXcursor.so.1:libxcursor1 libXi.so.6:libxi6 \
        libxkbcommon-x11.so.0:libxkbcommon-x11-0 "$@"; do
        [[ $libraries == *"${need%%:*}"* ]] || missing+=("${need##*:}")
    done
    ((${#missing[@]} == 0)) || install_packages "${missing[@]}"
}

# The program: `$MECH`, or one that is built in a release.
mech_program() {
    if [[ -z ${MECH:-} ]]; then
        cargo build --release --bin mech >&2
        MECH=${CARGO_TARGET_DIR:-target}/release/mech
    fi
    realpath "$MECH"
}

# Starts a display of this size, in pixels, and tries again where it does not answer.
begin_display() {
    rm -rf "$shots" && mkdir -p "$shots"
    unset WAYLAND_DISPLAY WAYLAND_SOCKET
    # So that a pixel is a pixel.
    export WINIT_X11_SCALE_FACTOR=1
    local try
    for try in 1 2 3; do
        start_display "$1" && return
        echo "Xvfb does not answer (try $try): $(cat "$shots/xvfb.log")" >&2
    done
    fail "no display"
}

# Starts Xvfb, and tells whether it answers within ten seconds. It stays as it is when its last client leaves: a reset at that moment
# would turn away the next one.
start_display() {
    rm -f "$shots/display"
    Xvfb -displayfd 3 -screen 0 "$1x24" -noreset -nolisten tcp 3>"$shots/display" 2>"$shots/xvfb.log" &
    local server=$!
    processes+=("$server")
    for _ in {1..100}; do
        if [[ -s $shots/display ]]; then
            DISPLAY=:$(cat "$shots/display")
            export DISPLAY
            xdotool getdisplaygeometry >/dev/null 2>&1 && return
        fi
        sleep 0.1
    done
    end_process "$server"
    return 1
}

# Waits until the program that was started last shows a window with this in its title.
window_of() {
    local found
    for _ in {1..300}; do
        found=$(xdotool search --onlyvisible --name "$1" 2>/dev/null | head -n 1) || true
        [[ -n $found ]] && echo "$found" && return
        kill -0 "${processes[-1]}" 2>/dev/null || fail "the program ends before its window comes up"
        sleep 0.1
    done
    fail "no window comes up: $(cat "$shots/xvfb.log")"
}

# Waits until the window is gone, whose program has been killed: the next one must not be taken for it.
window_gone() {
    for _ in {1..100}; do
        xdotool getwindowname "$window" >/dev/null 2>&1 || return 0
        sleep 0.1
    done
    fail "the window stays although its program is killed"
}

shot() { import -window root "$shots/$1.png"; }
# Whether two screenshots show the same of what `scene` cuts out of them.
same() {
    scene "$1" "$shots/one.ppm" && scene "$2" "$shots/other.ppm" || fail "no screenshot"
    cmp -s "$shots/one.ppm" "$shots/other.ppm"
}
# Takes screenshots until the scene differs from that of another one; where it never does, fails with this reason.
shot_unlike() {
    for _ in {1..50}; do
        shot "$2"
        same "$1" "$2" || return 0
        sleep 0.2
    done
    fail "$3"
}
# Takes screenshots until nothing moves any more.
shot_still() {
    for _ in {1..50}; do
        shot "$1"
        sleep 0.4
        shot later
        same "$1" later && return
    done
    fail "$2"
}
title() { xdotool getwindowname "$window"; }
press() {
    xdotool key "$@"
    sleep 0.3
}
# Waits until the title has these words in it.
until_title() {
    for _ in {1..100}; do
        [[ $(title) == *"$1"* ]] && return
        sleep 0.1
    done
    fail "the title is \"$(title)\", without \"$1\""
}
