#include "core/parallel.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <utility>

namespace tidewater {
namespace {

tbb::task_arena* innermost = nullptr;  // limits nest like scopes, on one thread

}  // namespace

// The arena has the threads' places, the global control lets TBB make threads for them where cores are fewer.
struct ThreadLimit::Control {
    explicit Control(int threads)
        : parallelism(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)),
          arena(threads),
          outer(std::exchange(innermost, &arena)) {}
    ~Control() { innermost = outer; }

    tbb::global_control parallelism;
    tbb::task_arena arena;
    tbb::task_arena* outer;
};

ThreadLimit::ThreadLimit(int threads)
    : control_(std::make_unique<Control>(threads > 0 ? threads : tbb::info::default_concurrency())) {}

ThreadLimit::~ThreadLimit() = default;

tbb::task_arena* limited_arena() { return innermost; }

}  // namespace tidewater
