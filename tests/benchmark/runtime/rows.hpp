// What bench_runtime compares: each function makes `count` round trips of a message and its answer.
#pragma once

#include <cstddef>

#include "pal/runtime/outcome.hpp"

namespace pal::benchmark {

/// Send, Receive, Reply of a skill in virtual time; `threads` in all, those beside client and server wait.
/// Throws std::runtime_error if the skill does not come to its end.
/// `requirements`: how many are watched, up to eight.
void skill_round_trips(std::size_t count, std::size_t threads, runtime::TraceMode trace,
                       std::size_t requirements = 0);

/// A skill of `threads` threads, of `count` in all: each makes one statement and ends. `blocks`: they are
/// those of a CONCURRENT.
void skill_starts(std::size_t count, std::size_t threads, bool blocks);

/// Two fibers of Boost.Fiber and two channels. False: built without it.
bool fiber_round_trips(std::size_t count);

/// Two threads, a mutex and a condition variable.
void thread_round_trips(std::size_t count);

/// Two coroutines that transfer to each other and do nothing else.
void bare_transfers(std::size_t count);

}  // namespace pal::benchmark
