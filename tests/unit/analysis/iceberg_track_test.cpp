#include "analysis/iceberg_track.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "analysis/fragments.h"
#include "core/random.h"

using namespace tidewater;
using namespace tidewater::analysis;

namespace {

constexpr std::uint32_t gone = Fragments::none;

using Labels = std::vector<std::uint32_t>;

struct Followed {
    std::vector<Labels> icebergs;  // of each particle, in each frame
    std::vector<IcebergEvent> events;
};

// Follows frames of ten particles; `seed` shuffles the particles and renames labels 0, 1, 2. glacier: a
// particle whose fragment is the glacier, unless it is in none.
Followed follow(const std::vector<Labels>& frames, std::uint64_t seed, std::size_t glacier = gone) {
    IcebergTracks tracks;
    Followed followed;
    double time = 0.0;
    for (const Labels& labels : frames) {
        Labels order(labels.size());
        std::iota(order.begin(), order.end(), 0u);
        std::ranges::sort(order, {}, [&](std::uint32_t i) { return random_uniform(seed, 0, i); });
        Labels shuffled;
        for (const std::uint32_t i : order) {
            shuffled.push_back(labels[i] == gone ? gone : static_cast<std::uint32_t>((labels[i] + seed) % 3));
        }
        const std::vector<float> volume(labels.size(), 2.0f);
        FragmentFrame frame{time++, order, shuffled, volume};
        const auto place = std::ranges::find(order, glacier);
        if (place != order.end()) frame.glacier = shuffled[static_cast<std::size_t>(place - order.begin())];
        const auto found = follow_icebergs(frame, tracks);
        Labels of_particle(labels.size(), gone);
        for (std::size_t i = 0; i < order.size(); ++i) {
            if (shuffled[i] != gone) of_particle[order[i]] = found[shuffled[i]];
        }
        followed.icebergs.push_back(of_particle);
        followed.events.insert(followed.events.end(), tracks.events.begin(), tracks.events.end());
    }
    return followed;
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
        const auto [icebergs, events] = follow(frames, seed);
        CHECK(icebergs[0] == Labels(10, 1));
        CHECK(icebergs[1] == Labels{2, 2, 2, 2, gone, 1, 1, 1, 1, 1});
        CHECK(icebergs[2] == Labels{2, 2, 2, 2, gone, 1, 1, 1, 3, 3});
        CHECK(icebergs[3] == Labels{2, 2, 2, 2, 2, 2, 2, 2, 3, 3});
        CHECK(icebergs[4] == Labels{gone, gone, gone, gone, gone, gone, gone, gone, 3, 3});
        using Kind = IcebergEvent::Kind;
        REQUIRE(events.size() == 6);
        const auto is = [&](std::size_t i, double time, Kind kind, std::uint32_t iceberg, std::uint32_t other,
                            double volume) {
            const IcebergEvent& e = events[i];
            return e.time == time && e.kind == kind && e.iceberg == iceberg && e.other == other &&
                   e.volume == volume;
        };
        CHECK(is(0, 0.0, Kind::split, 1, gone, 20.0));
        CHECK(is(1, 1.0, Kind::split, 2, 1, 8.0));
        CHECK(is(2, 2.0, Kind::split, 3, 1, 4.0));
        CHECK(is(3, 3.0, Kind::merge, 1, 2, 6.0));
        CHECK(is(4, 4.0, Kind::gone, 2, gone, 0.0));
        CHECK(is(5, 5.0, Kind::gone, 3, gone, 0.0));
    }
}

TEST_CASE("the glacier stays iceberg 0 even where the larger part leaves it") {
    const std::vector<Labels> frames{{0, 0, 0, 0, 0, 0, 0, 0, 1, 1},
                                     {0, 0, 0, 1, 1, 1, 1, 1, 2, 2},
                                     {0, 0, 0, 0, 0, 0, 0, 0, 2, 2},  // it comes back
                                     {gone, gone, gone, 1, 1, 1, 1, 1, 2, 2}};
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const auto [icebergs, events] = follow(frames, seed, 0);
        CHECK(icebergs[0] == Labels{0, 0, 0, 0, 0, 0, 0, 0, 1, 1});
        CHECK(icebergs[1] == Labels{0, 0, 0, 2, 2, 2, 2, 2, 1, 1});
        CHECK(icebergs[2] == Labels{0, 0, 0, 0, 0, 0, 0, 0, 1, 1});
        CHECK(icebergs[3] == Labels{gone, gone, gone, 3, 3, 3, 3, 3, 1, 1});
        REQUIRE(events.size() == 4);
        CHECK((events[1].iceberg == 2 && events[1].other == glacier_id));
        CHECK((events[2].kind == IcebergEvent::Kind::merge && events[2].other == glacier_id));
        CHECK(events[2].volume == 10.0);
        CHECK((events[3].iceberg == 3 && events[3].other == glacier_id));
    }
}

TEST_CASE("of equal pieces the one with the lowest particle keeps the id") {
    CHECK(follow({{0, 0, 0, 0}, {1, 0, 0, 1}}, 0).icebergs[1] == Labels{1, 2, 2, 1});
}

TEST_CASE("without ice there is nothing to follow") {
    IcebergTracks tracks;
    CHECK(follow_icebergs({}, tracks).empty());
    CHECK(tracks.count == 1);
    CHECK(tracks.events.empty());
}
