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

mech=$(mech_program)
shots=target/studio-window
begin_display 1280x800

folder=$shots/files
mkdir "$folder"
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

sleep 1
shot_still opened "what is opened does not come to rest"
colors=$(convert "$shots/opened.png" -format %k info:)
((colors > 60)) || fail "the window is blank: $colors colours"

# The pin of the upper plate and the tie.
drag 345 261 329 246
until_title changed
shot_unlike opened dragged "the drag changes nothing"
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
shot_unlike played-1 played-2 "it does not move"
press space 0
sleep 0.3

# The joint of the tie and the lower plate is taken out: the diagnoses tell what is loose, and a click mends it.
click 448 417
press Delete
until_title changed
press ctrl+s
"$mech" check "$leg" >"$shots/check" 2>&1 && fail "the leg is broken, and nobody says so"
click 1080 37
shot_still broken "what is broken does not come to rest"
xdotool mousemove 1080 195
sleep 0.5
shot_unlike broken ghost "what a repair would do is not seen"
click 1080 195
sleep 0.5
shot mended
press ctrl+s
"$mech" check "$leg" >"$shots/check" 2>&1 || fail "a click does not mend it: $(cat "$shots/check")"

# By night, and as small as a telephone.
click 928 37
press 6
shot_unlike mended night "the night is as the day"
press 6
xdotool windowsize --sync "$window" 390 760
sleep 1
shot small

kill "$studio"
window_gone

# Figure 1 of the paper from nothing, without typing: 14 gestures, a second each.
"$mech" edit "$folder/figure_1.mech" &
studio=$!
processes+=("$studio")
window=$(window_of figure_1)
xdotool windowfocus "$window"
sleep 1
# Clicks a tool by its number from the top, from 0.
tool() { click 45 $((37 + 23 * $1)); }
# The pixel in which a place is seen, in tenths of a unit.
pixel() { echo $((4955 + 707 * $1 / 10)) $((3875 - 707 * $2 / 10)) | awk '{ printf "%d %d", $1 / 10, $2 / 10 }'; }
begin=$SECONDS
tool 6
click $(pixel -30 0) && sleep 0.5
click $(pixel 0 0) && sleep 0.5
tool 7
for x in -30 0 -20; do
    click $(pixel $x 0) && sleep 0.5
done
tool 1
drag $(pixel 10 0) $(pixel 50 0)
tool 4
drag $(pixel 50 0) $(pixel 56 0)
tool 10
click $(pixel -30 0) && sleep 0.5
click 175 763
sleep 0.5
took=$((SECONDS - begin))
shot figure-1
xdotool mousemove 600 200
shot_unlike figure-1 figure-1-later "figure 1 does not move"
press space ctrl+s
until_title 'figure_1.mech - '
"$mech" check "$folder/figure_1.mech" >"$shots/check" 2>&1 || fail "figure 1 is wrong: $(cat "$shots/check")"
# Killed in the middle of work: what was drawn is offered again.
press space Escape
tool 1
drag $(pixel -30 30) $(pixel -10 30)
until_title changed
sleep 0.5
kill -9 "$studio"
window_gone
"$mech" edit "$folder/figure_1.mech" &
studio=$!
processes+=("$studio")
window=$(window_of figure_1)
xdotool windowfocus "$window"
sleep 1
shot left
click 515 38
until_title changed
press ctrl+s
until_title 'figure_1.mech - '
grep -q 'link bar2' "$folder/figure_1.mech" || fail "what was drawn last is lost: $(cat "$folder/figure_1.mech")"
kill "$studio"

if [[ -n ${UPDATE_PICTURES:-} ]]; then
    mkdir -p docs/studio
    for name in opened broken ghost figure-1; do
        convert "$shots/$name.png" -strip -colors 256 "png8:docs/studio/$name.png"
    done
fi
echo "studio window: a drag changes one number, what is broken is told and mended by a click, it plays; what kill -9 leaves is restored; figure 1 is drawn in 14 gestures and $took s (screenshots in $shots)"
