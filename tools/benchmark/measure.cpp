#include "measure.h"

#include <malloc.h>
#include <tbb/info.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "core/error.h"
#include "core/hash.h"
#include "core/parallel.h"

namespace tidewater::benchmark {
namespace {

struct Result {
    std::size_t particles = 0;
    double seconds = 0.0;  // of all steps
    double bytes = 0.0;    // that the process grew by, at most
    std::uint64_t hash = 0;
    std::array<double, mpm::phase_names.size()> phase_seconds{};
};

// A value of /proc/self/status that is given in kB, in bytes.
double memory(const std::string& name) {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        double kilobytes = 0.0;
        if (word == name + ":" && status >> kilobytes) return 1024.0 * kilobytes;
    }
    throw InputError("/proc/self/status: no " + name + "; the benchmark needs Linux");
}

// Starts counting the greatest resident memory (VmHWM) anew, from what is in use now.
void reset_greatest_memory() {
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << 5 << std::flush;
}

template <int D, class Real>
Result run(const Job& job) {
    const double before = memory("VmRSS");
    auto simulation = mpm::make_simulation<D, Real>(make_scene<D>(job.what.name, job.particles));
    reset_greatest_memory();
    const auto start = std::chrono::steady_clock::now();
    for (int n = 0; n < job.steps; ++n) advance(simulation, stable_time_step(simulation));
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    return {.particles = simulation.particle_count(),
            .seconds = elapsed.count(),
            .bytes = memory("VmHWM") - before,
            .hash = state_hash(simulation),
            .phase_seconds = simulation.seconds};
}

Result run(const Job& job) {
    const bool narrow = job.precision == "float";
    if (job.what.dimension == 2) return narrow ? run<2, float>(job) : run<2, double>(job);
    return narrow ? run<3, float>(job) : run<3, double>(job);
}

std::string text(const char* format, double value) {
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, format, value);
    return buffer;
}

}  // namespace

std::string header() {
    std::string names =
        "case,dimension,material,precision,threads,particles,steps,particle_steps_per_s,bytes_per_particle,"
        "hash";
    for (const auto name : mpm::phase_names) names += "," + std::string(name);
    return names;
}

std::string measure(const Job& job) {
    const int threads = job.threads > 0 ? job.threads : tbb::info::default_concurrency();
    const ThreadLimit limit(threads);
    Job warm_up = job;  // threads and the program's pages are there before memory and time count
    warm_up.particles = 1;
    warm_up.steps = 2;
    run(warm_up);
    malloc_trim(0);

    Result result = run(job);
    for (int n = 1; n < job.repeat; ++n) {
        Result again = run(job);
        again.bytes = result.bytes;  // later runs find memory that earlier ones have freed
        if (again.seconds < result.seconds) result = again;
    }
    const auto count = static_cast<double>(result.particles);
    std::string row = std::string(job.what.name) + "," + std::to_string(job.what.dimension) + "," +
                      std::string(job.what.material) + "," + job.precision + "," + std::to_string(threads) +
                      "," + std::to_string(result.particles) + "," + std::to_string(job.steps) + "," +
                      text("%.0f", count * job.steps / result.seconds) + "," +
                      text("%.1f", result.bytes / count) + "," + hash_hex(result.hash);
    for (const double seconds : result.phase_seconds) row += "," + text("%.4f", seconds / result.seconds);
    return row;
}

}  // namespace tidewater::benchmark
