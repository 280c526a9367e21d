#!/usr/bin/env bash
# overhang_test.sh PROJECT BIN: the sweep over submergences runs each depth through make once and draws the lengths.
source "$(dirname "$0")/assert.sh"
project=$1
bin=$2
cp "$(dirname "$0")/tiny_ice.toml" "$work"
cd "$work" || exit 1
sweep() {
    run make -f "$project/tools/overhang_sweep.mk" SCENE=tiny_ice.toml SWEEP=sweep DEPTHS='0 0.5' BIN="$bin" "$@"
}

case_named "each depth is a run of its own, and the lengths are drawn against theory"
sweep
expect_code 0
expect_file sweep/D0/postprocess/first_iceberg.csv
expect_file sweep/D0.5/simulate/ledger.csv
expect_file sweep/overhang.svg
run grep --count --invert-match '^#' sweep/overhang.csv
expect_same "$output" 3

case_named "a depth that is up to date is not run again, a new one alone is"
touch marker
sweep DEPTHS='0 0.5 0.25'
expect_code 0
expect_file sweep/D0.25/postprocess/first_iceberg.csv
run find sweep/D0 sweep/D0.5 -newer marker -name 'frame_*'
expect_same "$output" ""
run grep --count --invert-match '^#' sweep/overhang.csv
expect_same "$output" 4
