#!/usr/bin/env bash
# benchmark_test.sh BIN: tidewater-benchmark's command line and CSV, and what it and tidewater-ceilings link.
source "$(dirname "$0")/assert.sh"
bin=$1

# benchmark OPTION... runs it; all runs here are so small that their times say nothing.
benchmark() { run "$bin/tidewater-benchmark" "$@"; }

# column NAME prints that column of $output, a line for each row.
column() {
    local names
    IFS=, read -ra names < <(head -n 1 <<<"$output")
    for number in "${!names[@]}"; do
        [[ ${names[number]} != "$1" ]] || tail -n +2 <<<"$output" | cut --delimiter=, --fields=$((number + 1))
    done
}

rows() { echo $(($(wc -l <<<"$output") - 1)); }

case_named "the header names the columns, then the engine's phases"
benchmark --case water2d --particles 4000 --steps 10
expect_code 0
header=$(head -n 1 <<<"$output")
known=case,dimension,material,precision,threads,particles,steps,particle_steps_per_s,bytes_per_particle,hash
expect_same "${header:0:${#known}}" "$known"
[[ ${header:${#known}} =~ ^(,[a-z_]+)+$ ]] || fail_case "phases: $header"

case_named "a row has a value in every column, and the phases' shares add up to at most 1"
expect_same "$(rows)" 1
row=$(tail -n 1 <<<"$output")
expect_same "${row//[^,]/}" "${header//[^,]/}"
number='[0-9]+(\.[0-9]+)?'
[[ $row =~ ^water2d,2,water,float,[1-9][0-9]*,[1-9][0-9]*,10,$number,-?$number,[0-9a-f]{16}(,$number)+$ ]] ||
    fail_case "row: $row"
tail -n 1 <<<"$output" | cut --delimiter=, --fields=11- | tr , '\n' |
    awk '{ sum += $1 } END { exit !(sum > 0.5 && sum <= 1.001) }' || fail_case "shares: $row"

case_named "options choose, and of several values every combination runs"
benchmark --case water3d water2d --precision double float --threads 1 2 --particles 4000 8000 --steps 1 2
expect_code 0
expect_same "$(rows)" 32
expect_same "$(column case | uniq -c | tr --squeeze-repeats ' \n' ' ')" " 16 water3d 16 water2d "
expect_same "$(column dimension | sort | uniq -c | tr --squeeze-repeats ' \n' ' ')" " 16 2 16 3 "
for of in precision threads steps; do
    expect_same "$(column $of | sort | uniq -c | tr --squeeze-repeats ' ' | cut --fields=2 --delimiter=' ')" "16
16"
done

case_named "the number of particles is near the wanted one"
benchmark --case water2d water3d --particles 100000 --steps 1
for particles in $(column particles); do
    ((particles > 80000 && particles < 120000)) || fail_case "$particles particles"
done

case_named "memory per particle is of the size of a particle's columns"
for bytes in $(column bytes_per_particle); do
    ((${bytes%.*} > 15 && ${bytes%.*} < 1000)) || fail_case "$bytes bytes"
done

case_named "any number of threads ends in the same state; another precision or number of steps does not"
for case in water2d water3d; do
    benchmark --case $case --particles 4000 --threads 1 2 5 --steps 60
    expect_code 0
    expect_same "$(column hash | uniq | wc -l)" 1
    benchmark --case $case --particles 4000 --precision float double --steps 60 61
    expect_same "$(column hash | sort --unique | wc -l)" 4
done

case_named "without --case every case runs"
benchmark --particles 1 --steps 1
expect_code 0
expect_line "water2d,2,water,"
expect_line "water3d,3,water,"

case_named "wrong options are told in a line, with exit code 2"
for options in "--case lake" "--particles 0" "--particles x" "--steps 0" "--threads -1" "--precision half" "--what" "lake" \
    "--steps"; do
    # shellcheck disable=SC2086 # words
    benchmark $options
    expect_code 2
    expect_same "$(wc -l <<<"$output")" 1
    expect_line "tidewater-benchmark: "
done
benchmark --help
expect_code 0
expect_line "--particles"

case_named "a full disk is told, with exit code 5"
run bash -c "'$bin/tidewater-benchmark' --case water2d --particles 1 --steps 1 >/dev/full"
expect_code 5
expect_same "$output" "tidewater-benchmark: standard output: writing failed; is the disk full?"

case_named "nothing but TBB and the C and C++ runtime is linked"
for program in benchmark ceilings; do
    [[ -e $bin/tidewater-$program ]] || continue # ceilings: on x86 only
    run ldd "$bin/tidewater-$program"
    expect_code 0
    others=$(grep --invert-match --extended-regexp '(linux-vdso|ld-linux|libtbb|libstdc\+\+|libgcc_s|libm|libc)[-.]' <<<"$output")
    expect_same "$others" ""
done

case_named "tidewater-ceilings takes no options"
if [[ -e $bin/tidewater-ceilings ]]; then
    run "$bin/tidewater-ceilings" --what
    expect_code 2
    expect_same "$output" "tidewater-ceilings: takes no options; writes CSV for one core, about half a minute"
fi
