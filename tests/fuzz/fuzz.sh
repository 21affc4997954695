#!/bin/sh
# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# usage: fuzz.sh scene|cut|drawing MINUTES
# The scene reader starts from the samples, the broken scenes and the corpus that is
# kept, with the keys and words of the schema as a dictionary; the cut from its
# corpus, whose bytes are sections; the import of drawings from the odd files of the
# tests. What breaks the property is left in
# build/fuzz/found; the fewest inputs that reach all the code replace the kept corpus.
set -eu
target=$1
minutes=$2
source=$(cd "$(dirname "$0")/../.." && pwd)
driver=$source/build/fuzz/tests/fuzz/driver/${target}_fuzz
work=$source/build/fuzz

case $target in
    scene)
        corpus=$source/tests/fuzz/corpus grown=$work/grown longest=6000 kept_longest=3000
        set -- "-dict=$work/words.dict" "$source/tests/data/broken" "$source/samples"
        mkdir -p "$work"
        grep -oE '"[a-zA-Z_-]+"' "$source/resources/schema/keyblock-scene.schema.json" "$source"/samples/*.json -h |
            sort -u | sed 's/"\(.*\)"/"\\"\1\\""/' > "$work/words.dict" ;;
    cut)
        corpus=$source/tests/fuzz/cut_corpus grown=$work/grown_cut longest=400 kept_longest=200
        set -- -len_control=0 ;;
    drawing)
        corpus=$source/tests/fuzz/drawing_corpus grown=$work/grown_drawing longest=6000 kept_longest=2000
        mkdir -p "$work"
        printf '"%s"\n' LINE ARC CIRCLE ELLIPSE SPLINE LWPOLYLINE POLYLINE VERTEX SEQEND INSERT BLOCK ENDBLK SECTION \
            ENDSEC ENTITIES BLOCKS TABLES LAYER HEADER '$INSUNITS' EOF > "$work/words.dict"
        rm -rf "$work/odd" && cp -r "$source/tests/data/import" "$work/odd"
        rm "$work/odd/inserts-without-end.dxf"  # takes seconds, and its offspring too
        set -- "-dict=$work/words.dict" "$work/odd" ;;
    *)
        echo "no fuzzer is called $target: scene, cut or drawing" >&2
        exit 2 ;;
esac
mkdir -p "$grown" "$work/found" "$corpus"

"$driver" -max_total_time=$((minutes * 60)) -max_len=$longest -timeout=60 -rss_limit_mb=3000 \
          -artifact_prefix="$work/found/" -print_final_stats=1 -use_value_profile=0 \
          "$grown" "$corpus" "$@"

rm -rf "$work/kept" && mkdir "$work/kept"
"$driver" -set_cover_merge=1 -use_counters=0 -max_len=$kept_longest "$work/kept" "$corpus" "$grown" 2>/dev/null
find "$corpus" -type f -delete
cp "$work/kept"/* "$corpus/"
echo "kept $(ls "$corpus" | wc -l) inputs; found $(ls "$work/found" | wc -l) that break the $target property"
