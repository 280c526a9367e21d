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
