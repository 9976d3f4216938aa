#!/usr/bin/env bash
# Plays the crane in a window on a virtual display, with keys and mouse, and looks at what is seen there.
# Leaves its screenshots in target/virtual-display.
set -euo pipefail
cd "$(dirname "$0")/../.."

. studio/tests/display.sh
install_display

mech=$(mech_program)
shots=target/virtual-display
begin_display 1100x800

"$mech" play examples/gallery/src/mechanisms/crane.rs &
player=$!
processes+=("$player")
window=$(window_of LuffingCrane)
xdotool windowfocus "$window"

# What a screenshot shows of the mechanism, below the words.
scene() { convert "$shots/$1.png" -crop +0+80 +repage "ppm:$2"; }
# How many pixels have the red of a mark.
red() { scene "$1" - | convert ppm:- -fill black +opaque '#C94F45' -fill white -opaque '#C94F45' -format '%[fx:round(mean*w*h)]' info:; }
until_title 'playing own motion'
shot moving-1
shot_unlike moving-1 moving-2 "nothing moves"
colors=$(convert "$shots/moving-1.png" -format %k info:)
((colors > 60)) || fail "the window is blank: $colors colours"

press space
until_title paused
shot_still paused "it does not come to rest"
sleep 0.4
shot paused-later
same paused paused-later || fail "it moves while it is paused"

press Right
shot_unlike paused stepped "a step changes nothing"

# From the start the middle of the jib is at this pixel: it is pulled to the left and up.
press r
shot_unlike stepped reset "the start changes nothing"
xdotool mousemove --window "$window" 400 378 mousedown 1 mousemove --window "$window" 370 351 mousemove --window "$window" 340 341
sleep 0.3
shot_unlike reset dragged "the drag changes nothing"
xdotool mouseup 1
[[ $(title) != *'luff 55.0°'* ]] || fail "the drag does not turn the motor: $(title)"

press 2 6
press Right
shot_still layers "the layers do not come to rest"
press 2 6 d
shot_unlike layers night "the night is as the day"
press d

before=$(red dragged)
press Tab space
until_title 'motor `luff` stopped at 82.'
for _ in {1..50}; do
    shot limit
    after=$(red limit)
    ((after > before + 400)) && break
    sleep 0.2
done
((after > before + 400)) || fail "no mark is seen at the limit: $before and then $after red pixels"
press b space
until_title 'playing backwards'
until_title 'motor `luff` stopped at 27.'
shot_unlike limit other-limit "both limits look the same"

xdotool windowsize --sync "$window" 500 400
sleep 0.5
shot small
corner=$(convert "$shots/small.png" -format '%[pixel:p{2,397}]' info:)
beyond=$(convert "$shots/small.png" -format '%[pixel:p{2,420}]' info:)
[[ $corner != "$beyond" ]] || fail "the window is not painted when it is made smaller: $corner"

press q
wait "$player" || fail "it does not end well"
echo "virtual display: moves, pauses, steps, follows the mouse, stops at both limits (screenshots in $shots)"
