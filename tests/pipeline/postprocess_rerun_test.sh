#!/usr/bin/env bash
# postprocess_rerun_test.sh BIN: postprocess makes again what a change needs, and nothing else.
source "$(dirname "$0")/assert.sh"
bin=$1
cp "$(dirname "$0")/tiny.toml" "$work"
cd "$work" || exit 1

simulated() { "$bin/tidewater-geometry" tiny.toml --run "$1" && "$bin/tidewater-simulate" tiny.toml --run "$1"; }
postprocess() {
    run "$bin/tidewater-postprocess" tiny.toml --run run "$@"
    expect_code 0
}
# The files that were written since the last call of `since`, without the tables and charts of the whole run.
since() { touch mark && sleep 0.05; }
made() { (cd run/postprocess && find . \( -path './frames/*' -o -name '*_*.vtp' -o -name 'frame_t=*' \) -newer ../../mark | sort | xargs); }

run simulated run
expect_code 0

case_named "a first call makes everything"
since
postprocess --set postprocess.gauges=[1]
first=$(made)
for file in ./frames/gauges_0000.csv ./frames/surface_0000.h5 ./particles_0001.vtp ./frame_t=0.00.png; do
    [[ " $first " == *" $file "* ]] || fail_case "$file was not made: $first"
done
cp -r run/postprocess first

case_named "a second call makes no frame again, and the same tables"
since
postprocess --set postprocess.gauges=[1]
expect_same "$(made)" ""
run diff -r --exclude=.stamps first run/postprocess
expect_code 0

case_named "another gauge reads the gauges again, and draws what shows them"
since
postprocess --set postprocess.gauges=[1,1.5]
expect_same "$(made | tr ' ' '\n' | grep -v '^./frames/gauges_\|^./frame_t=')" ""
run grep -c . run/postprocess/frames/gauges_0000.csv
expect_code 0
run head -n 8 run/postprocess/gauges.csv
expect_line "time,x=1,x=1.5"

case_named "another width of pictures draws them again, and reads nothing else"
since
postprocess --set postprocess.gauges=[1,1.5] --set postprocess.picture_width=500
expect_same "$(made | tr ' ' '\n' | grep -v '^./frame_t=')" ""
[[ -n $(made) ]] || fail_case "no picture was drawn"

case_named "what is not asked for any more goes"
postprocess --set postprocess.picture_times=[0]
expect_file "run/postprocess/frame_t=0.00.png"
expect_same "$(find run/postprocess -name 'frame_t=*.png' | wc -l)" 1
expect_no_file run/postprocess/frames/gauges_0000.csv

case_named "a frame that is lost is made again, and no other"
postprocess
rm run/postprocess/particles_0001.vtp
since
postprocess
expect_same "$(made)" ./particles_0001.vtp

case_named "a frame that is another one is done again, in all its products"
touch run/simulate/frame_0001.hdf
since
postprocess
[[ -z $(made | tr ' ' '\n' | grep -v '_0001\.\|^./frame_t=') ]] || fail_case "made: $(made)"
[[ " $(made) " == *" ./particles_0001.vtp "* ]] || fail_case "made: $(made)"

case_named "a journal that ends within a line counts up to there"
printf '0123456789abcdef particles_00' >>run/postprocess/.stamps
since
postprocess
expect_same "$(made)" ""

case_named "a postprocess killed at random moments goes on, to the bytes of one that was not"
rm -rf run/postprocess
postprocess
mv run/postprocess whole
for wait in 0.02 0.1 0.2 0.05 0.3; do
    "$bin/tidewater-postprocess" tiny.toml --run run >/dev/null 2>&1 &
    killed=$!
    sleep "$wait"
    kill -KILL "$killed" 2>/dev/null
    wait "$killed" 2>/dev/null
done
postprocess
expect_same "$(find run/postprocess -name '*.part')" ""
run diff -r --exclude=.stamps whole run/postprocess
expect_code 0
