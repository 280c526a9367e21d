#!/usr/bin/env bash
# commit_test.sh PROJECT: which commit simulate is built with, told by what commit.cmake writes. Without git only "unknown".
source "$(dirname "$0")/assert.sh"
script=$1/stages/simulate/commit.cmake
mkdir -p "$work/project"/{lib,stages,tests}
cd "$work/project" || exit 1
export GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_SYSTEM=/dev/null GIT_CEILING_DIRECTORIES=$work
touch CMakeLists.txt lib/a.h stages/b.cpp

# Writes the source anew and keeps the commit in it in $commit.
find_commit() {
    run cmake -D SOURCE="$work/project" -D OUTPUT="$work/commit.cpp" -P "$script"
    expect_code 0
    commit=$(sed -n 's/.*return "\(.*\)".*/\1/p' "$work/commit.cpp")
}
repository() { git -c user.name=a -c user.email=a@b "$@" >/dev/null 2>&1 || fail_case "git $*"; }
head_commit() { git rev-parse HEAD; }

case_named "outside of git it is unknown"
find_commit
expect_same "$commit" unknown
command -v git >/dev/null || exit 0

case_named "it is the last commit that changed the sources"
repository init
repository add .
repository commit --message first
find_commit
first=$(head_commit)
expect_same "$commit" "$first"
echo text >README.md
echo text >tests/c.sh
repository add .
repository commit --message documents
find_commit
expect_same "$commit" "$first"

case_named "what is changed or new in the sources makes it dirty"
echo change >lib/a.h
find_commit
expect_same "$commit" "$first-dirty"
repository commit --all --message second
find_commit
expect_same "$commit" "$(head_commit)"
touch stages/new.cpp
find_commit
expect_same "$commit" "$(head_commit)-dirty"
rm stages/new.cpp
echo other >tests/c.sh
find_commit
expect_same "$commit" "$(head_commit)"

case_named "the source of a commit that is the same is left as it is"
touch --date=2020-01-01 "$work/commit.cpp"
find_commit
expect_same "$(date --reference="$work/commit.cpp" +%Y)" 2020
