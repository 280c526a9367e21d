#!/usr/bin/env bash
# tools_test.sh PROJECT: tools/run and tools/test, as far as that goes without installing or building anything.
source "$(dirname "$0")/assert.sh"
project=$1
cp -r "$project/tools" "$work/tools"
chmod -R go+rX "$work"
stubs=$work/stubs
mkdir "$stubs"

# stub NAME SCRIPT: a program that stands in for the system's.
stub() {
    printf '#!/bin/bash\n%s\n' "$2" >"$stubs/$1"
    chmod 755 "$stubs/$1"
}

# install_as USER_ID: install_packages as tools/run calls it, with the stubs before the system's programs.
install_as() {
    local as=()
    ((EUID != 0 || $1 == 0)) || as=(setpriv --reuid="$1" --clear-groups)
    run "${as[@]}" env PATH="$stubs:/usr/bin:/bin" bash -c "source '$work/tools/common.sh'; install_packages"
}

case_named "tools/run without a scene, with two or with an unknown option ends with 2"
for arguments in "" "a.toml b.toml" "a.toml --what" "a.toml --set"; do
    # shellcheck disable=SC2086 # words
    run bash "$project/tools/run" $arguments
    expect_code 2
    expect_line "run: "
done

case_named "a missing scene ends with 3 before anything is installed"
run bash "$project/tools/run" missing.toml
expect_code 3
expect_same "$output" "run: missing.toml: no such scene file; $project/configs has some"

case_named "a path that make cannot take is told"
touch "$work/my scene.toml"
run bash "$project/tools/run" "$work/my scene.toml"
expect_code 2
expect_line "in a path: $work/my scene.toml"

case_named "tools/run and tools/test tell their options"
run bash "$project/tools/run" --help
expect_code 0
expect_line "--set KEY=VALUE"
run bash "$project/tools/test" --help
expect_code 0
expect_line "--sanitize"

case_named "tools/test with an unknown option ends with 2"
run bash "$project/tools/test" --what
expect_code 2

case_named "a signal to a script that passes it on lets the command come to its own end, with its exit code"
for signal in TERM INT; do
    env --default-signal=INT bash -c "source '$work/tools/common.sh'; passing_signals_on bash -c \
        'trap \"sleep 0.2; echo ended well; exit 7\" TERM; echo >\"$work/ready\"; while :; do sleep 0.05; done'" \
        >"$work/said" 2>&1 &
    script=$!
    for _ in {1..200}; do [[ ! -e $work/ready ]] && sleep 0.05; done
    kill "-$signal" "$script"
    code=0
    wait "$script" || code=$?
    expect_same "$code" 7
    expect_same "$(cat "$work/said")" "ended well"
    rm "$work/ready"
done
run bash -c "source '$work/tools/common.sh'; passing_signals_on true && passing_signals_on bash -c 'exit 3'"
expect_code 3

case_named "nothing is installed where every package is"
stub dpkg-query 'printf installed'
stub apt-get "echo \"\$@\" >>'$work/apt.log'"
install_as "$EUID"
expect_code 0
expect_line "all packages are installed"
expect_no_file "$work/apt.log"

case_named "exactly the missing packages are installed, after the lists are updated"
stub dpkg-query 'case ${!#} in cmake | libvtk9-dev) printf not-installed ;; *) printf installed ;; esac'
stub sudo 'while [[ $1 == -* ]]; do shift; done; "$@"'
install_as "$EUID"
expect_code 0
expect_same "$(cat "$work/apt.log")" "--yes update
--yes install --no-install-recommends cmake libvtk9-dev"

case_named "a failing installation shows what apt-get said and ends with its exit code"
stub apt-get 'echo "E: no network"; exit 100'
install_as "$EUID"
expect_code 100
expect_line "E: no network"

case_named "without root and sudo the missing packages are named"
stub sudo 'exit 1'
install_as 65534
expect_code 1
expect_line "as root run: apt-get install --no-install-recommends cmake libvtk9-dev"

# build_with COMPILER: build as tools/run calls it, where cmake is a stub that writes its arguments to cmake.log and, to
# configure, the compiler's path as CMake does. Of compilers there are clang++-19 and g++.
build_with() {
    rm -f "$work/cmake.log"
    run env CXX="$1" PATH="$stubs:/usr/bin:/bin" bash -c "source '$work/tools/common.sh'; build '$work/b' Release all"
}
stub clang++-19 'echo clang'
stub g++ 'echo gnu'
stub cmake "echo \"CC=\$CC CXX=\$CXX \$*\" >>'$work/cmake.log'
[[ \$1 == --build ]] && exit
mkdir -p '$work/b' && touch '$work/b/build.ninja'
echo \"CMAKE_CXX_COMPILER:FILEPATH=$stubs/\$CXX\" >'$work/b/CMakeCache.txt'"

case_named "clang-19 builds unless CXX names another compiler"
build_with ""
expect_code 0
expect_line "configuring $work/b (Release) with clang++-19: took"
expect_same "$(head -n 1 "$work/cmake.log")" \
    "CC=clang-19 CXX=clang++-19 --fresh -G Ninja -S $work -B $work/b -D CMAKE_BUILD_TYPE=Release"

case_named "a folder that is configured with this compiler is only built"
build_with clang++-19
expect_code 0
expect_no_line "configuring"
expect_same "$(wc -l <"$work/cmake.log")" 1

case_named "a folder that another compiler built is configured anew, and one line says so"
build_with g++
expect_code 0
expect_line "configuring $work/b (Release) with g++ instead of $stubs/clang++-19"
expect_line "building $work/b: took"
build_with g++
expect_no_line "configuring"

case_named "a compiler that does not exist is told"
build_with no-such-compiler
expect_code 1
expect_same "$output" "bash: CXX=no-such-compiler: no such compiler"
