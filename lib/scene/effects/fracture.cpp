#include "scene/effects/fracture.h"

#include <array>

#include "mpm/materials/ice.h"
#include "scene/effects/effect.h"
#include "scene/reading.h"
#include "scene/text.h"

namespace tidewater::scene {

template <>
inline constexpr std::array<std::string_view, 2> enum_names<mpm::ShearReturn>{"pressure", "trace"};

namespace {

constexpr std::array keys{
    Key{.name = "fracture.strength",
        .unit = "Pa",
        .member = member<&Scene::ice, &Ice::model, &mpm::IceModel::beta_p0>(),
        .range = positive,
        .effect = "fracture",
        .stages = by_simulate,
        .help = "βp0, in isotropic tension, of intact ice"},
    Key{.name = "fracture.beta",
        .member = member<&Scene::ice, &Ice::model, &mpm::IceModel::beta>(),
        .range = {.min = 0.01, .max = 1.0},
        .effect = "fracture",
        .stages = by_simulate,
        .help = "β: strength in isotropic tension over that in compression; see the README for the default"},
    Key{.name = "fracture.friction",
        .member = member<&Scene::ice, &Ice::model, &mpm::IceModel::friction>(),
        .range = positive,
        .effect = "fracture",
        .stages = by_simulate,
        .help = "M, slope of the critical state line q = M p"},
    Key{.name = "fracture.softening",
        .member = member<&Scene::fracture, &Fracture::softening>(),
        .effect = "fracture",
        .stages = by_simulate,
        .help = "paper: ξ = fracture.hardening, so that finer cells break more easily; crack_band: ξ from "
                "fracture.energy and the cell size"},
    Key{.name = "fracture.hardening",
        .member = member<&Scene::ice, &Ice::model, &mpm::IceModel::hardening>(),
        .range = positive,
        .effect = "fracture",
        .stages = by_simulate,
        .help = "ξ of the paper's softening; stable only if βξ < 1, above a point fails within a few steps"},
    Key{.name = "fracture.energy",
        .unit = "J/m²",
        .member = member<&Scene::fracture, &Fracture::energy>(),
        .range = not_negative,
        .example = "800",
        .effect = "fracture",
        .stages = by_simulate,
        .help = "of a crack in uniaxial tension, for softening = \"crack_band\""},
    Key{.name = "fracture.hardening_limit",
        .member = member<&Scene::fracture, &Fracture::hardening_limit>(),
        .effect = "fracture",
        .stages = by_simulate,
        .help = "start: ice never gets stronger than it was; none: the paper's rule, by which ice that is "
                "sheared "
                "under pressure gains strength without bound"},
    Key{.name = "fracture.shear_return",
        .member = member<&Scene::ice, &Ice::model, &mpm::IceModel::shear_return>(),
        .effect = "fracture",
        .stages = by_simulate,
        .help = "what a return in shear keeps: the pressure, as the paper says, or tr b, as its authors' "
                "code does"},
};

void check_softening(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!reading.usable({"fracture.softening", "fracture.energy"})) return;
    const bool band = scene.fracture.softening == Softening::crack_band;
    const bool energy = scene.fracture.energy > 0.0;
    if (band && !energy) {
        reading.report("fracture.energy",
                       "missing; softening = \"crack_band\" needs the energy of a crack, e.g. energy = 800 "
                       "(J/m²)");
    } else if (!band && energy) {
        reading.report("fracture.energy",
                       "is not read with softening = \"paper\"; set softening = \"crack_band\" or remove it");
    }
}

// Above this share of κ the yield surface has no compressive tip (mpm/materials/ice_yield.h), and the
// strength would be another.
constexpr double highest_p0 = 0.45;

void check_strength(Reading& reading) {
    const Scene& scene = reading.scene;
    if (!reading.usable({"dimension", "ice.youngs_modulus", "ice.poisson_ratio", "ice.moduli",
                         "fracture.strength", "fracture.beta"})) {
        return;
    }
    const mpm::IceModel& ice = scene.ice.model;
    const double p0 = ice.beta_p0 / ice.beta, max = highest_p0 * ice.bulk_modulus(scene.dimension);
    if (p0 < max) return;
    reading.report("fracture.strength", "over fracture.beta, p0 of intact ice, is " +
                                            number_text(short_number(p0)) + " Pa; it must be below " +
                                            number_text(highest_p0) +
                                            " κ = " + number_text(short_number(max)) +
                                            " Pa; lower it, or raise fracture.beta or ice.youngs_modulus");
}

void check(Reading& reading) {
    require_effect(reading, "fracture", "ice", "there is nothing that could fracture");
    check_softening(reading);
    check_strength(reading);
}

// From βξ = 1 on a point snaps in isotropic tension. In uniaxial tension a band of width h snaps if it stores
// more energy, h σt²/2E, than its crack costs (mpm/materials/ice.h).
std::vector<std::string> warnings(const Scene& scene) {
    const mpm::IceModel ice = ice_model(scene);
    const double product = ice.beta * ice.hardening;
    if (scene.fracture.softening == Softening::crack_band) {
        const double strength = ice.uniaxial_strength(scene.dimension);
        const double stored = 0.5 * scene.domain.cell_size * strength * strength / ice.youngs_modulus;
        if (scene.fracture.energy >= stored && product < 1.0) return {};
        return {"fracture.energy: cells of " + metres(scene.domain.cell_size) + " store " +
                number_text(short_number(stored)) +
                " J/m² before they break, so cracks will cost what the cells say and not " +
                number_text(scene.fracture.energy) + " J/m²; use smaller cells or a higher energy"};
    }
    if (product < 1.0) return {};
    return {"fracture.hardening: βξ = " + number_text(short_number(product)) +
            ", and from 1 on ice snaps within a few steps and dissipates what the steps say; a smaller β or "
            "ξ softens gradually"};
}

}  // namespace

constinit const Effect fracture_effect{
    .name = "fracture", .keys = keys, .check = check, .warnings = warnings};

}  // namespace tidewater::scene
