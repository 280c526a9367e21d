#!/usr/bin/env bash
# movie_test.sh BIN: pictures in both forms, and a movie of them where ffmpeg is there.
source "$(dirname "$0")/assert.sh"
bin=$1
cp "$(dirname "$0")/tiny.toml" "$work"
cd "$work" || exit 1
mkdir with failing without

# Programs in place of ffmpeg: one that writes the pictures' list as the movie, and one that fails.
cat >with/ffmpeg <<'SH'
#!/bin/sh
while [ $# -gt 1 ]; do [ "$1" = -i ] && list=$2; shift; done
while read -r line; do echo "$line"; done <"$list" >"$1"
SH
printf '#!/bin/sh\necho "no encoder" >&2\nexit 3\n' >failing/ffmpeg
chmod +x with/ffmpeg failing/ffmpeg
postprocess() { PATH=$work/$1 run "$bin/tidewater-postprocess" tiny.toml --run run "${@:2}"; }

run "$bin/tidewater-geometry" tiny.toml --run run
expect_code 0
run "$bin/tidewater-simulate" tiny.toml --run run
expect_code 0

case_named "without ffmpeg a line says so, and all else is made"
postprocess without --movie
expect_code 0
expect_line "no frames.mp4: ffmpeg is not there; install it"
expect_no_file run/postprocess/frames.mp4
expect_file run/postprocess/waves.csv

case_named "every picture and chart is there as SVG and as PNG"
for picture in run/postprocess/*.png; do expect_file "${picture%.png}.svg"; done
for picture in run/postprocess/*.svg; do expect_file "${picture%.svg}.png"; done
expect_file run/postprocess/frame_t=0.00.svg
expect_file run/postprocess/energy.png
expect_file run/geometry/scene.svg

case_named "with ffmpeg the pictures are a movie, in order"
postprocess with --movie
expect_code 0
expect_no_line "frames.mp4"
expect_same "$(sed 's/.*\///; s/.$//' run/postprocess/frames.mp4 | xargs)" \
    "$(cd run/postprocess && printf '%s\n' frame_t=*.png | sort --version-sort | xargs)"

case_named "a movie that fails is told, with what ffmpeg says"
postprocess failing --movie
expect_code 5
expect_line "no encoder"
expect_line "ffmpeg failed with exit code 3"
expect_same "$(find run/postprocess -name 'frames.mp4*')" ""

case_named "the option is postprocess' alone"
run "$bin/tidewater-simulate" tiny.toml --run run --movie
expect_code 2
