#!/usr/bin/env bash
# checkpoint_test.sh PROJECT BIN SET_HDF5: a run that is stopped or killed ends with the bytes of one that was not.
source "$(dirname "$0")/assert.sh"
project=$1
bin=$2
set_hdf5=$3
cp "$(dirname "$0")/tiny.toml" "$work"
cd "$work" || exit 1
export LC_ALL=C # for the point in EPOCHREALTIME
checkpoint=cut/simulate/checkpoint.h5

# A few seconds of a block in water; a checkpoint at every turn.
options=(--set simulate.end_time=6 --set simulate.pressure_gauges=[[1,0],[2,0.25]] --set simulate.checkpoint_interval=0.02 --threads 2)
# simulate FOLDER [OPTION...]
simulate() { run "$bin/tidewater-simulate" tiny.toml --run "$1" "${options[@]}" "${@:2}"; }
# in_background [OPTION...] begins or goes on with the run in cut; $process is its number.
in_background() {
    env --default-signal=INT "$bin/tidewater-simulate" tiny.toml --run cut "${options[@]}" "$@" >output 2>&1 &
    process=$!
}
# ended_process sets code and output as run does.
ended_process() {
    code=0
    wait "$process" 2>/dev/null || code=$?
    output=$(cat output)
}
# Waits until FILE is there, half a minute at most.
wait_for() {
    for _ in {1..600}; do
        [[ ! -e $1 ]] || return 0
        sleep 0.05
    done
    fail_case "no $1 after 30 s"
}
begin_anew() {
    rm -rf cut
    mkdir cut
    cp -r whole/geometry cut
}
# The run in cut is whole: every file but log and run.json, which hold times, is that of the undisturbed run.
expect_whole() {
    run diff --recursive --exclude=log --exclude=run.json whole cut
    expect_code 0
}
# on_full_disk KIB COMMAND... ends in the command, whose writes fail beyond so much of one file.
on_full_disk() {
    trap '' XFSZ
    ulimit -f "$1"
    exec "${@:2}"
}

run "$bin/tidewater-geometry" tiny.toml --run whole
expect_code 0
before=$EPOCHREALTIME
simulate whole
expect_code 0
duration=$(awk "BEGIN { print $EPOCHREALTIME - $before }")
expect_no_file whole/simulate/checkpoint.h5
begin_anew

case_named "killed at twenty random moments and continued, it ends with the same bytes"
seed=$$
RANDOM=$seed
echo "  seed $seed"
went_on=0
for ((kills = 0; kills < 20;)); do
    in_background
    sleep "$(awk "BEGIN { print $duration * (0.05 + 0.2 * $RANDOM / 32768) }")"
    kill -KILL "$process" 2>/dev/null
    ended_process
    ! grep --quiet "going on from $checkpoint" <<<"$output" || ((++went_on))
    if [[ $code == 137 ]]; then
        ((++kills))
    else # it was at its end already
        expect_code 0
        expect_whole
        begin_anew
    fi
done
simulate cut
expect_code 0
expect_whole
echo "  $went_on processes went on from a checkpoint"
((went_on >= 5)) || fail_case "too few to tell"

for name in TERM INT; do
    case_named "SIG$name, also several times at once, ends it with a checkpoint and 128 + the signal"
    begin_anew
    in_background --set simulate.checkpoint_interval=0
    wait_for cut/simulate/frame_0002.hdf
    kill "-$name" "$process"
    kill "-$name" "$process"
    ended_process
    expect_code $((128 + $(kill -l "$name")))
    expect_line "tidewater-simulate: stopped by SIG$name at t = "
    expect_line "the same command goes on from $checkpoint"
    expect_file "$checkpoint"
    expect_file cut/simulate/gauges.csv.part
    expect_no_file cut/simulate/ledger.csv
done
options+=(--set simulate.checkpoint_interval=0) # the same command as that of the stopped run
simulate whole
simulate cut
expect_code 0
expect_line "going on from $checkpoint"
expect_whole
run grep --count "particles (.*) in .* blocks" cut/simulate/log
expect_same "$output" 2

case_named "--until stops at the first step that ends then or later, and changes no step"
begin_anew
simulate cut --until 0.5
expect_code 0
expect_line "stopped by --until at t = 0.500"
expect_no_file cut/simulate/ledger.csv
expect_file cut/simulate/frame_0005.hdf
expect_no_file cut/simulate/frame_0006.hdf
expect_same "$(tail -n 1 cut/simulate/ledger.csv.part | cut -d, -f1)" 0.5
simulate cut --until 0.5
expect_line "stopped by --until at t = 0.500"
simulate cut --until 0.723
expect_line "stopped by --until at t = 0.723"
cp "$checkpoint" early.h5
cp -r cut stopped
simulate cut
expect_code 0
expect_whole

case_named "--from goes on from a copy of a checkpoint, or begins anew"
simulate cut --from early.h5
expect_line "going on from early.h5, t = 0.723"
expect_whole
rm -r cut
cp -r stopped cut
simulate cut --from start
expect_no_line "going on"
expect_whole

