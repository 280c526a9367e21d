#!/usr/bin/env bash
# lab_test.sh PROJECT BIN WRITE_BLOCK_WAVE: the laboratory's cases go through make once and into one picture.
source "$(dirname "$0")/assert.sh"
project=$1
bin=$2
write_block_wave=$3
cp "$(dirname "$0")"/{block_wave,tiny}.toml "$work"
cd "$work" || exit 1

case_named "runs are put beside the laboratory in one table and one picture"
"$write_block_wave" block_wave.toml a || fail_case "no run was written"
run "$bin/tidewater-postprocess" block_wave.toml --run a
cp -r a b
run "$bin/tidewater-lab" GF=a b --out compared
expect_code 0
expect_line "GF"
expect_same "$(find compared -type f | sort | tr '\n' ' ')" "compared/lab.csv compared/lab.svg "
expect_same "$(grep --invert-match '^#' compared/lab.csv | cut --delimiter=, --fields=1-3)" "case,speed,lab_speed
GF,1.15,1.15
b,1.15,nan"

case_named "what is missing is told"
run "$bin/tidewater-lab" a nothing
expect_code 3
expect_same "$output" "tidewater-lab: nothing/postprocess/tsunami.csv: the file does not exist; run tidewater-postprocess on a \
run with a rigid block in water"
run "$bin/tidewater-lab"
expect_code 2
expect_line "tidewater-lab: RUN is required"
run "$bin/tidewater-lab" a --out /proc/none
expect_code 5

case_named "the cases go through make with the keys that are set, each once"
for name in gravity_fall capsize; do cp tiny.toml "lab_$name.toml"; done
lab() {
    run make -f "$project/tools/lab_tsunamis.mk" SCENES=. OUT=lab CASES='gravity_fall capsize' BIN="$bin" \
        SET="--set postprocess.picture_width=400" "$@"
}
lab
expect_code 0
expect_file lab/lab.csv
expect_file lab/gravity_fall/postprocess/waves.csv
expect_file lab/capsize/postprocess/waves.csv
run grep picture_width lab/capsize/postprocess/scene.toml
expect_line "picture_width = 400"
touch marker
lab
run find lab -newer marker -name 'frame_*'
expect_same "$output" ""

case_named "tools/lab_tsunamis tells its options"
run bash "$project/tools/lab_tsunamis" --help
expect_code 0
expect_line "--set KEY=VALUE"
run bash "$project/tools/lab_tsunamis" --what
expect_code 2
run bash "$project/tools/lab_tsunamis" --set
expect_code 2
