#!/usr/bin/env bash
# wave_train_test.sh BIN WRITE_WAVE_TRAIN: what postprocess tells of waves that are known, read from snapshots.
source "$(dirname "$0")/assert.sh"
bin=$1
write_wave_train=$2
cp "$(dirname "$0")/wave_train.toml" "$work"
cd "$work" || exit 1

# value FILE COLUMN [ROW] prints a value, of the first row unless told.
value() {
    grep --invert-match '^#' "$1" | awk -F, -v name="$2" -v row="${3-1}" \
        'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) column = i } NR == row + 1 { print $column }'
}

# expect_near WHAT VALUE EXPECTED TOLERANCE
expect_near() {
    awk -v a="$2" -v b="$3" -v t="$4" 'BEGIN { exit !(a != "nan" && a - b <= t && b - a <= t) }' ||
        fail_case "$1 is $2, not $3"
}

case_named "gauges put there afterwards give back heights, periods and celerity"
"$write_wave_train" wave_train.toml train || fail_case "no run was written"
run "$bin/tidewater-postprocess" wave_train.toml --run train --threads 2
expect_code 0
waves=train/postprocess/waves.csv
# Crest to trough of 0.12 sin p + 0.04 sin 2p, and 4 √((0.12² + 0.04²)/2).
height=$(awk 'BEGIN { for (p = 0; p < 6.2832; p += 0.001) { e = 0.12 * sin(p) + 0.04 * sin(2 * p)
    if (e > top) top = e; if (e < low) low = e } print top - low }')
for row in 1 2 3 4; do
    x=$(value $waves x $row)
    expect_near "H_s at $x m" "$(value $waves H_s $row)" "$height" 0.01
    expect_near "H_max at $x m" "$(value $waves H_max $row)" "$height" 0.015
    expect_near "H_m0 at $x m" "$(value $waves H_m0 $row)" 0.3578 0.012
    expect_near "T_z at $x m" "$(value $waves T_z $row)" 2.5 0.02
    expect_near "T_p at $x m" "$(value $waves T_p $row)" 2.5 0.03
    expect_near "the waves at $x m" "$(value $waves waves $row)" 15 1
    expect_near "the depth at $x m" "$(value $waves depth $row)" 1 1e-9
    expect_same "$(value $waves doubt $row)" "fewer than 30 waves"
done
for row in 1 2 3; do expect_near "celerity $row" "$(value $waves celerity $row)" 3.132 0.06; done
expect_near "celerity of all" "$(value $waves celerity 5)" 3.132 0.03

case_named "the spectrum has the two frequencies, with the variance of each"
spectra=train/postprocess/spectra.csv
grep --invert-match '^#' $spectra | awk -F, '
    $1 == 4 && before { sum[$4 < 0.6] += $5 * ($4 - before) }
    $1 == 4 { before = $4 }
    END { print sum[1], sum[0] }' >variances
expect_near "0.12²/2" "$(cut --delimiter=' ' --fields=1 variances)" 0.0072 0.0005
expect_near "0.04²/2" "$(cut --delimiter=' ' --fields=2 variances)" 0.0008 0.0001

case_named "the surface of every frame, its diagram over space and time, and the far wall's elevation are there"
expect_same "$(find train/postprocess/frames -name 'surface_*.h5' | wc -l)" 321
for name in space_time.svg space_time.nc spectra.svg decay.svg run_up.svg gauges.nc; do expect_file "train/postprocess/$name"; done
expect_no_file train/postprocess/gauges_snapshots.nc
highest=$(grep --invert-match '^#' train/postprocess/run_up.csv | awk -F, 'NR > 1 && $4 > top { top = $4 } END { print top }')
expect_near "the highest at the wall" "$highest" 0.1313 0.015
expect_line "at the far wall the water rose to 0.1"

case_named "waves that do not fall with distance have no decay to trust"
expect_near "the exponent" "$(value train/postprocess/decay_fit.csv exponent)" 0 0.03
expect_near "distance_ratio" "$(value train/postprocess/decay.csv distance_ratio 3)" 6 1e-9

case_named "a run of a few seconds tells why it has no statistics"
sed -i 's/^end_time.*/end_time = 4/' wave_train.toml
"$write_wave_train" wave_train.toml short || fail_case "no run was written"
run "$bin/tidewater-postprocess" wave_train.toml --run short --threads 2
expect_code 0
expect_same "$(value short/postprocess/waves.csv H_s)" nan
expect_same "$(value short/postprocess/waves.csv T_p)" nan
[[ $(value short/postprocess/waves.csv doubt 4) == *"no whole wave between zero-up-crossings"* ]] || fail_case "no reason is told"
