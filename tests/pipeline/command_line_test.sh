#!/usr/bin/env bash
# command_line_test.sh BIN: what every stage does with its command line and with a bad scene.
source "$(dirname "$0")/assert.sh"
bin=$1
tiny=$(cd "$(dirname "$0")" && pwd)/tiny.toml
cd "$work" || exit 1

for stage in geometry simulate postprocess; do
    program=$bin/tidewater-$stage

    case_named "$stage tells its options, its version and the keys"
    run "$program" --help
    expect_code 0
    expect_line "--set KEY=VALUE"
    run "$program" --version
    expect_code 0
    expect_line "tidewater-$stage 0."
    run "$program" --help-scene
    expect_code 0
    expect_line "water.depth"

    case_named "$stage without a scene or with an unknown option ends with 2 and one line"
    run "$program"
    expect_code 2
    expect_same "$output" "tidewater-$stage: scene is required; --help lists the options"
    run "$program" "$tiny" --tread 4
    expect_code 2
    expect_line "tidewater-$stage: "
    expect_same "$(wc -l <<<"$output")" 1

    case_named "$stage accepts a scene that is in order, without writing anything"
    run "$program" "$tiny" --check
    expect_code 0
    expect_same "$output" "$tiny: the scene is in order"
    expect_same "$(ls -A "$work")" ""

    case_named "$stage tells of a missing scene file with exit code 3"
    run "$program" missing.toml
    expect_code 3
    expect_same "$output" "tidewater-$stage: missing.toml: cannot be read; check the path"

    case_named "$stage ends with 5 where what it prints cannot be written"
    for option in --help-scene --print-scene "--print-part $stage" --check; do
        run bash -c "'$program' '$tiny' $option >/dev/full"
        expect_code 5
        expect_line "tidewater-$stage: standard output: writing failed; is the disk full?"
    done

    case_named "$stage tells of a folder that it cannot write with exit code 5"
    run "$program" "$tiny" --run /proc/tidewater
    expect_code 5
    expect_line "tidewater-$stage: /proc/tidewater/$stage: cannot be created"
done

program=$bin/tidewater-simulate

case_named "only simulate takes --from and --until, a time from 0 on"
run "$program" --help
expect_line "--from start|CHECKPOINT"
expect_line "--until TIME"
run "$program" "$tiny" --until -1
expect_code 2
expect_line "--until"
run "$bin/tidewater-geometry" "$tiny" --until 1
expect_code 2

case_named "all problems of a scene are told at once, with exit code 2 and nothing written"
cat >bad.toml <<'TOML'
effects = ["water", "rigd"]
[domain]
size = [2, 1.01]
cell_size = 0.05
[water]
dpeth = 0.5
density = -1
[simulate]
end_time = "long"
end_time = 3
snapshot_interval = 0.1
gauges = [5]
TOML
run "$program" bad.toml --set x.y=1 --run out
expect_code 2
expect_line 'tidewater-simulate: bad.toml:1: effects: unknown effect "rigd"; did you mean "rigid"?'
expect_line 'tidewater-simulate: bad.toml:3: domain.size: 1.01 m along z is not a whole number of cells of 0.05 m'
expect_line 'tidewater-simulate: bad.toml:6: water.dpeth: unknown key; did you mean water.depth?'
expect_line 'tidewater-simulate: bad.toml:7: water.density: -1 kg/m³ is out of range; it must be above 0 kg/m³'
expect_line 'tidewater-simulate: bad.toml:9: simulate.end_time: needs a number in s, e.g. end_time = 10; got text "long"'
expect_line 'tidewater-simulate: bad.toml:10: simulate.end_time: duplicate key; keep one of them'
expect_line 'tidewater-simulate: bad.toml:12: simulate.gauges: outside the tank, which ends at x = 2 m: 5'
expect_line 'tidewater-simulate: --set x.y=1: unknown key; --help-scene lists all keys'
expect_same "$(wc -l <<<"$output")" 8
expect_no_file out

case_named "the printed scene reads back to the same"
run "$program" "$tiny" --set block.angle=10 --print-scene
expect_code 0
printf '%s\n' "$output" >printed.toml
first=$output
run "$program" printed.toml --print-scene
expect_same "$output" "$first"
expect_line "angle = 10"

case_named "the printed part holds only what the stage reads"
run "$program" "$tiny" --print-part geometry
expect_code 0
expect_line "block.size = [0.5, 0.5]"
expect_line "simulate.gauges = [0.8, 1.2]" # its picture shows them
expect_no_line "simulate.end_time"

case_named "a warning is told and the stage goes on"
run "$program" "$tiny" --check --set water.sound_speed=20
expect_code 0
expect_line "tidewater-simulate: warning: water.sound_speed: 20 m/s is less than 10 times the fastest expected flow"
