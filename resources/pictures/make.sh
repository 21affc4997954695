#!/bin/sh
# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes the pictures of the README anew: runs the samples that they show and paints
# them beside this script. Usage: make.sh PROGRAM, from any folder.
set -eu
program=$(realpath "${1:?usage: make.sh PROGRAM}")
here=$(cd "$(dirname "$0")" && pwd)
samples=$here/../../samples
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# picture(sample, figure, name, further words of export)
picture() {
    sample=$1 figure=$2 name=$3
    shift 3
    [ -f "$work/$sample.kbrun" ] || "$program" run "$samples/$sample.json" --out "$work/$sample.kbrun" >"$work/told"
    "$program" export "$work/$sample.kbrun" --figure "$figure" "$@" --out "$work/$name.png"
    mv "$work/$name.png" "$here/$name.png"
    echo "$here/$name.png"
}

picture drift-bolted section drift-bolted --dpi 150
picture drift-unbolted section drift-unbolted --dpi 150
picture rebar-stated bolt rebar-stated-bolt --dpi 150
