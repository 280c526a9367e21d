#!/usr/bin/env bash
# all_stages_test.sh BIN: unusual scenes through all stages, and how a stage fails when its input or its disk does.
source "$(dirname "$0")/assert.sh"
bin=$1
cp "$(dirname "$0")/tiny.toml" "$work"
cd "$work" || exit 1

# stage NAME SCENE FOLDER [OPTION...]
stage() { run "$bin/tidewater-$1" "$2" --run "$3" --threads 2 "${@:4}"; }

# all_stages SCENE FOLDER [OPTION...] runs them and expects each one's last file.
all_stages() {
    local name
    for name in geometry simulate postprocess; do
        stage "$name" "$@"
        expect_code 0
    done
    expect_file "$2/geometry/geometry.vdb"
    expect_file "$2/simulate/ledger.csv"
    expect_file "$2/postprocess/waves.csv"
    expect_same "$(find "$2" -name '*.part')" ""
}

# Runs a command whose writes fail beyond so many KiB of a file, as on a full disk.
on_full_disk() {
    (
        trap '' XFSZ
        ulimit -f "$1"
        exec "${@:2}"
    )
}

# expect_whole FOLDER LIKE: each file that FOLDER has is the same as in LIKE, where all went well.
expect_whole() {
    local file
    while read -r file; do
        cmp --silent "$1/$file" "$2/$file" || fail_case "$1/$file is not whole"
    done < <(cd "$1" && find . -type f ! -name log ! -name run.json ! -name .stamps)
}

case_named "a scene with water and a block goes through all stages"
all_stages tiny.toml whole

case_named "the recorded command and so the results are the same from another folder"
mkdir elsewhere
(cd elsewhere && "$bin/tidewater-geometry" ../tiny.toml --run there --threads=1) >/dev/null 2>&1
run cmp whole/geometry/geometry.vdb elsewhere/there/geometry/geometry.vdb
expect_code 0

case_named "a key of postprocess changes no byte of the level sets"
sed 's/^picture_width.*/picture_width = 500/' tiny.toml >elsewhere/tiny.toml
stage geometry elsewhere/tiny.toml other
run cmp whole/geometry/geometry.vdb other/geometry/geometry.vdb
expect_code 0

case_named "a scene without gauges goes through all stages"
all_stages tiny.toml no_gauges --set simulate.gauges=[]

case_named "a scene in 3D goes through all stages"
cat >solid.toml <<'TOML'
dimension = 3
effects = ["water", "rigid"]
domain.size = [1, 0.4, 0.6]
domain.cell_size = 0.05
water.depth = 0.3
water.sound_speed = 40
block.size = [0.2, 0.2, 0.2]
block.center = [0.15, 0.2, 0.45]
simulate.end_time = 0.05
simulate.snapshot_interval = 0.05
simulate.gauges = [0.5]
postprocess.picture_width = 400
TOML
all_stages solid.toml solid

case_named "a scene of a block alone goes through all stages"
cat >block.toml <<'TOML'
effects = ["rigid"]
domain.size = [1, 1]
domain.cell_size = 0.05
block.size = [0.3, 0.3]
block.center = [0.5, 0.5]
simulate.end_time = 0.1
simulate.snapshot_interval = 0.05
postprocess.picture_width = 400
TOML
all_stages block.toml block

case_named "a run that is shortened below the times of its pictures and rows goes through all stages"
all_stages tiny.toml short --set simulate.end_time=0.1 --set simulate.gauge_interval=0.5 \
    --set postprocess.picture_times=[0,0.1,3]
expect_line "tidewater-postprocess: warning: postprocess.picture_times: later than simulate.end_time"

case_named "a scene without anything in it ends with 2"
stage simulate tiny.toml whole --set effects=[]
expect_code 2
expect_line "there would be no particles"

case_named "simulate without level sets ends with 3 and names the file"
stage simulate tiny.toml nothing
expect_code 3
expect_line "tidewater-simulate: nothing/geometry/geometry.vdb: "

case_named "postprocess without a simulated run ends with 3 and names it"
stage postprocess tiny.toml nothing
expect_code 3
expect_line "tidewater-postprocess: nothing/simulate"

case_named "a truncated frame ends postprocess with 3 and is named"
cp -r whole truncated
truncate --size=-1000 truncated/simulate/frame_0001.hdf
stage postprocess tiny.toml truncated
expect_code 3
expect_line "tidewater-postprocess: truncated/simulate/frame_0001.hdf: "

case_named "references that the report cannot read are told, and the earlier results stay"
for reference in "celerity 1 2" "speed 1 2 us" "celerity 2 1 us" "celerity a 2 us" "celerity@4 1 2 us" "run_up@4 1 2 us"; do
    run "$bin/tidewater-postprocess" tiny.toml --run whole --set "postprocess.references=[\"$reference\"]"
    case $reference in
        celerity@4*) expect_code 0 ;; # the celerity from that gauge to the next
        *)
            expect_code 2
            expect_line "postprocess.references: \"$reference\": "
            ;;
    esac
    expect_file whole/postprocess/report.html
done
stage postprocess tiny.toml whole

case_named "a run that leaves what can be computed ends with 4 and no result that looks whole"
cp -r whole broken
stage simulate tiny.toml broken --set water.density=1e300 # beyond what single precision holds
expect_code 4
expect_line "tidewater-simulate: step "
expect_no_file broken/simulate/ledger.csv
# The curves so far tell what went wrong.
expect_same "$(find broken -name '*.part' | sort | tr '\n' ' ')" \
    "broken/simulate/bodies.csv.part broken/simulate/gauges.csv.part broken/simulate/ledger.csv.part "

for name in geometry simulate postprocess; do
    case_named "$name on a full disk ends with 5 and nothing broken under a final name"
    for size in 1 8 40; do
        rm -rf full
        cp -r whole full
        [[ $name != geometry ]] || rm full/geometry/*
        run on_full_disk "$size" "$bin/tidewater-$name" tiny.toml --run full --threads 2
        expect_code 5
        expect_line "tidewater-$name: full/$name/"
        expect_whole "full/$name" "whole/$name"
        expect_same "$(find full -name '*.part')" ""
    done
done
