// The header in which an activity finds its arguments, and its body by hand is declared; empty bodies to
// begin with.
#include "codegen/emit.hpp"

namespace pal::codegen {

namespace {

std::string result(const Plan& plan, const PlannedMethod& method) {
  if (method.kind == PlannedMethod::Kind::decide) return "bool";
  if (method.writes.empty()) return "void";
  if (method.writes.size() == 1) return plan.messages[method.writes.front()].type;
  return method.result_type;
}

std::string parameters(const Plan& plan, const PlannedMethod& method, bool used = true) {
  std::string text;
  for (const std::size_t index : method.reads) {
    const PlannedMessage& message = plan.messages[index];
    const std::string name = used ? message.variable : "/*" + message.variable + "*/";
    text += (text.empty() ? "const " : ", const ") + message.type + "& " + name;
  }
  return text;
}

void write_results(Writer& out, const Plan& plan, const PlannedModule& module) {
  for (const PlannedMethod& method : module.methods) {
    if (method.result_type.empty()) continue;
    out.line("/// What " + method.pal + " of " + module.pal_name + " gives.");
    out.open("struct " + method.result_type + " {");
    for (const std::size_t index : method.writes) {
      out.line(plan.messages[index].type + " " + plan.messages[index].variable + ";");
    }
    out.close("};").line();
  }
}

void write_interface(Writer& out, const Plan& plan, const PlannedModule& module) {
  write_results(out, plan, module);
  out.line("/// What " + module.kind + " " + module.pal_name + " leaves to its author.");
  out.line("class " + module.interface + " {");
  out.line(" public:").indent();
  out.line("virtual ~" + module.interface + "() = default;").line();
  out.line("/// A run of the skill begins: what was left from the last one is to be forgotten.");
  out.line("virtual void start(const Parameters&) {}").line();
  out.line(
      "/// A promise was broken, and the run asks for a contingency. True: what is computed from now on "
      "answers");
  out.line("/// it.");
  out.line("virtual bool promise_broken(const runtime::BrokenPromise&) { return false; }");
  for (const PlannedMethod& method : module.methods) {
    out.line();
    out.line("/// " + method.pal + (method.description.empty() ? "" : ": " + method.description));
    out.line("virtual " + result(plan, method) + " " + method.name + "(" + parameters(plan, method) +
             ") = 0;");
  }
  out.close("};");
}

}  // namespace

GeneratedFile emit_empty_activities(const Plan& plan) {
  Writer out;
  out.line("// The activities of skill " + plan.skill.name + ". Each is empty yet: yours to write.");
  out.line("#include <memory>").line();
  out.line("#include \"" + plan.file + "_skill.hpp\"").line();
  out.line("namespace pal::skills {").line();
  out.line("namespace " + plan.name + " {").line("namespace {").line();
  std::string made;
  for (const PlannedModule& module : plan.modules) {
    if (module.interface.empty()) continue;
    const std::string type = module.interface + "ByHand";
    made += (made.empty() ? "" : ", ") + ("std::make_unique<" + plan.name + "::" + type + ">()");
    out.line("class " + type + " final : public " + module.interface + " {");
    out.line(" public:").indent();
    out.line("void start(const Parameters& /*parameters*/) override {}");
    for (const PlannedMethod& method : module.methods) {
      const std::string given = result(plan, method);
      const std::string body = given == "void"   ? "{}"
                               : given == "bool" ? "{ return false; }"
                                                 : "{ return {}; }";
      out.line(given + " " + method.name + "(" + parameters(plan, method, false) + ") override " + body);
    }
    out.close("};").line();
  }
  out.line("}  // namespace").line("}  // namespace " + plan.name).line();
  out.open("std::unique_ptr<runtime::Skill> " + plan.name + "_skill() {");
  out.line("return " + plan.name + "::make_" + plan.name + "(" + made + ");");
  out.close().line();
  out.line("}  // namespace pal::skills");
  return {plan.file + ".cpp", out.take()};
}

GeneratedFile emit_activities(const Plan& plan) {
  Writer out;
  write_heading(out, plan, "What the system programmer writes for skill " + plan.skill.name + ".");
  out.line("//");
  out.line(
      "// The methods are called one at a time, at the instant at which the statement has its effect. None "
      "may wait, or");
  out.line("// allocate once the skill runs. One that throws ends the skill with its error completion.");
  out.line("#pragma once").line();
  out.line("#include \"" + plan.file + "_messages.hpp\"");
  out.line("#include \"" + plan.file + "_parameters.hpp\"");
  out.line("#include \"pal/runtime/broken_promise.hpp\"");
  open_namespace(out, plan);
  bool first = true;
  for (const PlannedModule& module : plan.modules) {
    if (module.interface.empty()) continue;
    if (!first) out.line();
    first = false;
    write_interface(out, plan, module);
  }
  close_namespace(out, plan);
  return {plan.file + "_activities.hpp", out.take()};
}

}  // namespace pal::codegen
