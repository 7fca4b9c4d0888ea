#include "tests/support/planned_skill.hpp"

#include <algorithm>
#include <set>

#include "runtime/kernel/ports.hpp"

namespace pal::test {

using namespace codegen;
using runtime::Time;

namespace {

runtime::Interval interval(const Interval& of) {
  return {Time(of.best), Time(of.worst)};
}

/// Before the wait, which has a view of them.
struct Targets {
  explicit Targets(const PlannedStatement& statement) {
    for (const PlannedEnd& end : statement.ends) all.push_back(runtime::from(static_cast<int>(end.channel)));
  }
  std::vector<runtime::Target> all;
};

class AnyWait final : private Targets, public runtime::WaitOperation {
 public:
  AnyWait(runtime::Thread& thread, const PlannedStatement& statement)
      : Targets(statement),
        WaitOperation(thread, static_cast<int>(*statement.row),
                      statement.within ? std::optional<Time>(*statement.within) : std::nullopt, all) {}
};

void mentioned(const pan::Guard& guard, std::vector<int>& all) {
  if (guard.kind == pan::Guard::Kind::equals) {
    if (std::find(all.begin(), all.end(), guard.condition.value) == all.end())
      all.push_back(guard.condition.value);
  }
  for (const pan::Guard& term : guard.terms) mentioned(term, all);
}

class AnyTest final : public runtime::TestConditions {
 public:
  AnyTest(runtime::Thread& thread, const PlannedStatement& statement)
      : TestConditions(thread, static_cast<int>(*statement.row)) {
    for (const pan::Guard& guard : statement.guards) mentioned(guard, conditions_);
  }

 private:
  std::span<const int> conditions() const override { return conditions_; }
  std::vector<int> conditions_;
};

class AnyConcurrent final : public runtime::ConcurrentOperation {
 public:
  AnyConcurrent(runtime::Thread& thread, const PlannedStatement& statement, const Plan& plan)
      : ConcurrentOperation(thread, static_cast<int>(*statement.row)) {
    for (const std::vector<std::size_t>& threads : statement.threads) {
      for (const std::size_t block : threads) {
        if (plan.threads[block].parent == static_cast<std::size_t>(thread.index()))
          blocks_.push_back(static_cast<int>(block));
      }
    }
  }
  std::span<const int> blocks() const override { return blocks_; }

