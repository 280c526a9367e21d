#!/usr/bin/env bash
# coarse_fall_test.sh PROJECT BIN: what configs/lab_gravity_fall_coarse.toml must show (lib/analysis/README.md, Waves).
source "$(dirname "$0")/../pipeline/assert.sh"
project=$1
bin=$2
cd "$work" || exit 1
run make -f "$project/tools/pipeline.mk" SCENE="$project/configs/lab_gravity_fall_coarse.toml" RUN=run BIN="$bin" \
    SET='--set postprocess.picture_width=400' # a hundred pictures, of which the test sees that they are there
expect_code 0

# column FILE NAME: the values of a CSV column, one per line.
column() {
    awk -F, -v name="$2" '/^#/ { next }
        !index_of { for (i = 1; i <= NF; ++i) if ($i == name) index_of = i; next }
        { print $index_of }' "$1"
}
holds() { [[ $1 != *nan* ]] && awk "BEGIN { exit !($1) }" || fail_case "does not hold: $1"; }
ledger=run/simulate/ledger.csv

case_named "the first wave's celerity is within 5 % of sqrt(g D)"
error=$(column run/postprocess/waves.csv error_percent | tail -n 1)
echo "  celerity off by $error %"
holds "$error < 5 && $error > -5"

# Water under its own weight is denser: M(1 m) = 1.00123 m with c0 = 63 m/s and theta = 7 (lib/mpm/materials/water.h).
case_named "mass is exact to rounding: 16 m2 of compressed water and 0.25 m2 of block"
weighed=$(awk 'BEGIN { c = 1000 * 9.81 / (1000 * 63^2 / 7); p = 6 / 7; printf "%.9f", 16000 * ((1 + p * c)^(1 / p) - 1) / c + 230 }')
read -r least most < <(column $ledger mass | sort -g | sed -n '1p;$p' | xargs)
holds "$most - $least <= 1e-12 * $most && ($most - $weighed)^2 < (1e-9 * $most)^2"

case_named "momentum is what gravity and the walls gave, to the rounding of float"
for axis in x z; do
    worst=$(paste -d, <(column $ledger momentum_$axis) <(column $ledger wall_impulse_$axis) \
        <(column $ledger gravity_impulse_z) | awk -F, -v axis=$axis '
        { open = $1 - $2 - (axis == "z" ? $3 : 0); if (open < 0) open = -open; if (open > worst) worst = open }
        END { print worst }')
    echo "  open by at most $worst kg m/s along $axis"
    holds "$worst < 1e-6 * $most * 9.81 * 5" # of the weight times the run's length
done

# The ledger's kinetic energy runs ahead by its change in half a step (lib/mpm/state/ledger.h).
case_named "energy at the time of the positions is never above its start"
highest=$(paste -d, <(column $ledger energy) <(column $ledger kinetic) <(column $ledger step) | awk -F, '
    NR == 1 { start = $1 }
    NR > 1 { above = $1 - start - 0.5 * ($2 - kinetic) / ($3 - step); if (NR == 2 || above > most) most = above }
    { kinetic = $2; step = $3 }
    END { print most / start }')
holds "$highest <= 1e-9"

case_named "far from the block the water is still at its level before the wave comes"
holds "($(column run/simulate/gauges.csv 'x=12' | sed -n 50p))^2 < (0.1 * 0.04)^2"

case_named "pictures, charts and the ParaView collection are there"
for file in frame_t=2.00.png gauges.svg energy.svg celerity.svg particles.pvd particles_0100.vtp; do
    expect_file "run/postprocess/$file"
done
expect_file run/simulate/frame.hdf.series
