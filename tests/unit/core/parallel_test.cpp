#include "core/parallel.h"

#include <doctest/doctest.h>
#include <tbb/task_arena.h>

#include <atomic>
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

TEST_CASE("an exception of a body reaches the caller") {
    CHECK_THROWS_AS(parallel_for(10,
                                 [](std::size_t i) {
                                     if (i == 7) throw i;
                                 }),
                    std::size_t);
}
