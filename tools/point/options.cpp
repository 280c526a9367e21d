#include "options.h"

#include <cmath>
#include <map>

#include "common/tool.h"
#include "core/error.h"
#include "core/provenance.h"
#include "scene/scene.h"

namespace tidewater::point {
namespace {

using mpm::IceModel;
using mpm::LoadPath;
using mpm::Moduli;
using mpm::ShearReturn;

// What stands on the command line, in its units.
struct Words {
    IceModel ice;
    std::string scene;             // empty: ice from the options above
    std::vector<std::string> set;  // keys of the scene
    mpm::Loading loading;
    int dimension = 3;
    bool failed = false;
    std::string out = "point", moduli = "plane_strain", shear_return = "pressure", path = "isotropic",
                precision = "double";
};

const std::map<std::string, LoadPath> paths{{"isotropic", LoadPath::isotropic},
                                            {"uniaxial", LoadPath::uniaxial},
                                            {"uniaxial_strain", LoadPath::uniaxial_strain},
                                            {"shear", LoadPath::shear}};

void declare_ice(CLI::App& app, Words& words) {
    IceModel& ice = words.ice;
    const auto number = [&](const char* name, double& value, const char* what, double least,
                            double greatest) {
        app.add_option(name, value, what)
            ->check(CLI::Range(least, greatest))
            ->capture_default_str()
            ->group("Ice");
    };
    number("--youngs-modulus", ice.youngs_modulus, "E, Pa", 1.0, 1e13);
    number("--poisson-ratio", ice.poisson_ratio, "ν", 0.0, 0.499);
    number("--beta-p0", ice.beta_p0, "βp0, strength in isotropic tension, Pa", 1e-3, 1e12);
    number("--beta", ice.beta, "β, that over the strength in isotropic compression", 1e-6, 100.0);
    number("--friction", ice.friction, "M, slope of the critical state line q = M p", 1e-6, 100.0);
    number("--hardening", ice.hardening, "ξ", 1e-9, 1e6);
    app.add_option("--cap-hardening", ice.cap_hardening, "whether p0 stays <= p0(α0)")
        ->capture_default_str()
        ->group("Ice");
    app.add_option("--moduli", words.moduli, "of 2D: of a slice of a wide body, or λ + 2μ/3 as in the paper")
        ->check(CLI::IsMember({"plane_strain", "paper"}))
        ->capture_default_str()
        ->group("Ice");
    app.add_option("--shear-return", words.shear_return, "what the return to the surface keeps")
        ->check(CLI::IsMember({"pressure", "trace"}))
        ->capture_default_str()
        ->group("Ice");
}

// Declared after the options of the ice, which a scene replaces.
void declare_scene(CLI::App& app, Words& words) {
    const auto of_ice =
        app.get_options([](const CLI::Option* option) { return option->get_group() == "Ice"; });
    auto* scene =
        app.add_option("--scene", words.scene, "take the ice, its cells and the dimension of this scene")
            ->type_name("FILE")
            ->group("Scene");
    for (CLI::Option* option : of_ice) scene->excludes(option);
    scene->excludes(app.get_option("--dimension"));
    app.add_option("--set", words.set, "a key of the scene, instead of the file's value; repeatable")
        ->type_name("KEY=VALUE")
        ->needs(scene)
        ->group("Scene");
}

void declare_path(CLI::App& app, Words& words) {
    mpm::Loading& loading = words.loading;
    std::vector<std::string> names;
    for (const auto& [name, path] : paths) names.push_back(name);
    app.add_option("--path", words.path, "how the point is strained")
        ->check(CLI::IsMember(names))
        ->capture_default_str()
        ->group("Path");
    app.add_option("--strain", loading.strain,
                   "at the end, or the amplitude of cycles; logarithmic, γ in shear; negative: compression")
        ->check(CLI::Range(-3.0, 3.0))
        ->capture_default_str()
        ->group("Path");
    app.add_option("--steps", loading.steps, "in all")
        ->check(CLI::Range(1, 10'000'000))
        ->capture_default_str()
        ->group("Path");
    app.add_option("--cycles", loading.cycles,
                   "0: straight to the strain; else there, to its opposite and back")
        ->check(CLI::Range(0, 100'000))
        ->capture_default_str()
        ->group("Path");
    app.add_option("--held-pressure", loading.held_pressure, "Pa, in shear, instead of constant volume")
        ->check(CLI::Range(-1e12, 1e12))
        ->group("Path");
    app.add_flag("--failed", words.failed, "start without strength (α = 0)")->group("Path");
    app.add_option("--dimension", words.dimension, "2 or 3")
        ->check(CLI::IsMember({2, 3}))
        ->capture_default_str()
        ->group("Path");
    app.add_option("--precision", words.precision, "of the kernels; scenes have float")
        ->check(CLI::IsMember({"float", "double"}))
        ->capture_default_str()
        ->group("Path");
}

IceModel ice_of_scene(Words& words) {
    std::vector<scene::Override> overrides;
    for (const std::string& set : words.set) overrides.push_back(scene::parse_override(set));
    const scene::Scene scene = scene::read_scene(words.scene, overrides);
    if (!scene.has("fracture"))
        throw SceneError(words.scene +
                         ": effects names no \"fracture\", so its ice has no strength to be driven to");
    words.dimension = scene.dimension;
    return ice_model(scene);
}

// The one place where the ice is made.
IceModel make_ice_model(Words& words) {
    if (!words.scene.empty()) return ice_of_scene(words);
    IceModel ice = words.ice;
    ice.moduli = words.moduli == "paper" ? Moduli::paper : Moduli::plane_strain;
    ice.shear_return = words.shear_return == "trace" ? ShearReturn::trace : ShearReturn::pressure;
    const double p0 = ice.beta_p0 / ice.beta, kappa = ice.bulk_modulus(words.dimension);
    if (!(p0 < 0.45 * kappa))
        throw SceneError("--beta-p0 over --beta, p0 at the start, must be below 0.45 κ = " +
                         std::to_string(0.45e-6 * kappa) + " MPa; raise --youngs-modulus or --beta");
    return ice;
}

Options make_options(Words& words) {
    Options options{.ice = make_ice_model(words),
                    .loading = words.loading,
                    .dimension = words.dimension,
                    .single_precision = words.precision == "float",
                    .failed = words.failed,
                    .out = words.out};
    options.loading.path = paths.at(words.path);
    if (!std::isfinite(words.loading.strain) || words.loading.strain == 0.0)
        throw SceneError("--strain must be a number other than 0");
    if (words.loading.held_pressure && options.loading.path != LoadPath::shear)
        throw SceneError("--held-pressure goes with --path shear only");
    if (options.out.filename().empty()) throw SceneError("--out needs a name behind the folder");
    return options;
}

}  // namespace

std::optional<Options> parse_options(int argc, const char* const* argv) {
    CLI::App app("Drives one point of ice along a path of strain; writes PREFIX.csv and PREFIX.svg.",
                 "tidewater-point");
    Words words;
    app.set_version_flag("--version", "tidewater-point " + program_version());
    declare_ice(app, words);
    declare_path(app, words);
    declare_scene(app, words);
    app.add_option("--out", words.out, "where the results go: PREFIX.csv and PREFIX.svg")
        ->type_name("PREFIX")
        ->capture_default_str();
    if (!parse_command_line(app, argc, argv)) return std::nullopt;
    return make_options(words);
}

}  // namespace tidewater::point
