// The table of keys. Each key of a scene is declared once, in keys_<part>.cpp; reading, --set, checks,
// printing, the stages' parts and the reference are derived from this table. The default of a key is its
// member's initialiser in scene.h.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

#include "scene/scene.h"
#include "scene/toml_document.h"

namespace tidewater::scene {

// Allowed numbers: least ≤ x ≤ most, without `least` itself if it is open. Lists: each number.
struct Range {
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    bool open = false;

    // False for NaN and infinities too.
    bool contains(double number) const;
    // "above 0 m", "from 0 to 1"; empty if every number is allowed.
    std::string text(std::string_view unit) const;
};

// How to reach one key's member of a Scene. `item` counts the sections of a repeated key, from 0; other keys
// ignore it.
template <class T>
struct Member {
    const T& (*read)(const Scene&, std::size_t item);
    T& (*write)(Scene&, std::size_t item);
};

// member<&Scene::domain, &Scene::Domain::size>() reaches scene.domain.size.
template <auto... path>
constexpr auto member() {
    using T = std::remove_cvref_t<decltype((std::declval<Scene&>().*....*path))>;
    return Member<T>{[](const Scene& scene, std::size_t) -> const T& { return (scene.*....*path); },
                     [](Scene& scene, std::size_t) -> T& { return (scene.*....*path); }};
}

// block_member<&Scene::Block::size>() reaches scene.blocks[item].size.
template <auto last>
constexpr auto block_member() {
    using T = std::remove_cvref_t<decltype(std::declval<Scene::Block&>().*last)>;
    return Member<T>{
        [](const Scene& scene, std::size_t item) -> const T& { return scene.blocks[item].*last; },
        [](Scene& scene, std::size_t item) -> T& { return scene.blocks[item].*last; }};
}

using AnyMember =
    std::variant<Member<bool>, Member<double>, Member<int>, Member<std::uint64_t>, Member<std::string>,
                 Member<std::vector<double>>, Member<Points>, Member<std::vector<std::string>>,
                 Member<mpm::WallRule>, Member<mpm::PistonMotion>, Member<mpm::Moduli>,
                 Member<mpm::ShearReturn>, Member<mpm::WaterScheme>, Member<mpm::WaterTension>,
                 Member<mpm::Transfer>, Member<mpm::BodyContact>, Member<IceBase>, Member<BedShape>,
                 Member<Nodata>, Member<IceColors>, Member<Pattern>, Member<Softening>,
                 Member<HardeningLimit>, Member<Precision>, Member<analysis::WaveKind>>;

// Stages that read a key, as bits.
constexpr unsigned by(Stage stage) { return 1u << static_cast<unsigned>(stage); }
inline constexpr unsigned by_geometry = by(Stage::geometry);
inline constexpr unsigned by_simulate = by(Stage::simulate);
inline constexpr unsigned by_postprocess = by(Stage::postprocess);
inline constexpr unsigned by_all = by_geometry | by_simulate | by_postprocess;

struct Key {
    std::string_view name;  // "domain.cell_size"
    std::string_view unit = "";
    AnyMember member;
    Range range = {};
    std::string_view example = "";  // TOML; empty: the default
    std::string_view effect = "";   // empty: in every scene
    bool required = false;
    std::string_view instead = "";  // a key that, if set, says what this required one would
    bool per_dimension = false;     // a list with one number per dimension
    bool only_3d = false;
    unsigned stages = by_all;  // that read it
    bool changes_results = true;
    bool file = false;  // names a file that the stages read; what it holds counts too
    std::string_view help;

    std::string_view section() const;  // "domain"; empty for title, dimension, ...
    std::string_view last_name() const;
    // False for a key of an effect that the scene does not name, and for a 3D key in 2D.
    bool applies(const Scene& scene) const;
    // Whether its section may stand in the file several times, as [[block]].
    bool repeated() const;
    // How many members it has in the scene.
    std::size_t count(const Scene& scene) const;
    // "block.size"; of several "block.2.size" for item 1.
    std::string name_of(std::size_t item, const Scene& scene) const;
};

// In the order in which they are printed.
std::span<const Key> all_keys();

// Null if there is none.
const Key* find_key(std::string_view name);

// Names that `effects` may hold.
std::span<const std::string> known_effects();

// "a number in m", "one of "slip", "stick" or "separate"".
std::string type_text(const Key& key);

// The key's value in the scene, as TOML.
std::string value_text(const Key& key, const Scene& scene, std::size_t item = 0);

// Sets the key's member. Returns what is wrong with the value and what is right, or an empty text; then the
// scene is as before.
std::string set_value(const Key& key, const Value& value, Scene& scene, std::size_t item = 0);

}  // namespace tidewater::scene
