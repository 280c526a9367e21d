#!/usr/bin/env bash
# paraview_test.sh BIN: postprocess writes what ParaView opens, inline, with a script that Python can read, and once.
source "$(dirname "$0")/assert.sh"
bin=$1
cp "$(dirname "$0")/tiny.toml" "$(dirname "$0")/tiny_ice.toml" "$work"
cd "$work" || exit 1

for scene in tiny tiny_ice; do
    run "$bin/tidewater-geometry" $scene.toml --run $scene
    expect_code 0
    run "$bin/tidewater-simulate" $scene.toml --run $scene --set simulate.end_time=1 --set simulate.snapshot_interval=0.5
    expect_code 0
done
# postprocess SCENE [OPTION...]
postprocess() {
    run "$bin/tidewater-postprocess" "$1.toml" --run "$1" --set simulate.end_time=1 --set simulate.snapshot_interval=0.5 "${@:2}"
    expect_code 0
}
points() { grep --max-count=1 --only-matching 'NumberOfPoints="[0-9]*"' "$1" | tr -dc 0-9; }

case_named "collections name files that are there, all of them inline"
postprocess tiny
postprocess tiny_ice
for collection in tiny/postprocess/particles.pvd tiny/postprocess/iceberg_surfaces.pvd tiny_ice/postprocess/particles.pvd; do
    expect_file $collection
    for name in $(grep --only-matching 'file="[^"]*"' $collection | cut -d\" -f2); do
        expect_file "$(dirname $collection)/$name"
    done
done
run grep --files-with-matches appended tiny/postprocess/*.vtp tiny_ice/postprocess/*.vtp
expect_same "$output" ""

case_named "particles of ice have their stress and strength"
for column in velocity velocity_magnitude pressure material principal_stress damage alpha p0 failure_time; do
    grep --quiet "Name=\"$column\"" tiny_ice/postprocess/particles_0001.vtp || fail_case "there is no $column"
done

case_named "the script of the standard view is Python"
expect_file tiny/postprocess/view.py
if command -v python3 >/dev/null; then
    run python3 -m py_compile tiny/postprocess/view.py
    expect_code 0
    rm -rf tiny/postprocess/__pycache__
fi

case_named "a second call writes no frame again"
touch mark
sleep 0.05
postprocess tiny
expect_same "$(find tiny/postprocess -name '*.vtp' -newer mark)" ""

case_named "fewer particles, or none, and no surfaces, if the scene asks for it"
all=$(points tiny/postprocess/particles_0001.vtp)
postprocess tiny --set postprocess.decimation=4 --set postprocess.surfaces=false
some=$(points tiny/postprocess/particles_0001.vtp)
((some > all / 6 && some < all / 3)) || fail_case "$some of $all particles are left"
expect_no_file tiny/postprocess/iceberg_surfaces.pvd
expect_no_file tiny/postprocess/iceberg_surfaces_0001.vtp
postprocess tiny --set postprocess.decimation=0
expect_no_file tiny/postprocess/particles.pvd
expect_no_file tiny/postprocess/particles_0001.vtp
expect_file tiny/postprocess/iceberg_surfaces_0001.vtp
