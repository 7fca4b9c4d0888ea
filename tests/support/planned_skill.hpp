// A skill that the runtime runs without C++ of its own. It awaits what generated code would await, as the
// plan of the code generator says.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "codegen/plan.hpp"
#include "pal/runtime/dispatcher.hpp"
#include "pal/runtime/thread.hpp"

namespace pal::test {

/// Deals out times and outcomes.
using Dealer = std::function<std::uint64_t(std::uint64_t)>;  // of 0 … n-1

class PlannedSkill final : public runtime::Skill {
 public:
  PlannedSkill(const codegen::Plan& plan, Dealer dealer);

  const runtime::SkillDescription& description() const override { return description_; }
  const runtime::Wiring& wiring() const override { return wiring_; }
  void reset_parameters() override {}
  void set_parameter(std::string_view name, double) override {
    runtime::unknown_parameter(description_, name);
  }
  void start() override {}
  runtime::Task body(std::size_t index, runtime::Thread& thread) override;
  void reserve_executed(runtime::Thread&) override {}

 private:
  struct Follower {
    PlannedSkill* skill;
    const codegen::PlannedBody* body;
    runtime::Task follow(runtime::Thread& thread);
  };
  void require();
  Follower& follower(const codegen::PlannedBody& body);
  const codegen::PlannedBody* block(const codegen::PlannedBody& body, std::size_t thread) const;

  const codegen::Plan& plan_;
  Dealer dealer_;
  std::map<const codegen::PlannedBody*, std::unique_ptr<Follower>> followers_;
  std::vector<runtime::ProcessorSpec> processors_;
  std::vector<runtime::ThreadSpec> threads_;
  std::vector<runtime::StatementSpec> statements_;
  std::vector<runtime::ChannelSpec> channels_;
  std::vector<std::string_view> conditions_;
  std::vector<std::string_view> devices_;
  std::vector<runtime::CompletionSpec> completions_;
  std::vector<runtime::DeviceTimes> times_;
  std::deque<std::vector<int>> indices_;
  std::vector<runtime::RequirementSpec> requirements_;
  std::vector<runtime::KeptSpec> kept_;
  runtime::SkillDescription description_;
  runtime::Wiring wiring_;
};

/// What messages of devices carry: nothing, as PlannedSkill has it; or all their fields, each of them zero.
enum class Payloads { none, zeros };

/// The device of that name as the environment of `plan` describes it, with times that `dealer` deals out.
std::unique_ptr<runtime::Device> planned_device(const codegen::Plan& plan, const std::string& name,
                                                Dealer dealer, Payloads payloads = Payloads::none);

}  // namespace pal::test
