// A scene: everything that a run is made of, as read from one TOML file and --set options.
//
// Each member below is one key of the file ("domain.cell_size"), declared once in keys.cpp with its unit,
// check, help and the stages that read it; its initialiser here is its default. `effects` names the physics
// that is simulated; a key of an effect that is not named is an error. Vectors have one entry per dimension:
// (x, z) in 2D, (x, y, z) in 3D.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/wave_theory.h"
#include "geometry/box.h"
#include "geometry/polygon.h"
#include "geometry/profile.h"
#include "mpm/bodies/rigid.h"
#include "mpm/boundaries/boundaries.h"
#include "mpm/materials/ice.h"
#include "mpm/materials/water.h"
#include "mpm/state/simulation.h"
#include "scene/toml_document.h"

namespace tidewater::scene {

enum class Stage { geometry, simulate, postprocess };  // in the order in which they run
enum class Softening { paper, crack_band };            // how ξ follows from the keys
enum class HardeningLimit { start, none };
enum class IceBase { given, bed, floating };                  // what the ice's lower side follows
enum class BedShape { straight, smooth };                     // of the ground between corners
enum class Nodata { refuse, fill };                           // of an elevation model's holes
enum class IceColors { damage, iceberg };                     // of pictures
enum class Pattern { lattice, blue_noise };                   // of particles
enum class Precision { single_precision, double_precision };  // "float", "double" in the file

struct Scene {
    std::string title;
    int dimension = 2;
    std::vector<std::string> effects;  // of known_effects()
    std::uint64_t seed = 1;

    struct Domain {
        std::vector<double> size;                         // m; the tank is the box from the origin to size
        double cell_size = 0.0;                           // Δx, m
        double gravity = 9.81;                            // m/s², downward
        mpm::WallRule wall_left = mpm::WallRule::slip;    // x = 0
        mpm::WallRule wall_right = mpm::WallRule::slip;   // x = size
        mpm::WallRule wall_front = mpm::WallRule::slip;   // y = 0, 3D
        mpm::WallRule wall_back = mpm::WallRule::slip;    // y = size, 3D
        mpm::WallRule wall_bottom = mpm::WallRule::slip;  // z = 0
        mpm::WallRule wall_top = mpm::WallRule::slip;     // z = size
    } domain;

    struct Water {                  // effect "water"
        double depth = 0.0;         // m, of the still water
        double submergence = -1.0;  // D/H, from which depth follows; negative: depth is given
        double length = 0.0;        // m, from the left wall; 0: the whole tank
        mpm::WaterModel model;      // water.density, .sound_speed, .exponent, .scheme, .tension
    } water;

    struct Wave {  // effect "wave": the water starts as a wave
        analysis::WaveKind kind = analysis::WaveKind::standing;
        double height = 0.0;  // a, m
        double length = 0.0;  // of a standing wave, m
        double center = 0.0;  // of a solitary wave's crest at the start, m
    } wave;

    struct Block {                   // effect "rigid"
        std::vector<double> size;    // m
        std::vector<double> center;  // m, at t = 0
        double angle = 0.0;          // degrees, turned in the x–z plane from x towards z
        double density = 920.0;      // kg/m³
        mpm::BodyContact contact = mpm::BodyContact::slip;
        double friction = 0.0;         // Coulomb's coefficient, of contact = slip
        std::vector<double> velocity;  // m/s, at t = 0
        double spin = 0.0;             // degrees/s, at t = 0; from x towards z
    };
    std::vector<Block> blocks = std::vector<Block>(1);  // [block] or [[block]]; one at least

    struct Ice {                      // effect "ice"
        std::vector<double> size;     // m
        std::vector<double> corner;   // m, the lowest one; at t = 0
        std::vector<double> profile;  // m: x0, z0, x1, z1, … of an outline; size and corner are its box
        std::string profile_file;
        IceBase base = IceBase::given;
        mpm::IceModel model;  // ice.density, ice.youngs_modulus, ice.poisson_ratio, ice.moduli
    } ice;

