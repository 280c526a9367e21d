#!/usr/bin/env bash
# citations_test.sh PROJECT
source "$(dirname "$0")/assert.sh"
project=$1
citations=$(dirname "$0")/citations.sh

# cited FILE LINE runs the check on a small project with two READMEs, one header and FILE, which holds LINE.
cited() {
    rm -rf "$work/copy"
    mkdir -p "$work/copy"/{lib/mpm/grid,stages,tests,tools,configs}
    touch "$work/copy/CMakeLists.txt" "$work/copy/lib/mpm/grid/grid.h"
    printf '# The engine\n\n## Grid and transfer\n\n### Walls: `run this`\n' >"$work/copy/lib/mpm/README.md"
    printf '# The project\n' >"$work/copy/README.md"
    printf '%b\n' "$2" >>"$work/copy/$1"
    run bash "$citations" "$work/copy"
}

case_named "every citation of the project leads somewhere"
run bash "$citations" "$project"
expect_code 0

case_named "what lies outside of the project is found"
cited lib/mpm/a.h '// Source: shared''/physics.md.'
expect_code 1
expect_line 'lib/mpm/a.h:1: cites shared''/, which is not in the project'
cited configs/a.toml 'title = "x"  # ../shared''/scenes.md'
expect_code 1

case_named "a file that does not exist is found, by its path or as includes name it"
cited stages/a.cpp '// See lib/mpm/none.h, and mpm/none.h.'
expect_line 'stages/a.cpp:1: cites lib/mpm/none''.h, which does not exist'
expect_line 'stages/a.cpp:1: cites mpm/none''.h, which does not exist'
cited README.md 'It is told in `none.h`.'
expect_line 'README.md:2: cites none.h, which does not exist'

case_named "a heading that does not exist is found, also on the next line"
cited lib/mpm/a.h '// lib/mpm/README.md, Ice.'
expect_line 'lib/mpm/a.h:1: lib/mpm/README.md has no such heading: Ice.'
cited lib/mpm/a.h '// lib/mpm/README.md, Grid and\n// nothing.'
expect_code 1

case_named "a link that leads nowhere is found"
cited README.md '[engine](lib/mpm/none.md)'
expect_line 'README.md:2: the link (lib/mpm/none.md) leads nowhere'
cited README.md '[engine](lib/mpm/README.md#ice)'
expect_code 1

case_named "files, patterns, headings and links that exist may be cited"
cited lib/mpm/a.h '// lib/mpm/grid/grid.h, mpm/grid/grid.h and lib/*/grid/*.h: lib/mpm/README.md, Grid and\n// transfer; and\n// lib/mpm/README.md, Walls.'
expect_code 0
cited README.md '[engine](lib/mpm/README.md#grid-and-transfer), `grid.h`, [elsewhere](https://example.org), lib/<folder>/x.h'
expect_code 0

case_named "code is no citation"
cited tools/a.h 'const char* path = "lib/mpm/none.h";'
expect_code 0
