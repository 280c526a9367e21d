#!/usr/bin/env bash
# block_wave_test.sh BIN WRITE_BLOCK_WAVE: what postprocess tells of the wave of a block, from a run whose wave is known.
source "$(dirname "$0")/assert.sh"
bin=$1
write_block_wave=$2
cp "$(dirname "$0")"/{block_wave,tiny}.toml "$work"
cd "$work" || exit 1

# postprocess SCENE RUN [OPTION...]
postprocess() {
    run "$bin/tidewater-postprocess" "$1" --run "$2" --threads 2 "${@:3}"
}

# value FILE COLUMN [ROW] prints a value, of the first row unless told.
value() {
    grep --invert-match '^#' "$1" | awk -F, -v name="$2" -v row="${3-1}" \
        'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) column = i } NR == row + 1 { print $column }'
}

# expect_near WHAT VALUE EXPECTED TOLERANCE
expect_near() {
    awk -v a="$2" -v b="$3" -v t="$4" 'BEGIN { exit !(a != "nan" && a - b <= t && b - a <= t) }' ||
        fail_case "$1 is $2, not $3"
}

files="bodies.svg energy_split.csv energy_split.svg first_wave.csv first_wave.svg long_waves.csv tsunami.csv waves_3d.csv"

case_named "the first wave has the speed, height and place that it was made with"
"$write_block_wave" block_wave.toml fall || fail_case "no run was written"
postprocess block_wave.toml fall
expect_code 0
for name in $files; do expect_file "fall/postprocess/$name"; done
tsunami=fall/postprocess/tsunami.csv
expect_near celerity "$(value $tsunami celerity)" 3 0.015
expect_near amplitude "$(value $tsunami amplitude)" 0.1 0.003
expect_near "its time" "$(value $tsunami amplitude_time)" 0.5 0.11
expect_near "its place" "$(value $tsunami amplitude_x)" 2.1 0.4
expect_near error_percent "$(value $tsunami error_percent)" -4.2 0.6
expect_same "$(value fall/postprocess/long_waves.csv pairs)" 0 # the run has no gauges
wave=fall/postprocess/first_wave.csv
for row in 10 20 30; do
    time=$(value $wave time $row)
    expect_near "x at $time s" "$(value $wave x $row)" "$(awk -v t="$time" 'BEGIN { print 0.6 + 3 * t }')" 0.05
    expect_near "height at $time s" "$(value $wave amplitude $row)" \
        "$(awk -v t="$time" 'BEGIN { print 0.1 * exp(-(t - 0.5) / 6) }')" 0.003
    expect_near "distance" "$(value $wave distance $row)" "$(value $wave x $row)" 1e-9 # the block is at the wall
    expect_near "time since the greatest" "$(value $wave time_from_greatest $row)" \
        "$(awk -v t="$time" -v g="$(value $tsunami amplitude_time)" 'BEGIN { print t - g }')" 1e-6
done

case_named "the slide is that of the heavier block, and what is printed agrees"
expect_near speed "$(value $tsunami speed)" 1.15 1e-9
expect_near F "$(value $tsunami F)" 0.3672 1e-4
expect_near S "$(value $tsunami S)" 0.4 1e-9
expect_near M "$(value $tsunami M)" 0.184 1e-9
expect_line "block: 184.0 kg per m, its fastest point 1.150 m/s at 0.40 s (number 1, the heaviest of 2)"
expect_line "F = 0.367, S = 0.400, M = 0.184; impulse product P = "
expect_line "(F and P outside the validated range)"
expect_line "first wave to the right: at most 0.09"
expect_line " % of sqrt(g D) = 3.132 m/s (a linear wave, which disperses: "
expect_line "in 3D (+-50 %), of 0.09"
expect_line "energy at 3.60 s: block -100.0 J per m, water 70.0, lost 30.0; the total's greatest rise above its start 0.00 J per m"
expect_no_line "to the left"

case_named "in 3D it is lower by the laboratory's factor, with its scatter"
table=fall/postprocess/waves_3d.csv
expect_same "$(grep --invert-match '^#' $table | cut --delimiter=, --fields=1 | tr '\n' ' ')" "distance_ratio 2 5 10 15 35 "
# 1.5 2^(-5/6) 0.3672^0.4 √(0.4 · 0.184)
expect_near factor "$(value $table factor)" 0.1530 2e-4
greatest=$(value $tsunami amplitude)
for part in _low:0.5 :1 _high:1.5; do
    expect_near "amplitude_3d${part%:*}" "$(value $table "amplitude_3d${part%:*}" 2)" \
        "$(awk -v f="$(value $table factor 2)" -v a="$greatest" -v s="${part#*:}" 'BEGIN { print f * a * s }')" 1e-7
done
expect_near "the crest at 5 m" "$(value $table amplitude_2d_here 2)" 0.0851 0.002 # 0.1 exp(-(4.4/3 - 0.5)/6)
expect_same "$(value $table impulse_range 2)" "outside the validated range"
expect_same "$(value $table amplitude_2d_here 5)" nan

case_named "energies of block, water and loss add up to nothing"
split=fall/postprocess/energy_split.csv
for row in 1 5 37; do
    expect_near "the sum" "$(grep --invert-match '^#' $split | awk -F, -v row="$row" \
        'NR == row + 1 { print $2 + $3 + $4 - $5 }')" 0 1e-9
done
expect_near "the loss" "$(value $split lost 37)" 30 1e-9

case_named "a rise of the energy is told"
cp -r fall rise
sed -i 's/^\(0\.30[0-9]*,.*\),[0-9.]*$/\1,5004.5/' rise/simulate/ledger.csv
postprocess block_wave.toml rise
expect_line "the total's greatest rise above its start 1.50 J per m"

case_named "a block in the open sends its wave both ways"
sed 's/center.*/center = [5.25, 1.2]/' block_wave.toml >open.toml
cp -r fall open && cp open.toml open/simulate/scene.toml
postprocess open.toml open
expect_code 0
expect_line "first wave to the right: at most"
expect_line "first wave to the left: none was found"
case_named "the celerity from gauges is that of one of the waves"
awk 'function g(d) { return 0.1 * exp(-4.5 * d * d) } BEGIN { print "time,x=2,x=7,x=9"
    for (t = 0; t < 3.65; t += 0.1) print t "," g(t - 2.5) "," g(t - 1.5) "," g(t - 1.5 - 2 / 3) }' >open/simulate/gauges.csv
