#!/usr/bin/env bash
# icebergs_test.sh BIN WRITE_CALVING: what postprocess tells of ice that broke, from a run whose crack is known.
source "$(dirname "$0")/assert.sh"
bin=$1
write_calving=$2
cp "$(dirname "$0")"/{calving,tiny}.toml "$work"
cd "$work" || exit 1

# postprocess RUN CRACK_END [OPTION...] writes the run and looks at it.
postprocess() {
    "$write_calving" calving.toml "$1" "$2" || fail_case "no run was written"
    run "$bin/tidewater-postprocess" calving.toml --run "$1" --threads 2 "${@:3}"
}

# value FILE COLUMN prints the first row's.
value() {
    grep --invert-match '^#' "$1" | awk -F, -v name="$2" \
        'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) column = i } NR == 2 { print $column }'
}

# expect_near WHAT VALUE EXPECTED TOLERANCE
expect_near() {
    awk -v a="$2" -v b="$3" -v t="$4" 'BEGIN { exit !(a != "nan" && a - b <= t && b - a <= t) }' ||
        fail_case "$1 is $2, not $3"
}

case_named "the first iceberg has the crack's time, length and start"
postprocess broken 0
expect_code 0
first=broken/postprocess/first_iceberg.csv
expect_near time "$(value $first time)" 1.495 1e-6
expect_near length "$(value $first length)" 61 2
expect_near length_ratio "$(value $first length_ratio)" 0.7625 0.03
expect_near height "$(value $first height)" 80 1e-6
expect_near end_time "$(value $first end_time)" 2 1e-6
expect_near mass "$(value $first mass)" "$(awk -v v="$(value $first volume)" 'BEGIN { print 900 * v }')" 1
awk -v h="$(value $first start_height)" 'BEGIN { exit !(h > 0.67) }' || fail_case "the crack began at the top"
expect_line "first iceberg: came off at 1.50 s, "
expect_line "its crack: began at the top at "
expect_line "first crack: from the top, 61 m (0.76 H) behind the front, at 1.1 s"
expect_near crack_time "$(value $first crack_time)" 1.195 1e-6
expect_near crack_start_time "$(value $first crack_start_time)" 1.105 1e-6
expect_near crack_start_height "$(value $first crack_start_height)" 0.9875 1e-6
expect_near crack_position "$(value $first crack_position)" 61 0.1
expect_file broken/postprocess/frame_t=2.00.png

case_named "its failure plane is upright, by a fit and from the front's foot"
expect_near plane_angle "$(value $first plane_angle)" 90 2
expect_near foot_angle "$(value $first foot_angle)" 52.7 1 # atan(80/61)

case_named "the main event is the iceberg that was followed, as wide as the first one"
event=broken/postprocess/main_event.csv
expect_near time "$(value $event time)" 2 1e-6
expect_near time_before "$(value $event time_before)" 0 1e-6
expect_near failed_width "$(value $event failed_width)" 61 2
expect_near plane_angle "$(value $event plane_angle)" 90 3
expect_same "$(value $event icebergs)" 1
expect_line "main event: between 0.00 and 2.00 s, "

case_named "what came off is a slide into the water before the front, told in 3D too"
slide=broken/postprocess/calving_wave.csv
expect_near depth "$(value $slide depth)" 76 1e-9
expect_near speed "$(value $slide speed)" 1 1e-6
expect_near F "$(value $slide F)" "$(awk 'BEGIN { print 1 / sqrt(9.81 * 76) }')" 1e-6
expect_near S "$(value $slide S)" "$(awk 'BEGIN { print 61 / 76 }')" 1e-3
expect_near M "$(value $slide M)" "$(awk -v m="$(value $slide mass)" 'BEGIN { print m / 1000 / 76 ^ 2 }')" 1e-6
expect_same "$(value broken/postprocess/waves_3d.csv impulse_range)" "outside the validated range"

case_named "the iceberg is described, its crumbs are none"
expect_same "$(grep --invert-match --count '^#' broken/postprocess/icebergs.csv)" 2
expect_same "$(value broken/postprocess/icebergs.csv iceberg)" 1
expect_near rotation "$(value broken/postprocess/icebergs.csv rotation_y)" 0 1e-6
expect_near velocity "$(value broken/postprocess/icebergs.csv velocity_x)" 1 1e-4
expect_near height "$(value broken/postprocess/icebergs.csv length)" 80 6
expect_near break "$(value broken/postprocess/iceberg_summary.csv break_distance)" 50 8
expect_same "$(value broken/postprocess/iceberg_summary.csv detachment_time)" 2
expect_same "$(value broken/postprocess/iceberg_summary.csv parent)" 0

