#include "mpm/grid/grid.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <initializer_list>

#include "core/random.h"

using namespace tidewater;
using namespace tidewater::mpm;

TEST_CASE_TEMPLATE("block indices and keys are inverse to each other", Dimension,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    const double largest = D == 2 ? 2147483648.0 : 2097152.0;
    for (std::uint64_t n = 0; n < 200; ++n) {
        Index<D> block;
        for (std::size_t axis = 0; axis < D; ++axis)
            block[axis] = static_cast<int>(largest * random_uniform(2, axis, n));
        CHECK(block_at<D>(block_key<D>(block)) == block);
    }
    Index<D> ends;
    ends.fill(static_cast<int>(largest - 1.0));
    CHECK(block_at<D>(block_key<D>(ends)) == ends);
    CHECK(block_key<D>(Index<D>{}) == 0);
}

TEST_CASE("keys interleave the bits with the last axis lowest") {
    CHECK(block_key<2>({0, 1}) == 1);
    CHECK(block_key<2>({1, 0}) == 2);
    CHECK(block_key<2>({2, 3}) == 0b1101);
    CHECK(block_key<3>({0, 0, 1}) == 1);
    CHECK(block_key<3>({0, 1, 0}) == 2);
    CHECK(block_key<3>({1, 0, 0}) == 4);
    CHECK(block_key<3>({2, 0, 1}) == 0b100001);
}

TEST_CASE_TEMPLATE("every tile node reaches exactly one node, and comes back to its tile", Dimension,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    Index<D> cells;
    cells.fill(3 * Block<D>::width);
    Grid<D, double> grid;
    grid.layout = Layout<D>{0.1, cells};
    Index<D> middle;
    middle.fill(3);
    Index<D> beside = middle;
    beside[0] = 4;
    activate(grid, {block_key<D>(middle), block_key<D>(beside)});
    // Tile 0 carries 1, 2, 3 …, tile 1 nothing.
    for (int n = 0; n < Block<D>::tile_size; ++n) {
        grid.tile(0)[n] = Node<double>::Constant(n < Block<D>::tile_nodes ? n + 1 : 1e6);
        grid.tile(1)[n].setZero();
    }
    double sum = 0;
    for (std::size_t slot = 0; slot < grid.node_blocks.size(); ++slot) {
        sum_tiles<D, double>(grid.tiles_of_node[slot], grid.tiles.data(), grid.block_nodes(slot));
        for (int n = 0; n < Block<D>::nodes; ++n) sum += grid.block_nodes(slot)[n][0];
    }
    CHECK(sum == 0.5 * Block<D>::tile_nodes * (Block<D>::tile_nodes + 1));
    std::vector<Node<double>> back(Block<D>::tile_size, Node<double>::Constant(-1.0));
    load_tile(grid, grid.nodes, 0, back.data());
    for (int n = 0; n < Block<D>::tile_nodes; ++n) CHECK(back[static_cast<std::size_t>(n)][0] == n + 1);
    for (int n = Block<D>::tile_nodes; n < Block<D>::tile_size; ++n)
        CHECK(back[static_cast<std::size_t>(n)].isZero(0.0));
}

TEST_CASE("momenta become velocities with the kick, and nodes without mass become zero") {
    std::vector<Node<float>> nodes(Block<3>::nodes, Node<float>(2.0f, 4.0f, 6.0f, 2.0f));
    nodes[5] = Node<float>(1.0f, 1.0f, 1.0f, 0.0f);
    momentum_to_velocity<3, float>(-0.5f, nodes.data());
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        const Node<float> expected = n == 5 ? Node<float>::Zero() : Node<float>(1.0f, 2.0f, 2.5f, 2.0f);
        CHECK((nodes[n] == expected).all());
    }
    std::vector<Node<double>> flat(Block<2>::nodes, Node<double>(2.0, 4.0, 0.0, 2.0));
    momentum_to_velocity<2, double>(-0.5, flat.data());
    for (const auto& node : flat) CHECK((node == Node<double>(1.0, 1.5, 0.0, 2.0)).all());
}

TEST_CASE_TEMPLATE(
    "the nodes that tiles reach are told, and sums and velocities of these alone are those of all", Dimension,
    std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    Grid<D, double> grid;
    Index<D> cells;
    cells.fill(8 * Block<D>::width);
    grid.layout = Layout<D>{0.1, cells};
    // Every second block or so, in disorder.
    std::vector<BlockKey> blocks;
    for (int n = 0; n < power(4, D); ++n) {
        Index<D> block = index_of<D>(n, 4);
        for (int& along : block) along += 2;
        if (random_uniform(1, 0, static_cast<std::uint64_t>(n)) < 0.4) blocks.push_back(block_key<D>(block));
    }
    std::ranges::sort(blocks);
    activate(grid, blocks);
    CHECK(grid.linked_anew);
    for (auto& node : grid.tiles) node.setOnes();
    long reached = 0;
    for (std::size_t slot = 0; slot < grid.node_blocks.size(); ++slot) {
        const auto& tiles = grid.tiles_of_node[slot];
        std::vector<Node<double>> all(Block<D>::nodes, Node<double>::Constant(7.0)), some(Block<D>::nodes);
        sum_tiles<D, double>(tiles, grid.tiles.data(), all.data());
        for (auto& node : some) node.setZero();
        const NodeBox<D> box = reached_nodes<D>(tiles);
        box.for_each_run([&](int first, int count) {
            for (int n = first; n < first + count; ++n) some[static_cast<std::size_t>(n)].setConstant(7.0);
            reached += count;
        });
        sum_tiles<D, double>(tiles, grid.tiles.data(), some.data(), box);
        for (std::size_t n = 0; n < all.size(); ++n) CHECK((all[n] == some[n]).all());
        momentum_to_velocity<D, double>(-0.5, all.data());
        momentum_to_velocity<D, double>(-0.5, some.data(), box);
        for (std::size_t n = 0; n < all.size(); ++n) CHECK((all[n] == some[n]).all());
    }
    CHECK(reached < 0.8 * static_cast<double>(grid.nodes.size()));
}
