#!/usr/bin/env bash
# example_dem_test.sh PROJECT: tools/make_example_dem makes configs/dem_example as it is committed, and without folders
# or arguments of its own.
source "$(dirname "$0")/assert.sh"
project=$1

case_named "the script gives the committed bytes, from any folder and in any locale"
cd "$work" || exit 1
run env LC_ALL=de_DE.UTF-8 "$project/tools/make_example_dem" "$work/made"
expect_code 0
for file in bed.asc bed.prj surface.asc surface.prj; do
    expect_file "$work/made/$file"
    cmp --quiet "$work/made/$file" "$project/configs/dem_example/$file" || fail_case "$file differs from the committed one"
done

case_named "nothing else is left, here or there"
expect_same "$(ls "$work")" made
expect_same "$(ls "$work/made" | wc -l)" 4

case_named "the ground is nowhere above the surface, and both have every row and value"
for model in bed surface; do
    expect_same "$(tail -n +7 "$work/made/$model.asc" | awk 'NF != 100 { bad = 1 } END { print NR, bad + 0 }')" "60 0"
done
expect_same "$(paste -d ' ' "$work/made/bed.asc" "$work/made/surface.asc" | tail -n +7 |
    awk '{ for (i = 1; i <= 100; ++i) above += $i > $(i + 100) } END { print above + 0 }')" 0
