#include "runtime/kernel/promises.hpp"

#include <algorithm>

#include "runtime/kernel/thrown.hpp"

namespace pal::runtime {

namespace {
BrokenPromise::Unit unit_of(const RequirementSpec& requirement) {
  using enum BrokenPromise::Unit;
  if (requirement.measure == RequirementSpec::Measure::loss) return messages;
  return requirement.measure == RequirementSpec::Measure::load ? share : time;
}

// The promises of a device.
constexpr std::size_t not_later = 0, not_sooner = 1, once = 2, promises_of_a_device = 3;

/// PAL has no word for frames that are late, so that no proof could hold with a tolerance of theirs.
DeviceTimes with_tolerance(DeviceTimes times, Time tolerance) {
  using enum DeviceTimes::Behaviour;
  if (times.behaviour == events || times.behaviour == sporadic) times.jitter += tolerance;
  if (times.behaviour == on_request) {
    times.answer.best = std::max(Time::zero(), times.answer.best - tolerance);
    times.answer.worst += tolerance;
  }
  return times;
}
}  // namespace

Promises::Promises(const Clock& clock, Journal& journal, Skill& skill, const RunOptions& options)
    : clock_(clock),
      journal_(journal),
      skill_(skill),
      wiring_(skill.wiring()),
      policy_(options.on_broken_promise),
      cost_tolerance_(options.real_time ? options.real_time->cost_tolerance : Time::zero()),
      requirements_(wiring_, journal.tables(), options.margins) {
  const Time tolerance = options.real_time ? options.real_time->tolerance : Time::zero();
  for (const DeviceTimes& times : wiring_.times) devices_.emplace_back(with_tolerance(times, tolerance));
  rows_.resize(row_of_requirement(wiring_.requirements.size()));
  late_devices_.reserve(devices_.size());
  if (requirements_.any()) journal.watch(this, &requirements_.routes());
}

std::size_t Promises::row_of_device(int device, std::size_t promise) const {
  return promises_of_a_device * static_cast<std::size_t>(device) + promise;
}

std::size_t Promises::row_of_statement(int statement) const {
  return row_of_device(static_cast<int>(wiring_.devices.size()), 0) + static_cast<std::size_t>(statement);
}

std::size_t Promises::row_of_requirement(std::size_t requirement) const {
  return row_of_statement(static_cast<int>(wiring_.statements.size())) + requirement;
}

// What is seen.

void Promises::sent(int device, int channel) {
  if (devices_.empty()) return;
  if (wiring_.channels[static_cast<std::size_t>(channel)].message != watch(device).times().message) return;
  note(device, channel, watch(device).event(clock_.now));
  look_at(device);
}

void Promises::answered(int device, int channel, Time asked) {
  if (devices_.empty()) return;
  note(device, channel, watch(device).answered(clock_.now, asked));
  look_at(device);
}

void Promises::took(const Thread& thread, Time used) {
  const Operation& operation = *thread.control.operation;
  const int statement = operation.statement();
  const Interval& declared = wiring_.statements[static_cast<std::size_t>(statement)].cost;
  const Time limit = declared.worst + (operation.is_activity() ? Time::zero() : cost_tolerance_);
  if (used > limit)
    note({row_of_statement(statement), used, thread.control.index, statement, -1, false, false, limit});
}

void Promises::see(const trace::Event& event, std::span<const std::uint32_t> meters) {
  const std::vector<Exceeded>& exceeded = requirements_.see(event, meters);
  journal_.routes_changed();
  if (!exceeded.empty()) note(exceeded);
  next_ = std::min(next_, requirements_.soonest());
}

Time Promises::due() {
  next_ = requirements_.due();
  for (const DeviceWatch& device : devices_) next_ = std::min(next_, device.due());
  return next_;
}

const std::vector<int>& Promises::overdue() {
  const Time now = clock_.now;
  late_devices_.clear();
  for (std::size_t d = 0; d < devices_.size(); ++d) {
    if (devices_[d].due() > now) continue;
    if (devices_[d].is_asked()) late_devices_.push_back(static_cast<int>(d));
    note(static_cast<int>(d), -1, devices_[d].overdue(now));
  }
  if (requirements_.due() <= now) note(requirements_.overdue(now));
  due();
  return late_devices_;
}

// What is noted.

void Promises::note(int device, int channel, const Seen& seen) {
  if (seen.what == Seen::What::kept) return;
  const bool sooner = seen.what == Seen::What::sooner;
  note({row_of_device(device, sooner ? not_sooner : not_later), seen.measured,
        journal_.actor_of_device(device), -1, channel, sooner, seen.noted});
}

void Promises::note_unasked(int device, int channel, Time measured) {
  note({row_of_device(device, once), measured, journal_.actor_of_device(device), -1, channel, false, false});
}

void Promises::note(const std::vector<Exceeded>& exceeded) {
  for (const Exceeded& each : exceeded) {
    const RequirementSpec& requirement = wiring_.requirements[each.requirement];
    note({row_of_requirement(each.requirement), each.measured, each.actor, each.statement, -1,
          each.measured < requirement.least, each.noted});
  }
}

void Promises::note(const Breach& breach) {
  if (journal_.over()) return;
  Row& row = rows_[breach.row];
  const bool first = row.broken < 0;
  row.measured = first          ? breach.measured
                 : breach.least ? std::min(row.measured, breach.measured)
                                : std::max(row.measured, breach.measured);
  if (breach.noted) return;
  if (first) {
    row.broken = static_cast<std::int32_t>(broken_.size());
    broken_.push_back(describe(breach));
    journal_.name_promise(broken_.back().promise);
  } else {
    ++broken_[static_cast<std::size_t>(row.broken)].times;
  }
  journal_.broken(breach.actor, breach.statement, breach.channel, row.broken);
  if (policy_ != OnBrokenPromise::stop && (policy_ != OnBrokenPromise::contingency || !first)) return;
  BrokenPromise broken = broken_[static_cast<std::size_t>(row.broken)];
  broken.measured = breach.measured;
  apply_policy(breach, broken);
}

void Promises::apply_policy(const Breach& breach, const BrokenPromise& broken) {
  std::string reason = in_words(broken);
  if (policy_ == OnBrokenPromise::contingency) {
    asks_skill_ = true;
    try {
      const bool answered = skill_.promise_broken(broken);
      asks_skill_ = false;
      if (answered) return;
      reason += "; the skill has no answer to it";
    } catch (...) {
      asks_skill_ = false;
      reason += "; the skill's answer: " + what_was_thrown();
    }
  }
  journal_.fail_at(breach.actor, breach.statement, reason);
}

std::vector<BrokenPromise> Promises::take() {
  for (const Row& row : rows_) {
    if (row.broken >= 0) broken_[static_cast<std::size_t>(row.broken)].measured = row.measured;
  }
  return std::move(broken_);
}

std::vector<MeasuredRequirement> Promises::measured() {
  requirements_.end(clock_.now);
  std::vector<MeasuredRequirement> all;
  for (std::size_t r = 0; r < wiring_.requirements.size(); ++r) {
    const RequirementSpec& spec = wiring_.requirements[r];
    all.push_back({std::string(spec.name), unit_of(spec), spec.least, spec.most, requirements_.worst(r)});
  }
  return all;
}

// In words.

std::string Promises::name_of(std::int32_t actor) const {
  if (actor < 0) return {};
  const auto index = static_cast<std::size_t>(actor);
  const std::size_t threads = wiring_.threads.size();
  return std::string(index < threads ? wiring_.threads[index].name : wiring_.devices[index - threads]);
}

std::string Promises::promise_of_device(std::size_t device, std::size_t promise) const {
  using Behaviour = DeviceTimes::Behaviour;
  const std::string name(wiring_.devices[device]);
  if (promise == once) return name + " answers each request once, and nothing else";
  const bool sooner = promise == not_sooner;
  const DeviceTimes& times = devices_[device].times();
  const std::string jitter = times.jitter > Time::zero() ? ", up to " + in_words(times.jitter) + " late" : "";
  const std::string message(times.message);
  switch (times.behaviour) {
    case Behaviour::events:
      return name + " sends " + message + " every " + in_words(times.period) + jitter +
             (sooner ? ", not sooner" : ", not later");
    case Behaviour::sporadic:
      return name + " sends " + message + " " + in_words(times.period) + " apart" + jitter + ", not sooner";
    case Behaviour::frames:
      return name + " gives a frame " +
             in_words(sooner ? times.answer.best : times.answer.worst + times.period) +
             " after a request at the " + (sooner ? "soonest" : "latest");
    case Behaviour::on_request:
    case Behaviour::unknown:
      break;
  }
  return name + " answers " + in_words(sooner ? times.answer.best : times.answer.worst) +
         " after a request at the " + (sooner ? "soonest" : "latest");
}

std::string Promises::promise_of_requirement(const RequirementSpec& requirement) const {
  static constexpr const char* measures[] = {"a response", "an age",       "an age",     "an interval",
                                             "a duration", "a reaction",   "a reaction", "a loss",
                                             "a load",     "a busy period"};
  const BrokenPromise::Unit unit = unit_of(requirement);
  std::string text = "requirement " + std::string(requirement.name) + ", " +
                     measures[static_cast<std::size_t>(requirement.measure)];
  if (requirement.least > Time::zero()) text += " of at least " + in_words(requirement.least, unit);
  if (requirement.most != Time::max())
    text += (requirement.least > Time::zero() ? " and" : " of") +
            (" at most " + in_words(requirement.most, unit));
  if (requirement.measure == RequirementSpec::Measure::loss) text += " in " + std::to_string(requirement.in);
  return text;
}

BrokenPromise Promises::describe(const Breach& breach) const {
  BrokenPromise broken;
  broken.by = name_of(breach.actor);
  broken.measured = breach.measured;
  broken.first = clock_.now;
  const std::size_t statements = row_of_statement(0), requirements = row_of_requirement(0);
  const auto has = [](std::span<const int> list, std::size_t index) {
    return std::find(list.begin(), list.end(), static_cast<int>(index)) != list.end();
  };
  if (breach.row >= requirements) {
    const RequirementSpec& requirement = wiring_.requirements[breach.row - requirements];
    broken.promise = promise_of_requirement(requirement);
    broken.unit = unit_of(requirement);
    broken.endangers = {std::string(requirement.name)};
    return broken;
  }
  if (breach.row < statements) {
    const std::size_t device = breach.row / promises_of_a_device;
    broken.promise = promise_of_device(device, breach.row % promises_of_a_device);
    for (const RequirementSpec& requirement : wiring_.requirements) {
      if (has(requirement.devices, device)) broken.endangers.emplace_back(requirement.name);
    }
    return broken;
  }
  const StatementSpec& statement = wiring_.statements[breach.row - statements];
  broken.promise = std::string(statement.text) + " of " + std::string(statement.module) + " (" +
                   std::string(statement.file) + ":" + std::to_string(statement.line) + ") takes at most " +
                   in_words(breach.limit);
  int root = breach.actor;  // a block belongs to the thread whose CONCURRENT begins it
  while (wiring_.threads[static_cast<std::size_t>(root)].parent >= 0)
    root = wiring_.threads[static_cast<std::size_t>(root)].parent;
  for (const RequirementSpec& requirement : wiring_.requirements) {
    if (has(requirement.threads, static_cast<std::size_t>(root)))
      broken.endangers.emplace_back(requirement.name);
  }
  return broken;
}

}  // namespace pal::runtime