case_named "a crack that is not through detaches nothing, and is told"
postprocess cracked 10
expect_code 0
expect_same "$(value cracked/postprocess/first_iceberg.csv time)" nan
expect_near crack_time "$(value cracked/postprocess/first_iceberg.csv crack_time)" 1.195 1e-6
expect_line "first crack: from the top, 61 m "
expect_same "$(grep --invert-match --count '^#' cracked/postprocess/icebergs.csv)" 1
expect_same "$(value cracked/postprocess/main_event.csv time)" nan
expect_line "main event: none, nothing came off the glacier"
expect_line "no iceberg came off: "

case_named "a toe that is crushed is no crack"
postprocess crushed 80
expect_code 0
expect_same "$(value crushed/postprocess/first_iceberg.csv crack_time)" nan
expect_line "no crack formed"

case_named "what is an iceberg is the scene's choice"
postprocess broken 0 --set postprocess.iceberg_share=1
expect_code 0
expect_same "$(value $first time)" nan

case_named "which damage divides fragments is the scene's choice, and changes no detachment"
for damage in 0.01 1; do
    postprocess "damage_$damage" 0 --set "postprocess.iceberg_damage=$damage"
    expect_code 0
    expect_near time "$(value "damage_$damage/postprocess/first_iceberg.csv" time)" 1.495 1e-6
done
awk -v a="$(value damage_0.01/postprocess/main_event.csv volume)" -v b="$(value damage_1/postprocess/main_event.csv volume)" \
    'BEGIN { exit !(b > a + 100) }' || fail_case "a greater damage leaves no greater icebergs"

case_named "a scene without ice leaves none of the files, not even earlier ones"
postprocess broken 0
"$bin/tidewater-geometry" tiny.toml --run tiny >/dev/null 2>&1
"$bin/tidewater-simulate" tiny.toml --run tiny >/dev/null 2>&1
mkdir tiny/postprocess
cp broken/postprocess/{icebergs,calving,iceberg_summary,iceberg_events,sizes,size_fits,size_histogram}.csv \
    broken/postprocess/{sizes,calving}.svg tiny/postprocess
run "$bin/tidewater-postprocess" tiny.toml --run tiny
expect_code 0
# iceberg_surfaces shows the block.
expect_same "$(cd tiny/postprocess && ls | grep -E 'iceberg|calving|size' | grep -v iceberg_surfaces)" ""

case_named "tidewater-overhang puts runs beside beam theory"
cp -r broken deeper
sed -i 's/^depth = .*/depth = 92/' deeper/postprocess/scene.toml
cp -r broken pushed
sed -i 's/^effects = .*/effects = ["water", "ice", "fracture", "shelf", "push"]/' pushed/postprocess/scene.toml
printf '[shelf]\nlength = 200\nheight = 60\n[push]\nspeed = 10\nramp = 1\n' >>pushed/postprocess/scene.toml
run "$bin/tidewater-overhang" deeper broken cracked pushed --out compared
expect_code 0
expect_file compared/overhang.svg
expect_same "$(grep --invert-match '^#' compared/overhang.csv | cut --delimiter=, --fields=1-3)" "run,height,depth_ratio
broken,80,0.2
cracked,80,0.2
pushed,80,0.2
deeper,80,0.4"
expect_same "$(value compared/overhang.csv overhang)" nan
pushed=$(grep --invert-match '^#' compared/overhang.csv | sed --quiet --regexp-extended '1p;/^pushed/p')
expect_near "the overhang" "$(value - overhang <<<"$pushed")" 0.624375 1e-6 # (240 + 10 (1.495 - 0.5) - 200) / 80
expect_near "the first crack's place" "$(value - crack_position_ratio <<<"$pushed")" 0.7625 0.001
expect_near "Li/H" "$(value compared/overhang.csv length_ratio)" 0.7625 0.03
expect_near "eq. 1" "$(value compared/overhang.csv eq1)" 0.7792 0.001
expect_same "$(find compared | wc -l)" 3

case_named "tidewater-overhang tells what is missing"
run "$bin/tidewater-overhang" broken nothing
expect_code 3
expect_same "$output" "tidewater-overhang: nothing/postprocess/first_iceberg.csv: the file does not exist; run tidewater-postprocess \
on a run whose ice fractures"
expect_no_file overhang.csv
run "$bin/tidewater-overhang"
expect_code 2
expect_line "tidewater-overhang: RUN is required"
run "$bin/tidewater-overhang" broken --out /proc/none
expect_code 5
