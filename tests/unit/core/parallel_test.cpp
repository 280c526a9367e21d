#include "core/parallel.h"

#include <doctest/doctest.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

using namespace tidewater;

TEST_CASE("a parallel loop calls its body once for every item, with any number of threads and of items") {
    for (const int threads : {1, 2, 5, 16}) {
        const ThreadLimit limit(threads);
        for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{1000}}) {
            std::vector<std::atomic<int>> calls(count);
            parallel_for(count, [&](std::size_t i) { ++calls[i]; });
            for (const auto& call : calls) REQUIRE(call == 1);
        }
    }
}

TEST_CASE("a thread limit of one runs every item on the calling thread") {
    const ThreadLimit limit(1);
    std::atomic<int> elsewhere = 0;
    parallel_for(1000, [&](std::size_t) { elsewhere += tbb::this_task_arena::current_thread_index() != 0; });
    CHECK(elsewhere == 0);
}

TEST_CASE("a body may have as many threads beside it as the limit says, on any machine") {
    for (const int threads : {1, 2, 5, 16}) {
        const ThreadLimit limit(threads);
        std::atomic<int> other = 0;
        parallel_for(100, [&](std::size_t) { other += tbb::this_task_arena::max_concurrency() != threads; });
        CHECK(other == 0);
    }
}

TEST_CASE("sixteen threads are more than two even on two cores") {
    const ThreadLimit limit(16);
    std::mutex mutex;
    std::condition_variable joined;
    std::set<std::thread::id> seen;
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    parallel_for(16, [&](std::size_t) {  // each item waits for three threads
        std::unique_lock lock(mutex);
        seen.insert(std::this_thread::get_id());
        joined.notify_all();
        joined.wait_until(lock, deadline, [&] { return seen.size() >= 3; });
    });
    CHECK(seen.size() >= 3);
}

TEST_CASE("of nested limits the innermost counts, and then the outer one again") {
    const auto concurrency = [] {
        std::atomic<int> found = 0;
        parallel_for(1, [&](std::size_t) { found = tbb::this_task_arena::max_concurrency(); });
        return found.load();
    };
    const ThreadLimit outer(4);
    {
        const ThreadLimit inner(3);
        CHECK(concurrency() == 3);
    }
    CHECK(concurrency() == 4);
}

TEST_CASE("a loop inside a loop's body calls its body once for every item") {
    const ThreadLimit limit(5);
    std::vector<std::atomic<int>> calls(400);
    parallel_for(20, [&](std::size_t i) { parallel_for(20, [&](std::size_t j) { ++calls[20 * i + j]; }); });
    for (const auto& call : calls) REQUIRE(call == 1);
}

TEST_CASE("an exception of a body reaches the caller") {
    const ThreadLimit limit(2);
    CHECK_THROWS_AS(parallel_for(10,
                                 [](std::size_t i) {
                                     if (i == 7) throw i;
                                 }),
                    std::size_t);
}
