#!/bin/sh
# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# usage: fuzz.sh DRIVER MINUTES
# Starts from the samples, the broken scenes and the corpus that is kept, with the
# keys and words of the schema as a dictionary. What breaks the reader is left in
# build/fuzz/found; the fewest inputs that reach all the code replace the kept corpus.
set -eu
driver=$1
minutes=$2
source=$(cd "$(dirname "$0")/../.." && pwd)
work=$source/build/fuzz
mkdir -p "$work/grown" "$work/found" "$work/kept"

grep -oE '"[a-zA-Z_-]+"' "$source/resources/schema/keyblock-scene.schema.json" "$source"/samples/*.json -h |
    sort -u | sed 's/"\(.*\)"/"\\"\1\\""/' > "$work/words.dict"

"$driver" -max_total_time=$((minutes * 60)) -max_len=6000 -timeout=10 -rss_limit_mb=3000 -dict="$work/words.dict" \
          -artifact_prefix="$work/found/" -print_final_stats=1 -use_value_profile=0 \
          "$work/grown" "$source/tests/fuzz/corpus" "$source/tests/data/broken" "$source/samples"

rm -rf "$work/kept" && mkdir "$work/kept"
"$driver" -set_cover_merge=1 -use_counters=0 -max_len=3000 "$work/kept" "$source/tests/fuzz/corpus" "$work/grown" 2>/dev/null
find "$source/tests/fuzz/corpus" -type f -delete
cp "$work/kept"/* "$source/tests/fuzz/corpus/"
echo "kept $(ls "$source/tests/fuzz/corpus" | wc -l) inputs; found $(ls "$work/found" | wc -l) that break the reader"
