#!/usr/bin/env bash
# layers_test.sh PROJECT
source "$(dirname "$0")/assert.sh"
project=$1
layers=$(dirname "$0")/layers.sh

# planted FILE INCLUDE runs the check on a copy of the project in which FILE, and no other, includes INCLUDE.
mkdir "$work/copy"
cp -r "$project/lib" "$project/stages" "$work/copy"
planted() {
    find "$work/copy" -name 'planted.*' -delete
    printf '// planted\n  # include %s\n' "$2" >"$work/copy/$1"
    run bash "$layers" "$work/copy"
}

case_named "every include of the project goes downward"
run bash "$layers" "$project"
expect_code 0

case_named "an upward include is found, with its file and line"
planted lib/core/planted.h '"mpm/materials/water.h"'
expect_code 1
expect_line 'lib/core/planted.h:2: lib/core must not include "mpm/materials/water.h"; it may include from: core'

case_named "a sideways include is found"
planted lib/io/planted.cpp '"mpm/materials/water.h"'
expect_line 'lib/io/planted.cpp:2: lib/io must not include "mpm/materials/water.h"'

case_named "an include of the scene by a kernel is found, in angle brackets too"
planted lib/mpm/planted.cpp '<scene/scene.h>'
expect_line 'lib/mpm/planted.cpp:2: lib/mpm must not include "scene/scene.h"'

case_named "an include of a stage by a library is found"
planted lib/scene/planted.cpp '"common/stage.h"'
expect_line 'lib/scene/planted.cpp:2: lib/scene must not include "common/stage.h"'

case_named "an include that climbs out of lib is found"
planted lib/scene/planted.cpp '"../stages/common/stage.h"'
expect_line 'lib/scene must not include "../stages/common/stage.h"'

case_named "an include of one stage by another is found"
planted stages/geometry/planted.cpp '"simulate/planted.h"'
expect_line 'stages/geometry must not include "simulate/planted.h"'

case_named "downward includes and those of other libraries are allowed"
planted lib/scene/planted.cpp '<io/nothing.h>'
expect_code 0
planted lib/core/planted.cpp '<sys/stat.h>'
expect_code 0

case_named "an upward include between the rooms of the engine is found"
planted lib/mpm/grid/planted.h '"mpm/state/simulation.h"'
expect_code 1
expect_line 'lib/mpm/grid/planted.h:2: lib/mpm/grid must not include from lib/mpm/state; it may from: grid base'

case_named "pairs of the engine that include each other are found"
planted lib/mpm/step/sort.cpp '"mpm/step/step.h"'
expect_code 1
expect_line "include each other in a circle"
expect_line "lib/mpm/step/sort"
