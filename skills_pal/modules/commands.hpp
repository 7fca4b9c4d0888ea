// SM2 and SM3 of commands.pal, and the list that SM2 gives.
#pragma once

#include <initializer_list>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/drivers/val/protocol.hpp"
#include "skills_pal/modules/signature.hpp"

namespace pal::skills {

using runtime::drivers::val::Verb;

/// What SM1 and its contingency list, and SM2 gives: they run one after the other. `Command` is the message.
template <class Command>
class CommandList {
 public:
  CommandList() { commands_.reserve(room); }

  /// Drops what is left of the last list.
  void begin() {
    commands_.clear();
    next_ = 0;
  }
  /// The fields that count are those that the verb names. No more than `room` commands a list: more allocate.
  CommandList& add(Verb verb, double a = 0, double b = 0, double c = 0) {
    Command command;
    command.verb = static_cast<std::int64_t>(verb);
    command.a = a;
    command.b = b;
    command.c = c;
    commands_.push_back(command);
    return *this;
  }
  CommandList& add(Verb verb, const runtime::Text& location, double a = 0, double b = 0, double c = 0) {
    add(verb, a, b, c);
    commands_.back().location = location;
    return *this;
  }
  /// Of the motions that follow, per cent of the arm's. Takes back a speed in mm/s that was set before.
  CommandList& set_speed(double percent) { return add(Verb::speed, percent).add(Verb::joint_speed, 100); }
  /// The one that was added last, to fill in what is left.
  Command& last() { return commands_.back(); }

  Command take() { return next_ < commands_.size() ? commands_[next_++] : Command{}; }
  bool taken() const { return next_ >= commands_.size(); }

 private:
  static constexpr std::size_t room = 16;
  std::vector<Command> commands_;
  std::size_t next_ = 0;
};

/// SM2.
template <class Interface>
class Commands final : public Interface {
  using Command = ResultOf<&Interface::give>;
  using Answer = ArgumentOf<&Interface::decide_pc_ok>;
  using Error = runtime::drivers::val::Error;

 public:
  explicit Commands(std::shared_ptr<CommandList<Command>> list) : list_(std::move(list)) {}

  Command give() override { return list_->take(); }
  bool decide_pc_ok(const Answer& answer) override { return answer.ok; }
  bool decide_pc_refused(const Answer& answer) override { return is(answer, Error::unreachable); }
  bool decide_pc_hit(const Answer& answer) override { return is(answer, Error::arm_fault); }
  bool decide_pc_listed() override { return list_->taken(); }

 private:
  static bool is(const Answer& answer, Error error) {
    return answer.code == static_cast<std::int64_t>(error);
  }

  std::shared_ptr<CommandList<Command>> list_;
};

/// SM3. Its exception is what ends the skill, with the error completion of its template.
template <class Interface>
class Report final : public Interface {
  using Answer = ArgumentOf<&Interface::report>;

 public:
  void report(const Answer& answer) override {
    throw std::runtime_error("VAL: " + std::string(answer.error.view()));
  }
};

}  // namespace pal::skills
