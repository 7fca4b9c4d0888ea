#include "runtime/thread.hpp"

#include "runtime/run.hpp"

namespace pal::runtime {

Thread::Thread(Run& run, int index, const ThreadSpec& spec, std::size_t conditions) : run_(run) {
  control.index = index;
  control.spec = &spec;
  control.latched.resize(conditions);
  control.tested.resize(conditions);
}

namespace detail {

void* allocate_frame(Thread& thread, std::size_t size) {
  return thread.run().frames().allocate(size);
}
void release_frame(void* frame) noexcept {
  FramePool::release(frame);
}
void body_ended(Thread& thread) noexcept {
  thread.run().blocks().ended(thread);
}
void body_threw(Thread& thread) noexcept {
  thread.run().fail_by_exception(thread);
}

}  // namespace detail

}  // namespace pal::runtime
