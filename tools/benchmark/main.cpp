// tidewater-benchmark: how fast the engine steps, and in how much memory, case by case. See README.md.
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "core/error.h"
#include "measure.h"

namespace tidewater::benchmark {
namespace {

struct Options {
    std::vector<std::string> cases, precisions{"float"};
    std::vector<int> threads{0}, steps{200};
    std::vector<long> particles{1'000'000};
    int repeat = 1;
};

void declare(CLI::App& app, Options& options) {
    for (const Case& known : cases()) options.cases.emplace_back(known.name);
    app.add_option("--case", options.cases, "what to run")
        ->check(CLI::IsMember(std::vector<std::string>(options.cases)))
        ->capture_default_str();
    app.add_option("--particles", options.particles, "about so many; at least 64 cells are filled")
        ->check(CLI::Range(1L, 1'000'000'000L))
        ->capture_default_str();
    app.add_option("--steps", options.steps, "steps that are timed")
        ->check(CLI::Range(1, 1'000'000'000))
        ->capture_default_str();
    app.add_option("--repeat", options.repeat, "a row is the fastest of so many runs")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--threads", options.threads, "0: all cores")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    app.add_option("--precision", options.precisions, "of particles and grid")
        ->check(CLI::IsMember({"float", "double"}))
        ->capture_default_str();
}

// Every combination of the options' values.
std::vector<Job> jobs_of(const Options& options) {
    std::vector<Job> jobs;
    for (const std::string& name : options.cases) {
        const Case what = *std::ranges::find(cases(), name, &Case::name);
        for (const std::string& precision : options.precisions)
            for (const int threads : options.threads)
                for (const long particles : options.particles)
                    for (const int steps : options.steps)
                        jobs.push_back({what, precision, threads, particles, steps, options.repeat});
    }
    return jobs;
}

void print(const std::string& line) {
    if (std::printf("%s\n", line.c_str()) < 0 || std::fflush(stdout) != 0)
        throw OutputError("standard output: writing failed; is the disk full?");
}

// Runs `work` and turns what it throws into a line on standard error and an exit code.
template <class Work>
int guarded(const std::string& what, const Work& work) {
    try {
        work();
        return 0;
    } catch (const Error& error) {
        std::fprintf(stderr, "tidewater-benchmark: %s%s\n", what.c_str(), error.what());
        return static_cast<int>(error.code());
    } catch (const std::exception& error) {
        std::fprintf(stderr, "tidewater-benchmark: %s%s\n", what.c_str(), error.what());
        return 1;
    }
}

// Measures and prints a row in a process of its own, so that no row finds the memory of an earlier one.
int in_own_process(const Job& job) {
    const std::string what = std::string(job.what.name) + ": ";
    const pid_t child = fork();
    if (child == 0) _exit(guarded(what, [&] { print(measure(job)); }));
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child || !WIFEXITED(status)) {
        std::fprintf(stderr, "tidewater-benchmark: %sended without a result; is there enough memory?\n",
                     what.c_str());
        return 1;
    }
    return WEXITSTATUS(status);
}

int run(int argc, const char* const* argv) {
    CLI::App app("Times the engine's steps. One line of CSV for every combination of the options' values.",
                 "tidewater-benchmark");
    Options options;
    declare(app, options);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& answered) {
        return app.exit(answered);
    } catch (const CLI::ParseError& error) {
        return guarded("",
                       [&] { throw SceneError(std::string(error.what()) + "; --help lists the options"); });
    }
    int code = guarded("", [] { print(header()); });
    for (const Job& job : jobs_of(options)) {
        if (code == 0) code = in_own_process(job);
    }
    return code;
}

}  // namespace
}  // namespace tidewater::benchmark

int main(int argc, char** argv) { return tidewater::benchmark::run(argc, argv); }
