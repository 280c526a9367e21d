#!/usr/bin/env bash
# glacier_test.sh PROJECT BIN: glaciers with all that the geometry stage can do to them, through the three stages.
source "$(dirname "$0")/assert.sh"
project=$1
bin=$2
cp "$(dirname "$0")/tiny_glacier.toml" "$work"
cp -r "$project/configs/dem_example" "$project/configs/dem_example.toml" "$work"
cd "$work" || exit 1

# stage NAME SCENE FOLDER [OPTION...]
stage() { run "$bin/tidewater-$1" "$2" --run "$3" "${@:4}"; }

# volume_of NAME FOLDER: what the summary says.
volume_of() { sed -n "s/^$1: \([0-9.e+]*\) m.*/\1/p" "$2/geometry/summary.txt"; }
holds() { awk "BEGIN { exit !($1) }" || fail_case "does not hold: $1"; }

case_named "a glacier goes through all stages and leaves what can be looked at"
for name in geometry simulate postprocess; do
    stage "$name" tiny_glacier.toml run --threads 2 --set particles.pattern=blue_noise
    expect_code 0
done
for file in geometry.vdb surfaces.vtp image.vti scene.png summary.txt cracks.csv scene.toml; do
    expect_file "run/geometry/$file"
done
expect_file run/postprocess/waves.csv
expect_same "$(find run -name '*.part')" ""

case_named "the summary tells volumes, the front, what was cut and what a run will need"
output=$(cat run/geometry/summary.txt)
for line in "bed: " "water: " "its front: at x = 100.0 m" "D/H = " "neutral is" "crevasses: 4" "cracks: Voronoi cells of r = " \
    "20 % of the ice's strength" "simulate will have about"; do
    expect_line "$line"
done

case_named "without anything cut the volume is the outline's area"
plain=(--set 'effects=["water", "ice", "bed"]' --set bed.friction=0 --set bed.pore_pressure=0)
sed '/^\[fracture\]/,/^cohesion/d' tiny_glacier.toml >plain.toml
stage geometry plain.toml plain "${plain[@]}"
expect_code 0
# 90 (52 + 46)/2 + 10 (46 + 40)/2 above the bed at 10 m
holds "($(volume_of ice plain) - 4840)^2 < 0.5^2"

# mass FOLDER: of all particles at the start, kg/m.
mass() {
    awk -F, '/^#/ { next } !column { for (i = 1; i <= NF; ++i) if ($i == "mass") column = i; next } { print $column; exit }' \
        "$1/simulate/ledger.csv"
}

case_named "the particles have the mass of what was made"
sed '/^\[water\]/,/^depth/d; /^gauges/d' plain.toml >dry.toml
dry() { # FOLDER EFFECTS OPTION...
    for name in geometry simulate; do
        stage "$name" dry.toml "$1" --set "effects=[\"ice\", \"bed\"$2]" --set bed.friction=0 --set bed.pore_pressure=0 --set simulate.end_time=0.01 \
            --set simulate.snapshot_interval=0.01 "${@:3}"
        expect_code 0
    done
}
dry dry ""
holds "($(mass dry) / 900 / 4840 - 1)^2 < 0.001^2"
dry crevassed ', "crevasses"' --set crevasses.spacing=25 --set 'crevasses.depth=[8, 14]' --set 'crevasses.opening=[3, 5]'
holds "($(mass crevassed) / 900 / $(volume_of ice crevassed) - 1)^2 < 0.001^2"

case_named "empty cracks take their share of it, also where they are thinner than a particle"
dry cracked ', "cracks"' --set cracks.cell_size=15 --set cracks.width=0.5 --set domain.cell_size=1
share=$(sed -n 's/.* take \([0-9.]*\) %.*/\1/p' cracked/geometry/summary.txt)
holds "(1 - $(mass cracked) / $(mass dry)) / ($share / 100) > 0.9 && (1 - $(mass cracked) / $(mass dry)) / ($share / 100) < 1.05"

case_named "ice in the ground is told, outlines and elevation models"
stage geometry plain.toml bad "${plain[@]}" --set ice.base=given --set 'ice.profile=[0, 5, 0, 62, 90, 56, 100, 50, 100, 5]'
expect_code 2
expect_line "500 m² of the ice, 9.4 %, lies in the ground; set ice.base = \"bed\""

case_named "1, 2 and 5 threads give the same bytes of every file"
for threads in 1 5; do
    for name in geometry simulate; do
        stage "$name" tiny_glacier.toml "on_$threads" --threads "$threads" --set particles.pattern=blue_noise
        expect_code 0
        run diff --recursive --exclude=log --exclude=run.json "run/$name" "on_$threads/$name"
        expect_code 0
    done
done

case_named "another seed gives another glacier"
stage geometry tiny_glacier.toml other --set seed=6
run cmp run/geometry/geometry.vdb other/geometry/geometry.vdb
expect_code 1

case_named "cracks.csv that is missing is told"
rm on_5/geometry/cracks.csv
stage simulate tiny_glacier.toml on_5 --set particles.pattern=blue_noise --from start
expect_code 3
expect_line "cracks.csv"

case_named "elevation models go through all stages, in 3D and along a line"
coarse=(--set domain.cell_size=25 --set simulate.end_time=1 --set simulate.snapshot_interval=0.5 --set 'crevasses.opening=[25, 30]'
    --set postprocess.picture_width=400)
for name in geometry simulate postprocess; do
    stage "$name" dem_example.toml dem "${coarse[@]}"
    expect_code 0
done
output=$(cat dem/geometry/summary.txt)
expect_line "bed.asc: AAIGrid, 100 x 60 pixels"
expect_line "WGS 84 / UTM zone 22N"
line=("${coarse[@]}" --set dimension=2 --set 'domain.size=[1900, 400]' --set 'ice.size=[900, 400]' --set 'ice.corner=[0, 0]'
    --set 'dem.origin=[530310, 7742629]' --set 'simulate.gauges=[900]')
sed '/^angle\|^wander\|^wavelength/d' dem_example.toml >line.toml
for name in geometry simulate postprocess; do
    stage "$name" line.toml line "${line[@]}"
    expect_code 0
done

case_named "an elevation model that is replaced makes the geometry stage's part another"
before=$("$bin/tidewater-geometry" dem_example.toml --print-part geometry)
sed -i '7s/-[0-9.]*/-60.0/' dem_example/bed.asc
[[ $before != "$("$bin/tidewater-geometry" dem_example.toml --print-part geometry)" ]] || fail_case "the same part"

case_named "what is wrong with elevation models is told with the place and the remedy"
refuses() { # WHAT OPTION...
    stage geometry dem_example.toml bad "${coarse[@]}" "${@:2}"
    expect_code 3
    expect_line "$1"
}
refuses "reaches beyond" --set 'dem.origin=[529000, 7742283]'
refuses "lower dem.datum by" --set dem.datum=-100
refuses "shows no ice in the box" --set 'ice.size=[100, 700, 400]' --set 'ice.corner=[1500, 0, 0]' --set crevasses.from=1500 --set crevasses.spacing=95
refuses "no raster that GDAL can read" --set dem.bed=dem_example.toml
rm dem_example/bed.prj
refuses "crs" --set seed=2
