// A skill that lists commands for VAL: what all of them are made of.
#pragma once

#include <memory>
#include <utility>

#include "pal/runtime/skill.hpp"
#include "skills_pal/modules/commands.hpp"
#include "skills_pal/modules/signature.hpp"

namespace pal::skills {

/// A module that lists commands by the skill's parameters; `Interface` has its activities, `Command` is the
/// message.
template <class Interface, class Command>
class Listing : public Interface {
 public:
  using List = CommandList<Command>;
  using Parameters = ArgumentOf<&Interface::start>;

  explicit Listing(std::shared_ptr<List> list) : list_(std::move(list)) {}
  void start(const Parameters& parameters) override { parameters_ = parameters; }

 protected:
  List& list() { return *list_; }
  const Parameters& parameters() const { return parameters_; }

 private:
  std::shared_ptr<List> list_;
  Parameters parameters_;
};

/// The skill that `make` makes of SM1 (`Method`), SM2 and SM3, which share the list, and of its other
/// modules.
template <class Method, class GiveInterface, class ReportInterface, class Make, class... Others>
std::unique_ptr<runtime::Skill> make_listing(Make make, std::shared_ptr<typename Method::List> list,
                                             Others... others) {
  return make(std::make_unique<Method>(list), std::make_unique<Commands<GiveInterface>>(list),
              std::make_unique<Report<ReportInterface>>(), std::move(others)...);
}

}  // namespace pal::skills
