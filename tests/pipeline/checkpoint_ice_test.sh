#!/usr/bin/env bash
# checkpoint_ice_test.sh BIN: a run of ice that is killed, also while it settles, ends with the bytes of one that was not;
# so it does on another number of threads.
source "$(dirname "$0")/assert.sh"
bin=$1
cp "$(dirname "$0")/tiny_ice.toml" "$work"
cd "$work" || exit 1
export LC_ALL=C # for the point in EPOCHREALTIME

options=(--set simulate.checkpoint_interval=0.02 --set simulate.end_time=6)
# simulate FOLDER [OPTION...]
simulate() { run "$bin/tidewater-simulate" tiny_ice.toml --run "$1" "${options[@]}" "${@:2}"; }
expect_whole() {
    run diff --recursive --exclude=log --exclude=run.json whole cut
    expect_code 0
}

case_named "a slab settles, is pushed off its shelf, breaks, and the water that is too much leaves"
run "$bin/tidewater-geometry" tiny_ice.toml --run whole
expect_code 0
before=$EPOCHREALTIME
simulate whole --threads 2
expect_code 0
duration=$(awk "BEGIN { print $EPOCHREALTIME - $before }")
expect_line "settled after "
run awk -F, '/^time/ { for (c = 1; c <= NF; ++c) if ($c == "outflow_mass") column = c } END { print ($column > 0) }' \
    whole/simulate/ledger.csv
expect_same "$output" 1
run "$bin/tidewater-postprocess" tiny_ice.toml --run whole --set simulate.end_time=6
expect_code 0
expect_line "first iceberg: came off at "
for column in principal_stress damage alpha failure_time; do
    grep --quiet "Name=\"$column\"" whole/postprocess/particles_0003.vtp || fail_case "frames have no $column"
done
rm -r whole/postprocess

case_named "one thread and three give the same bytes as two"
for threads in 1 3; do
    rm -rf cut
    mkdir cut
    cp -r whole/geometry cut
    simulate cut --threads $threads
    expect_code 0
    run diff --recursive --exclude=log --exclude=run.json whole/simulate cut/simulate
    for file in whole/simulate/frame_*.hdf whole/simulate/*.csv; do
        run cmp "$file" "cut/simulate/$(basename "$file")"
        expect_code 0
    done
done

case_named "killed at eight random moments and continued, it ends with the same bytes"
seed=$$
RANDOM=$seed
echo "  seed $seed"
rm -rf cut
mkdir cut
cp -r whole/geometry cut
went_on=0
for ((kills = 0; kills < 8;)); do
    "$bin/tidewater-simulate" tiny_ice.toml --run cut "${options[@]}" --threads 2 >output 2>&1 &
    process=$!
    sleep "$(awk "BEGIN { print 0.1 + $duration * (0.02 + 0.3 * $RANDOM / 32768) }")"
    kill -KILL "$process" 2>/dev/null
    code=0
    wait "$process" 2>/dev/null || code=$?
    output=$(cat output)
    ! grep --quiet "going on from cut/simulate/checkpoint.h5" <<<"$output" || ((++went_on))
    if [[ $code == 137 ]]; then
        ((++kills))
    else # it was at its end already
        expect_code 0
        expect_whole
        rm -r cut/simulate
    fi
done
simulate cut --threads 2
expect_code 0
expect_whole
echo "  $went_on processes went on from a checkpoint"
((went_on >= 2)) || fail_case "too few to tell"

case_named "a start that does not settle is an error that says what to do"
mkdir never
cp -r whole/geometry never
simulate never --set settle.tolerance=1e-3 --set settle.max_time=0.05
expect_code 4
expect_line "the start has not settled after 0.05 s"
