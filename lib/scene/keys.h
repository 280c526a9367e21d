// The table of keys. Each key of a scene is declared once: those of an effect in effects/<effect>.cpp, the
// others in keys_scene.cpp, keys_simulate.cpp and keys_postprocess.cpp. Reading, --set, checks, printing, the
// stages' parts and the reference are derived from this table. The default of a key is the initialiser of its
// member.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "scene/member.h"
#include "scene/scene.h"
#include "scene/toml_document.h"

namespace tidewater::scene {

// The numbers that a key allows: min ≤ x ≤ max, or min < x ≤ max if the range is open. In a list, each number
// must lie in it.
struct Range {
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    bool open = false;
    bool infinite = false;  // inf is allowed too

    // False for NaN, and for infinities unless `infinite` allows inf.
    bool contains(double number) const;
    // "above 0 m", "from 0 to 1"; empty if every number is allowed.
    std::string text(std::string_view unit) const;
};

inline constexpr Range positive{.min = 0.0, .open = true};
inline constexpr Range not_negative{.min = 0.0};

// Sets of stages, one bit for each.
constexpr unsigned by(Stage stage) { return 1u << static_cast<unsigned>(stage); }
inline constexpr unsigned by_geometry = by(Stage::geometry);
inline constexpr unsigned by_simulate = by(Stage::simulate);
inline constexpr unsigned by_postprocess = by(Stage::postprocess);
inline constexpr unsigned by_all = by_geometry | by_simulate | by_postprocess;

struct Key {
    std::string_view name;  // "domain.cell_size"
    std::string_view unit = "";
    Member member;
    Range range = {};
    std::string_view example = "";  // TOML; if it is empty, the default is the example
    std::string_view effect = "";   // if it is empty, the key is in every scene
    bool required = false;
    std::string_view instead = "";    // a key that makes this required one unnecessary
    std::string_view points_of = "";  // this key names a table of points, from which that key is read
    bool per_dimension = false;       // a list with one number per dimension
    bool only_3d = false;
    unsigned stages = by_all;  // those that read it
    bool changes_results = true;
    bool retired = false;  // still read, for scenes of old, but neither listed nor printed
    bool file = false;     // it names a file that the stages read, and what that holds counts too
    std::string_view help;

    // "domain"; empty for title, dimension, ...
    std::string_view section() const;
    std::string_view last_name() const;
    // False for a key of an effect that the scene does not name, and for a 3D key in 2D.
    bool applies(const Scene& scene) const;
    // Whether its section may stand in the file several times, under double brackets.
    bool repeated() const;
    // How often its section stands in the scene.
    std::size_t count(const Scene& scene) const;
    // "block.size", or "block.2.size" for item 1 of several.
    std::string name_of(std::size_t item, const Scene& scene) const;
};

// All keys in the order in which they are printed.
std::span<const Key> all_keys();

// Null if there is none.
const Key* find_key(std::string_view name);

// The sections that may stand in a file several times.
std::span<const std::string> repeated_sections();

// "a number in m", "one of "slip", "stick" or "separate"".
std::string type_text(const Key& key);

// The key's value in the scene, as TOML.
std::string value_text(const Key& key, const Scene& scene, std::size_t item = 0);

// Sets the key's member. Returns what is wrong with the value and what is right, or an empty text. If
// something is wrong, the scene stays as it is.
std::string set_value(const Key& key, const Value& value, Scene& scene, std::size_t item = 0);

}  // namespace tidewater::scene
