#include "analysis/iceberg_track.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "analysis/fragments.h"
#include "core/random.h"

using namespace tidewater;
using namespace tidewater::analysis;

namespace {

constexpr std::uint32_t gone = Fragments::none;

using Labels = std::vector<std::uint32_t>;

// Follows frames of ten particles; `seed` shuffles the particles and renames labels 0, 1, 2.
IcebergTracks follow(const std::vector<Labels>& frames, std::uint64_t seed,
                     std::vector<Labels>& of_particles) {
    IcebergTracks tracks;
    double time = 0.0;
    for (const Labels& labels : frames) {
        std::vector<std::uint64_t> order(labels.size());
        std::iota(order.begin(), order.end(), 0u);
        std::ranges::sort(order, {}, [&](std::uint64_t i) { return random_uniform(seed, 0, i); });
        Labels shuffled;
        for (const std::uint64_t i : order) {
            shuffled.push_back(labels[i] == gone ? gone : static_cast<std::uint32_t>((labels[i] + seed) % 3));
        }
        const std::vector<float> volume(labels.size(), 2.0f);
        const auto found = follow_icebergs({time++, order, shuffled, volume}, tracks);
        Labels of_particle(labels.size(), gone);
        for (std::size_t i = 0; i < order.size(); ++i) {
            if (shuffled[i] != gone) of_particle[order[i]] = found[shuffled[i]];
        }
        of_particles.push_back(of_particle);
    }
    return tracks;
}

}  // namespace

TEST_CASE("a block that splits, merges and melts keeps its ids, in any order of particles") {
    const std::vector<Labels> frames{{0, 0, 0, 0, 0, 0, 0, 0, 0, 0},
                                     {1, 1, 1, 1, gone, 0, 0, 0, 0, 0},  // the larger piece keeps 0
                                     {0, 0, 0, 0, gone, 1, 1, 1, 2, 2},  // and splits again
                                     {0, 0, 0, 0, 0, 0, 0, 0, 2, 2},     // 0 and 1 merge; 1 has more
                                     {gone, gone, gone, gone, gone, gone, gone, gone, 0, 0},
                                     {}};
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        std::vector<Labels> icebergs;
        const IcebergTracks tracks = follow(frames, seed, icebergs);
        CHECK(icebergs[0] == Labels(10, 0));
        CHECK(icebergs[1] == Labels{1, 1, 1, 1, gone, 0, 0, 0, 0, 0});
        CHECK(icebergs[2] == Labels{1, 1, 1, 1, gone, 0, 0, 0, 2, 2});
        CHECK(icebergs[3] == Labels{1, 1, 1, 1, 1, 1, 1, 1, 2, 2});
        CHECK(icebergs[4] == Labels{gone, gone, gone, gone, gone, gone, gone, gone, 2, 2});
        using Kind = IcebergEvent::Kind;
        REQUIRE(tracks.events.size() == 6);
        const auto is = [&](std::size_t i, double time, Kind kind, std::uint32_t iceberg,
                            std::uint32_t other) {
            const IcebergEvent& e = tracks.events[i];
            return e.time == time && e.kind == kind && e.iceberg == iceberg && e.other == other;
        };
        CHECK(is(0, 0.0, Kind::split, 0, IcebergEvent::none));
        CHECK(is(1, 1.0, Kind::split, 1, 0));
        CHECK(is(2, 2.0, Kind::split, 2, 0));
        CHECK(is(3, 3.0, Kind::merge, 0, 1));
        CHECK(is(4, 4.0, Kind::gone, 1, IcebergEvent::none));
        CHECK(is(5, 5.0, Kind::gone, 2, IcebergEvent::none));
    }
}

TEST_CASE("of equal pieces the one with the lowest particle keeps the id") {
    std::vector<Labels> icebergs;
    follow({{0, 0, 0, 0}, {1, 0, 0, 1}}, 0, icebergs);
    CHECK(icebergs[1] == Labels{0, 1, 1, 0});
}

TEST_CASE("a turned and spinning box gives its edges, motion and spin back") {
    for (const int dimension : {2, 3}) {
        const Eigen::Vector3d center(1000.0, dimension == 3 ? 300.0 : 0.0, 50.0), drift(1.5, 0.0, -0.5);
        const Eigen::Vector3d spin =
            dimension == 3 ? Eigen::Vector3d(0.1, -0.2, 0.3) : Eigen::Vector3d(0.0, 0.2, 0.0);
        const Eigen::Vector3d axis =
            dimension == 3 ? Eigen::Vector3d(1.0, 2.0, 3.0).normalized() : Eigen::Vector3d(0.0, 1.0, 0.0);
        const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.6, axis).toRotationMatrix();
        std::vector<float> points, velocity, volume;
        const int across = dimension == 3 ? 20 : 1;
        for (int i = 0; i < 40; ++i) {
            for (int j = 0; j < across; ++j) {
                for (int k = 0; k < 10; ++k) {
                    const Eigen::Vector3d at(i - 19.5, j - 0.5 * (across - 1), k - 4.5);
                    const Eigen::Vector3d r = turn * at, v = drift + spin.cross(r);
                    for (int d = 0; d < 3; ++d) {
                        points.push_back(static_cast<float>(center[d] + r[d]));
                        velocity.push_back(static_cast<float>(v[d]));
                    }
                    volume.push_back(1.0f);
                }
            }
        }
        std::vector<std::uint32_t> members(volume.size());
        std::iota(members.begin(), members.end(), 0u);
        const IcebergState s = describe_iceberg({points, velocity, volume}, members, dimension, 1.0, 52.0);
        CHECK(s.volume == static_cast<double>(volume.size()));
        CHECK(s.length == doctest::Approx(40.0).epsilon(1e-4));
        CHECK(s.height == doctest::Approx(10.0).epsilon(1e-4));
        CHECK(s.width == doctest::Approx(dimension == 3 ? 20.0 : 0.0).epsilon(1e-4));
        CHECK(std::abs(s.axes.col(0).dot(turn.col(0))) == doctest::Approx(1.0).epsilon(1e-6));
        CHECK((s.centroid - center).norm() < 1e-4);
        CHECK((s.velocity - drift).norm() < 1e-5);
        CHECK((s.rotation - spin).norm() < 1e-5);
        const double half = 0.5 * ((s.draft + s.freeboard) - 1.0);
        CHECK(s.draft == doctest::Approx(half + 2.5).epsilon(1e-4));
    }
}

TEST_CASE("a single particle is a box of a spacing at rest in itself") {
    const std::vector<float> point{3.0f, 0.0f, 1.0f}, velocity{2.0f, 0.0f, 0.0f}, volume{0.25f};
    const IcebergState s =
        describe_iceberg({point, velocity, volume}, std::vector<std::uint32_t>{0}, 2, 0.5, 1.0);
    CHECK(s.length == 0.5);
    CHECK(s.height == 0.5);
    CHECK(s.width == 0.0);
    CHECK(s.rotation.norm() == 0.0);
    CHECK(s.draft == 0.25);
    CHECK(s.freeboard == 0.25);
}
