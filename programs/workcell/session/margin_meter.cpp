#include "programs/workcell/session/margin_meter.hpp"

#include <sys/resource.h>

#include <array>
#include <chrono>

#include "runtime/watch/requirement_watch.hpp"

namespace pal::workcell {
namespace {

constexpr std::size_t room = 1U << 16U;
constexpr auto look_each = std::chrono::milliseconds(10);

}  // namespace

struct MarginMeter::Run {
  explicit Run(const runtime::Wiring& its_wiring)
      : wiring(its_wiring), tables(runtime::trace_tables(wiring)), watch(wiring, tables) {}

  const runtime::Wiring& wiring;
  trace::Trace tables;
  runtime::RequirementWatch watch;
  std::uint64_t dropped_before = 0;
};

MarginMeter::MarginMeter(server::Knowledge& knowledge)
    : knowledge_(knowledge), ring_(room), thread_([this] { work(); }) {}

MarginMeter::~MarginMeter() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

runtime::TraceRing* MarginMeter::begin(const runtime::Skill& skill) {
  auto run = std::make_unique<Run>(skill.wiring());
  if (!run->watch.any()) return nullptr;
  run->dropped_before = ring_.dropped();
  {
    const std::lock_guard lock(mutex_);
    run_ = std::move(run);
  }
  changed_.notify_all();
  return &ring_;
}

void MarginMeter::end() {
  const std::lock_guard lock(mutex_);
  take_what_is_there();
  tell();
  run_.reset();
}

void MarginMeter::take_what_is_there() {
  std::array<trace::Event, 256> events;
  while (const std::size_t count = ring_.take(events))
    for (std::size_t i = 0; run_ && i < count; ++i) run_->watch.see(events[i]);
  if (run_ && ring_.dropped() != run_->dropped_before) run_.reset();
}

void MarginMeter::tell() {
  if (!run_) return;
  const auto& requirements = run_->wiring.requirements;
  for (std::size_t i = 0; i < requirements.size(); ++i)
    if (const auto worst = run_->watch.worst(i))
      knowledge_.measure(std::string(run_->wiring.skill), std::string(requirements[i].name),
                         std::chrono::duration<double>(*worst).count(),
                         requirements[i].most == runtime::Time::max());
}

void MarginMeter::work() {
  // The cell's own threads come first; on Linux this is of the thread.
  constexpr int less_urgent = 5;
  ::setpriority(PRIO_PROCESS, 0, less_urgent);
  std::unique_lock lock(mutex_);
  while (!ending_) {
    changed_.wait(lock, [this] { return ending_ || run_; });
    if (ending_) return;
    take_what_is_there();
    tell();
    changed_.wait_for(lock, look_each, [this] { return ending_; });
  }
}

}  // namespace pal::workcell
