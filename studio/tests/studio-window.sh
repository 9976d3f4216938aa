#!/usr/bin/env bash
# Opens the gallery's Jansen leg in the studio on a virtual display, as somebody does who has never seen Rust: drags a pin, looks at what
# `git diff` shows, breaks the leg, mends it by a click, and plays it. Leaves its screenshots in target/studio-window; with
# UPDATE_PICTURES=1 those of the docs are renewed.
set -euo pipefail
cd "$(dirname "$0")/../.."

. studio/tests/display.sh
install_display libEGL.so.1:libegl1 libGL.so.1:libgl1
drivers=(/usr/lib/*/dri/swrast_dri.so /usr/lib/*/libgallium-*.so)
[[ -e ${drivers[0]} || -e ${drivers[-1]} ]] || install_packages libgl1-mesa-dri
export LIBGL_ALWAYS_SOFTWARE=1

cargo build --release --bin mech
mech=$PWD/${CARGO_TARGET_DIR:-target}/release/mech
[[ ${CARGO_TARGET_DIR:-target} == /* ]] && mech=$CARGO_TARGET_DIR/release/mech
shots=target/studio-window
begin_display 1280x800

folder=$(mktemp -d)
leg=$folder/jansen.rs
cp examples/gallery/src/mechanisms/jansen.rs "$leg"
git -C "$folder" init -q
git -C "$folder" add .
git -C "$folder" -c user.name=user -c user.email=user@example.org commit -qm leg

"$mech" edit "$leg" &
studio=$!
processes+=("$studio")
window=$(window_of 'mech edit')
xdotool windowfocus "$window"
until_title jansen.rs

# Drags from one pixel to another.
drag() {
    xdotool mousemove "$1" "$2" mousedown 1
    for part in 1 2 3 4; do
        xdotool mousemove $(($1 + ($3 - $1) * part / 4)) $(($2 + ($4 - $2) * part / 4))
        sleep 0.1
    done
    xdotool mouseup 1
    sleep 0.5
}
click() {
    xdotool mousemove "$1" "$2" click 1
    sleep 0.5
}
# What a screenshot shows of the drawing.
scene() { convert "$shots/$1.png" -crop 800x700+100+40 +repage "ppm:$2"; }
same() {
    scene "$1" "$shots/one.ppm" && scene "$2" "$shots/other.ppm" || fail "no screenshot"
    cmp -s "$shots/one.ppm" "$shots/other.ppm"
}

sleep 1
shot opened
colors=$(convert "$shots/opened.png" -format %k info:)
((colors > 60)) || fail "the window is blank: $colors colours"

# The pin of the upper plate and the tie.
drag 278 255 262 240
until_title changed
shot dragged
! same opened dragged || fail "the drag changes nothing"
press ctrl+s
until_title 'jansen.rs - '
changed=$(git -C "$folder" diff --numstat)
[[ $changed == "1"$'\t'"1"$'\t'jansen.rs ]] || fail "a drag changes more than a line: $changed"
git -C "$folder" diff -U0 --word-diff=porcelain --word-diff-regex='[0-9.-]+|[^0-9 ]+' | grep '^[-+][^-+]' >"$shots/diff" || true
grep -vE '^[-+][0-9.-]+$' "$shots/diff" && fail "a drag changes more than numbers"


# It plays, and goes back to its start.
click 700 740
press space
sleep 0.3
shot played-1
sleep 0.3
shot played-2
! same played-1 played-2 || fail "it does not move"
press space 0
sleep 0.3

# The joint of the tie and the lower plate is taken out: the diagnoses tell what is loose, and a click mends it.
click 386 419
press Delete
until_title changed
press ctrl+s
"$mech" check "$leg" >"$shots/check" 2>&1 && fail "the leg is broken, and nobody says so"
click 1080 37
shot broken
xdotool mousemove 1080 195
sleep 0.5
shot ghost
! same broken ghost || fail "what a repair would do is not seen"
click 1080 195
sleep 0.5
shot mended
press ctrl+s
"$mech" check "$leg" >"$shots/check" 2>&1 || fail "a click does not mend it: $(cat "$shots/check")"

# By night, and as small as a telephone.
click 928 37
press 6
shot night
! same mended night || fail "the night is as the day"
press 6
xdotool windowsize --sync "$window" 390 760
sleep 1
shot small

kill "$studio"
if [[ -n ${UPDATE_PICTURES:-} ]]; then
    mkdir -p docs/studio
    for name in opened broken ghost; do
        convert "$shots/$name.png" -strip -colors 256 "png8:docs/studio/$name.png"
    done
fi
rm -rf "$folder"
echo "studio window: a drag changes one number, what is broken is told and mended by a click, it plays (screenshots in $shots)"
