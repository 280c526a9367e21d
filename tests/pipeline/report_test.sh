#!/usr/bin/env bash
# report_test.sh BIN: what report.html tells of a run, and what it warns of.
source "$(dirname "$0")/assert.sh"
bin=$1
cp "$(dirname "$0")/tiny.toml" "$work"
cd "$work" || exit 1

# report FOLDER OPTION... keeps the report's text, an element's end a line, in $output.
report() {
    run "$bin/tidewater-postprocess" tiny.toml --run "$@"
    expect_code 0
    run sed 's|</[a-z0-9]*>|\n|g; s|<[^>]*>||g' "$1/postprocess/report.html"
}
# change FILE COLUMN FACTOR: multiplies the column in the last row.
change() {
    awk -F, -v OFS=, -v name="$2" -v factor="$3" '
        NR == FNR { last = FNR; next }
        /^#/ { print; next }
        !column { for (i = 1; i <= NF; i++) if ($i == name) column = i; print; next }
        FNR == last { $column *= factor }
        { print }' OFMT=%.17g CONVFMT=%.17g "$1" "$1" >changed && mv changed "$1"
}

"$bin/tidewater-geometry" tiny.toml --run run >log 2>&1 && "$bin/tidewater-simulate" tiny.toml --run run >log 2>&1 ||
    fail_case "$(cat log)"

case_named "a run without trouble has its cost and no warning of its momentum, mass or end"
report run
expect_line "Steps limited by"
expect_line "particle-steps/s"
expect_no_line "Momentum along"
expect_no_line "Mass drifts"
expect_no_line "going on or was stopped"

case_named "numbers lie within or outside of the scene's references"
report run --set 'postprocess.references=["block_speed 0 1000 a & b", "block_speed - 0 nobody"]'
expect_line "0 to 1000 m/s"
expect_line "a &amp; b"
expect_line "at most 0 m/s"
expect_line "within"
expect_line "outside"
expect_line "1 of 2 numbers with a reference lie within it."

case_named "energy that rises, momentum that is open and mass that drifts are warned of"
cp -r run drifted
change drifted/simulate/ledger.csv energy 1.1
change drifted/simulate/ledger.csv wall_impulse_z 1.01
change drifted/simulate/ledger.csv mass 0.99
report drifted
expect_line "The total energy rises by up to 37"
expect_line "Momentum along z is open by"
expect_no_line "Momentum along x"
expect_line "Mass drifts by"

case_named "water that a wall holds is warned of before the run, in its log, its facts and its report, with the layer against the depth"
held=(--set domain.wall_bottom=stick)
run "$bin/tidewater-geometry" tiny.toml --run held "${held[@]}"
expect_line "domain.wall_bottom = \"stick\": holds the water, in a layer that grows with each step: about "
run "$bin/tidewater-simulate" tiny.toml --run held "${held[@]}"
expect_line "domain.wall_bottom = \"stick\": holds the water"
run cat held/simulate/run.json
expect_line "holds the water"
report held "${held[@]}"
expect_line " m thick after "

case_named "a run that was stopped is warned of"
cp -r run stopped
rm stopped/simulate/frame_000[12].hdf stopped/simulate/frame.hdf.series
report stopped
expect_line "The run is going on or was stopped: its last frame is of t = 0 s of 0.2 s."

case_named "an estimate outside of its validated range is told, once"
report run
expect_same "$(grep -c "The impulse-product estimate of the wave is outside" <<<"$output")" 1

case_named "a run whose facts are gone has a report that says so"
mv run/simulate/run.json run.json
report run
expect_no_line "particle-steps/s"
expect_line "not recorded: there is no simulate/run.json"
expect_line "What was run"