 private:
  std::vector<int> blocks_;
};

bool holds(const pan::Guard& guard, const runtime::Thread& thread) {
  switch (guard.kind) {
    case pan::Guard::Kind::equals:
      return thread.tested(guard.condition.value) == guard.value;
    case pan::Guard::Kind::negation:
      return !holds(guard.terms.front(), thread);
    case pan::Guard::Kind::all_of:
      return std::all_of(guard.terms.begin(), guard.terms.end(),
                         [&](const pan::Guard& term) { return holds(term, thread); });
    case pan::Guard::Kind::any_of:
      return std::any_of(guard.terms.begin(), guard.terms.end(),
                         [&](const pan::Guard& term) { return holds(term, thread); });
  }
  return false;
}

}  // namespace

PlannedSkill::PlannedSkill(const Plan& plan, Dealer dealer) : plan_(plan), dealer_(std::move(dealer)) {
  for (const pan::Processor& each : plan.environment.processors)
    processors_.push_back({each.name, each.preemptive});
  for (const PlannedThread& each : plan.threads)
    threads_.push_back({each.pal_name, static_cast<int>(each.processor), each.priority,
                        each.parent ? static_cast<int>(*each.parent) : -1, each.can_end});
  for (const PlannedRow& each : plan.statements)
    statements_.push_back({each.module, each.text, each.file, each.line, interval(each.cost)});
  for (const PlannedChannel& each : plan.channels)
    channels_.push_back({each.sender,
                         each.message,
                         each.receiver,
                         {},
                         each.answer ? static_cast<int>(*each.answer) : -1,
                         each.request,
                         each.from_device,
                         each.to_device});
  for (const PlannedCondition& each : plan.conditions) conditions_.push_back(each.pal_name);
  for (const std::string& each : plan.devices) devices_.push_back(each);
  for (const pan::Completion& each : plan.skill.completions) {
    using Kind = runtime::CompletionSpec::Kind;
    const Kind kind = each.kind == pan::Completion::Kind::error ? Kind::error : Kind::normal;
    completions_.push_back({each.code, kind, each.description});
  }
  description_ = {plan.skill.name, plan.environment.name, {}, {}, completions_};
  const pan::Latency& latency = plan.environment.latency;
  wiring_ = {plan.skill.name,
             plan.environment.name,
             processors_,
             threads_,
             statements_,
             channels_,
             conditions_,
             devices_,
             interval(plan.environment.costs.test),
             {interval(latency.within_processor), interval(latency.between_processors)}};
  require();
}

/// The tables that a run is compared with.
void PlannedSkill::require() {
  using Behaviour = runtime::DeviceTimes::Behaviour;
  for (const std::string& name : plan_.devices) {
    runtime::DeviceTimes& times = times_.emplace_back();
    for (const pan::DeviceTiming& row : plan_.environment.devices) {
      if (row.device != name) continue;
      if (const auto* event = std::get_if<pan::EventDevice>(&row.behaviour)) {
        times = {event->sporadic ? Behaviour::sporadic : Behaviour::events, event->message, event->period,
                 event->jitter};
        if (event->phase) times.phase = *event->phase;
      } else if (const auto* request = std::get_if<pan::RequestDevice>(&row.behaviour)) {
        times.behaviour = Behaviour::on_request;
        times.answer = interval(request->answer);
        times.may_fail = request->may_fail;
      } else {
        const auto& frames = std::get<pan::FrameDevice>(row.behaviour);
        times.behaviour = Behaviour::frames;
        times.period = frames.period;
        times.answer = {frames.collecting, frames.collecting};
      }
    }
  }
  const auto indices = [this](const std::vector<std::size_t>& list) {
    return std::span<const int>(indices_.emplace_back(list.begin(), list.end()));
  };
  for (const codegen::PlannedRequirement& each : plan_.requirements) {
    runtime::RequirementSpec spec;
    spec.name = each.name;
    spec.measure = static_cast<runtime::RequirementSpec::Measure>(each.measure);
    spec.least = each.least;
    if (each.most) spec.most = *each.most;
    spec.channels = indices(each.channels);
    spec.at = indices(each.at);
    if (each.condition) spec.condition = static_cast<int>(*each.condition);
    spec.code = each.code;
    spec.threads = indices(each.threads);
    spec.devices = indices(each.devices);
    if (each.device) spec.device = static_cast<int>(*each.device);
    spec.in = each.in;
    spec.processors = indices(each.processors);
    spec.after = indices(each.after);
    spec.during = indices(each.during);
    requirements_.push_back(spec);
  }
  for (const codegen::PlannedKept& each : plan_.kept)
    kept_.push_back({static_cast<runtime::KeptSpec::How>(each.how), static_cast<int>(each.place),
                     static_cast<int>(each.kept)});
  wiring_.times = times_;
  wiring_.requirements = requirements_;
  wiring_.kept = kept_;
}

PlannedSkill::Follower& PlannedSkill::follower(const PlannedBody& body) {
  auto& made = followers_[&body];
  if (!made) made = std::make_unique<Follower>(Follower{this, &body});
  return *made;
}

const PlannedBody* PlannedSkill::block(const PlannedBody& body, std::size_t thread) const {
  for (const PlannedStatement& statement : body) {
    for (std::size_t i = 0; i < statement.branches.size(); ++i) {
      if (i < statement.threads.size()) {
        const std::vector<std::size_t>& threads = statement.threads[i];
        if (std::find(threads.begin(), threads.end(), thread) != threads.end()) return &statement.branches[i];
      }
      if (const PlannedBody* found = block(statement.branches[i], thread)) return found;
    }
  }
  return nullptr;
}

runtime::Task PlannedSkill::body(std::size_t index, runtime::Thread& thread) {
  const PlannedThread& of = plan_.threads[index];
  const PlannedBody& whole = plan_.modules[of.module].body;
  return follower(of.parent ? *block(whole, index) : whole).follow(thread);
}

runtime::Task PlannedSkill::Follower::follow(runtime::Thread& thread) {
  using Kind = PlannedStatement::Kind;
  for (const PlannedStatement& statement : *body) {
    const int row = statement.row ? static_cast<int>(*statement.row) : -1;
    switch (statement.kind) {
      case Kind::take_start:
        co_await thread.take_start(row);
        break;
      case Kind::wait: {
        const int taken = co_await AnyWait(thread, statement);
        if (statement.branches.empty()) break;
        const std::size_t branch = taken < 0 ? statement.ends.size() : static_cast<std::size_t>(taken);
        co_await skill->follower(statement.branches[branch]).follow(thread);
        break;
      }
      case Kind::send:
        co_await thread.send(row, static_cast<int>(statement.ends.front().channel));
        break;
      case Kind::complete:
        co_await thread.complete(row, statement.code);
        break;
      case Kind::set: {
        PlannedSkill* const of = skill;
        const std::optional<bool> value = statement.value;
        co_await thread.set(row, static_cast<int>(*statement.condition),
                            [of, value] { return value ? *value : of->dealer_(2) == 1; });
        break;
      }
      case Kind::read:
        co_await thread.read(row, static_cast<int>(*statement.condition));
        break;
      case Kind::perform:
        co_await thread.perform(row, [] {});
        break;
      case Kind::execute:
        co_await skill->follower(skill->plan_.modules[*statement.module].body).follow(thread);
        break;
      case Kind::nothing:
        break;
      case Kind::choose: {
        co_await AnyTest(thread, statement);
        std::size_t arm = 0;
        while (arm < statement.guards.size() && !holds(statement.guards[arm], thread)) ++arm;
        if (arm < statement.guards.size()) {
          co_await skill->follower(statement.branches[arm]).follow(thread);
        } else {
          co_await thread.no_arm_holds(row);
        }
        break;
      }
      case Kind::loop: {
        std::optional<runtime::Thread::Within> within;
        if (statement.loop) within.emplace(thread, static_cast<int>(*statement.loop));
        for (;;) {
          co_await skill->follower(statement.branches.front()).follow(thread);
          if (statement.guards.empty()) continue;
          co_await AnyTest(thread, statement);
          if (holds(statement.guards.front(), thread)) break;
        }
        break;
      }
      case Kind::concurrent:
        co_await AnyConcurrent(thread, statement, skill->plan_);
        break;
    }
  }
  co_return;
}

// Devices.

namespace {

class PlannedDevice : public runtime::Device {
 public:
  PlannedDevice(const Plan& plan, std::string name, Dealer dealer, Payloads payloads)
      : dealer_(std::move(dealer)), name_(std::move(name)) {
    for (const PlannedChannel& channel : plan.channels) {
      if (channel.receiver == name_ && channel.to_device) {
        ports_.push_back({channel.message, true, fields(plan, channel, payloads)});
        const int answer = channel.answer ? static_cast<int>(*channel.answer) : -1;
        answers_.push_back(answer < 0 ? "" : plan.channels[static_cast<std::size_t>(answer)].message);
      } else if (channel.sender == name_ && channel.from_device) {
        ports_.push_back({channel.message, false, fields(plan, channel, payloads)});
        answers_.push_back("");
      }
    }
  }
  const std::string& name() const override { return name_; }
  const std::vector<runtime::PortSpec>& ports() const override { return ports_; }
  void attach(runtime::DeviceHost& host) override { host_ = &host; }
  void open() override {}
  void receive(std::size_t, std::span<const double>) override {}
  void close() override {}

