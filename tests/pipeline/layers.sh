#!/usr/bin/env bash
# layers.sh PROJECT prints each #include that goes upward or sideways, as "file:line: what"; exit code 1 if there is one.
#
#     core <- geometry, mpm, analysis, io <- scene <- stages
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
exit "$violations"
