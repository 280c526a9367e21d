// All kinds in one tank.
#pragma once

#include "support/flight.h"
#include "support/tank.h"

namespace tidewater::test {

// Water, a rigid block that falls into it and a block of ice that does so too and breaks, in this order.
template <int D>
mpm::Start<D> mixed_tank() {
    auto start = dropped_block_start<D>();
    start.parameters.ice = empty_start<D>(1).parameters.ice;
    add_cube<D>({Material::ice, cells_at<D>(1.3, 1.2, D == 2 ? 12.5 : 8.3), D == 2 ? 5.0 : 3.0,
                 cells_at<D>(0.1, 0.0, -1.0), 0.5, -2.0},
                start);
    return start;
}

}  // namespace tidewater::test