postprocess open.toml open
expect_near "from gauge to gauge" "$(value open/postprocess/waves.csv celerity 2)" 3 0.03
expect_near "of all" "$(value open/postprocess/waves.csv celerity 4)" 3 0.03

case_named "a block at the right wall sends its wave to the left"
sed 's/center.*/center = [11.75, 1.2]/' block_wave.toml >right.toml
cp -r fall right && cp right.toml right/simulate/scene.toml
postprocess right.toml right
expect_no_line "to the right"
expect_line "first wave to the left: none was found"

case_named "the same in 3D, with the block's width and the length of its rotation"
sed 's/^effects/dimension = 3\n&/; s/\[12, 1.6\]/[12, 0.4, 1.6]/; s/\[0.5, 0.4\]/[0.5, 0.4, 0.4]/
    s/\[0.25, 1.2\]/[0.25, 0.2, 1.2]/' block_wave.toml >solid.toml
"$write_block_wave" solid.toml solid || fail_case "no run was written"
postprocess solid.toml solid
expect_code 0
expect_near celerity "$(value solid/postprocess/tsunami.csv celerity)" 3 0.015
expect_near M "$(value solid/postprocess/tsunami.csv M)" 0.46 1e-9 # of 184 kg, 0.4 m wide
expect_line "block: 184.0 kg, its fastest point"
expect_line "energy at 3.60 s: block -100.0 J, water 70.0"

case_named "the pictures are on one page, at the interval that is asked for"
expect_same "$(grep --count '^<img ' fall/postprocess/frames.html)" 2
postprocess block_wave.toml fall --set postprocess.picture_interval=0.4 --set postprocess.picture_window=[0,0.5,6,1.6]
expect_code 0
expect_same "$(find fall/postprocess -name 'frame_t=*.png' | wc -l)" 10
expect_same "$(grep --only-matching 'data-time="[^"]*"' fall/postprocess/frames.html | tr '\n' ' ')" \
    "$(printf 'data-time="%.2f" ' 0 0.4 0.8 1.2 1.6 2 2.4 2.8 3.2 3.6)"
embedded=$(sed --quiet 's/^<img.*data-time="2.00" src="data:image\/png;base64,\(.*\)">$/\1/p' fall/postprocess/frames.html)
expect_same "$(base64 --decode <<<"$embedded" | sha256sum | cut -c1-64)" \
    "$(sha256sum <fall/postprocess/frame_t=2.00.png | cut -c1-64)"

case_named "a window that is no part of the tank is told, before anything is removed"
for window in [0,0,6] [6,0,0,1] [0,0,13,1]; do
    postprocess block_wave.toml fall --set "postprocess.picture_window=$window"
    expect_code 2
    expect_line "tidewater-postprocess: postprocess.picture_window: needs x0, z0, x1, z1 of a part of the tank, as [0, 0, 12, 1.6]"
done
postprocess solid.toml solid --set postprocess.picture_window=[0,0,1,1]
expect_code 2
expect_file fall/postprocess/waves.csv

case_named "a bodies.csv that is damaged ends with 3 and names what is wrong"
cp -r fall broken
sed -i 's/fastest/slowest/' broken/simulate/bodies.csv
postprocess block_wave.toml broken
expect_code 3
expect_line "tidewater-postprocess: broken/simulate/bodies.csv: "
expect_file broken/postprocess/tsunami.csv # what an earlier call wrote
cp fall/simulate/bodies.csv broken/simulate
sed -i 's/^\([0-9.]*\),2,/\1,3,/' broken/simulate/bodies.csv
sed -i 's/,50$/,500/' broken/simulate/bodies.csv
postprocess block_wave.toml broken
expect_code 3
expect_line "body 3 is no block of the scene"

case_named "a scene without a block, or a run without bodies.csv, leaves none of the files, not even earlier ones"
sed 's/, "rigid"//; /^\[block\]/,/^$/d' tiny.toml >water.toml
"$bin/tidewater-geometry" water.toml --run tiny >/dev/null 2>&1
"$bin/tidewater-simulate" water.toml --run tiny >/dev/null 2>&1
rm -f fall/simulate/bodies.csv
cp -r fall/postprocess tiny/postprocess
postprocess water.toml tiny
expect_code 0
postprocess block_wave.toml fall
expect_code 0
expect_line "no bodies.csv, and so nothing of the block's wave; run tidewater-simulate again"
for name in $files; do
    expect_no_file "tiny/postprocess/$name"
    expect_no_file "fall/postprocess/$name"
done
