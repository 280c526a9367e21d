// The columns of nodes in the box: what lies above each other along the last axis.
//
// Test: tests/unit/mpm/step/slow_columns_test.cpp.
#pragma once

#include <optional>

#include "core/parallel.h"
#include "mpm/grid/grid.h"

namespace tidewater::mpm {

// The number of columns of nodes in the box, and the place of one in a list of them.
template <int D>
struct Columns {
    Index<D - 1> count{};

    explicit Columns(const Layout<D>& layout) {
        for (std::size_t axis = 0; axis + 1 < D; ++axis) count[axis] = layout.cells[axis] + 1;
    }
    std::size_t size() const {
        std::size_t product = 1;
        for (const int n : count) product *= static_cast<std::size_t>(n);
        return product;
    }
    // Calls visit(n, column) for all of them, in parallel; `column` has its numbers along the horizontal
    // axes.
    template <class Visit>
    void for_each(const Visit& visit) const {
        parallel_for(size(), [&](std::size_t n) { visit(n, at(n)); });
    }
    Index<D - 1> at(std::size_t n) const {
        Index<D - 1> column;
        for (std::size_t axis = D - 1; axis-- > 0;) {
            const auto along = static_cast<std::size_t>(count[axis]);
            column[axis] = static_cast<int>(n % along);
            n /= along;
        }
        return column;
    }
    // The column of a node, or of its number along the horizontal axes; empty beyond the box.
    template <std::size_t axes>
    std::optional<std::size_t> place(const std::array<int, axes>& node) const {
        std::size_t column = 0;
        for (std::size_t axis = 0; axis + 1 < D; ++axis) {
            if (node[axis] < 0 || node[axis] >= count[axis]) return {};
            column = column * static_cast<std::size_t>(count[axis]) + static_cast<std::size_t>(node[axis]);
        }
        return column;
    }
};

}  // namespace tidewater::mpm
