#!/bin/sh
# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Runs the samples angle-*.json and prints the table of resources/help/angle-series.md:
# the largest force through the joint, the displacement at which it was reached, and
# how the bolt broke.
# usage: sh samples/angle-series.sh [PROGRAM] [--set PATH=VALUE …]
set -eu
program=build/release/keyblock
case ${1:---} in --*) ;; *) program=$1; shift ;; esac
here=$(dirname "$0")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

echo "| bolt | angle | largest load, kN | of it axial, shear | displacement there, mm | at rupture, mm | breaks by |"
echo "| --- | --- | --- | --- | --- | --- | --- |"
for scene in "$here"/angle-*.json; do
    name=$(basename "$scene" .json)
    "$program" run "$scene" --out "$work/run.kbrun" --overwrite --progress none "$@" > "$work/summary" 2>&1 || {
        cat "$work/summary" >&2
        exit 1
    }
    "$program" export "$work/run.kbrun" --table history --out "$work/history.csv"
    "$program" export "$work/run.kbrun" --table events --out "$work/events.csv"
    awk -F, -v name="$name" '
        FNR == 1 { for (i = 1; i <= NF; ++i) column[FILENAME, $i] = i; next }
        FILENAME ~ /events/ {
            kind = $column[FILENAME, "kind"]
            if (kind ~ /rupture/ && how == "") { how = kind; when = $column[FILENAME, "time_s"] + 0 }
            next
        }
        {
            time = $column[FILENAME, "time_s"] + 0
            if (how != "" && time > when) next
            axial = $column[FILENAME, "axial_N"]
            shear = $column[FILENAME, "shear_N"]
            last = 1e3 * $column[FILENAME, "displacement_ux_m"]
            load = sqrt(axial * axial + shear * shear)
            if (load > most) { most = load; n = axial; q = (shear < 0 ? -shear : shear) + 0; at = last }
        }
        END {
            split(name, part, "-")
            sub(/^0/, "", part[3])
            printf "| %s | %s° | %.1f | %.1f, %.1f | %.1f | %s | %s |\n", part[2], part[3], most / 1e3, n / 1e3, q / 1e3, at,
                   how == "" ? "none by " sprintf("%.0f", last) : sprintf("%.1f", last), how == "" ? "–" : how
        }' "$work/events.csv" "$work/history.csv"
done