    struct Fracture {  // effect "fracture"; fracture.strength, .beta, .friction, .hardening and
                       // .shear_return are members of ice.model
        Softening softening = Softening::paper;
        double energy = 0.0;  // J/m², of crack_band
        HardeningLimit hardening_limit = HardeningLimit::start;
    } fracture;

    struct Cliff {                     // effect "cliff": the front is irregular
        double amplitude = 0.0;        // m
        double wavelength = 100.0;     // m, along y, 3D
        double wavelength_up = 100.0;  // m, along z
    } cliff;

    struct Undercut {         // effect "undercut": a notch in the front
        double depth = 0.0;   // m, along x
        double height = 0.0;  // m
        double below = 0.0;   // m, of its upper edge below the still water
    } undercut;

    struct Crevasses {                            // effect "crevasses"
        double spacing = 0.0;                     // m, along x
        std::vector<double> depth{20.0, 50.0};    // m, least and greatest
        std::vector<double> opening{5.0, 10.0};   // m, least and greatest
        double from = 0.0, to = 0.0;              // m, along x; to 0: up to the front
        double angle = 0.0;                       // degrees, in plan
        double length = 0.0;                      // m, across the flow; 0: all of it
        double wander = 0.0, wavelength = 200.0;  // m
    } crevasses;

    struct Cracks {              // effect "cracks": Voronoi cells
        double cell_size = 0.0;  // m
        double width = 0.0;      // m
        double cohesion = 0.0;   // of intact ice
    } cracks;

    struct Dem {                     // effect "dem": elevation models
        std::string bed, surface;    // files
        std::vector<double> origin;  // m, (east, north)
        double azimuth = 90.0;       // degrees
        double datum = 0.0;          // m
        double freeboard = 5.0;      // m, the least of ice
        std::string crs;
        Nodata nodata = Nodata::refuse;
    } dem;

    struct Shelf {             // effect "shelf"
        double length = 0.0;   // m, from the left wall
        double height = 0.0;   // m, above the bottom
        double retreat = 0.0;  // m/s
        mpm::WallRule wall = mpm::WallRule::separate;
    } shelf;

    struct Bed {                      // effect "bed"
        std::vector<double> profile;  // m: x0, z0, x1, z1, …
        std::string profile_file;
        BedShape shape = BedShape::straight;
        mpm::WallRule wall = mpm::WallRule::separate;
    } bed;

    struct Push {            // effect "push"
        double speed = 0.0;  // m/s
        double ramp = 0.0;   // s
    } push;

    struct Piston {  // effect "piston"
        mpm::PistonMotion motion = mpm::PistonMotion::solitary;
        double height = 0.0;     // m, of the wave; solitary
        double amplitude = 0.0;  // m, half of the stroke; sine
        double period = 0.0;     // s; sine
        double ramp = 0.0;       // s; sine
    } piston;

    struct Outlet {          // effect "outlet"
        double width = 0.0;  // m, up to the right wall
    } outlet;

    struct Sponge {              // effect "sponge"
        double width = 0.0;      // m, up to the right wall
        double strength = 10.0;  // σ at the wall over √(g water.depth)/width
    } sponge;

    struct Settle {               // effect "settle"
        double tolerance = 1e4;   // Pa
        double max_time = 100.0;  // s
    } settle;

    struct Particles {
        int per_axis = 2;  // particles per cell and axis: 2 gives 4 per cell in 2D, 8 in 3D
        Pattern pattern = Pattern::lattice;
        double jitter = 0.0;  // 0: in rows; 1: anywhere within the particle's own share of the cell
    } particles;

    struct Simulate {
        double end_time = 0.0;           // s
        double snapshot_interval = 0.0;  // s
        double gauge_interval = 0.01;    // s, between rows of gauges.csv and ledger.csv
        Points gauges;           // (x), in 3D also (x, y), of each gauge, m; (x): the middle of the width
        Points pressure_gauges;  // (x, z), in 3D (x, y, z), m
        Precision precision = Precision::single_precision;
        double cfl = 0.5;
        mpm::Transfer transfer = mpm::Transfer::apic;
        double checkpoint_interval = 300.0;  // s of wall time; 0: only when stopped
    } simulate;

