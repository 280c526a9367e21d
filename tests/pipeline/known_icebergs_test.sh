#!/usr/bin/env bash
# known_icebergs_test.sh BIN WRITE_ICEBERGS: postprocess gives known sizes, motions, splits and mergers back.
source "$(dirname "$0")/assert.sh"
bin=$1
write_icebergs=$2
cp "$(dirname "$0")/known_icebergs.toml" "$work"
cd "$work" || exit 1

# rows FILE COLUMN... [-- CONDITION] prints columns of the rows that an awk condition on named columns, as
# "\$c[\"iceberg\"] == 3", chooses.
rows() {
    local file=$1 names=() condition=1
    shift
    while [[ $# -gt 0 && $1 != -- ]]; do names+=("$1") && shift; done
    [[ $# -gt 1 ]] && condition=$2
    grep --invert-match '^#' "$file" | awk -F, -v names="${names[*]}" '
        NR == 1 { for (i = 1; i <= NF; ++i) c[$i] = i; count = split(names, wanted, " "); next }
        '"$condition"' { line = ""; for (i = 1; i <= count; ++i) line = line (i > 1 ? " " : "") $c[wanted[i]]; print line }'
}
expect_near() {
    awk -v a="$2" -v b="$3" -v t="$4" 'BEGIN { exit !(a != "nan" && a - b <= t && b - a <= t) }' ||
        fail_case "$1 is $2, not $3"
}
postprocess() { run "$bin/tidewater-postprocess" known_icebergs.toml --run run --threads 2 "$@"; }

"$write_icebergs" known_icebergs.toml run || fail_case "no run was written"
out=run/postprocess

case_named "a block that splits keeps its id in its larger part, and what grows back or ends is told"
postprocess
expect_code 0
expect_same "$(rows $out/iceberg_events.csv time kind iceberg other volume break_distance -- '$c["time"] > 0')" \
    "1 split 251 0 1200 30
2 split 252 251 400 nan
3 merge 252 0 400 nan
4 gone 251 nan 0 nan"
expect_same "$(rows $out/icebergs.csv time volume -- '$c["iceberg"] == 251')" "1 1200
2 800
3 800"

case_named "its size, place and motion are those it has"
row() { rows $out/icebergs.csv "$1" -- '$c["iceberg"] == 251 && $c["time"] == 1'; }
for pair in length:40 width:0 height:30 tilt:90 x:93 y:0 z:80 velocity_x:1.5 velocity_z:-0.25 rotation_y:0 draft:30 \
    freeboard:10 area:30 clearance:60 grounded:0 mass:1080000 buoyancy:0.83333; do
    expect_near "${pair%:*}" "$(row "${pair%:*}")" "${pair#*:}" 1e-3
done

case_named "the summary tells where it comes from and what became of it"
expect_same "$(rows $out/iceberg_summary.csv parent calved detachment_time break_distance first_time last_time gone \
    first_volume last_volume -- '$c["iceberg"] == 251')" "0 1 1 30 1 3 1 1200 800"
expect_same "$(rows $out/iceberg_summary.csv parent calved detachment_time merged merged_into -- '$c["iceberg"] == 252')" \
    "251 0 1 1 0"
expect_same "$(rows $out/iceberg_summary.csv calved detachment_time -- '$c["iceberg"] == 1')" "0 nan"

case_named "calving is told over time, with the front"
expect_same "$(rows $out/calving.csv time calved returned calved_total front_position)" "0 0 0 0 100
1 1200 0 1200 70
2 0 0 1200 70
3 0 400 800 80
4 0 0 800 80"
expect_same "$(rows $out/main_event.csv time icebergs largest volume failed_width plane_angle)" "1 1 251 1200 30 90"
expect_line "main event: between 0.00 and 1.00 s, 1200 m² per m of width in 1 iceberg; failed width 30.0 m"

case_named "sizes of a power law give its exponent back within the interval"
law='$c["set"] == "last" && $c["model"] == "power_law"'
expect_same "$(rows $out/size_fits.csv sizes published_low doubt -- "$law")" "250 1.5 "
rows $out/size_fits.csv exponent_low exponent_high p -- "$law" >fit
awk '{ exit !($1 < 2 && 2 < $2 && $2 - $1 < 0.6 && $3 > 0.1) }' fit || fail_case "the fit is $(cat fit)"
expect_same "$(rows $out/sizes.csv count -- '$c["set"] == "last"' | head -1)" 250
expect_same "$(rows $out/size_histogram.csv count -- '$c["set"] == "last"' | awk '{ n += $1 } END { print n }')" 250
expect_file $out/sizes.svg
expect_file $out/calving.svg

case_named "a second call makes nothing of a frame again and the same tables"
cp -r $out before
postprocess
expect_code 0
run diff -r --exclude=.stamps before $out
expect_code 0

case_named "a frame that is lost is followed again from the frame before, to the same bytes"
rm $out/frames/icebergs_0002.csv
postprocess
expect_code 0
run diff -r --exclude=.stamps before $out
expect_code 0

case_named "a greater least volume leaves fewer icebergs and no pictures to draw"
touch mark && sleep 0.05
postprocess --set postprocess.iceberg_volume=500
expect_code 0
rows $out/icebergs.csv volume | awk '$1 < 500 { exit 1 }' || fail_case "there are smaller ones"
expect_same "$(find $out -name 'frame_t=*.png' -newer mark | wc -l)" 0

case_named "a reach that bridges the gaps leaves one glacier and fewer boxes"
postprocess --set postprocess.iceberg_reach=4
expect_code 0
awk -v n="$(rows $out/calving.csv icebergs | head -1)" 'BEGIN { exit !(n < 250) }' || fail_case "all boxes are apart"

case_named "members that are damaged are named"
printf 'x' | dd of=$out/frames/members_0001.h5 conv=notrunc bs=1 seek=1 2>/dev/null
rm $out/frames/icebergs_0002.csv
postprocess --set postprocess.iceberg_reach=4
expect_code 3
[[ $output == *members_0001.h5* ]] || fail_case "the line is: $output"
