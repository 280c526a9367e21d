#!/usr/bin/env bash
# threads_test.sh BIN: any number of threads gives the same bytes of every file that geometry and simulate write.
source "$(dirname "$0")/assert.sh"
bin=$1
cp "$(dirname "$0")/tiny.toml" "$work"
cd "$work" || exit 1

# run_with THREADS FOLDER [OPTION...]
run_with() {
    local threads=$1 folder=$2
    shift 2
    for stage in geometry simulate; do
        run "$bin/tidewater-$stage" tiny.toml --run "$folder" --threads "$threads" "$@"
        expect_code 0
    done
    rm "$folder/simulate/log" "$folder/simulate/run.json" # hold times
}

for precision in float double; do
    case_named "1, 2, 5 and 16 threads give the same bytes, $precision"
    options=(--set particles.jitter=0.5 --set simulate.precision=$precision)
    run_with 1 one "${options[@]}"
    expect_file one/simulate/frame_0002.hdf
    for threads in 2 5 16; do
        run_with "$threads" "on_$threads" "${options[@]}"
        run diff --recursive one "on_$threads"
        expect_code 0
        rm -r "on_$threads"
    done
    rm -r one
done

case_named "another seed gives other particles"
run_with 1 first --set particles.jitter=0.5
run_with 1 second --set particles.jitter=0.5 --set seed=2
run cmp first/simulate/frame_0000.hdf second/simulate/frame_0000.hdf
expect_code 1
