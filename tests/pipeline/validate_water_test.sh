#!/usr/bin/env bash
# validate_water_test.sh PROJECT BIN: the water's scenes, very coarse and short, go through the pipeline and are drawn and
# tabled against their references.
source "$(dirname "$0")/assert.sh"
project=$1
bin=$2
cd "$work" || exit 1
# validate SCENES SET [VARIABLE...]
validate() {
    run make -f "$project/tools/validate_water.mk" BIN="$bin" OUT=out SCENES="$1" \
        SET="--set postprocess.picture_width=400 $2" "${@:3}"
}
# finding RUN QUANTITY: its measured value.
finding() { grep "^$1,$2" out/validation.csv | cut -d, -f5; }
holds() { [[ $1 != *nan* && $1 != *'* '* ]] && awk "BEGIN { exit !($1) }" || fail_case "does not hold: $1"; }

case_named "water at rest is judged by its pressure, speed, level and energy"
validate rest '--set simulate.end_time=0.1 --set simulate.snapshot_interval=0.05 --set domain.cell_size=0.1'
expect_code 0
expect_file out/rest.svg
expect_line 'pressure on the bed'
speed=$(finding rest 'fastest particle at the end')
holds "$speed >= 0 && $speed < 0.05"

case_named "standing waves of several lengths have periods near theory's and are drawn over k"
validate dispersion '--set domain.cell_size=0.1' LENGTHS='12 6'
expect_code 0
for file in dispersion_12.svg dispersion_6.svg dispersion.svg; do expect_file "out/$file"; done
period=$(finding dispersion_6 period) # 2.271 s
holds "$period > 2.1 && $period < 2.4"

case_named "a solitary wave passes its gauges"
validate solitary_wave '--set domain.cell_size=0.125 --set simulate.end_time=2.5'
expect_code 0
speed=$(finding solitary_wave 'celerity')
holds "$(head -n 1 <<<"$speed") > 3.2 && $(head -n 1 <<<"$speed") < 3.6"

case_named "a dam break is compared with its published series, moved by one shift of time"
validate dam_break '--set domain.cell_size=0.005715 --set simulate.end_time=0.3'
expect_code 0
expect_line 'how much later their clock shows it'
front=$(finding dam_break 'speed of the front')
holds "$front > 1 && $front < 2.5"

case_named "sensors on the wall that it strikes are compared with the published ones"
validate dam_break_pressure '--set domain.cell_size=0.02 --set domain.size=[1.62,0.9] --set simulate.pressure_gauges=[[1.62,0.003]] --set simulate.end_time=0.6'
expect_code 0
expect_line 'x=1.62 z=0.003: arrival'

case_named "a folder without a run is told"
run "$bin/tidewater-validate-water" out/nothing
expect_code 3
expect_line 'out/nothing: no whole run'
