#!/usr/bin/env bash
# postprocess_inputs_test.sh BIN: postprocess works on a run that grows, on part of a copy, and goes on where it was killed.
source "$(dirname "$0")/assert.sh"
bin=$1
cp "$(dirname "$0")/tiny.toml" "$work"
cd "$work" || exit 1
"$bin/tidewater-geometry" tiny.toml --run whole >/dev/null 2>&1 && "$bin/tidewater-simulate" tiny.toml --run whole \
    >/dev/null 2>&1 || fail_case "no run was simulated"
postprocess() {
    run "$bin/tidewater-postprocess" tiny.toml --run "$1" "${@:2}"
    expect_code 0
}
# What a folder holds, without the times of its files and without the journal of what was made.
same_results() {
    run diff -r --exclude=.stamps --exclude=report.html "$1/postprocess" "$2/postprocess"
    expect_code 0
}
postprocess whole

case_named "a run that grows is done frame by frame, with the tables so far, and ends as if done at once"
mkdir -p grown/simulate
cp -p whole/simulate/scene.toml grown/simulate
for table in gauges ledger bodies; do
    head -n 12 whole/simulate/$table.csv >grown/simulate/$table.csv.part
    printf '0.17' >>grown/simulate/$table.csv.part # a row that is being written
done
cp -p whole/simulate/frame_0000.hdf grown/simulate
postprocess grown
first=$(stat -c '%i %Y %n' grown/postprocess/particles_0000.vtp)
expect_no_file grown/postprocess/particles_0001.vtp
expect_file grown/postprocess/energy.svg
cp -p whole/simulate/frame_0001.hdf grown/simulate
cp -p whole/simulate/frame_0002.hdf grown/simulate/frame_0002.hdf.part
postprocess grown
expect_file grown/postprocess/particles_0001.vtp
expect_no_file grown/postprocess/particles_0002.vtp
rm grown/simulate/*.part
cp -p whole/simulate/* grown/simulate
postprocess grown
expect_same "$(stat -c '%i %Y %n' grown/postprocess/particles_0000.vtp)" "$first"
same_results whole grown

case_named "a copy of the frames and the scene is enough; what is left out is told"
mkdir -p copy/simulate
cp whole/simulate/{scene.toml,frame_*.hdf} copy/simulate
run "$bin/tidewater-postprocess" copy/simulate/scene.toml --run copy
expect_code 0
expect_line "no gauges.csv, and so no gauges but postprocess.gauges"
expect_line "no ledger.csv, and so no energy"
expect_line "no bodies.csv, and so nothing of the block's wave"
expect_file copy/postprocess/particles_0002.vtp
expect_no_file copy/postprocess/energy.svg

case_named "a stage that is killed goes on to the same bytes"
cp -r whole killed
rm -r killed/postprocess
for delay in 0.03 0.1 0.2 0.3; do
    "$bin/tidewater-postprocess" tiny.toml --run killed >/dev/null 2>&1 &
    sleep $delay
    kill -9 $! 2>/dev/null
    wait $! 2>/dev/null
done
postprocess killed
same_results whole killed

case_named "a frame that is cut off, of a newer format or without a column ends with 3 and names the file"
cp -r whole broken
truncate --size=-1000 broken/simulate/frame_0001.hdf
run "$bin/tidewater-postprocess" tiny.toml --run broken
expect_code 3
expect_line "tidewater-postprocess: broken/simulate/frame_0001.hdf: it is truncated or no HDF5 file"
