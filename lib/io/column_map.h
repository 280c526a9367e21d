// Which arrays of another program's particle files become which columns of a snapshot, as people write it:
//
//     velocity=vel            the array vel
//     velocity=u:v:w          an array for each component
//     damage=state[2]         one component, counted from 0, of an array
//     volume=0.25             a number for every particle, where no array is called so
//     material=water          likewise the name of a material
//
// Entries are separated by commas. A column that is not named is the array of its own name. Arrays with a
// comma, a colon or a bracket in their names cannot be named.
// Test: tests/unit/io/column_map_test.cpp
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/types.h"

namespace tidewater::io {

struct ArrayPart {
    std::string array;   // or a number, or the name of a material
    int component = -1;  // of the array; -1: all
};

// What a column is made of: one part, or one for each component.
using ColumnSource = std::vector<ArrayPart>;

// By the column's name. Without an entry: the array of that name.
using ColumnMap = std::map<std::string, ColumnSource, std::less<>>;

// Nothing if there is none of that name.
std::optional<Material> material_named(std::string_view name);

ColumnSource column_source(const ColumnMap& map, std::string_view column);

// Throws SceneError, with the columns that there are, if an entry is none of the above or names no column of
// io::snapshot_columns.
ColumnMap parse_column_map(std::string_view text);

// Which material each of another program's numbers stands for; empty: the numbers are those of Material.
using MaterialNumbers = std::map<int, Material>;

// "water=3,ice=1,ice=2". Throws SceneError.
MaterialNumbers parse_material_numbers(std::string_view text);

}  // namespace tidewater::io
