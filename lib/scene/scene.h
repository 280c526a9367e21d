// A scene: everything that a run is made of, as read from one TOML file and --set options.
//
// Each member below is one key of the file ("domain.cell_size"), and its initialiser is the key's default.
// The table of keys (keys.h) adds its unit, range, help and the stages that read it. `effects` names the
// physics that is simulated: an effect's keys are a struct in effects/<effect>.h, and a key of an effect that
// is not named is an error. Vectors have one entry per dimension: (x, z) in 2D, (x, y, z) in 3D.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/box.h"
#include "mpm/boundaries/wall.h"
#include "mpm/particles/transfer.h"
#include "scene/effects/bed.h"
#include "scene/effects/cliff.h"
#include "scene/effects/cracks.h"
#include "scene/effects/crevasses.h"
#include "scene/effects/dem.h"
#include "scene/effects/fracture.h"
#include "scene/effects/ice.h"
#include "scene/effects/outlet.h"
#include "scene/effects/piston.h"
#include "scene/effects/push.h"
#include "scene/effects/rigid.h"
#include "scene/effects/settle.h"
#include "scene/effects/shelf.h"
#include "scene/effects/sponge.h"
#include "scene/effects/undercut.h"
#include "scene/effects/water.h"
#include "scene/effects/wave.h"
#include "scene/enum_names.h"
#include "scene/toml_document.h"

namespace tidewater::scene {

// In the order in which they run.
enum class Stage { geometry, simulate, postprocess };

// How particles fill a body at the start.
enum class Pattern { lattice, blue_noise };
template <>
inline constexpr std::array<std::string_view, 2> enum_names<Pattern>{"lattice", "blue_noise"};

enum class Precision { single_precision, double_precision };
template <>
inline constexpr std::array<std::string_view, 2> enum_names<Precision>{"float", "double"};

// What colours the ice in pictures.
enum class IceColors { damage, iceberg };
template <>
inline constexpr std::array<std::string_view, 2> enum_names<IceColors>{"damage", "iceberg"};

struct Scene {
    std::string title;
    int dimension = 2;
    std::vector<std::string> effects;
    std::uint64_t seed = 1;

    // The tank is the box from the origin to size.
    struct Domain {
        std::vector<double> size;                         // m
        double cell_size = 0.0;                           // Δx, m
        double gravity = 9.81;                            // m/s², downward
        mpm::WallRule wall_left = mpm::WallRule::slip;    // x = 0
        mpm::WallRule wall_right = mpm::WallRule::slip;   // x = size
        mpm::WallRule wall_front = mpm::WallRule::slip;   // y = 0, 3D
        mpm::WallRule wall_back = mpm::WallRule::slip;    // y = size, 3D
        mpm::WallRule wall_bottom = mpm::WallRule::slip;  // z = 0
        mpm::WallRule wall_top = mpm::WallRule::slip;     // z = size
    } domain;

    // The effects. A member holds its defaults where the scene does not name its effect.
    Water water;
    Wave wave;
    std::vector<Block> blocks = std::vector<Block>(1);  // effect "rigid"; at least one
    Ice ice;
    Fracture fracture;
    Cliff cliff;
    Undercut undercut;
    Crevasses crevasses;
    Cracks cracks;
    Dem dem;
    Shelf shelf;
    Bed bed;
    Push push;
    Piston piston;
    Outlet outlet;
    Sponge sponge;
    Settle settle;

    struct Particles {
        int per_axis = 2;  // particles per cell and axis: 2 gives 4 per cell in 2D, 8 in 3D
        Pattern pattern = Pattern::lattice;
        double jitter = 0.0;  // 0: in rows; 1: anywhere within the particle's own share of the cell
    } particles;

    // A gauge is at (x), in the middle of the tank's width, or in 3D at (x, y). A pressure gauge is at (x,
    // z), in 3D at (x, y, z).
    struct Simulate {
        double end_time = 0.0;           // s
        double snapshot_interval = 0.0;  // s
        double gauge_interval = 0.0;     // s, between rows of gauges.csv and ledger.csv; 0: row_interval
        Points gauges;                   // m
        Points pressure_gauges;          // m
        Precision precision = Precision::single_precision;
        double cfl = 0.5;
        mpm::Transfer transfer = mpm::Transfer::apic;
        double checkpoint_interval = 300.0;  // s of wall time; 0: only when stopped
    } simulate;

