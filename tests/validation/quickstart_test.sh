#!/usr/bin/env bash
# quickstart_test.sh PROJECT BIN: what configs/quickstart.toml must show (shared/physics.md §3, last row of the table).
source "$(dirname "$0")/../pipeline/assert.sh"
project=$1
bin=$2
cd "$work" || exit 1
run make -f "$project/tools/pipeline.mk" SCENE="$project/configs/quickstart.toml" RUN=run BIN="$bin"
expect_code 0

# column FILE NAME: the values of a CSV column, one per line.
column() {
    awk -F, -v name="$2" '/^#/ { next }
        !index_of { for (i = 1; i <= NF; ++i) if ($i == name) index_of = i; next }
        { print $index_of }' "$1"
}
holds() { awk "BEGIN { exit !($1) }" || fail_case "does not hold: $1"; }
ledger=run/simulate/ledger.csv

case_named "the first wave's celerity is within 5 % of sqrt(g D)"
error=$(column run/postprocess/waves.csv error_percent | tail -n 1)
echo "  celerity off by $error %"
holds "$error < 5 && $error > -5"

case_named "mass is exact to rounding"
read -r least most < <(column $ledger mass | sort -g | sed -n '1p;$p' | xargs)
holds "$most - $least <= 1e-12 * $most"

case_named "momentum is what gravity and the walls gave, to the rounding of float"
read -r momentum wall gravity < <(paste <(column $ledger momentum_z) <(column $ledger wall_impulse_z) \
    <(column $ledger gravity_impulse_z) | tail -n 1)
holds "($momentum - $wall - $gravity)^2 < (1e-6 * $gravity)^2"

case_named "energy is never above its start"
start=$(column $ledger energy | head -n 1)
highest=$(column $ledger energy | sort -g | tail -n 1)
holds "$highest <= $start * (1 + 1e-9)"

case_named "far from the block the water is still at its level before the wave comes"
holds "$(column run/simulate/gauges.csv 'x=12' | sed -n 50p)^2 < (0.1 * 0.04)^2"

case_named "pictures, charts and the ParaView collection are there"
for file in frame_t=2.00.png gauges.svg energy.svg celerity.svg particles.pvd particles_0100.vtp; do
    expect_file "run/postprocess/$file"
done
expect_file run/simulate/frame.hdf.series
