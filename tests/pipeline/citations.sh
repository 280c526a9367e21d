#!/usr/bin/env bash
# citations.sh PROJECT prints each citation in a comment or README that leads nowhere, as "file:line: what"; exit code 1 if
# there is one. What is cited:
#
#     lib/…, stages/…, tests/…, tools/…, configs/…     files or folders of the project; * stands for anything
#     mpm/<name>.h                                     headers and sources, as includes name them
#     `water.h`, in a README                           a file of that name, wherever it lies
#     lib/mpm/README.md, Water                         a heading of that README
#     [text](../io/x.md#heading), in a README          a file, and a heading of it
#
# What lies outside of the project, as folders named shared do, cannot be cited.
set -euo pipefail
cd "$1"

# Prints "file:line:kind:what" for each citation. The next line is joined for headings that go on there.
find_citations() {
    awk '
    function comment(line) {
        if (FILENAME ~ /\.md$/) return line
        mark = FILENAME ~ /\.(h|cpp|in)$/ ? "//" : "#"
        at = index(line, mark)
        return at ? substr(line, at + length(mark)) : ""
    }
    function tell(kind, what) { print file ":" number ":" kind ":" what }
    # Calls for each match of `pattern`, which begins with one character before the citation itself.
    function each(text, pattern, kind,    rest, found) {
        rest = " " text
        while (match(rest, pattern)) {
            found = substr(rest, RSTART + 1, RLENGTH - 1)
            rest = substr(rest, RSTART + RLENGTH)
            if (rest ~ /^[<{$…]/) continue  # goes on with a placeholder
            if (kind == "heading") {
                sub(/, $/, "", found)
                if (rest !~ /^[A-Z]/) continue
                tell(kind, found "|" rest next_text)
                continue
            }
            sub(/[.,;:`]+$/, "", found)
            tell(kind, found)
        }
    }
    function work(text) {
        if (text == "") return
        each(text, "[^A-Za-z0-9_]shared/", "outside")
        each(text, "[^A-Za-z0-9_./<{}$*-](lib|stages|tests|tools|configs)/[A-Za-z0-9_./*-]+", "path")
        each(text, "[^A-Za-z0-9_./<{}$*-](core|geometry|mpm|analysis|io|scene|common|support)/[A-Za-z0-9_/*]+\\.(h|cpp)", "source")
        each(text, "[^A-Za-z0-9_./-][A-Za-z0-9_./-]+/README\\.md, ", "heading")
        if (file !~ /\.md$/) return
        each(text, "`[a-z0-9_]+\\.(h|cpp)`", "name")
        each(text, "\\]\\([^)#: ]*(#[^) ]*)?\\)", "link")
    }
    function last() { next_text = ""; work(held); held = "" }
    FNR == 1 { last() }
    {
        text = comment($0)
        next_text = " " text
        sub(/^ +/, " ", next_text)
        work(held)
        held = text
        file = FILENAME
        number = FNR
    }
    END { last() }' "$@"
}

headings() { sed --quiet 's/^##* //p' "$1"; }
anchors() { headings "$1" | tr '[:upper:]' '[:lower:]' | sed 's/[^a-z0-9 _-]//g; s/ /-/g'; }

exists() { compgen -G "${1%/}" >/dev/null; }
is_source() { exists "lib/$1" || exists "stages/$1" || exists "tests/$1" || exists "tools/$1"; }

# README|what follows: whether a heading begins what follows.
has_heading() {
    local heading
    [[ -f ${1%%|*} ]] || return 1
    while read -r heading; do
        [[ ${1#*|} == "$heading" || ${1#*|} == "$heading"[!A-Za-z]* ]] && return
    done < <(headings "${1%%|*}" | sed 's/:.*//')
    return 1
}

# FILE (PATH#ANCHOR): whether the link leads somewhere, seen from the file's folder.
leads_somewhere() {
    local link=${2#(} target anchor
    link=${link%)}
    target=$1
    [[ ${link%%#*} == "" ]] || target=$(dirname "$1")/${link%%#*}
    [[ -e $target ]] || return 1
    [[ $link == *"#"* ]] || return 0
    anchor=${link#*#}
    anchors "$target" | grep --quiet --line-regexp --fixed-strings -- "$anchor"
}

mapfile -t texts < <(find README.md CMakeLists.txt lib stages tests tools configs -type f -size -200k \
    ! -path 'tests/*/results/*' -exec grep --files-with-matches --binary-files=without-match '' {} + | sort)
mapfile -t names < <(find lib stages tests tools -name '*.h' -o -name '*.cpp' | sed 's:.*/::')
known=" ${names[*]} "

violations=0
complain() {
    echo "$1"
    violations=1
}
while IFS=: read -r file line kind what; do
    case $kind in
        outside) complain "$file:$line: cites shared/, which is not in the project" ;;
        path) exists "$what" || complain "$file:$line: cites $what, which does not exist" ;;
        source) is_source "$what" || complain "$file:$line: cites $what, which does not exist" ;;
        name) [[ $known == *" $what "* ]] || complain "$file:$line: cites $what, which does not exist" ;;
        heading) has_heading "$what" || complain "$file:$line: ${what%%|*} has no such heading: ${what#*|}" ;;
        link) leads_somewhere "$file" "${what#]}" || complain "$file:$line: the link $what leads nowhere" ;;
    esac
done < <(find_citations "${texts[@]}" | sort --unique)
exit "$violations"
