// All pairs of points that are near each other, in time n log n for the sort plus the number of pairs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tidewater::analysis {

// A point with the number of its cell. Cells are cubes of edge `reach`, numbered along x, then y, then z,
// with an empty one around all, so that the cells of a row have consecutive numbers and no row meets the
// next.
struct CellPoint {
    std::uint64_t cell;
    std::uint32_t index;
    std::array<float, 3> at;
};

struct CellPoints {
    std::vector<CellPoint> points;           // in the order of cell, then index
    std::array<std::uint64_t, 4> next_rows;  // from a cell to the middle of the rows that follow its own
};

// points holds (x, y, z) of each, finite and within 2^20 reach of each other; chosen are those that count.
CellPoints sort_into_cells(std::span<const float> points, std::span<const std::uint32_t> chosen,
                           double reach);

// Calls visit(a, b) once, in an order that depends on nothing but the arguments, for each two of the chosen
// points that are at most `reach` apart. In 2D all y are equal.
template <class Visit>
void for_each_pair(std::span<const float> points, std::span<const std::uint32_t> chosen, double reach,
                   const Visit& visit) {
    const auto [sorted, next_rows] = sort_into_cells(points, chosen, reach);
    const double reach2 = reach * reach;
    const auto visit_range = [&](const CellPoint& a, std::size_t from, std::size_t to) {
        for (std::size_t j = from; j < to; ++j) {
            const CellPoint& b = sorted[j];
            const double x = a.at[0] - b.at[0], y = a.at[1] - b.at[1], z = a.at[2] - b.at[2];
            if (x * x + y * y + z * z <= reach2) visit(a.index, b.index);
        }
    };
    // As the cell's number grows, so do both ends of the cells that it is compared with.
    std::size_t end = 0;
    for (std::size_t i = 0; i < sorted.size(); ++i) {  // the rest of its own cell, and the one to the right
        while (end < sorted.size() && sorted[end].cell <= sorted[i].cell + 1) ++end;
        visit_range(sorted[i], i + 1, end);
    }
    for (const std::uint64_t row : next_rows) {
        std::size_t from = 0, to = 0;
        for (const CellPoint& point : sorted) {
            while (from < sorted.size() && sorted[from].cell < point.cell + row - 1) ++from;
            while (to < sorted.size() && sorted[to].cell <= point.cell + row + 1) ++to;
            visit_range(point, from, to);
        }
    }
}

}  // namespace tidewater::analysis
