// A cantilever of elastic ice, 100 m long and 40 m high, sags and swings as beams do.
#include <doctest/doctest.h>

#include "support/beam.h"

using namespace tidewater;
using namespace tidewater::mpm;
using test::Cantilever;

TEST_CASE("finite elements and Timoshenko's beam agree for a slender cantilever") {
    Cantilever beam;
    beam.height = 5.0;
    const auto thin = test::TimoshenkoBeam(beam).answer();
    const auto plane = test::PlaneElements(beam, 40, 2).answer();
    CHECK(plane.sag == doctest::Approx(thin.sag).epsilon(0.005));
    CHECK(plane.frequency == doctest::Approx(thin.frequency).epsilon(0.005));
}

TEST_CASE("Timoshenko's beam without shear is Euler and Bernoulli's") {
    Cantilever beam;
    CHECK(test::TimoshenkoBeam(beam, 1e9).answer().sag == doctest::Approx(0.753).epsilon(0.001));
    beam.height = 0.4;  // of little rotatory inertia; the frequency goes with the height
    CHECK(test::TimoshenkoBeam(beam, 1e9).answer().frequency == doctest::Approx(0.00714).epsilon(0.001));
}

TEST_CASE(
    "a cantilever of 40 cells sags and swings as plane elasticity says, and within 3 % of Timoshenko's "
    "beam") {
    for (const Moduli moduli : {Moduli::plane_strain, Moduli::paper}) {
        Cantilever beam;
        beam.ice.moduli = moduli;
        const auto expected = test::TimoshenkoBeam(beam).answer();
        const auto plane = test::PlaneElements(beam, 40, 16).answer();
        const auto engine = test::Beam<float>(beam, 40).measure(expected.frequency);
        MESSAGE("sag " << engine.sag << " m, expected " << plane.sag << " and " << expected.sag
                       << "; frequency " << engine.frequency << " Hz, expected " << plane.frequency << " and "
                       << expected.frequency);
        CHECK(engine.sag == doctest::Approx(plane.sag).epsilon(0.002));
        CHECK(engine.frequency == doctest::Approx(plane.frequency).epsilon(0.002));
        CHECK(engine.sag == doctest::Approx(expected.sag).epsilon(0.03));
        CHECK(engine.frequency == doctest::Approx(expected.frequency).epsilon(0.03));
    }
}
