#include "tests/run/skills/support/slower.hpp"

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
  std::unique_ptr<runtime::Skill> skill_;
  std::vector<runtime::StatementSpec> statements_;
  runtime::Wiring wiring_;
};

}  // namespace

std::string slow_down(const std::string& workcell, const Slower& slower) {
  const std::regex line("TIME " + slower.activity + " +OF " + slower.module + " *:[^\n]*");
  if (!std::regex_search(workcell, line))
    throw std::runtime_error("the workcell has no time of " + slower.activity);
  return std::regex_replace(workcell, line,
                            "TIME " + slower.activity + " OF " + slower.module + " : " +
                                std::to_string(slower.milliseconds) + " ms");
}

std::unique_ptr<runtime::Skill> slow_down(std::unique_ptr<runtime::Skill> skill, const Slower& slower) {
  return std::make_unique<SlowerSkill>(std::move(skill), slower);
}

}  // namespace pal::test
