// PAL → PAN → PAL, and PAL → PAN → DOT → PAN, are the identity on programs.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <random>
#include <sstream>
#include <string>

#include "pal/check/to_unit.hpp"
#include "pal/pan/dot.hpp"
#include "pal/pan/dump.hpp"
#include "pal/syntax/print.hpp"
#include "tests/support/random_program.hpp"
#include "tests/support/touch_files.hpp"
#include "tests/unit/check/specification.hpp"

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
    if (network.modules[i].name == name) tree.units.push_back(check::to_unit(network, pan::ModuleId(i)));
  }
  std::ostringstream out;
  syntax::print(tree, out);
  return out.str();
}

std::string dump_of(const pan::Network& network) {
  std::ostringstream out;
  pan::dump(network, out);
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
  auto text = test::touch_modules_text();
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

TEST_CASE("a module drawn as DOT is read back as the same network") {
  constexpr std::uint64_t first_seed = 20260712;
  for (std::uint64_t seed = first_seed; seed < first_seed + 300; ++seed) {
    CAPTURE(seed);
    const std::string body = test::RandomProgram(seed).module();
    const auto checked = test::check_text(test::program_declarations + body);
    REQUIRE(checked.specification.sketches.size() == 1);
    const auto& network = checked.specification.sketches.front();
    const auto module = std::find_if(network.modules.begin(), network.modules.end(),
                                     [](const pan::Module& it) { return it.name == "SM1"; });
    REQUIRE(module != network.modules.end());
    const pan::ModuleId id(static_cast<std::size_t>(module - network.modules.begin()));
    pan::DotOptions letters;
    letters.letters = true;
    letters.direction = pan::DotOptions::Direction::left_to_right;
    for (const auto& options : {pan::DotOptions(), letters}) {
      MemoryFileSystem files;
      const std::string dot = pan::to_dot(network, id, options);
      files.add("SM1.dot", dot);
      files.add("a.pal", "USES \"SM1.dot\"\n" + test::program_declarations);
      const auto again = test::check_files(files, {"a.pal"});
      CAPTURE(body, dot);
      REQUIRE(again.specification.sketches.size() == 1);
      REQUIRE(module_of(again.specification.sketches.front(), "SM1") == body);
      REQUIRE(dump_of(again.specification.sketches.front()) == dump_of(network));
    }
  }
}

TEST_CASE("the templates of logical sensors come back from PAN and from DOT") {
  const std::string declarations =
      "MESSAGE force : REAL N\nMESSAGE load : REAL N\nSensor Driver: SD1\nSensor Driver: SD2\nSkill Module: "
      "SM1\n";
  const std::string body =
      "  ACTIVITY make READS load WRITES force\n"
      "BEGIN\n  REPEAT\n    WTM( request force from SM1 )\n    TXM( request load from SD1 )\n"
      "    WTM( load from SD1 )\n    make\n    TXM( force to SM1 )\n  UNTIL( forever )\nEND\n";
  for (const std::string slots : {"", "  DESCRIPTION   \"the force; of the tool\"\n  SENSOR DRIVER SD1\n",
                                  "  METHOD \"a; b\"\n  METHOD \"<c \\\"100 %\\\" \\\\>\"\n",
                                  "  DESCRIPTION   \"one\"\n  DESCRIPTION   \"\"\n  SENSOR DRIVER SD1\n  "
                                  "METHOD        \"m\"\n  RETURNS       force\n"}) {
    const std::string text = "Logical Sensor: LS1\n" + slots + body;
    const auto checked = test::check_text(declarations + text);
    CAPTURE(text);
    REQUIRE_FALSE(checked.diagnostics.has_errors());
    const auto& network = checked.specification.sketches.front();
    const auto once = module_of(network, "LS1");
    CHECK(once == text);
    for (std::size_t i = 0; i < network.modules.size(); ++i) {
      if (network.modules[i].name != "LS1") continue;
      MemoryFileSystem files;
      files.add("LS1.dot", pan::to_dot(network, pan::ModuleId(i)));
      files.add("a.pal", "USES \"LS1.dot\"\n" + declarations);
      const auto again = test::check_files(files, {"a.pal"});
      CAPTURE(pan::to_dot(network, pan::ModuleId(i)));
      REQUIRE_FALSE(again.diagnostics.has_errors());
      CHECK(module_of(again.specification.sketches.front(), "LS1") == text);
    }
  }
}

TEST_CASE("DOT texts that are cut off, doubled or shuffled are read safely") {
  constexpr std::uint64_t seed = 20260713;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  const auto checked = test::check_text(test::touch_modules_text());
  const auto& network = checked.specification.sketches.front();
  std::size_t read = 0;
  for (int round = 0; round < 1000; ++round) {
    std::string dot;
    while (dot.empty()) {
      const pan::ModuleId module(random() % network.modules.size());
      if (!network.modules[module.index()].body.empty()) dot = pan::to_dot(network, module);
    }
    const auto at = [&] { return random() % dot.size(); };
    switch (round % 5) {
      case 0:
        dot.resize(at());
        break;
      case 1:
        dot.erase(at(), random() % 80);
        break;
      case 2:
        dot.insert(at(), dot.substr(at(), random() % 200));
        break;
      case 3: {  // a whole line gone: a node or an edge
        const auto end = dot.find('\n', at());
        const auto next = end == std::string::npos ? end : dot.find('\n', end + 1);
        if (next != std::string::npos) dot.erase(end, next - end);
        break;
      }
      default:
        for (int i = 0; i < 5; ++i) dot[at()] = static_cast<char>(1 + random() % 127);
    }
    MemoryFileSystem files;
    files.add("a.dot", dot);
    const auto result = test::check_files(files, {"a.dot"});
    if (!result.diagnostics.has_errors()) ++read;
    for (const auto& finding : result.diagnostics.all()) CHECK(finding.where.valid());
  }
  CHECK(read < 900);
  CHECK(read > 20);
}
