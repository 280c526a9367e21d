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

std::optional<Material> material_named(std::string_view name) {
    for (const Material material : {Material::water, Material::ice, Material::rigid}) {
        if (material_name(material) == name) return material;
    }
    return {};
}

}  // namespace tidewater
