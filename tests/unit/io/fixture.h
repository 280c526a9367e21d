// What the tests of io share: a folder with short names, a provenance, a small cloud of particles.
#pragma once

#include <filesystem>
#include <iterator>
#include <limits>
#include <string>

#include "core/error.h"
#include "core/provenance.h"
#include "core/types.h"
#include "io/snapshot.h"
#include "support/temporary_folder.h"

namespace tidewater::io {

class TemporaryFolder : public test::TemporaryFolder {
public:
    std::filesystem::path operator/(const std::string& name) const { return path() / name; }
    std::size_t file_count() const {
        return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path()), {}));
    }
};

inline Provenance test_provenance() {
    return {"tidewater-test", "1.2.3", "tidewater-test a.toml", "00ff", 7};
}

// `count` particles on a slope in 2D, every third of them rigid, with values that differ in every column.
inline Snapshot test_snapshot(std::size_t count) {
    Snapshot snapshot;
    snapshot.time = 1.25;
    for (std::size_t i = 0; i < count; ++i) {
        const auto value = static_cast<float>(i);
        for (const float part : {0.5f * value, 0.0f, 2.0f + 0.25f * value}) snapshot.points.push_back(part);
        for (const float part : {3.0f * value, 0.0f, -4.0f * value}) snapshot.velocity.push_back(part);
        snapshot.pressure.push_back(1000.0f + value);
        snapshot.volume.push_back(0.25f);
        snapshot.material.push_back(
            static_cast<std::uint8_t>(i % 3 == 2 ? Material::rigid : Material::water));
        snapshot.id.push_back(static_cast<std::uint32_t>(7 * i));
    }
    return snapshot;
}

// The same with what a run with ice has: every fourth particle has failed.
inline Snapshot test_snapshot_of_ice(std::size_t count) {
    Snapshot snapshot = test_snapshot(count);
    for (std::size_t i = 0; i < count; ++i) {
        const bool failed = i % 4 == 0;
        snapshot.principal_stress.push_back(i % 5 == 0 ? std::numeric_limits<float>::quiet_NaN()
                                                       : 1000.0f * static_cast<float>(i));
        snapshot.damage.push_back(failed ? 1.0f : 0.25f);
        snapshot.alpha.push_back(failed ? 0.125f : -0.001f);
        snapshot.failure_time.push_back(failed ? 0.5f : std::numeric_limits<float>::quiet_NaN());
    }
    return snapshot;
}

// The line of the InputError that `work` throws; empty if it throws none.
template <class Work>
std::string input_error(const Work& work) {
    try {
        work();
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

}  // namespace tidewater::io
