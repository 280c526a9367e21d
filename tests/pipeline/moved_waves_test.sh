#!/usr/bin/env bash
# moved_waves_test.sh PROJECT BIN: tools/moved_waves on a tiny glacier.
source "$(dirname "$0")/assert.sh"
project=$1
export BIN=$2
scene=$(dirname "$0")/tiny_glacier.toml

case_named "a scene is run in each way, once, with a row of numbers for each"
run "$project/tools/moved_waves" "$work/out" "$scene" "plain" "cfl --set simulate.cfl=0.25"
expect_code 0
expect_same "$(head -1 "$work/out/waves.csv")" "way,crest x=180,celerity,failed_width,plane_angle,F,S,M,steps"
expect_same "$(wc -l <"$work/out/waves.csv")" 3
steps() { awk -F, -v way="$1" '$1 == way { print $NF }' "$work/out/waves.csv"; }
(($(steps cfl) > 3 * $(steps plain) / 2)) || fail_case "half the step makes $(steps cfl) steps of $(steps plain)"
highest=$(awk -F, '!/^#/ && NF == 2 && $2 + 0 > top { top = $2 } END { printf "%.2f", top }' "$work/out/plain/simulate/gauges.csv")
expect_same "$(awk -F, '$1 == "plain" { print $2 }' "$work/out/waves.csv")" "$highest"
touch -r "$work/out/plain/simulate/log" "$work/before"
run "$project/tools/moved_waves" "$work/out" "$scene" "plain"
expect_code 0
[[ ! $work/out/plain/simulate/log -nt $work/before ]] || fail_case "a run that is there was made again"

case_named "a way that is not in order ends it with what the stage says"
run "$project/tools/moved_waves" "$work/out" "$scene" "wrong --set bed.friction=-1"
expect_code 1
expect_line "bed.friction"

case_named "without a scene it tells how it is used"
run "$project/tools/moved_waves"
expect_code 2
expect_line "tools/moved_waves OUT SCENE"
