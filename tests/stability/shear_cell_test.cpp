// Failed ice, sheared under pressure to several times its thickness: a heavy rigid slab rides over it.
#include <doctest/doctest.h>

#include <string>

#include "support/box.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

constexpr double thick = 4.0;  // of the layer, m

// A layer of ice on a rough floor below a slab that presses at 0.5 MPa and moves at 10 m/s.
template <int D>
Start<D> shear_cell(bool cap) {
    constexpr double length = 16.0, end = thick + 3.0;
    auto start = test::ice_box<D>({}, 9.81);
    start.cells.fill(4);
    start.cells[0] = 48, start.cells[D - 1] = 12;
    start.parameters.ice.cap_hardening = cap;
    start.parameters.boundaries.walls[D - 1][0] = WallRule::stick;
    Vector<D, double> low = Vector<D, double>::Zero(), high = Vector<D, double>::Constant(4.0);
    low[0] = 2.0, high[0] = 2.0 + length, high[D - 1] = thick;
    test::add_ice<D>(test::box_shape<D>(low, high), start);
    low[D - 1] = thick, high[D - 1] = end;
    start.rigid.push_back({.size = high - low,
                           .center = 0.5 * (low + high),
                           .density = 0.5e6 / 9.81 / (end - thick),
                           .contact = BodyContact::stick,
                           .velocity = 10.0 * Vector<D, double>::Unit(0)});
    return start;
}

// The greatest βp0 of the ice, Pa.
template <int D, class Real>
double greatest_strength(const Simulation<D, Real>& s) {
    const IceModel& ice = s.parameters.ice;
    double hardest = 0.0;
    for (const Real alpha : s.bodies[0].alpha) hardest = std::min(hardest, static_cast<double>(alpha));
    return ice.beta * ice.bulk_modulus(D) * std::min(std::sinh(-ice.hardening * hardest), 0.45);
}

}  // namespace

TEST_CASE_TEMPLATE("failed ice is sheared under pressure by more than its thickness", Engine,
                   test::Engine<2, float>, test::Engine<2, double>, test::Engine<3, float>) {
    for (const bool cap : {true, false}) {
        auto s = make_simulation<Engine::D, typename Engine::Real>(shear_cell<Engine::D>(cap));
        for (auto& alpha : s.bodies[0].alpha) alpha = 0;
        const double from = s.rigid[0].center[0];
        test::check_run(1.5, s);
        const double strength = greatest_strength(s), at_start = s.parameters.ice.beta_p0;
        MESSAGE((cap ? std::string("capped") : std::string("uncapped"))
                << ", sheared by " << (s.rigid[0].center[0] - from) / thick << ", strength " << strength);
        CHECK(s.rigid[0].center[0] - from > thick);
        CHECK((strength > 1.01 * at_start) != cap);
    }
}
