// The class of the skill, which a dispatcher runs.
#include <algorithm>

#include "codegen/emit.hpp"
#include "codegen/names.hpp"

namespace pal::codegen {

namespace {

/// What the skill is made of: "std::unique_ptr<SM1Activities> sm1", …
std::vector<std::string> makings(const Plan& plan) {
  std::vector<std::string> result;
  for (const PlannedModule& module : plan.modules) {
    if (!module.interface.empty())
      result.push_back("std::unique_ptr<" + module.interface + "> " + module.variable);
  }
  return result;
}

std::string factory(const Plan& plan) {
  return "std::unique_ptr<runtime::Skill> make_" + plan.name + "(";
}

std::string skill_header(const Plan& plan) {
  Writer out;
  write_heading(out, plan, "Skill " + plan.skill.name + ", for the dispatcher.");
  out.line("#pragma once").line();
  out.line("#include <memory>").line();
  out.line("#include \"" + plan.file + "_activities.hpp\"");
  out.line("#include \"pal/runtime/skill.hpp\"");
  open_namespace(out, plan);
  out.line("const runtime::SkillDescription& description();").line();
  out.line("/// The skill with the activities of its modules, none of them null.");
  out.list(factory(plan), makings(plan), ");");
  close_namespace(out, plan);
  return out.take();
}

void write_description(Writer& out, const Plan& plan) {
  out.open("constexpr std::array<std::string_view, " + std::to_string(plan.skill.descriptions.size()) +
           "> descriptions{{");
  for (const std::string& text : plan.skill.descriptions) out.line(literal(text) + ",");
  out.close("}};").line();
  out.open("constexpr std::array<runtime::CompletionSpec, " + std::to_string(plan.skill.completions.size()) +
           "> completions{{");
  for (const pan::Completion& completion : plan.skill.completions) {
    std::string kind = "normal";
    if (completion.kind == pan::Completion::Kind::contingency) kind = "contingency";
    if (completion.kind == pan::Completion::Kind::error) kind = "error";
    out.line("{" + std::to_string(completion.code) + ", runtime::CompletionSpec::Kind::" + kind + ", " +
             literal(completion.description) + "},");
  }
  out.close("}};").line();
}

void write_class(Writer& out, const Plan& plan) {
  out.line("class " + plan.skill_class + " final : public runtime::Skill {");
  out.line(" public:").indent();
  std::vector<std::string> initialisers;
  for (const PlannedModule& module : plan.modules) {
    if (!module.interface.empty()) {
      initialisers.push_back(module.variable + "_activities_(std::move(" + module.variable + "))");
    }
  }
  if (!initialisers.empty()) {
    out.list("explicit " + plan.skill_class + "(", makings(plan), ")");
    out.list("    : ", initialisers, " {}").line();
  }
  out.line("const runtime::SkillDescription& description() const override { return " + plan.name +
           "::description(); }");
  out.line("const runtime::Wiring& wiring() const override { return " + plan.name + "::wiring(); }").line();
  out.line("void reset_parameters() override { parameters_ = {}; }");
  out.open("void set_parameter(std::string_view name, double value) override {");
  out.line("if (!" + plan.name +
           "::set_parameter(parameters_, name, value)) "
           "runtime::unknown_parameter(description(), name);");
  out.close();
  const bool texts = std::any_of(plan.parameters.begin(), plan.parameters.end(), [](const auto& parameter) {
    return parameter.pal.type == pan::ScalarType::text;
  });
  if (texts) {
    out.open("void set_text_parameter(std::string_view name, std::string_view text) override {");
    out.line("if (!" + plan.name +
             "::set_text_parameter(parameters_, name, text)) Skill::set_text_parameter(name, text);");
    out.close();
  }
  out.line();
  out.open("void start() override {");
  for (const PlannedModule& module : plan.modules) out.line(module.variable + "_.start(parameters_);");
  out.close().line();
  if (!initialisers.empty()) {
    out.open("bool promise_broken(const runtime::BrokenPromise& broken) override {");
    out.line("bool answered = false;");
    for (const PlannedModule& module : plan.modules) {
      if (!module.interface.empty())
        out.line("answered = " + module.variable + "_activities_->promise_broken(broken) || answered;");
    }
    out.line("return answered;");
    out.close().line();
  }
  out.open("runtime::Task body(std::size_t index, runtime::Thread& thread) override {");
  out.line("switch (index) {").indent();
  for (const PlannedModule& module : plan.modules) {
    if (!module.executed) {
      for (const PlannedThread& thread : plan.threads) {
        const bool own = !thread.parent && plan.modules[thread.module].pal_name == module.pal_name;
        if (own) {
          out.line("case thread_of::" + thread.constant + ":").indent();
          out.line("return " + module.variable + "_.body(thread);").outdent();
        }
      }
    }
    for (const auto& block : module.blocks) {
      for (const std::size_t thread : block.threads)
        out.line("case thread_of::" + plan.threads[thread].constant + ":");
      out.indent().line("return " + module.variable + "_." + block.function + "(thread);").outdent();
    }
  }
  out.line("default:").indent().line("return {};").outdent();
  out.close("}");
  out.close().line();
  std::vector<std::string> reserves;
  for (const PlannedModule& module : plan.modules) {
    for (std::size_t each = 0; each < module.runners.size(); ++each)
      reserves.push_back(module.variable + "_.body(thread)");
  }
  if (reserves.empty()) {
    out.line("void reserve_executed(runtime::Thread&) override {}");
  } else {
    out.open("void reserve_executed(runtime::Thread& thread) override {");
    if (reserves.size() == 1) {
      out.line("static_cast<void>(" + reserves.front() + ");");
    } else {
      out.line("// All that can be there at a time, together.");
      out.list("const std::array bodies{", reserves, "};");
    }
    out.close();
  }
  out.outdent().line().line(" private:").indent();
  out.line("Parameters parameters_;");
  for (const PlannedModule& module : plan.modules) {
    if (!module.interface.empty()) {
      out.line("std::unique_ptr<" + module.interface + "> " + module.variable + "_activities_;");
    }
  }
  for (const PlannedStore& store : plan.stores) out.line(store.type + " " + store.variable + "_;");
  // A module comes after those that it executes.
  std::vector<bool> written(plan.modules.size(), false);
  for (std::size_t round = 0; round < plan.modules.size(); ++round) {
    for (std::size_t m = 0; m < plan.modules.size(); ++m) {
      const PlannedModule& module = plan.modules[m];
      bool can = !written[m];
      for (const std::size_t other : module.executes) can = can && written[other];
      if (!can) continue;
      written[m] = true;
      std::string made;
      if (!module.interface.empty()) made = "*" + module.variable + "_activities_";
      if (const PlannedStore* store = store_of(plan, module))
        made += (made.empty() ? "" : ", ") + store->variable + "_";
      for (const std::size_t other : module.executes) {
        made += (made.empty() ? "" : ", ") + plan.modules[other].variable + "_";
      }
      out.line(module.type + " " + module.variable + "_" + (made.empty() ? "" : "{" + made + "}") + ";");
    }
  }
  out.close("};");
}

std::string skill_source(const Plan& plan) {
  Writer out;
  write_heading(out, plan, "Skill " + plan.skill.name + ", for the dispatcher.");
  out.line("#include \"" + plan.file + "_skill.hpp\"").line();
  out.line("#include <array>")
      .line("#include <cstddef>")
      .line("#include <string_view>")
      .line("#include <utility>")
      .line();
  out.line("#include \"" + plan.file + "_modules.hpp\"");
  out.line("#include \"" + plan.file + "_wiring.hpp\"");
  open_namespace(out, plan);
  out.line("namespace {").line();
  write_description(out, plan);
  write_class(out, plan);
  out.line().line("}  // namespace").line();
  out.open("const runtime::SkillDescription& description() {");
  out.line("static const runtime::SkillDescription text{" + literal(plan.skill.name) + ", " +
           literal(plan.environment.name) + ", descriptions, parameter_specs, completions};");
  out.line("return text;");
  out.close().line();
  out.list(factory(plan), makings(plan), ") {").indent();
  std::string moved;
  for (const PlannedModule& module : plan.modules) {
    if (!module.interface.empty())
      moved += (moved.empty() ? "" : ", ") + ("std::move(" + module.variable + ")");
  }
  out.line("return std::make_unique<" + plan.skill_class + ">(" + moved + ");");
  out.close();
  close_namespace(out, plan);
  return out.take();
}

}  // namespace

std::vector<GeneratedFile> emit_skill(const Plan& plan) {
  return {{plan.file + "_skill.hpp", skill_header(plan)}, {plan.file + "_skill.cpp", skill_source(plan)}};
}

}  // namespace pal::codegen
