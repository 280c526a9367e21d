// Names of columns of tables that were measured at a place: "x=2", "x=2 y=0.5", "x=1.61 z=0.003".
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tidewater::io {

struct NamedPlace {
    std::optional<double> x = {}, y = {}, z = {};  // m
};

std::string place_name(const NamedPlace& place);

// Nothing if the text is no such name.
std::optional<NamedPlace> parse_place(std::string_view name);

}  // namespace tidewater::io
