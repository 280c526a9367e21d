#include "core/types.h"

namespace tidewater {

std::string_view material_name(Material material) {
    switch (material) {
        case Material::water:
            return "water";
        case Material::ice:
            return "ice";
        case Material::rigid:
            return "rigid";
    }
    return "unknown";
}

}  // namespace tidewater
