#include "mpm/grid.h"

#include <doctest/doctest.h>

#include <initializer_list>

using namespace tidewater;
using namespace tidewater::mpm;

TEST_CASE_TEMPLATE("block indices and places are inverse to each other", Dimension,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    Index<D> cells;
    cells.fill(9);
    cells[0] = 30;
    const Layout<D> layout(0.1, cells);
    for (int index = 0; index < layout.block_count(); ++index) {
        CHECK(layout.block_index(layout.block_at(index)) == index);
    }
}

TEST_CASE_TEMPLATE("every tile node reaches exactly one node, and comes back to its tile", Dimension,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    Index<D> cells;
    cells.fill(3 * Block<D>::width);
    Grid<D, double> grid;
    grid.layout = Layout<D>(0.1, cells);
    Index<D> middle;
    middle.fill(3);
    Index<D> beside = middle;
    beside[0] = 4;
    activate(grid, {grid.layout.block_index(middle), grid.layout.block_index(beside)});
    // Tile 0 carries 1, 2, 3 …, tile 1 nothing.
    for (int n = 0; n < Block<D>::tile_nodes; ++n) {
        grid.tile(0)[n] = Node<double>::Constant(n + 1);
        grid.tile(1)[n].setZero();
    }
    double sum = 0;
    for (std::size_t slot = 0; slot < grid.node_blocks.size(); ++slot) {
        sum_tiles(grid, slot, grid.block_nodes(slot));
        for (int n = 0; n < Block<D>::nodes; ++n) sum += grid.block_nodes(slot)[n][0];
    }
    CHECK(sum == 0.5 * Block<D>::tile_nodes * (Block<D>::tile_nodes + 1));
    std::vector<Node<double>> back(Block<D>::tile_nodes);
    load_tile(grid, 0, back.data());
    for (int n = 0; n < Block<D>::tile_nodes; ++n) CHECK(back[static_cast<std::size_t>(n)][0] == n + 1);
}
