# shellcheck shell=bash
# A few words for tests in bash. A failed one tells where and what, and ends the test.
#
#     source "$(dirname "$0")/assert.sh"
#     case_named "an unknown key is told with the nearest"
#     run "$program" scene.toml
#     expect_code 2
#     expect_line "scene.toml:1: titel: unknown key; did you mean title?"

set -uo pipefail

work=$(mktemp -d "${TMPDIR:-/tmp}/tidewater-test-XXXXXX")
trap 'rm -rf "$work"' EXIT

case_named() {
    current_case=$1
    printf '%s\n' "- $1"
}

fail_case() {
    printf 'FAILED: %s (%s:%s)\n%s\n' "$current_case" "$(basename "$0")" "${BASH_LINENO[-2]}" "$1"
    exit 1
}

# run COMMAND... keeps its exit code in $code and all that it prints in $output.
run() {
    code=0
    output=$("$@" 2>&1 </dev/null) || code=$?
}

expect_code() { [[ $code == "$1" ]] || fail_case "exit code $code instead of $1; output:"$'\n'"$output"; }
expect_line() { grep --quiet --fixed-strings -- "$1" <<<"$output" || fail_case "no line with: $1"$'\n'"in: $output"; }
expect_no_line() { ! grep --quiet --fixed-strings -- "$1" <<<"$output" || fail_case "a line with: $1"$'\n'"in: $output"; }
expect_same() { [[ $1 == "$2" ]] || fail_case "got: $1"$'\n'"not: $2"; }
expect_file() { [[ -f $1 ]] || fail_case "no file $1"; }
expect_no_file() { [[ ! -e $1 ]] || fail_case "$1 exists"; }
