#!/bin/sh
# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Regenerates the README's image of Studio, on a virtual display. Needs the packages
# of `sh resources/install/debian.sh readers desktop`. Usage: studio.sh PROGRAM.
set -eu
program=$(realpath "${1:?usage: studio.sh PROGRAM}")
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
processes=""
trap 'kill $processes 2>/dev/null; rm -rf "$work"' EXIT
export HOME="$work" XDG_RUNTIME_DIR="$work"
unset XDG_CONFIG_HOME XDG_DATA_HOME XDG_CACHE_HOME

mkfifo "$work/display"
Xvfb -displayfd 3 -screen 0 1600x1000x24 -nolisten tcp 3>"$work/display" 2>/dev/null &
processes=$!
read -r number <"$work/display"
export DISPLAY=":$number"
cp "$here/../../samples/drift-rebar-dbolt.json" "$work"

# Without a window manager the window stays where it is placed, and nothing else is in the image.
"$program" "$work/drift-rebar-dbolt.json" >"$work/log" 2>&1 &
studio=$!
processes="$processes $studio"
for _ in $(seq 100); do
    window=$(xdotool search --onlyvisible --pid $studio 2>/dev/null | head -n 1) && [ -n "$window" ] && break
    sleep 0.2
done
sleep 3
xdotool windowmove "$window" 0 0 windowsize "$window" 1600 1000 windowfocus "$window" mousemove 700 300
sleep 1
xdotool key f
sleep 1
# Zoom in on the drift.
xdotool mousemove 835 398 click --repeat 5 --delay 200 4
sleep 1
xdotool key F5
# In the last stage the left wedge falls.
for _ in $(seq 600); do
    kill -0 $studio
    sleep 1
    [ -f "$work/drift-rebar-dbolt-1.kbrun" ] || continue
    "$(dirname "$program")/keyblock" info "$work/drift-rebar-dbolt-1.kbrun" 2>/dev/null | grep -q '^fall' && break
done
sleep 4
import -window root "$work/studio-run.png"
convert "$work/studio-run.png" +dither -colors 250 "PNG8:$here/studio-run.png"
echo "$here/studio-run.png"
