// The file that makes a plug-in of a skill: what a host asks for when it loads it (pal/runtime/plugin.hpp).
#include "codegen/emit.hpp"
#include "codegen/names.hpp"

namespace pal::codegen {

namespace {

/// The text as string literals, one a line.
void write_text(Writer& out, std::string_view name, std::string_view text) {
  out.open("{" + literal(name) + ",");
  if (text.empty()) out.line("\"\"");
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end == std::string_view::npos ? text.size() : end + 1);
    out.line(literal(line));
    text.remove_prefix(line.size());
  }
  out.close("},");
}

}  // namespace

GeneratedFile emit_plugin(const Plan& plan, const SourceManager& sources, FileId declared) {
  Writer out;
  write_heading(out, plan, "Skill " + plan.skill.name + " as a file of its own, which a host loads.");
  out.line("#include <array>").line("#include <memory>").line();
  out.line("#include \"pal/runtime/plugin.hpp\"").line();
  out.line("#ifndef PAL_SKILL_FOLDER").line("#define PAL_SKILL_FOLDER \"\"").line("#endif").line();
  out.line("namespace pal::skills {").line();
  out.line("/// The skill with its activities. You write it.");
  out.line("std::unique_ptr<runtime::Skill> " + plan.name + "_skill();").line();
  out.line("namespace {").line();
  out.open("constexpr std::array<runtime::SourceText, " + std::to_string(sources.size()) + "> sources{{");
  for (std::size_t i = 0; i < sources.size(); ++i)
    write_text(out, sources.name(FileId(i)), sources.text(FileId(i)));
  out.close("}};").line();
  out.line("}  // namespace").line();
  out.line("}  // namespace pal::skills").line();
  out.open(
      "extern \"C\" __attribute__((visibility(\"default\"))) const pal::runtime::SkillPlugin* pal_skill() {");
  out.line("static const pal::runtime::SkillPlugin plugin{");
  out.indent().indent();
  out.line("pal::runtime::plugin_interface, " + literal(plan.skill.name) + ", pal::skills::" + plan.name +
           "_skill, PAL_SKILL_FOLDER,");
  out.line(literal(sources.name(plan.skill.where.file)) + ", " +
           literal(sources.name(plan.environment.where.file)) + ", " +
           literal(declared.valid() ? sources.name(declared) : std::string()) + ", pal::skills::sources};");
  out.outdent().outdent();
  out.line("return &plugin;");
  out.close();
  return {plan.file + "_plugin.cpp", out.take()};
}

}  // namespace pal::codegen
