#!/usr/bin/env bash
# pipeline_test.sh PROJECT BIN: tools/pipeline.mk runs the stages that a change needs, and no others.
source "$(dirname "$0")/assert.sh"
project=$1
bin=$work/bin
cp -r "$2" "$bin" # own copies, so that touching them disturbs no other test
cp "$(dirname "$0")/tiny.toml" "$work"
cd "$work" || exit 1

pipeline() { run make -f "$project/tools/pipeline.mk" SCENE=tiny.toml BIN="$bin" THREADS=1 SET="$*"; }

# The stages that the last call ran, in their order.
stages_run() { sed -n 's/^tidewater-\([a-z]*\): writing .*/\1/p' <<<"$output" | xargs; }
expect_stages() {
    expect_code 0
    expect_same "$(stages_run)" "$*"
}

case_named "a first call runs all stages, into runs/<scene>"
pipeline
expect_stages geometry simulate postprocess
expect_file runs/tiny/geometry/geometry.vdb
expect_file runs/tiny/simulate/ledger.csv
expect_file runs/tiny/postprocess/waves.csv

case_named "each stage writes the resolved scene beside its results, which checks and reads back to the same"
for stage in geometry simulate postprocess; do
    run "$bin/tidewater-$stage" "runs/tiny/$stage/scene.toml" --print-scene
    expect_code 0
    expect_same "$output" "$(tail -n +5 "runs/tiny/$stage/scene.toml")"
done

case_named "the first lines of the resolved scene tell program, version and command"
run head -n 4 runs/tiny/simulate/scene.toml
expect_line "# program: tidewater-simulate"
expect_line "# version: 0."
expect_line "# command: tidewater-simulate tiny.toml"
expect_no_line "--run"

case_named "no partial file is left"
expect_same "$(find runs -name '*.part')" ""

case_named "a second call runs nothing"
pipeline
expect_stages

case_named "the same value in other words runs nothing"
pipeline --set domain.cell_size=5e-2
expect_stages

case_named "another gauge of postprocess runs postprocess alone"
pipeline --set postprocess.gauges=[1]
expect_stages postprocess
pipeline --set postprocess.gauges=[1]
expect_stages

case_named "another interval of snapshots runs simulate and postprocess"
pipeline --set simulate.snapshot_interval=0.05
expect_stages simulate postprocess

case_named "another block runs all stages"
pipeline --set block.angle=5
expect_stages geometry simulate postprocess

case_named "a key in the file counts as much as a --set option"
sed -i 's/^snapshot_interval.*/snapshot_interval = 0.2/' tiny.toml
pipeline --set block.angle=5
expect_stages simulate postprocess

case_named "a newer executable reruns its stage and those after it"
touch "$bin/tidewater-simulate"
pipeline --set block.angle=5
expect_stages simulate postprocess

case_named "a lost result of geometry is made again"
rm runs/tiny/geometry/geometry.vdb
pipeline --set block.angle=5
expect_stages geometry simulate postprocess

case_named "a bad scene runs nothing, tells its problems and leaves the results alone"
pipeline --set water.dpeth=1
expect_code 2
expect_line "tidewater-geometry: --set water.dpeth=1: unknown key; did you mean water.depth?"
expect_file runs/tiny/simulate/ledger.csv

case_named "a killed simulate leaves no result that looks whole, and runs again"
"$bin/tidewater-simulate" tiny.toml --set block.angle=5 --set simulate.end_time=1000 --threads 1 2>/dev/null &
killed=$!
for _ in {1..200}; do
    [[ -e runs/tiny/simulate/ledger.csv ]] || break
    sleep 0.05
done
kill -KILL "$killed"
wait "$killed" 2>/dev/null
expect_no_file runs/tiny/simulate/ledger.csv
pipeline --set block.angle=5
expect_stages simulate postprocess

case_named "a stage that fails tells why, and its exit code is kept for tools/run"
scene_before=$(cat runs/tiny/simulate/scene.toml)
printf 'not a vdb' >runs/tiny/geometry/geometry.vdb
pipeline --set block.angle=5
expect_code 2
expect_line "tidewater-simulate: runs/tiny/geometry/geometry.vdb"
expect_same "$(cat runs/tiny/parts/exit_code)" 3

case_named "a stage that cannot read its input leaves the earlier results and their scene as they are"
expect_file runs/tiny/simulate/ledger.csv
expect_same "$(cat runs/tiny/simulate/scene.toml)" "$scene_before"
