// make_skills FOLDER COUNT UNITS: writes COUNT random skills as C++, in UNITS files to compile.
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "codegen/generate.hpp"
#include "tests/support/any_skill.hpp"
#include "tests/support/drawn_program.hpp"

using namespace pal;

namespace {

constexpr int longest = 5;
constexpr std::size_t most_statements = 32;  // what compiles for long says no more

/// The due instant of an event that may be late is not in the trace, so the machine could not follow it.
std::string punctual(std::string text) {
  for (std::size_t at = text.find(" JITTER "); at != std::string::npos; at = text.find(" JITTER ")) {
    const std::size_t end = text.find(" ms", at);
    text.erase(at, end + 3 - at);
  }
  return text;
}

/// In half of them messages have fields, so that payloads are there.
std::string with_fields(std::string text, std::uint64_t seed) {
  if (seed % 2 == 0) return text;
  const std::pair<const char*, const char*> changes[] = {
      {"MESSAGE force : SIGNAL", "MESSAGE force : REAL N"},
      {"MESSAGE raw : SIGNAL", "MESSAGE raw : x : REAL[3] mm; count : INTEGER; good : BOOLEAN; name : TEXT"},
      {"MESSAGE motion : SIGNAL", "MESSAGE motion : dx, dz : REAL mm"},
      {"MESSAGE correction : SIGNAL", "MESSAGE correction : dz : REAL mm; count : INTEGER"}};
  for (const auto& [from, to] : changes) {
    const std::size_t at = text.find(from);
    if (at != std::string::npos) text.replace(at, std::string(from).size(), to);
  }
  return text;
}

/// Skills of one program have different names.
std::string named(std::string text, std::uint64_t seed) {
  const std::string heading = "SKILL random\n";
  const std::size_t at = text.find(heading);
  if (at == std::string::npos) return {};
  return text.replace(at, heading.size(), "SKILL random-" + std::to_string(seed) + "\n");
}

std::string result(const codegen::Plan& plan, const codegen::PlannedMethod& method) {
  if (method.kind == codegen::PlannedMethod::Kind::decide) return "bool";
  if (method.writes.empty()) return "void";
  return method.writes.size() == 1 ? plan.messages[method.writes.front()].type : method.result_type;
}

/// What a system programmer would write.
void write_by_hand(const codegen::Plan& plan, std::ostream& out) {
  out << "namespace pal::skills::" << plan.name << " {\nnamespace {\n";
  for (const codegen::PlannedModule& module : plan.modules) {
    if (module.interface.empty()) continue;
    out << "struct " << module.type << "ByHand final : " << module.interface << " {\n"
        << "  explicit " << module.type << "ByHand(std::shared_ptr<Dealer> given) : dealer(given) {}\n";
    for (const codegen::PlannedMethod& method : module.methods) {
      out << "  " << result(plan, method) << " " << method.name << "(";
      for (std::size_t r = 0; r < method.reads.size(); ++r)
        out << (r == 0 ? "const " : ", const ") << plan.messages[method.reads[r]].type << "&";
      const bool decides = method.kind == codegen::PlannedMethod::Kind::decide;
      out << ") override { "
          << (decides                 ? "return (*dealer)(2) == 1;"
              : method.writes.empty() ? ""
                                      : "return {};")
          << " }\n";
    }
    out << "  std::shared_ptr<Dealer> dealer;\n};\n";
  }
  out << "std::unique_ptr<runtime::Skill> make(Dealer dealer) {\n"
      << "  const auto shared = std::make_shared<Dealer>(std::move(dealer));\n  return make_" << plan.name
      << "(";
  bool first = true;
  for (const codegen::PlannedModule& module : plan.modules) {
    if (module.interface.empty()) continue;
    out << (first ? "" : ", ") << "std::make_unique<" << module.type << "ByHand>(shared)";
    first = false;
  }
  out << ");\n}\n}  // namespace\n"
      << "CompiledSkill compiled(std::uint64_t seed, const char* text) { return {seed, text, make}; }\n"
      << "}  // namespace pal::skills::" << plan.name << "\n";
}

/// One file of all generated ones, which include one another.
void write_generated(const std::vector<codegen::GeneratedFile>& files, const std::string& prefix,
                     std::ostream& out) {
  for (const bool headers : {true, false}) {
    for (const codegen::GeneratedFile& file : files) {
      if (file.name.ends_with(".hpp") != headers) continue;
      std::istringstream lines(file.text);
      for (std::string line; std::getline(lines, line);) {
        if (line == "#pragma once" || line.starts_with("#include \"" + prefix + "_")) continue;
        out << line << '\n';
      }
    }
  }
}

struct Unit {
  std::ostringstream text;
};

bool add(std::uint64_t seed, Unit& unit, std::ostream& declarations, std::ostream& list) {
  const std::string text = named(with_fields(punctual(test::drawn_program(seed, longest)), seed), seed);
  if (text.empty()) return false;
  const auto skill = test::any_skill(text);
  if (!skill->problem) return false;
  Diagnostics diagnostics;
  const auto plan =
      codegen::make_plan(skill->specification.skills.front(), skill->specification.environments.front(),
                         skill->sources, diagnostics);
  if (!plan || plan->statements.size() > most_statements) return false;
  write_generated(codegen::emit(*plan), plan->file, unit.text);
  write_by_hand(*plan, unit.text);
  declarations << "namespace pal::skills::" << plan->name
               << " { pal::test::CompiledSkill compiled(std::uint64_t seed, const char* text); }\n";
  list << "    pal::skills::" << plan->name << "::compiled(" << seed << ", R\"pal(" << text << ")pal\"),\n";
  return true;
}

int write(const std::string& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  if (out.flush()) return 0;
  std::cerr << "make_skills: cannot write " << path << '\n';
  return 2;
}

}  // namespace

int main(int count_of_arguments, char** arguments) {
  if (count_of_arguments != 4) {
    std::cerr << "make_skills FOLDER COUNT UNITS\n";
    return 2;
  }
  const std::string folder = arguments[1];
  const auto count = static_cast<std::size_t>(std::atoi(arguments[2]));
  std::vector<Unit> units(static_cast<std::size_t>(std::atoi(arguments[3])));
  for (Unit& unit : units) {
    unit.text
        << "#include <array>\n#include <functional>\n#include <memory>\n#include <utility>\n"
           "#include \"tests/run/compiled/compiled_skill.hpp\"\n"
           "using Dealer = std::function<std::uint64_t(std::uint64_t)>;\nusing pal::test::CompiledSkill;\n";
  }
  std::ostringstream declarations, list;
  std::size_t made = 0;
  for (std::uint64_t seed = 1; made < count; ++seed)
    made += add(seed, units[made % units.size()], declarations, list) ? 1 : 0;
  int status = 0;
  for (std::size_t u = 0; u < units.size(); ++u)
    status += write(folder + "/unit_" + std::to_string(u) + ".cpp", units[u].text.str());
  status += write(folder + "/all.cpp",
                  "#include \"tests/run/compiled/compiled_skill.hpp\"\n" + declarations.str() +
                      "std::vector<pal::test::CompiledSkill> pal::test::compiled_skills() {\n  return {\n" +
                      list.str() + "  };\n}\n");
  return status == 0 ? 0 : 2;
}