    // Volumes are areas in 2D. The help texts in keys_postprocess.cpp say what each key means.
    struct Postprocess {
        Points gauges;                      // m; read from the snapshots
        std::vector<double> picture_times;  // s; empty: five, evenly spread
        double picture_interval = 0.0;      // s; 0: picture_times
        int picture_width = 1600;           // pixels
        double picture_speed = 0.0;         // m/s; 0: the maximum of the run
        IceColors picture_ice = IceColors::damage;
        std::vector<double> picture_window;  // m, (x0, z0, x1, z1); empty: the whole tank
        int decimation = 1;                  // 1 in so many particles goes to ParaView; 0: none
        bool surfaces = true;
        double arrival_threshold = 0.05;      // share of the maximum amplitude at the gauge
        double iceberg_damage = 0.5;          // share of its strength that failed ice has lost
        std::vector<std::string> references;  // "quantity min max source"
        double iceberg_share = 0.05;          // minimum volume of an iceberg over the ice's height² × width
        double iceberg_reach = 1.5;           // particle spacings
        double iceberg_volume = 0.0;          // m³, minimum; 0: a cube of two cells
        double calving_window = 0.0;          // s; 0: a tenth of the run
    } postprocess;

    bool has(std::string_view effect) const;
};

// "geometry", "simulate" or "postprocess".
std::string_view stage_name(Stage stage);
std::optional<Stage> stage_named(std::string_view name);

// One --set option.
struct Override {
    std::string key;    // "domain.cell_size"
    std::string value;  // TOML; anything else, such as a bare word, is taken as text
};

// Splits "key=value". Throws SceneError if there is no '='.
Override parse_override(std::string_view text);

// Reads a scene, applies the overrides, and checks every key and the keys against each other. If two
// overrides set one key, the last counts. Throws SceneError with all problems, one line for each: "file:line:
// key: what is wrong; what to do". Throws InputError if the file cannot be read.
Scene read_scene(const std::filesystem::path& file, const std::vector<Override>& overrides = {});

// Bodies of a 2D scene reach so many cells to each side of y = 0. This keeps the ends in y outside the band
// of a level set that is cut by that plane.
inline constexpr double plane_half_width = 4.0;

// The box with this centre and these edges, given as vectors of the scene's dimension in m, and turned by
// `degrees` from x towards z.
geometry::Box make_box(const Scene& scene, const std::vector<double>& center, const std::vector<double>& size,
                       double degrees = 0.0);

// The distance between two particles of a lattice, m.
double particle_spacing(const Scene& scene);

// The time between rows of the tables, s: simulate.gauge_interval or, where that is 0, a tenth of
// simulate.snapshot_interval or the time in which sound crosses ten cells of water, whichever is longer,
// rounded up to 1, 2 or 5 times a power of ten. The latter is some twenty steps, of which a row costs two a
// part, and hardly more than the fastest wave takes to cross one cell.
double row_interval(const Scene& scene);

// What is allowed but probably not meant, one line each.
std::vector<std::string> scene_warnings(const Scene& scene);

// The scene as TOML: every key of its effects with its value, and with unit and help as comments. It reads
// back to the same Scene and to the same text.
std::string resolved_text(const Scene& scene);

// The lines of resolved_text that `stage` reads, without comments and without keys that change no result. The
// stage has to run again if they change. A stage does not read what the stages before it have decided for it.
std::string stage_part(const Scene& scene, Stage stage);

// A fingerprint of all keys that change the results of `stage` or of a stage before it, for provenance.
// Results keep their bytes when only keys change that later stages read.
std::string scene_hash(const Scene& scene, Stage stage);

// The lines of resolved_text with these keys, without comments: what a result that depends on them was made
// with. A name that ends in a dot stands for all keys of that section. Keys that do not apply to the scene or
// change no result are left out. Throws std::invalid_argument for a name that is neither a key's nor a
// section's.
std::string values_of(const Scene& scene, std::span<const std::string_view> names);

// The reference of all keys, each with its type, unit, default, range, effect, stages and help.
std::string key_reference();

}  // namespace tidewater::scene
