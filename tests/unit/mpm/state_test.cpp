#include "mpm/state.h"

#include <doctest/doctest.h>

#include <map>
#include <set>

#include "support/tank.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

// A block that turns as it falls into water, far enough from the corner that particles change their blocks.
template <int D>
Start<D> start_of() {
    Index<D> cells;
    cells.fill(D == 2 ? 20 : 9);
    cells[D - 1] = D == 2 ? 24 : 12;
    Vector<D, double> corner = Vector<D, double>::Constant(D == 2 ? 0.33 : 0.24);
    corner[D - 1] = D == 2 ? 0.55 : 0.35;
    return test::tank_start<D>(0.05, cells, D == 2 ? 0.6 : 0.4, 20.0, 0.2, corner, 2, 0.5);
}

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

template <int D, class Real>
void goes_on_the_same() {
    for (const int before : {0, 1, 150}) {
        auto s = make_simulation<D, Real>(start_of<D>());
        steps(s, before);
        const Saved state = saved(s);

        auto loaded = make_simulation<D, Real>(start_of<D>());
        visit_state(loaded, [&](const std::string& name, auto& value) { from_bytes(state.at(name), value); });
        relink(loaded);
        CHECK(state_hash(loaded) == state_hash(s));
        CHECK(saved(loaded) == state);

        steps(s, 150);
        steps(loaded, 150);
        CHECK(state_hash(loaded) == state_hash(s));
        CHECK(saved(loaded) == saved(s));
    }
}

}  // namespace

TEST_CASE("a loaded state is the saved one and has the same future, in 2D and 3D, float and double") {
    goes_on_the_same<2, float>();
    goes_on_the_same<2, double>();
    goes_on_the_same<3, float>();
    goes_on_the_same<3, double>();
}

TEST_CASE("saving changes nothing") {
    auto s = make_simulation<2, float>(start_of<2>());
    auto untouched = make_simulation<2, float>(start_of<2>());
    for (int n = 0; n < 20; ++n) {
        saved(s);
        steps(s, 1);
        steps(untouched, 1);
    }
    CHECK(saved(s) == saved(untouched));
}
