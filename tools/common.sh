# shellcheck shell=bash
# Shared by tools/run and tools/test: say what happens and how long it took, install what is missing, build.
# Until install_packages has run, only what a bare Debian has is used: bash, coreutils, dpkg, apt.

project=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { printf '%s: %s\n' "$(basename "$0")" "$*" >&2; }

fail() { # CODE MESSAGE
    say "$2"
    exit "$1"
}

# timed WHAT COMMAND... runs the command and says how long it took; ends the script with its exit code if it fails.
timed() {
    local what=$1 start=$SECONDS code=0
    shift
    say "$what"
    "$@" || code=$?
    ((code == 0)) || fail "$code" "$what: failed after $((SECONDS - start)) s"
    say "$what: took $((SECONDS - start)) s"
}

# quietly COMMAND... shows the command's output only if it fails.
quietly() {
    local output code=0
    output=$("$@" 2>&1 </dev/null) || code=$?
    ((code == 0)) || printf '%s\n' "$output" >&2
    return "$code"
}

# passing_signals_on COMMAND... runs it to its end, which SIGTERM and SIGINT ask it to come to; its exit code.
passing_signals_on() {
    local code=0 child
    "$@" &
    child=$!
    # shellcheck disable=SC2064 # this child
    trap "kill -TERM $child 2>/dev/null" INT TERM
    while wait "$child" && code=0 || code=$?; kill -0 "$child" 2>/dev/null; do :; done
    trap - INT TERM
    return "$code"
}

# The packages of tools/packages and of the other lists that are named, of those that tools has.
missing_packages() { # LIST...
    local package
    while read -r package; do
        [[ $(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null) == installed ]] ||
            printf '%s\n' "$package"
    done < <(cd "$project/tools" && cat packages "$@")
}

can_be_root() {
    ((EUID == 0)) && return
    command -v sudo >/dev/null || return 1
    sudo --non-interactive true 2>/dev/null || { [[ -t 0 ]] && sudo --validate; }
}

as_root() {
    if ((EUID == 0)); then
        "$@"
    else
        sudo "$@"
    fi
}

apt_get() { quietly as_root env DEBIAN_FRONTEND=noninteractive apt-get --yes "$@"; }

install_packages() { # LIST...
    local missing
    mapfile -t missing < <(missing_packages "$@")
    if ((${#missing[@]} == 0)); then
        say "all packages are installed"
        return
    fi
    local by_hand="apt-get install --no-install-recommends ${missing[*]}"
    command -v apt-get >/dev/null || fail 1 "no apt-get here; install what Debian calls ${missing[*]}, then run again"
    can_be_root || fail 1 "packages are missing and this user is neither root nor has sudo; as root run: $by_hand"
    timed "updating the lists of packages" apt_get update
    timed "installing (a few minutes): ${missing[*]}" apt_get install --no-install-recommends "${missing[@]}"
}

available_kilobytes() {
    local name value
    while read -r name value _; do
        [[ $name == MemAvailable: ]] && echo "$value"
    done </proc/meminfo
}

# As many compile jobs as there are cores, and memory for 1 GB each.
build_jobs() {
    local cores jobs
    cores=$(nproc)
    jobs=$(($(available_kilobytes) / 1000000))
    ((jobs < cores)) || jobs=$cores
    echo $((jobs > 1 ? jobs : 1))
}

# The compiler of a build folder, or nothing if it was not configured.
compiler_of() { # FOLDER
    [[ ! -f $1/build.ninja ]] || sed --quiet 's/^CMAKE_CXX_COMPILER:[A-Z]*=//p' "$1/CMakeCache.txt"
}

# build FOLDER TYPE TARGET configures the folder, if that was not done or not with this compiler, and builds what is not
# up to date. The compiler is clang-19, whose vectorised kernels were 1.3 to 2 times as fast as GCC 12's in trials, unless
# CXX names another.
build() {
    local folder=$1 type=$2 target=$3 before compiler
    [[ -n ${CXX-} ]] || export CXX=clang++-19 CC=clang-19
    compiler=$(command -v "$CXX") || fail 1 "CXX=$CXX: no such compiler"
    before=$(compiler_of "$folder")
    if [[ ! $before -ef $compiler ]]; then
        timed "configuring $folder ($type) with $CXX${before:+ instead of $before}" \
            quietly cmake --fresh -G Ninja -S "$project" -B "$folder" -D CMAKE_BUILD_TYPE="$type"
    fi
    timed "building $folder" cmake --build "$folder" --parallel "$(build_jobs)" --target "$target"
}
