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

# Starts a display of this size, in pixels.
begin_display() {
    rm -rf "$shots" && mkdir -p "$shots"
    Xvfb -displayfd 3 -screen 0 "$1x24" -nolisten tcp 3>"$shots/display" 2>"$shots/xvfb.log" &
    processes+=($!)
    for _ in {1..100}; do
        [[ -s $shots/display ]] && break
        sleep 0.1
    done
    [[ -s $shots/display ]] || fail "Xvfb does not start: $(cat "$shots/xvfb.log")"
    DISPLAY=:$(cat "$shots/display")
    export DISPLAY
    unset WAYLAND_DISPLAY WAYLAND_SOCKET
    # So that a pixel is a pixel.
    export WINIT_X11_SCALE_FACTOR=1
}

# Waits for a window with this in its title.
window_of() {
    timeout 20 xdotool search --sync --onlyvisible --name "$1" | head -n 1 || fail "no window comes up"
}

shot() { import -window root "$shots/$1.png"; }
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
