#include "tests/run/skills/support/slower.hpp"

#include <algorithm>
#include <regex>
#include <stdexcept>
#include <vector>

namespace pal::test {

namespace {

class SlowerSkill final : public runtime::Skill {
 public:
  SlowerSkill(std::unique_ptr<runtime::Skill> skill, const Slower& slower)
      : skill_(std::move(skill)),
        statements_(skill_->wiring().statements.begin(), skill_->wiring().statements.end()),
        threads_(skill_->wiring().threads.begin(), skill_->wiring().threads.end()),
        wiring_(skill_->wiring()) {
    bool found = false;
    for (runtime::StatementSpec& statement : statements_) {
      if (statement.module != slower.module || statement.text != slower.activity) continue;
      const runtime::Time time = std::chrono::milliseconds(slower.milliseconds);
      statement.cost = {time, time};
      found = true;
    }
    if (!found) throw std::runtime_error("the skill has no activity " + slower.activity);
    wiring_.statements = statements_;
    if (!slower.processor.empty()) place(slower);
    wiring_.threads = threads_;
  }

  const runtime::SkillDescription& description() const override { return skill_->description(); }
  const runtime::Wiring& wiring() const override { return wiring_; }
  void reset_parameters() override { skill_->reset_parameters(); }
  void set_parameter(std::string_view name, double value) override { skill_->set_parameter(name, value); }
  void set_text_parameter(std::string_view name, std::string_view text) override {
    skill_->set_text_parameter(name, text);
  }
  void start() override { skill_->start(); }
  runtime::Task body(std::size_t index, runtime::Thread& thread) override {
    return skill_->body(index, thread);
  }
  void reserve_executed(runtime::Thread& thread) override { skill_->reserve_executed(thread); }

 private:
  void place(const Slower& slower) {
    const auto& all = wiring_.processors;
    const auto processor = std::find_if(all.begin(), all.end(), [&](const runtime::ProcessorSpec& spec) {
      return spec.name == slower.processor;
    });
    const auto thread = std::find_if(threads_.begin(), threads_.end(), [&](const runtime::ThreadSpec& spec) {
      return spec.name == slower.module;
    });
    if (processor == all.end() || thread == threads_.end())
      throw std::runtime_error("the skill has no processor " + slower.processor + " or no module " +
                               slower.module);
    thread->processor = static_cast<int>(processor - all.begin());
  }

  std::unique_ptr<runtime::Skill> skill_;
  std::vector<runtime::StatementSpec> statements_;
  std::vector<runtime::ThreadSpec> threads_;
  runtime::Wiring wiring_;
};

}  // namespace

namespace {

std::string replaced(const std::string& text, const std::string& line, const std::string& by) {
  const std::regex pattern(line);
  if (!std::regex_search(text, pattern)) throw std::runtime_error("the workcell has no line " + line);
  return std::regex_replace(text, pattern, by);
}

}  // namespace

std::string slow_down(const std::string& workcell, const Slower& slower) {
  const std::string time = "TIME " + slower.activity + " OF " + slower.module + " : " +
                           std::to_string(slower.milliseconds) + " ms";
  const std::regex given("TIME " + slower.activity + " +OF " + slower.module + " *:[^\n]*");
  // The time of a skill's own activity stands in the skill; one of the workcell counts instead.
  const std::string text = std::regex_search(workcell, given)
                               ? std::regex_replace(workcell, given, time)
                               : replaced(workcell, "END ENVIRONMENT", time + "\nEND ENVIRONMENT");
  if (slower.processor.empty()) return text;
  const std::string place = "PLACE " + slower.module + " ON ";
  return replaced(text, place + "\\w+", place + slower.processor);
}

std::unique_ptr<runtime::Skill> slow_down(std::unique_ptr<runtime::Skill> skill, const Slower& slower) {
  return std::make_unique<SlowerSkill>(std::move(skill), slower);
}

}  // namespace pal::test