 protected:
  Time between(Time low, Time high) {
    const auto span = static_cast<std::uint64_t>((high - low).count());
    // Ends more often than not: there the worst is.
    const std::uint64_t how = dealer_(4);
    return how == 0 ? low : how == 1 ? high : low + Time(static_cast<std::int64_t>(dealer_(span + 1)));
  }
  std::size_t port_out(const std::string& message) const {
    for (std::size_t p = 0; p < ports_.size(); ++p) {
      if (!ports_[p].to_device && ports_[p].message == message) return p;
    }
    return ports_.size();
  }
  void deliver(std::size_t port) {
    const std::vector<double> zeros(runtime::payload_size(ports_[port].fields));
    host_->deliver(port, zeros);
  }
  std::size_t answer_to(std::size_t port) const { return port_out(answers_[port]); }

  static std::vector<runtime::FieldSpec> fields(const Plan& plan, const PlannedChannel& channel,
                                                Payloads payloads) {
    std::vector<runtime::FieldSpec> specs;
    if (payloads == Payloads::none || !channel.fields) return specs;
    for (const PlannedField& field : plan.messages[*channel.fields].fields) {
      const bool text = field.type == pan::ScalarType::text;
      specs.push_back({field.pal_name, field.unit,
                       text ? runtime::FieldKind::text : runtime::FieldKind::number,
                       field.size == 0 ? 1 : static_cast<std::size_t>(field.size)});
    }
    return specs;
  }