    struct Postprocess {
        Points gauges;                      // further gauges, read from the snapshots
        std::vector<double> picture_times;  // s; empty: five, evenly spread
        double picture_interval = 0.0;      // s, between pictures; 0: picture_times
        int picture_width = 1600;           // pixels
        double picture_speed = 0.0;         // m/s, the colour scale's upper end; 0: the run's own
        IceColors picture_ice = IceColors::damage;
        std::vector<double> picture_window;  // m: x0, z0, x1, z1 of the part to draw; empty: all
        int decimation = 1;                  // of the particles for ParaView one in so many is kept; 0: none
        bool surfaces = true;                // of water and bodies, for ParaView
        double arrival_threshold =
            0.05;  // a wave has arrived at this share of the gauge's greatest amplitude
        double iceberg_damage =
            0.5;  // effect "fracture": ice that lost this share of its strength has failed
        std::vector<std::string> references;  // "quantity least greatest source"
        double iceberg_share = 0.05;  // likewise: an iceberg's least volume, over the ice's height² × width
        double iceberg_reach = 1.5;   // effect "ice": of a connection, in particle spacings
        double iceberg_volume = 0.0;  // m³ (2D: m²): least of an iceberg that is followed; 0: two cells' cube
        double calving_window = 0.0;  // s, over which the calving rate is taken; 0: a tenth of the run
    } postprocess;

    bool has(std::string_view effect) const;
};

// "geometry", ...
std::string_view stage_name(Stage stage);
std::optional<Stage> stage_named(std::string_view name);

// One --set option.
struct Override {
    std::string key;    // "domain.cell_size"
    std::string value;  // TOML; what is not TOML, like a bare word, is taken as text
};

// Splits "key=value". Throws SceneError if there is no '='.
Override parse_override(std::string_view text);

// Reads, applies the overrides (of two for one key the last counts), checks every key and the keys against
// each other. Throws SceneError with one line per problem, all of them, each "file:line: key: what is wrong;
// what to do"; InputError if the file cannot be read.
Scene read_scene(const std::filesystem::path& file, const std::vector<Override>& overrides = {});

// The ice of a scene as the engine takes it: with ξ from the crack band where the scene asks for it.
mpm::IceModel ice_model(const Scene& scene);

// In 2D bodies reach four cells to each side of y = 0, so that a level set's band in that plane knows of no
// end in y.
inline constexpr double plane_half_width = 4.0;

// The box with this centre and these edges, vectors of the scene's dimension in m; turned by `degrees` from x
// towards z.
geometry::Box make_box(const Scene& scene, const std::vector<double>& center, const std::vector<double>& size,
                       double degrees = 0.0);
geometry::Box block_box(const Scene& scene, const Scene::Block& block);
geometry::Box ice_box(const Scene& scene);
// In the x–z plane: of ice.profile, or of that box.
geometry::Polygon ice_outline(const Scene& scene);

// The ground of a scene with the effect "bed".
geometry::Profile bed_profile(const Scene& scene);

// The wave that the water of a scene with the effect "wave" starts as.
analysis::InitialWave initial_wave(const Scene& scene);

// What is allowed but probably not meant, one line each.
std::vector<std::string> scene_warnings(const Scene& scene);

// The scene as TOML: every key of its effects with its value, unit and help as comments. Reads back to the
// same Scene, and to the same text.
std::string resolved_text(const Scene& scene);

// The lines of resolved_text that `stage` reads, without comments and without keys that change no result:
// what has to change for the stage to run again. Every stage reads what the stages before it do not already
// decide for it.
std::string stage_part(const Scene& scene, Stage stage);

// Fingerprint of all keys that change the results of `stage` or of a stage before it, for provenance: results
// keep their bytes when a key changes that only later stages read.
std::string scene_hash(const Scene& scene, Stage stage);

// The lines of resolved_text with these keys, without comments: what a result that depends on them was made
// with. A name ending in a dot stands for all keys of that section. Keys that do not apply to the scene, or
// change no result, are left out. Throws std::invalid_argument if a name is no key's and no section's.
std::string values_of(const Scene& scene, std::span<const std::string_view> names);

// The reference of all keys: name, type, unit, default, valid range, effect, stages, help.
std::string key_reference();

}  // namespace tidewater::scene
