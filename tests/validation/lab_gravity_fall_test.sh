#!/usr/bin/env bash
# lab_gravity_fall_test.sh PROJECT BIN: the paper's gravity-dominated fall at half its resolution and a quarter of its
# sound speed, which a machine of two cores does in about ten minutes.
source "$(dirname "$0")/../pipeline/assert.sh"
project=$1
bin=$2
cd "$work" || exit 1
case_named "the first wave's celerity is within 5 % of sqrt(g D) from 4 depths on"
run make -f "$project/tools/pipeline.mk" SCENE="$project/configs/lab_gravity_fall.toml" RUN=run BIN="$bin" \
    SET="--set domain.cell_size=0.02 --set water.sound_speed=63 --set simulate.gauges=[4,6,8,10,12]"
expect_code 0
celerity=$(grep "^celerity" <<<"$output")
echo "  $celerity"
error=$(sed -n 's/.* m\/s, \([-+0-9.]*\) % of.*/\1/p' <<<"$celerity")
[[ -n $error ]] && awk -v error="$error" 'BEGIN { exit !(error < 5 && error > -5) }' || fail_case "$celerity"
