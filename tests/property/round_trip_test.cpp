// PAL → PAN → PAL is the identity on programs.
#include <catch2/catch.hpp>
#include <cstdint>
#include <sstream>
#include <string>

#include "pal/check/recover.hpp"
#include "pal/syntax/print.hpp"
#include "tests/support/random_program.hpp"
#include "tests/unit/frontend/specification.hpp"

using namespace pal;

namespace {

/// The units of the kind that a network holds as graphs, in canonical form.
std::string modules_of(const syntax::Tree& tree) {
  syntax::Tree modules;
  for (const auto& unit : tree.units) {
    if (std::holds_alternative<syntax::ModuleUnit>(unit)) modules.units.push_back(unit);
  }
  std::ostringstream out;
  syntax::print(modules, out);
  return out.str();
}

std::string module_of(const pan::Network& network, const std::string& name) {
  syntax::Tree tree;
  for (std::size_t i = 0; i < network.modules.size(); ++i) {
    if (network.modules[i].name == name) tree.units.push_back(to_unit(network, pan::ModuleId(i)));
  }
  std::ostringstream out;
  syntax::print(tree, out);
  return out.str();
}

}  // namespace

TEST_CASE("PAL to PAN to PAL gives the program back") {
  constexpr std::uint64_t first_seed = 20260711;
  std::string all;
  for (std::uint64_t seed = first_seed; seed < first_seed + 400; ++seed) {
    CAPTURE(seed);
    const std::string body = test::RandomProgram(seed).module();
    const auto checked = test::check_text(test::program_declarations + body);
    REQUIRE(checked.specification.sketches.size() == 1);
    REQUIRE(module_of(checked.specification.sketches.front(), "SM1") == body);
    all += body;
  }
  // Every form of statement was among them.
  for (const char* form : {"WTM( Coordinator )",
                           "WTM( force from LS1 )\n",
                           "WTM( force from LS1 ) WITHIN 4 ms\n",
                           "WTM FIRST\n",
                           "WTM FIRST WITHIN 100 us\n",
                           "TXM( motion to MC1 )",
                           "TXM( request force from LS1 )",
                           "TXM( Completion Protocol 1 )",
                           "SPC( near )",
                           "SPC( near = TRUE )",
                           "SPC( near = FALSE )",
                           "RPC( near )",
                           "CASE\n",
                           "UNTIL( forever )",
                           "UNTIL( near",
                           "CONCURRENT\n",
                           "Execute CM1",
                           "Do Nothing",
                           "think",
                           "NOT ",
                           " AND ",
                           " OR "}) {
    CAPTURE(form);
    CHECK(all.find(form) != std::string::npos);
  }
}

TEST_CASE("the modules of the touch skill come back from their networks") {
  auto text = test::source_file("skills_pal/touch/touch_modules.pal");
  const auto checked = test::check_text(text);
  const auto& specification = checked.specification;
  REQUIRE(specification.sketches.size() == 1);
  const auto& network = specification.sketches.front();
  std::string once;
  for (const auto& module : network.modules) once += module_of(network, module.name);
  const auto declarations = text.substr(0, text.find("Sensor Driver:"));
  const auto again = test::check_text(declarations + once);
  REQUIRE_FALSE(again.diagnostics.has_errors());
  CHECK(modules_of(again.trees.front()).size() > 500);
  const auto& other = again.specification.sketches.front();
  for (const auto& module : network.modules)
    CHECK(module_of(other, module.name) == module_of(network, module.name));
}