# refuses LINE [OPTION...]: with a line and exit code 3, and leaves everything as it is.
refuses() {
    rm -rf before
    cp -r cut before
    simulate cut "${@:2}"
    expect_code 3
    expect_line "tidewater-simulate: $1"
    expect_same "$(grep -c 'tidewater-simulate: [^wt]' <<<"$output")" 1
    run diff --recursive before cut
    expect_code 0
}
# stopped_run [NAME VALUE]: the stopped run with something changed in its checkpoint.
stopped_run() {
    rm -rf cut
    cp -r stopped cut
    (($# == 0)) || "$set_hdf5" "$checkpoint" "$@" || fail_case "cannot set $1"
}

case_named "a damaged, truncated, foreign or newer checkpoint is refused"
stopped_run
size=$(stat --format=%s "$checkpoint")
printf '\xa5\x5a\xa5' | dd of="$checkpoint" bs=1 seek=$((size * 2 / 3)) conv=notrunc status=none
refuses "$checkpoint: array /"
stopped_run
truncate --size=-100 "$checkpoint"
refuses "$checkpoint: it is truncated or no HDF5 file; --from start begins the run anew"
cp stopped/simulate/frame_0000.hdf "$checkpoint"
refuses "$checkpoint: it is an HDF5 file but no tidewater checkpoint; --from start begins the run anew"
stopped_run format_version 9
refuses "$checkpoint: its format version 9 is newer than this program's 8; --from start begins the run anew"
stopped_run format_version 7
refuses "$checkpoint: its format version 7 is of a program that stepped by another rule; --from start begins the run anew"
for array in particle_blocks body0.begin; do
    stopped_run "/state/$array" 5
    refuses "$checkpoint: its arrays do not fit each other"
done
refuses "nothing.h5: the file does not exist" --from nothing.h5
simulate cut --from start --until 0
expect_code 0

case_named "a checkpoint of another scene is refused where it is named or costly, and else gives way with a line"
other="it is of another scene (simulate.cfl = 0.5 there, simulate.cfl = 0.4 here)"
stopped_run
refuses "early.h5: $other" --from early.h5 --set simulate.cfl=0.4
refuses "early.h5: it is of another scene (simulate.precision = \"float\" there, simulate.precision = \"double\" here)" \
    --from early.h5 --set simulate.precision=double
stopped_run /run/seconds 7200
refuses "$checkpoint: $other and holds 2 h 00 min of work" --set simulate.cfl=0.4
stopped_run
simulate cut --set simulate.cfl=0.4 --until 0
expect_code 0
expect_line "$checkpoint is ${other#it is }: beginning anew"
expect_no_file cut/simulate/frame_0001.hdf
stopped_run start 0000000000000000
refuses "$checkpoint: it is of a run that started from other particles" --from "$checkpoint"

case_named "a checkpoint of another build goes on, with a line"
stopped_run build 0000000000000000
simulate cut
expect_code 0
expect_line "it was written by another build of this program"
expect_whole

case_named "a run that leaves what can be computed ends with 4 and names its last good checkpoint"
stopped_run /state/body0.j nan
simulate cut
expect_code 4
expect_line "has a strain that is not a number"
expect_line "what it wrote remains, and $checkpoint, t = 0.723"
expect_file "$checkpoint"
expect_file cut/simulate/ledger.csv.part

case_named "a frame that is missing or of another run is told"
stopped_run
rm cut/simulate/frame_0003.hdf
refuses "cut/simulate/frame_0003.hdf: missing or of another run"
cp stopped/simulate/frame_0004.hdf cut/simulate/frame_0003.hdf
refuses "cut/simulate/frame_0003.hdf: missing or of another run"

case_named "a disk that is full for the checkpoint keeps the last good one, and the run goes on"
# In double precision and with few rows checkpoints are larger than frames and tables.
options+=(--set simulate.precision=double --set simulate.gauge_interval=0.05 --set simulate.checkpoint_interval=0.2)
limit=$(($(stat --format=%s whole/simulate/frame_0000.hdf whole/simulate/bodies.csv | sort -n | tail -n 1) / 1024 + 8))
simulate whole
expect_code 0
begin_anew
simulate cut --until 0.5
cp "$checkpoint" early.h5
(($(stat --format=%s early.h5) > limit * 1024)) || fail_case "the checkpoint is not larger than the limit"
on_full_disk "$limit" "$bin/tidewater-simulate" tiny.toml --run cut "${options[@]}" >output 2>&1 &
process=$!
wait_for cut/simulate/frame_0006.hdf
kill -TERM "$process"
ended_process
expect_code 143
expect_line "but $checkpoint"
expect_line "the same command goes on from $checkpoint, t = 0.500"
run cmp early.h5 "$checkpoint"
expect_code 0
expect_no_file "$checkpoint.part"
run on_full_disk "$limit" "$bin/tidewater-simulate" tiny.toml --run cut "${options[@]}"
expect_code 0
expect_line "warning: $checkpoint"
expect_whole

case_named "make passes SIGTERM on, and the same command goes on"
rm -r cut
pipeline=(make -f "$project/tools/pipeline.mk" SCENE=tiny.toml BIN="$bin" RUN=cut THREADS=2 SET="--set simulate.end_time=2")
"${pipeline[@]}" >output 2>&1 &
process=$!
wait_for cut/simulate/frame_0002.hdf
kill -TERM "$process"
ended_process
output=$(cat output)
expect_line "tidewater-simulate: stopped by SIGTERM"
expect_file "$checkpoint"
expect_same "$(cat cut/parts/exit_code)" 143
run "${pipeline[@]}" SET="--set simulate.end_time=2 --set simulate.checkpoint_interval=60"
expect_code 0
expect_line "going on from $checkpoint"
expect_file cut/postprocess/waves.csv

case_named "another interval of checkpoints reruns nothing"
run "${pipeline[@]}" SET="--set simulate.end_time=2 --set simulate.checkpoint_interval=7"
expect_code 0
expect_no_line "writing"
