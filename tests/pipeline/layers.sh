#!/usr/bin/env bash
# layers.sh PROJECT prints each #include that goes upward or sideways, as "file:line: what"; exit code 1 if there is one.
#
#     core <- geometry, mpm, analysis, io <- scene <- stages
#
# and within lib/mpm
#
#     base <- grid <- particles <- materials
#             grid <- boundaries <- bodies
#     all of these <- state <- readings, step
#
# Prints also each circle of lib/mpm's pairs of header and source.
set -euo pipefail
cd "$1"

# The folders that files of a folder may include from.
allowed() {
    case $1 in
        lib/core) echo core ;;
        lib/geometry | lib/mpm | lib/analysis | lib/io) echo "${1#lib/} core" ;;
        lib/scene) echo "scene geometry mpm analysis io core" ;;
        stages/*) echo "${1#stages/} common scene geometry mpm analysis io core" ;;
    esac
}

# The rooms of lib/mpm that a room may include from.
allowed_rooms() {
    local below="bodies boundaries materials particles grid base"
    case $1 in
        base) echo base ;;
        grid) echo "grid base" ;;
        particles) echo "particles grid base" ;;
        materials) echo "materials particles grid base" ;;
        boundaries) echo "boundaries grid base" ;;
        bodies) echo "bodies boundaries grid base" ;;
        state) echo "state $below" ;;
        readings | step) echo "$1 state $below" ;;
    esac
}

is_ours() { [[ -d lib/$1 || -d stages/$1 || $1 == stages || $1 == lib || $1 == tests || $1 == .. ]]; }

violations=0
for folder in lib/*/ stages/*/; do
    folder=${folder%/}
    may=$(allowed "$folder")
    while IFS=: read -r file line include; do
        [[ $include =~ \#[[:space:]]*include[[:space:]]*([\"<])([^\">]+) ]] || continue
        header=${BASH_REMATCH[2]}
        [[ $header == */* ]] || continue # a header of the same folder, or of a library
        target=${header%%/*}
        [[ ${BASH_REMATCH[1]} == '"' ]] || is_ours "$target" || continue
        [[ " $may " == *" $target "* ]] && continue
        echo "$file:$line: $folder must not include \"$header\"; it may include from: $may"
        violations=1
    done < <(grep --recursive --line-number --with-filename '^[[:space:]]*#[[:space:]]*include' "$folder" || true)
done

for folder in lib/mpm/*/; do
    room=$(basename "$folder")
    may=$(allowed_rooms "$room")
    while IFS=: read -r file line include; do
        [[ $include =~ \"mpm/([a-z]+)/ ]] || continue
        [[ " $may " == *" ${BASH_REMATCH[1]} "* ]] && continue
        echo "$file:$line: lib/mpm/$room must not include from lib/mpm/${BASH_REMATCH[1]}; it may from: $may"
        violations=1
    done < <(grep --recursive --line-number --with-filename '^[[:space:]]*#[[:space:]]*include[[:space:]]*"mpm/' "$folder" || true)
done

# A pair is its header and its source; tsort knows no order of pairs that stand in a circle.
circles=$(grep --recursive --with-filename '^[[:space:]]*#[[:space:]]*include[[:space:]]*"mpm/' lib/mpm |
    sed -E 's|^lib/(mpm/[^.]*)\.[a-z]+:.*"(mpm/[^."]*)\.h".*|\1 \2|' | tsort 2>&1 >/dev/null || true)
if [[ -n $circles ]]; then
    echo "lib/mpm: these pairs of header and source include each other in a circle:"
    sed -E 's/^tsort: //; /input contains a loop/d; s|^|    lib/|' <<<"$circles"
    violations=1
fi
exit "$violations"
