#!/usr/bin/env bash
# run_facts_test.sh BIN: what simulate writes into run.json, in one piece, in several, stopped and failed, and who reads it.
source "$(dirname "$0")/assert.sh"
bin=$1
cp "$(dirname "$0")/tiny.toml" "$(dirname "$0")/tiny_ice.toml" "$work"
cd "$work" || exit 1

# simulate FOLDER [OPTION...]
simulate() { run "$bin/tidewater-simulate" tiny.toml --run "$1" --threads 2 "${@:2}"; }
# fact KEY [FOLDER]: the value of a key that is there once, as it stands in the file.
fact() { sed -n "s/^ *\"$1\": \(.*[^,]\),\{0,1\}$/\1/p" "${2:-run}/simulate/run.json"; }
# tally FOLDER: what must not depend on how often a run was stopped.
tally() { sed -n '/"steps": /p; /"particle_steps": /p; /"time_step": {/,/}/p; /"first": {/,/}/p; /"last": {/,/}/p' "$1/simulate/run.json"; }
# holds EXPRESSION of awk
holds() { awk "BEGIN { exit !($1) }" || fail_case "not so: $1"; }

run "$bin/tidewater-geometry" tiny.toml --run run
expect_code 0

case_named "a whole run tells what it was and what it took"
simulate run
expect_code 0
expect_same "$(fact state)" '"complete"'
expect_same "$(fact reason)" null
expect_same "$(fact processes)" 1
expect_same "$(fact went_on_from_s)" null
expect_same "$(fact file)" '"tiny.toml"'
expect_same "$(fact title)" '"A tiny tank for the tests of the pipeline"'
expect_same "$(fact hash)" "\"$(sed -n 's/^# scene_hash: //p' run/simulate/ledger.csv)\""
expect_same "$(fact command)" '"tidewater-simulate tiny.toml"'
expect_same "$(fact threads)" 2
expect_same "$(fact simulated_s)" 0.2
expect_same "$(fact settling_s)" null
expect_same "$(fact checkpoint | tail -n 1)" null
expect_same "$(fact tables)" "$(cat run/simulate/*.csv | wc -c)"
expect_same "$(fact frames | tail -n 1)" "$(cat run/simulate/frame_*.hdf | wc -c)"
holds "$(fact peak_memory_bytes) > 1e6 && $(fact total) > $(fact pass) && $(fact pass) > 0"

case_named "its steps are the ledger's, each with what limited it"
expect_same "$(fact steps)" "$(tail -n 1 run/simulate/ledger.csv | cut -d, -f2)"
holds "$(fact sound_in_water) + $(fact motion) + $(fact falling) + $(fact end) == $(fact steps)"
holds "$(fact sound_in_water) > 0.9 * $(fact steps) && $(fact sound_in_ice) == 0"
holds "$(fact particle_steps) == $(fact steps) * $(fact water)"
holds "$(fact min_s) <= $(fact mean_s) && $(fact mean_s) <= $(fact max_s) && ($(fact mean_s) * $(fact steps) / 0.2 - 1)^2 < 0.01"

case_named "rows closer together than the steps change no step and no other row, and their cost is told"
cp -r run rows
simulate rows --set simulate.gauge_interval=0.0001
expect_code 0
expect_line "rows took"
expect_line "a longer simulate.gauge_interval costs less and changes nothing else"
expect_same "$(fact steps rows)" "$(fact steps)"
for table in gauges ledger; do
    expect_same "$(wc -l <rows/simulate/$table.csv)" "$(($(grep --count '^#' run/simulate/$table.csv) + 1 + 2001))"
    # Of the rows of both, all are equal.
    expect_same "$(grep --invert-match '^#' run/simulate/$table.csv |
        grep --invert-match --line-regexp --fixed-strings --file=rows/simulate/$table.csv)" ""
done

case_named "a run in three pieces tells the same as one in one piece, and that it is in three"
rm -rf cut
mkdir cut
cp -r run/geometry cut
for until in 0.05 0.13; do
    simulate cut --until $until
    expect_code 0
    expect_same "$(fact state cut)" '"stopped"'
    grep --quiet "stopped by --until at t = $until" <<<"$(fact reason cut)" || fail_case "no reason: $(fact reason cut)"
done
holds "$(fact checkpoint cut | tail -n 1) == $(stat --format=%s cut/simulate/checkpoint.h5)"
simulate cut
expect_code 0
expect_same "$(fact state cut)" '"complete"'
expect_same "$(fact processes cut)" 3
holds "$(fact went_on_from_s cut) >= 0.13 && $(fact went_on_from_s cut) < 0.131"
expect_same "$(tally cut)" "$(tally run)"

case_named "a run that is killed has told of its start"
cp -r run killed
"$bin/tidewater-simulate" tiny.toml --run killed --set simulate.end_time=60 >output 2>&1 &
process=$!
for _ in {1..600}; do
    [[ ! -e killed/simulate/gauges.csv.part ]] || break
    sleep 0.05
done
sleep 0.3
kill -KILL "$process"
wait "$process" 2>/dev/null
expect_same "$(fact state killed)" '"running"'
expect_same "$(fact ended killed)" null

case_named "a run that leaves what can be computed tells why it failed"
cp -r run failed
simulate failed --set water.density=1e300
expect_code 4
expect_same "$(fact state failed)" '"failed"'
expect_line "$(fact reason failed | tr -d '"')"

case_named "ice limits the steps where it is the faster one, and settling is told apart"
run "$bin/tidewater-geometry" tiny_ice.toml --run ice
run "$bin/tidewater-simulate" tiny_ice.toml --run ice --set simulate.end_time=0.5
expect_code 0
holds "$(fact sound_in_ice ice) > 0.5 * $(fact steps ice) && $(fact settling_s ice) > 0"
holds "$(sed -n '/"particles": {/,/}/s/^ *"ice": \([0-9]*\).*/\1/p' ice/simulate/run.json) > 0"

case_named "the report tells these facts"
run "$bin/tidewater-postprocess" tiny.toml --run run
expect_code 0
run sed 's|</[a-z0-9]*>|\n|g; s|<[^>]*>||g' run/postprocess/report.html
expect_line "complete; began "
expect_line "$(fact water) of water"
expect_line "$(fact steps) steps in "
share=$(awk "BEGIN { printf \"%.0f\", 100 * $(fact sound_in_water) / $(fact steps) }")
expect_line "sound in water $share %"
expect_line "energy $(sed -n '/"first": {/,/}/s/^ *"energy": \([0-9]*\).*/\1/p' run/simulate/run.json)"

case_named "a run.json that is damaged or of another program ends postprocess with a line, and its results stay"
for text in '{"format": ' '{"name": "a package"}'; do
    echo "$text" >run/simulate/run.json
    run "$bin/tidewater-postprocess" tiny.toml --run run
    expect_code 3
    expect_line "tidewater-postprocess: run/simulate/run.json: it is "
    expect_file run/postprocess/report.html
done
