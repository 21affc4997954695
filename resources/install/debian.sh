#!/bin/sh
# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs the packages that Keyblock is built with on Debian 12. It lists missing
# packages and needs root only if there are any; otherwise it finishes at once. It
# is safe to run again. Arguments are further packages or groups of them: `readers`
# is what tests need besides (a virtual display, programs that read exported files,
# the source of a locale with decimal commas, GNU parallel), `desktop` what moves the
# mouse and types in the window, `lint` what `make lint` checks with, `slurm` a job
# scheduler.
set -eu
export LC_ALL=C

further=""
for argument in "$@"; do
    case $argument in
        readers) argument="xvfb poppler-utils librsvg2-bin locales python3 parallel" ;;
        desktop) argument="xauth x11-utils xdotool wmctrl openbox dbus at-spi2-core python3-pyatspi imagemagick" ;;
        lint) argument="git clang-format clang-tidy python3" ;;
        slurm) argument="slurmctld slurmd slurm-client python3" ;;
    esac
    further="$further $argument"
done

packages="g++ cmake ninja-build ccache pkg-config
          libeigen3-dev libboost-dev libcgal-dev libsuitesparse-dev libopenblas-dev libtbb-dev libjemalloc-dev
          nlohmann-json3-dev libcli11-dev libsqlite3-dev libxxhash-dev libssl-dev libdxflib-dev
          qtbase5-dev libqt5svg5-dev libqcustomplot-dev libvtk9-qt-dev libgl1-mesa-dri libmuparser-dev fonts-inter
          libgtest-dev libbenchmark-dev$further"

if ! command -v dpkg-query >/dev/null 2>&1; then
    echo "This is not Debian: the build continues and will report missing packages. On Debian 12 it needs:" $packages >&2
    exit 0
fi

# shellcheck disable=SC2086  # a list of words
installed=$(dpkg-query -W -f '${db:Status-Abbrev}:${Package}:\n' $packages 2>/dev/null || true)
missing=""
for package in $packages; do
    case "$installed" in
        *"ii :$package:"*) ;;
        *) missing="$missing $package" ;;
    esac
done
[ -n "$missing" ] || exit 0

echo "Keyblock needs these Debian packages, which are not installed:$missing" >&2
root=""
if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null 2>&1; then
        echo "Installation needs root. As root, run: apt-get update && apt-get install --no-install-recommends$missing" >&2
        exit 1
    fi
    root="sudo"
fi

install() {
    # shellcheck disable=SC2086
    $root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing
}

# Package lists are used as they are if they contain every package; empty or outdated ones are updated.
# shellcheck disable=SC2086
if apt-cache show $missing >/dev/null 2>&1 && install; then
    exit 0
fi
if ! { $root apt-get update -qq && install; }; then
    echo "The packages could not be installed. Fix the errors above (network, sources.list, full disk) and run the" \
         "same command again." >&2
    exit 1
fi
