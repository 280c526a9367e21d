#include "mpm/state/state.h"

#include <doctest/doctest.h>

#include <initializer_list>

#include <algorithm>
#include <map>
#include <vector>

#include "support/mixed_tank.h"
#include "support/rough_ground.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

template <class T>
std::string bytes_of(const std::vector<T>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}
template <class T>
std::string bytes_of(const T& value) {
    return {reinterpret_cast<const char*>(&value), sizeof value};
}
template <class T>
void from_bytes(const std::string& bytes, std::vector<T>& values) {
    values.resize(bytes.size() / sizeof(T));
    std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(values.data()));
}
template <class T>
void from_bytes(const std::string& bytes, T& value) {
    std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(&value));
}

using Saved = std::map<std::string, std::string>;

template <int D, class Real>
Saved saved(Simulation<D, Real>& s) {
    Saved values;
    visit_state(s, [&](const std::string& name, auto& value) {
        CHECK_MESSAGE(values.emplace(name, bytes_of(value)).second, name);
    });
    return values;
}

template <int D, class Real>
void steps(Simulation<D, Real>& s, int count) {
    for (int n = 0; n < count; ++n) advance(s, stable_time_step(s));
}

// The order of all bodies' particles, which only sorting changes.
template <int D, class Real>
std::vector<std::vector<std::uint32_t>> orders(const Simulation<D, Real>& s) {
    std::vector<std::vector<std::uint32_t>> ids;
    for (const auto& particles : s.bodies) ids.push_back(particles.id);
    return ids;
}

// The ice has been strained and part of it has failed, so that its columns are not those of the start.
template <int D, class Real>
void check_ice_has_failed(const Simulation<D, Real>& s) {
    const auto& ice = s.bodies[1];
    REQUIRE(ice.material == Material::ice);
    const auto initial = static_cast<Real>(s.parameters.ice.initial_alpha(D));
    for (const auto& column : ice.strain) CHECK(std::ranges::any_of(column, [](Real e) { return e != 0; }));
    CHECK(std::ranges::any_of(ice.alpha, [&](Real alpha) { return alpha != initial; }));
}

template <int D, class Real>
void goes_on_the_same(const Start<D>& start) {
    const bool has_ice = start.bodies.size() == 2;
    for (const int before : {0, 1, 200}) {
        CAPTURE(before);
        auto s = make_simulation<D, Real>(start);
        steps(s, before);
        if (before == 200 && has_ice) check_ice_has_failed(s);
        const Saved state = saved(s);

        auto loaded = make_simulation<D, Real>(start);
        visit_state(loaded, [&](const std::string& name, auto& value) { from_bytes(state.at(name), value); });
        REQUIRE(relink(loaded));
        CHECK(state_hash(loaded) == state_hash(s));
        CHECK(saved(loaded) == state);
        CHECK(loaded.dt == s.dt);
        CHECK((before == 0) == (loaded.dt == 0.0));

        const auto order = orders(s);
        steps(s, 200);
        steps(loaded, 200);
        CHECK((orders(s) != order || !has_ice));  // the block alone changes its blocks late
        CHECK(state_hash(loaded) == state_hash(s));
        CHECK(saved(loaded) == saved(s));
        const bool skims = start.parameters.boundaries.sponge.exists();
        CHECK((!skims || before < 200 || !s.skimming.due.empty()));
    }
}

template <int D>
void goes_on_the_same() {
    auto sponge = test::dropped_block_start<D>();
    const double level = sponge.bodies[0].surface;
    sponge.parameters.boundaries.sponge = {.from = 0.1, .width = 0.4, .rate = 100.0, .level = level};
    for (const auto& start :
         {test::dropped_block_start<D>(), sponge, test::on_rough_ground(test::mixed_tank<D>())}) {
        CAPTURE(start.bodies.size());
        goes_on_the_same<D, float>(start);
        goes_on_the_same<D, double>(start);
    }
}

}  // namespace

TEST_CASE_TEMPLATE("a loaded state is the saved one and has the same future, for all kinds in one tank",
                   Dimension, std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    goes_on_the_same<Dimension::value>();
}

TEST_CASE_TEMPLATE("what is saved holds every column, the nodes and the time step", Dimension,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    constexpr int D = Dimension::value;
    auto s = make_simulation<D, float>(test::mixed_tank<D>());
    steps(s, 2);
    const Saved state = saved(s);
    std::vector<std::string> names{"dt",      "nodes",         "particle_blocks",
                                   "body0.j", "rigid0.center", "body1.alpha"};
    for (int column = 0; column < symmetric_size<D>; ++column)
        names.push_back("body1.strain_" + std::to_string(column));
    for (const std::string& name : names) {
        CAPTURE(name);
        REQUIRE(state.contains(name));
        CHECK(!state.at(name).empty());
    }
}

TEST_CASE("arrays that do not fit each other are not linked") {
    const auto start = test::mixed_tank<2>();
    auto s = make_simulation<2, float>(start);
    steps(s, 2);
    const Saved state = saved(s);
    const auto is_linked = [&](const std::string& changed, std::size_t bytes_less) {
        auto loaded = make_simulation<2, float>(start);
        visit_state(loaded, [&](const std::string& name, auto& value) {
            from_bytes(name == changed ? state.at(name).substr(bytes_less) : state.at(name), value);
        });
        return relink(loaded);
    };
    CHECK(is_linked("", 0));
    CHECK(!is_linked("nodes", sizeof(Node<float>)));
    CHECK(!is_linked("particle_blocks", sizeof(BlockKey)));
    CHECK(!is_linked("body0.begin", sizeof(std::uint32_t)));
    CHECK(!is_linked("body0.j", sizeof(float)));
    CHECK(!is_linked("body0.position_x", sizeof(Stored<float>)));
    CHECK(!is_linked("body1.strain_1", sizeof(float)));
    CHECK(!is_linked("body1.alpha", sizeof(float)));
}

TEST_CASE("saving changes nothing") {
    auto s = make_simulation<2, float>(test::mixed_tank<2>());
    auto untouched = make_simulation<2, float>(test::mixed_tank<2>());
    for (int n = 0; n < 20; ++n) {
        saved(s);
        steps(s, 1);
        steps(untouched, 1);
    }
    CHECK(saved(s) == saved(untouched));
}
