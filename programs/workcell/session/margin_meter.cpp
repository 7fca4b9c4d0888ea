#include "programs/workcell/session/margin_meter.hpp"

#include <sys/resource.h>

#include <chrono>
#include <string>
#include <string_view>
#include <utility>

namespace pal::workcell {
namespace {

using Measure = runtime::RequirementSpec::Measure;

constexpr auto look_each = std::chrono::milliseconds(10);

/// Seconds; per cent of a load; a number of a loss.
double in_unit(Measure measure, runtime::Time value) {
  const auto count = static_cast<double>(value.count());
  if (measure == Measure::loss) return count;
  return measure == Measure::load ? count / 1e7 : count / 1e9;
}

}  // namespace

MarginMeter::MarginMeter(server::Knowledge& knowledge) : knowledge_(knowledge), thread_([this] { work(); }) {}

MarginMeter::~MarginMeter() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

runtime::Margins* MarginMeter::begin(const runtime::Skill& skill) {
  const runtime::Wiring& wiring = skill.wiring();
  if (wiring.requirements.empty()) return nullptr;
  {
    const std::lock_guard lock(mutex_);
    margins_ = std::make_unique<runtime::Margins>(wiring.requirements.size());
    wiring_ = &wiring;
  }
  changed_.notify_all();
  return margins_.get();
}

std::vector<operations::Figure> MarginMeter::end() {
  const std::lock_guard lock(mutex_);
  tell();
  std::vector<operations::Figure> result;
  for (Measured& each : measured()) result.push_back({std::move(each.name), each.value.worst});
  wiring_ = nullptr;
  return result;
}

std::vector<MarginMeter::Measured> MarginMeter::measured() const {
  std::vector<Measured> result;
  if (wiring_ == nullptr) return result;
  for (std::size_t i = 0; i < wiring_->requirements.size(); ++i) {
    const runtime::RequirementSpec& spec = wiring_->requirements[i];
    const auto worst = margins_->worst(i);
    if (!worst) continue;
    // One with two limits is shown by its upper one.
    std::string_view name = spec.name;
    if (name.ends_with(".least")) continue;
    if (name.ends_with(".most")) name.remove_suffix(std::string_view(".most").size());
    const runtime::Time latest = margins_->latest(i).value_or(*worst);
    result.push_back({std::string(name),
                      {in_unit(spec.measure, *worst), in_unit(spec.measure, latest)},
                      spec.most == runtime::Time::max(),
                      spec.measure == Measure::load});
  }
  return result;
}

void MarginMeter::tell() {
  for (const Measured& each : measured())
    knowledge_.measure(std::string(wiring_->skill), each.name, each.value, each.at_least, each.is_load);
}

void MarginMeter::work() {
  // The cell's own threads come first; on Linux this is of the thread.
  constexpr int less_urgent = 5;
  ::setpriority(PRIO_PROCESS, 0, less_urgent);
  std::unique_lock lock(mutex_);
  while (!ending_) {
    changed_.wait(lock, [this] { return ending_ || wiring_ != nullptr; });
    if (ending_) return;
    tell();
    changed_.wait_for(lock, look_each, [this] { return ending_; });
  }
}

}  // namespace pal::workcell
