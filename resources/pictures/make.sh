#!/bin/sh
# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Regenerates the images of the README: runs the samples that they show and writes
# figures and an animation (needs ffmpeg) next to this script.
# Usage: make.sh PROGRAM, from any folder.
set -eu
program=$(realpath "${1:?usage: make.sh PROGRAM}")
here=$(cd "$(dirname "$0")" && pwd)
samples=$here/../../samples
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# picture(sample, figure, name, further options of export)
picture() {
    sample=$1 figure=$2 name=$3
    shift 3
    [ -f "$work/$sample.kbrun" ] || "$program" run "$samples/$sample.json" --out "$work/$sample.kbrun" >"$work/told"
    "$program" export "$work/$sample.kbrun" --figure "$figure" "$@" --out "$work/$name.png"
    mv "$work/$name.png" "$here/$name.png"
    echo "$here/$name.png"
}

# The frames of the dynamic stages at a fixed frame rate: frames are dense in time
# around events, so that the animation slows down there.
animation() {
    "$program" export "$work/$1.kbrun" --animation "$work/$1-frames" --dpi 100 --width 150 >"$work/told"
    first=$(awk -F, -v stage="$2" 'index($0, stage) { print NR - 1; exit }' "$work/$1-frames/frames.csv")
    ffmpeg -loglevel error -framerate 10 -start_number "$first" -i "$work/$1-frames/frame-%04d.png" -vf \
        'split[a][b];[a]palettegen=max_colors=200:stats_mode=full[p];[b][p]paletteuse=dither=none' "$work/$1.gif"
    mv "$work/$1.gif" "$here/$1.gif"
    echo "$here/$1.gif"
}

picture drift-rebar-dbolt section drift-rebar-dbolt --dpi 150
picture drift-rebar-dbolt bolt drift-rebar-dbolt-R1 --bolt R1 --at pressure:0.1 --dpi 130
animation drift-rebar-dbolt pressure
picture rebar-stated bolt rebar-stated-bolt --dpi 150
