#include "core/parallel.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

namespace tidewater {

struct ThreadLimit::Control {
    explicit Control(int threads)
        : parallelism(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)) {}
    tbb::global_control parallelism;
};

ThreadLimit::ThreadLimit(int threads)
    : control_(std::make_unique<Control>(threads > 0 ? threads : tbb::info::default_concurrency())) {}

ThreadLimit::~ThreadLimit() = default;

}  // namespace tidewater
