#include "pal/runtime/thread.hpp"

#include "runtime/kernel/kernel.hpp"

namespace pal::runtime {

Thread::Thread(Kernel& kernel, int index, const ThreadSpec& spec, std::size_t conditions) : kernel_(kernel) {
  control.index = index;
  control.spec = &spec;
  control.latched.resize(conditions);
  control.tested.resize(conditions);
}

Thread::Within::Within(Thread& thread, int loop) : thread_(thread), loop_(loop) {
  if (!thread.kernel().journal.over()) thread.kernel().promises.enter(loop, thread.index());
}

Thread::Within::~Within() {
  if (!thread_.kernel().journal.over()) thread_.kernel().promises.leave(loop_, thread_.index());
}

namespace detail {

void* allocate_frame(Thread& thread, std::size_t size) {
  return thread.kernel().frames.allocate(size);
}
void release_frame(void* frame) noexcept {
  FramePool::release(frame);
}
void body_ended(Thread& thread) noexcept {
  thread.kernel().blocks.ended(thread);
}
void body_threw(Thread& thread) noexcept {
  thread.kernel().journal.fail_by_exception(thread);
}

}  // namespace detail

}  // namespace pal::runtime
