#!/usr/bin/env bash
# point_test.sh BIN: tidewater-point's command line, table, picture and summary.
source "$(dirname "$0")/assert.sh"
bin=$1
cp "$(dirname "$0")/tiny_ice.toml" "$work"
cd "$work" || exit 1

point() { run "$bin/tidewater-point" "$@"; }

# column NAME FILE prints that column of a table.
column() {
    awk -F, -v name="$1" '/^#/ { next } !at { for (i = 1; i <= NF; i++) if ($i == name) at = i; next } { print $at }' "$2"
}

case_named "a path gives a table with all columns, a picture and a summary"
point --path uniaxial --strain 4e-3 --beta 0.2 --hardening 1 --steps 400 --out pull
expect_code 0
expect_line "uniaxial tensile strength     891.3 kPa"
expect_line "softening in isotropic tension is stable"
expect_line "strength is lost"
expect_file pull.svg
expect_same "$(grep --max-count=1 '^step' pull.csv)" "step,strain,log_volume,p,q,p0,alpha,damage,dissipated,case"
expect_same "$(column step pull.csv | wc -l)" 401
expect_same "$(column strain pull.csv | tail -n 1)" 0.004
expect_same "$(column damage pull.csv | tail -n 1)" 1
expect_same "$(column case pull.csv | uniq | tr '\n' ' ')" "elastic softening failed "
column q pull.csv | awk '{ if ($1 > top) top = $1 } END { exit !(top > 885e3 && top < 892e3) }' || fail_case "greatest q"
expect_same "$(grep --count '^# command: tidewater-point --path uniaxial' pull.csv)" 1
for text in "uniaxial loading" "(MPa), positive in compression" "first yield" "axial strain"; do
    grep --quiet --fixed-strings "$text" pull.svg || fail_case "no $text in the picture"
done

case_named "every path runs in 2D and 3D, in float and double"
for path in isotropic uniaxial uniaxial_strain shear; do
    for dimension in 2 3; do
        for precision in float double; do
            point --path $path --dimension $dimension --precision $precision --steps 50 --cycles 2 --strain -3e-3
            expect_code 0
            ! grep --quiet nan point.csv || fail_case "nan in $path"
        done
    done
done

case_named "failed ice can be sheared under a held pressure"
point --path shear --held-pressure 1e6 --failed --beta 0.1 --strain 0.02 --steps 10000
expect_code 0
expect_same "$(column p point.csv | tail -n 1 | awk '{ printf "%.3g", $1 }')" 1e+06

case_named "the uncapped rule and the trace rule are chosen by options"
point --path shear --held-pressure 1e6 --failed --beta 1 --strain 0.1 --cap-hardening false --shear-return trace
expect_code 0
column p0 point.csv | tail -n 1 | awk '{ exit !($1 > 5e7) }' || fail_case "p0 is not beyond 50 MPa"

case_named "wrong options are told in a line, with exit code 2, and nothing is written"
rm -f point.*
for options in "--path lake" "--strain 0" "--strain nan" "--strain x" "--steps 0" "--poisson-ratio 0.5" "--beta 0" "--beta-p0 1e9" \
    "--dimension 4" "--precision half" "--held-pressure 1e5" "--cycles -1" "--what" "lake" "--out folder/"; do
    # shellcheck disable=SC2086 # words
    point $options
    expect_code 2
    expect_same "$(wc -l <<<"$output")" 1
    expect_line "tidewater-point: "
done
expect_no_file point.csv
point --help
expect_code 0
expect_line "--shear-return"
point --version
expect_line "tidewater-point 0."

case_named "a folder that is not there and a full disk are told, with exit code 5"
point --out missing/point
expect_code 5
expect_line "missing"
run bash -c "'$bin/tidewater-point' --steps 10 >/dev/full"
expect_code 5

case_named "a scene gives its ice, and excludes options of the ice"
run "$bin/tidewater-point" --scene tiny_ice.toml --set fracture.beta=0.1 --path uniaxial --strain 5e-3 --out scene
expect_code 0
expect_line "p0 at the start               500.0 kPa"
run "$bin/tidewater-point" --scene tiny_ice.toml --beta 0.1 --out scene
expect_code 2
run "$bin/tidewater-point" --scene tiny_ice.toml --set fracture.bta=0.1 --out scene
expect_code 2
expect_line "did you mean fracture.beta?"
