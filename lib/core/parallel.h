// Parallel loops over independent items. Results must not depend on which thread runs an item: each item
// writes only its own output, and sums over items are taken afterwards, in item order.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cstddef>
#include <memory>

namespace tidewater {

// While it lives, parallel loops use up to `threads` threads (0: all of the machine's cores), also more than
// there are cores. Of nested limits the innermost counts. Made and destroyed by one thread, outside of loops.
// Test: tests/unit/core/parallel_test.cpp
class ThreadLimit {
public:
    explicit ThreadLimit(int threads);
    ~ThreadLimit();
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;

private:
    struct Control;
    std::unique_ptr<Control> control_;
};

// Where the innermost living limit lets loops run; null without one.
tbb::task_arena* limited_arena();

// Calls body(i) for every i in [0, count).
template <class Body>
void parallel_for(std::size_t count, const Body& body, std::size_t grain = 1) {
    const auto loop = [&] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain), [&](const auto& range) {
            for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
        });
    };
    tbb::task_arena* arena = limited_arena();
    arena ? arena->execute(loop) : loop();
}

}  // namespace tidewater
