// Ice that is torn, crushed to nothing and pushed together again.
#include <doctest/doctest.h>

#include "core/error.h"
#include "support/box.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

// A bar along x in an empty box, whose points fly apart, or at each other, at this rate (1/s).
template <int D>
Start<D> stretched_bar(const IceModel& ice, double rate) {
    auto start = test::long_ice_box<D>(60, D == 2 ? 16 : 10);
    start.parameters.ice = ice;
    const auto middle = test::middle_of<D>(start);
    Vector<D, double> half = Vector<D, double>::Constant(D == 2 ? 3.0 : 1.5);
    half[0] = 12.0;
    auto& body = test::add_ice<D>(test::box_shape<D>(middle - half, middle + half), start);
    const Vector<D, double> along = Vector<D, double>::Unit(0);
    test::set_motion<D>(middle, Vector<D, double>::Zero(), rate * along * along.transpose(), body);
    return start;
}

// βξ > 1, and so without stability at a point.
IceModel snapping_ice(double hardening) {
    IceModel ice;
    ice.beta = 1.0;
    ice.hardening = hardening;
    return ice;
}

}  // namespace

TEST_CASE_TEMPLATE("a bar whose ice snaps is torn apart", Engine, TIDEWATER_ENGINES) {
    for (const double hardening : {3.0, 30.0}) {
        auto s = make_simulation<Engine::D, typename Engine::Real>(
            stretched_bar<Engine::D>(snapping_ice(hardening), 1.0));
        test::check_run(0.3, s);
        CHECK(test::failed_share(s.bodies[0]) > 0.05);
    }
}

TEST_CASE_TEMPLATE("torn ice that is pushed together again stays in the box", Engine, TIDEWATER_ENGINES) {
    for (const bool cap : {true, false}) {
        IceModel ice = snapping_ice(3.0);
        ice.cap_hardening = cap;
        auto s = make_simulation<Engine::D, typename Engine::Real>(stretched_bar<Engine::D>(ice, 1.0));
        test::check_run(0.2, s);
        CHECK(test::failed_share(s.bodies[0]) > 0.05);
        for (auto& node : s.grid.nodes) node.template head<Engine::D>() *= typename Engine::Real(-1);
        test::check_run(0.6, s);
    }
}

// A step moves nothing by more than half a cell, so no trial of one step inverts; but points that close
// faster than sound leave no volume within a few.
TEST_CASE_TEMPLATE("ice that fails can be driven together faster than sound", Engine, TIDEWATER_ENGINES) {
    for (const double rate : {-300.0, 300.0}) {  // up to 3600 m/s
        CAPTURE(rate);
        auto s =
            make_simulation<Engine::D, typename Engine::Real>(stretched_bar<Engine::D>(IceModel{}, rate));
        test::check_run(0.05, s);
    }
}

TEST_CASE_TEMPLATE("elastic ice without volume stops the run and names step and particle", Engine,
                   TIDEWATER_ENGINES) {
    IceModel ice;
    ice.fracture = false;
    auto s = make_simulation<Engine::D, typename Engine::Real>(stretched_bar<Engine::D>(ice, -2000.0));
    CHECK_THROWS_WITH_AS(test::check_run(0.05, s), doctest::Contains("phase pass: ice particle "),
                         NumericsError);
}
