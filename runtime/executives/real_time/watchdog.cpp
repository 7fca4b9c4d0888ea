// The watchdog of a run in real time: above all levels.
#include <unistd.h>

#include <cstdlib>

#include "pal/runtime/broken_promise.hpp"
#include "runtime/executives/real_time/real_executive.hpp"

namespace pal::runtime {
namespace {

constexpr Time tick = std::chrono::milliseconds(5);
constexpr Time for_closing = std::chrono::seconds(1);

std::string in_seconds(Time time) {
  const std::string text = std::to_string(std::chrono::duration<double>(time).count());
  return text.substr(0, text.find('.') + 4) + " s";
}

/// Not by a stream, which what does not return may have locked.
void say(const std::string& text) {
  std::size_t at = 0;
  while (at < text.size()) {
    const ssize_t written = ::write(STDERR_FILENO, text.data() + at, text.size() - at);
    if (written <= 0) return;
    at += static_cast<std::size_t>(written);
  }
}

}  // namespace

void RealExecutive::start_watchdog() {
  dog_ = std::make_unique<OsThread>("pal watchdog", [this] { watch(); });
  if (top_priority_) make_fifo(dog_->handle(), *top_priority_ + 3);
}

void RealExecutive::watch() {
  for (Time next = monotonic_now() + tick; !watchdog_.sleep_until(next); next += tick) {
    look_for_hangs();
    if (!lock_.try_lock()) continue;
    look_at_clock(monotonic_now());
    look();
    exit();
  }
}

/// From outside.
void RealExecutive::look_for_hangs() {
  const Time hang_timeout = options_.real_time->hang_timeout;
  const Time now = monotonic_now();
  const auto for_too_long = [now](Time since, Time limit) {
    return since != Time::zero() && now - since > limit;
  };
  const Time held = lock_.since(), in_world(in_world_.load(std::memory_order_relaxed)),
             closing(in_closing_.load(std::memory_order_relaxed));
  const auto device = [this] { return kernel_->devices.at_work(); };
  if (for_too_long(closing, hang_timeout + for_closing)) {
    say("pal: closing device " + device() + " has not returned for " + in_seconds(now - closing) +
        "\n  DEVICES MAY NOT BE CLOSED; the process ends, because nothing else stops code that does not "
        "return\n");
    ::_exit(options_.real_time->hang_status);
  }
  const Time waits_until(waits_until_.load(std::memory_order_relaxed));
  if (for_too_long(waits_until, hang_timeout))
    end_process("the world was to wait for an instant that was over " + in_seconds(now - waits_until) +
                " ago");
  if (for_too_long(in_world, hang_timeout))
    end_process("the world with its devices has not returned for " + in_seconds(now - in_world));
  if (for_too_long(held, hang_timeout))
    end_process((kernel_->promises.asks_skill() ? "the skill's answer to a broken promise"
                 : !device().empty()            ? "device " + device()
                 : starting_                    ? "the start of the skill"
                 : moving_                      ? "the world"
                                                : "what has the kernel") +
                " has not returned for " + in_seconds(now - held));
}

/// From inside.
void RealExecutive::look() {
  if (RunControl* control = options_.control) {
    if (control->stopping() || (control->watching() && control->stop_instant() <= now()))
      journal_.fail("stopped on request");
  }
  look_for_deadlock();
  for (Level& level : levels_.all()) {
    // What was interrupted is not to blame; after the end no thread interrupts.
    if (level.work == nullptr || (!journal_.over() && !levels_.has_processor(level))) continue;
    const auto statement = static_cast<std::size_t>(level.work->control.operation->statement());
    const Time had = ++level.ticks * tick;
    const Time worst = wiring_.statements[statement].cost.worst;
    if (had <= options_.real_time->hang_timeout + worst) continue;
    const std::string why = journal_.place_of(*level.work) + " has not returned for " + in_seconds(had) +
                            "; its worst time is " + in_words(worst);
    make_ordinary(level.os_thread);  // others need its CPU
    journal_.fail(why);
    exit();
    end_process(why);
  }
}

/// No thread is at work, nothing is due, and no thread waits for a device, which might still answer.
void RealExecutive::look_for_deadlock() {
  const bool idle = !journal_.over() && levels_.idle() && queue_.empty() &&
                    (world_.apart() || world_.next_event() == Time::max()) && !kernel_->awaits_device();
  if (idle) journal_.fail("nothing is left to happen" + kernel_->who_waits());
}

/// From outside. The thread that asked for the run closes the devices, as always. If it cannot, another
/// thread does. If that does not return either, they are not closed.
void RealExecutive::end_process(const std::string& why) {
  hung_ = true;
  ended_.wake();
  bool closed = closed_.sleep_until(monotonic_now() + for_closing);
  if (!closed) {
    new OsThread("pal closes", [this] {  // never joined: the process ends
      kernel_->devices.close();
      closed_.wake();
    });
    closed = closed_.sleep_until(monotonic_now() + for_closing);
  }
  say("pal: " + why + "\n  " +
      (closed ? "the devices are closed" : "THE DEVICES COULD NOT BE CLOSED: closing does not return") +
      "; the process ends, because nothing else stops code that does not return\n");
  ::_exit(options_.real_time->hang_status);
}

void RealExecutive::wait_for_levels() {
  for (std::size_t i = 0; i < levels_.all().size(); ++i) {
    ended_.sleep();
    if (!hung_) continue;
    enter();
    kernel_->devices.close();
    exit();
    closed_.wake();
    for (;;) ::pause();
  }
}

}  // namespace pal::runtime
