// What fills a place of a scene, and its colour in pictures of scenes.
#pragma once

#include <cstdint>

#include "io/color.h"

namespace tidewater::io {

enum class Substance : std::uint8_t { nothing, bed, water, ice, rigid };

inline Color substance_color(Substance substance) {
    switch (substance) {
        case Substance::bed:
            return palette::ground;
        case Substance::water:
            return palette::water;
        case Substance::ice:
            return palette::ice;
        case Substance::rigid:
            return palette::rigid;
        case Substance::nothing:
            break;
    }
    return palette::air;
}

}  // namespace tidewater::io