  Dealer dealer_;
  std::string name_;
  std::vector<runtime::PortSpec> ports_;
  std::vector<std::string> answers_;
  runtime::DeviceHost* host_ = nullptr;
};

class Events final : public PlannedDevice {
 public:
  Events(const Plan& plan, const std::string& name, const pan::EventDevice& of, Dealer dealer,
         Payloads payloads)
      : PlannedDevice(plan, name, std::move(dealer), payloads), of_(of) {}
  void open() override {
    due_ = host_->now() + (of_.phase ? Time(*of_.phase) : between(Time(0), Time(of_.period)));
    host_->at(due_, [this] { next(); });
  }

 private:
  void next() {
    const Time late = between(Time(0), Time(of_.jitter));
    host_->at(due_ + late, [this] {
      const std::size_t port = port_out(of_.message);
      if (port < ports_.size()) deliver(port);
    });
    due_ += of_.sporadic ? between(Time(of_.period), Time(2 * of_.period)) : Time(of_.period);
    host_->at(due_, [this] { next(); });
  }
  const pan::EventDevice& of_;
  Time due_{};
};

class Answers final : public PlannedDevice {
 public:
  Answers(const Plan& plan, const std::string& name, const pan::RequestDevice& of, Dealer dealer,
          Payloads payloads)
      : PlannedDevice(plan, name, std::move(dealer), payloads), of_(of) {}
  void receive(std::size_t port, std::span<const double>) override {
    if (answers_[port].empty()) return;
    waiting_.push_back(port);
    if (!busy_) serve();
  }
  bool withdraw(std::size_t port) override {
    const auto found = std::find(waiting_.begin(), waiting_.end(), port);
    if (found == waiting_.end()) return false;
    waiting_.erase(found);
    return true;
  }

 private:
  void serve() {
    const std::size_t port = waiting_.front();
    waiting_.erase(waiting_.begin());
    busy_ = true;
    host_->mark_busy(true);
    host_->at(host_->now() + between(Time(of_.answer.best), Time(of_.answer.worst)), [this, port] {
      busy_ = false;
      host_->mark_busy(false);
      if (of_.may_fail && dealer_(4) == 0) {
        host_->leave_unanswered(answer_to(port));
      } else {
        deliver(answer_to(port));
      }
      if (!busy_ && !waiting_.empty()) serve();
    });
  }
  const pan::RequestDevice& of_;
  std::vector<std::size_t> waiting_;
  bool busy_ = false;
};

class Frames final : public PlannedDevice {
 public:
  Frames(const Plan& plan, const std::string& name, const pan::FrameDevice& of, Dealer dealer,
         Payloads payloads)
      : PlannedDevice(plan, name, std::move(dealer), payloads), of_(of) {}
  void attach(runtime::DeviceHost& host) override {
    host_ = &host;
    start_ = of_.phase ? Time(*of_.phase) : between(Time(0), Time(of_.period) - Time(1));
    host_->at(start_, [this] { frame(); });
  }
  void receive(std::size_t port, std::span<const double>) override {
    if (!answers_[port].empty()) waiting_.push_back(port);
  }
  bool withdraw(std::size_t port) override {
    const auto found = std::find(waiting_.begin(), waiting_.end(), port);
    if (found == waiting_.end()) return false;
    waiting_.erase(found);
    return true;
  }

 private:
  void frame() {
    start_ += Time(of_.period);
    const std::vector<std::size_t> served = std::move(waiting_);
    waiting_.clear();
    host_->mark_busy(true);
    for (std::size_t more = 1; more < served.size(); ++more) host_->mark_busy(true);
    host_->at(host_->now() + Time(of_.collecting), [this, served] {
      host_->mark_busy(false);
      for (const std::size_t port : served) deliver(answer_to(port));
    });
    host_->at(start_, [this] { frame(); });
  }
  const pan::FrameDevice& of_;
  Time start_{};
  std::vector<std::size_t> waiting_;
};

}  // namespace

std::unique_ptr<runtime::Device> planned_device(const Plan& plan, const std::string& name, Dealer dealer,
                                                Payloads payloads) {
  for (const pan::DeviceTiming& timing : plan.environment.devices) {
    if (timing.device != name) continue;
    if (const auto* event = std::get_if<pan::EventDevice>(&timing.behaviour))
      return std::make_unique<Events>(plan, name, *event, std::move(dealer), payloads);
    if (const auto* answers = std::get_if<pan::RequestDevice>(&timing.behaviour))
      return std::make_unique<Answers>(plan, name, *answers, std::move(dealer), payloads);
    return std::make_unique<Frames>(plan, name, std::get<pan::FrameDevice>(timing.behaviour),
                                    std::move(dealer), payloads);
  }
  return std::make_unique<PlannedDevice>(plan, name, std::move(dealer), payloads);
}

}  // namespace pal::test
