#!/usr/bin/env bash
# import_test.sh BIN: postprocess reads the particles of other programs.
source "$(dirname "$0")/assert.sh"
bin=$1
cd "$work" || exit 1

cat >tank.toml <<'END'
title = "Particles of another program"
effects = ["water"]

[domain]
size = [2, 1]
cell_size = 0.05

[water]
depth = 0.5

[simulate]
end_time = 1
snapshot_interval = 0.5

[postprocess]
gauges = [1]
picture_width = 400
END

# foreign FILE LEVEL: water up to LEVEL in the x-y plane of a tank that begins at x = -1, as text, without times.
foreign() {
    awk -v level="$2" 'BEGIN {
        for (x = -0.9875; x < 1; x += 0.025) for (y = 0.0125; y < level; y += 0.025) {
            points = points sprintf("%g %g 0 ", x, y); u = u sprintf("%g ", x); v = v sprintf("%g ", y); ++n
        }
        printf "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\"><PolyData>"
        printf "<Piece NumberOfPoints=\"%d\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">", n
        printf "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">%s</DataArray></Points>", points
        printf "<PointData><DataArray type=\"Float64\" Name=\"u\" format=\"ascii\">%s</DataArray>", u
        printf "<DataArray type=\"Float64\" Name=\"v\" format=\"ascii\">%s</DataArray></PointData></Piece></PolyData></VTKFile>\n", v
    }' >"$1"
}
foreign sph_1.vtp 0.5
foreign sph_2.vtp 0.55
foreign sph_10.vtp 0.6
import=("$bin/tidewater-postprocess" tank.toml --run run --up y --origin=-1,0,0 --particles)

case_named "gauges, pictures and a collection are made of another program's particles"
run "${import[@]}" sph_*.vtp --map velocity=u:v
expect_code 0
expect_line "the files tell no times: 0, 1, 2, ... s in the order of the numbers in their names"
expect_line "no volume in the files: 0.000625 m² for every particle"
expect_line "no material in the files: all is water"
expect_no_line "outside of the scene's tank"
expect_file run/postprocess/particles_0002.vtp
expect_file "run/postprocess/frame_t=2.00.png"
levels=$(grep -v '^#' run/postprocess/gauges.csv | tail -n +2)
expect_same "$(cut -d, -f1 <<<"$levels" | xargs)" "0 1 2"
awk -F, '{ wrong += ($2 - 0.05 * $1) ^ 2 > 1e-6 } END { exit wrong > 0 }' <<<"$levels" || fail_case "levels: $levels"

case_named "a second call makes no frame again, other times do"
touch mark && sleep 0.05
run "${import[@]}" sph_*.vtp --map velocity=u:v
expect_code 0
expect_same "$(find run/postprocess -name 'particles_*.vtp' -newer mark)" ""
run "${import[@]}" sph_1.vtp sph_2.vtp sph_10.vtp --map velocity=u:v --times 0,0.5,1
expect_code 0
expect_same "$(find run/postprocess -name 'particles_*.vtp' -newer mark | wc -l)" 2
expect_file "run/postprocess/frame_t=0.50.png"

case_named "a tank that is elsewhere is told"
run "$bin/tidewater-postprocess" tank.toml --run other --up y --particles sph_1.vtp --map velocity=u:v
expect_code 0
expect_line "particles lie outside of the scene's tank (domain.size); --origin and --up say where it is"

case_named "a missing array, a cut file and a newer format end with 3 and one line with the file"
run "${import[@]}" sph_1.vtp
expect_code 3
expect_line "tidewater-postprocess: sph_1.vtp: column velocity is missing; name one by --map velocity=ARRAY; its arrays are u, v"
run "${import[@]}" sph_1.vtp --map velocity=u:w
expect_code 3
expect_line "sph_1.vtp: column velocity: there is no array w;"
head -c 3000 sph_1.vtp >cut.vtp
run "${import[@]}" cut.vtp --map velocity=u:v
expect_code 3
expect_line "tidewater-postprocess: cut.vtp: it is truncated"
sed 's/version="0.1"/version="9.0"/' sph_1.vtp >newer.vtp
run "${import[@]}" newer.vtp --map velocity=u:v
expect_code 3
expect_line "tidewater-postprocess: newer.vtp: its format version 9 is newer than the 2 that is read"
run "$bin/tidewater-postprocess" tank.toml --run flat --particles sph_1.vtp --map velocity=u:v
expect_code 3
expect_line "but the scene is in 2D; if that axis is up, pass --up y"
run "${import[@]}" none.vtp
expect_code 3
expect_line "none.vtp: the file does not exist; check the path"

case_named "a column that there is not is told with those that there are"
run "${import[@]}" sph_1.vtp --map vel=u
expect_code 2
expect_line "--map: \"vel\" is no column; the columns are velocity, pressure, "
