#include "io/places.h"

#include <algorithm>

#include "io/text.h"

namespace tidewater::io {

std::string place_name(const NamedPlace& place) {
    std::string name;
    const auto add = [&](char axis, const std::optional<double>& at) {
        if (at) name += (name.empty() ? "" : " ") + std::string(1, axis) + "=" + format_number(*at);
    };
    add('x', place.x);
    add('y', place.y);
    add('z', place.z);
    return name;
}

std::optional<NamedPlace> parse_place(std::string_view name) {
    NamedPlace place;
    while (!name.empty()) {
        const auto word = name.substr(0, name.find(' '));
        name.remove_prefix(std::min(word.size() + 1, name.size()));
        if (word.size() < 3 || word[1] != '=') return std::nullopt;
        auto* at = word[0] == 'x'   ? &place.x
                   : word[0] == 'y' ? &place.y
                   : word[0] == 'z' ? &place.z
                                    : nullptr;
        if (at == nullptr || *at) return std::nullopt;
        *at = parse_number(word.substr(2));
        if (!*at) return std::nullopt;
    }
    return place.x ? std::optional(place) : std::nullopt;
}

}  // namespace tidewater::io
