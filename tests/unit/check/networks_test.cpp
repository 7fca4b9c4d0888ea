#include <algorithm>
#include <catch2/catch.hpp>

#include "pal/pan/dump.hpp"
#include "tests/unit/check/specification.hpp"

using namespace pal;
using test::check_files;

namespace {

const pan::Module& module(const pan::Network& network, const std::string& name) {
  return *std::find_if(network.modules.begin(), network.modules.end(),
                       [&](const pan::Module& m) { return m.name == name; });
}

}  // namespace

TEST_CASE("the touch skills are networks without errors") {
  const DiskFileSystem files;
  const std::string folder = PAL_SOURCE_DIR "/skills_pal/";
  const auto checked = check_files(
      files, {folder + "touch/touch.pal", folder + "touch/touch_read_first.pal", folder + "workcell.pal"});
  REQUIRE(checked.diagnostics.errors() == 0);
  REQUIRE(checked.specification.skills.size() == 2);
  REQUIRE(checked.specification.environments.size() == 1);
  CHECK(checked.specification.sketches.empty());
  for (const auto& skill : checked.specification.skills) {
    CAPTURE(skill.skill.name);
    CHECK(skill.modules[skill.main.index()].name == "SM1");
    CHECK(module(skill, "SM1").threads == std::vector<std::string>{"SM1", "SM1.1", "SM1.2"});
    CHECK(skill.modules[module(skill, "CM1").executed_by.index()].name == "SM1");
    CHECK(skill.channels.size() == 10);
    CHECK(skill.requirements.size() == 3);
  }
}

TEST_CASE("every node that splits the flow has its mate, and every edge leads to a node") {
  const DiskFileSystem files;
  const auto checked = check_files(files, {PAL_SOURCE_DIR "/skills_pal/touch/touch.pal",
                                           PAL_SOURCE_DIR "/tests/golden/check/wait_forms.pal",
                                           PAL_SOURCE_DIR "/tests/golden/check/figure_3_6.pal"});
  auto networks = checked.specification.skills;
  networks.insert(networks.end(), checked.specification.sketches.begin(),
                  checked.specification.sketches.end());
  REQUIRE(networks.size() == 3);
  for (const auto& network : networks) {
    for (const auto& m : network.modules) {
      const auto& nodes = m.body.nodes;
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        CAPTURE(m.name, i);
        const auto& node = nodes[i];
        CHECK(node.where.valid());
        for (const auto to : node.out) CHECK((to.valid() && to.index() < nodes.size()));
        if (node.mate.valid()) CHECK(nodes[node.mate.index()].mate == pan::NodeId(i));
        if (const auto* wait = std::get_if<pan::Wait>(&node.content)) {
          const bool plain = wait->channels.size() == 1 && !wait->within;
          CHECK(node.mate.valid() != plain);
          CHECK(node.out.size() == wait->channels.size() + (wait->within ? 1u : 0u));
        }
      }
    }
  }
}

TEST_CASE("an executed module talks as the module that executes it") {
  const DiskFileSystem files;
  const auto checked = check_files(files, {PAL_SOURCE_DIR "/skills_pal/touch/touch.pal"});
  const auto& network = checked.specification.skills.at(0);
  for (const auto& channel : network.channels) {
    CHECK(pan::party_name(network, channel.sender) != "CM1");
    CHECK(pan::party_name(network, channel.receiver) != "CM1");
  }
}

TEST_CASE("two skills of one run see only what their own files use") {
  MemoryFileSystem files;
  const std::string skill = "SKILL METHOD M COMPLETION 0 NORMAL COMPLETION 1 ERROR END SKILL\n";
  const std::string body = "Skill Module: M BEGIN WTM( Coordinator ) TXM( Completion Protocol 0 ) END\n";
  files.add("a.pal", "SKILL a " + skill + body);
  files.add("b.pal", "SKILL b " + skill + body);
  const auto checked = check_files(files, {"a.pal", "b.pal"});
  CHECK(checked.diagnostics.all().empty());
  CHECK(checked.specification.skills.size() == 2);
}

TEST_CASE("a file is read once, however it is named") {
  MemoryFileSystem files;
  files.add("x/a.pal", "USES \"b.pal\"\nUSES \"../x/b.pal\"\n");
  files.add("x/b.pal", "DEVICE d\n");
  const auto checked = check_files(files, {"x/a.pal", "./x/a.pal"});
  CHECK(checked.trees.size() == 2);
  CHECK(checked.diagnostics.all().empty());
}

TEST_CASE("a check without deadlocks says all but them") {
  MemoryFileSystem files;
  files.add("a.pal", test::source_file("tests/golden/check/fail_deadlock.pal"));
  SourceManager sources;
  Diagnostics all, quick;
  const auto trees = check::read_sources(files, sources, {"a.pal"}, all);
  check::check(trees, all);
  check::check(trees, quick, {}, check::Depth::without_deadlocks);
  REQUIRE(all.errors() == 1);
  CHECK(all.all().front().code == Code::PAL0521);
  CHECK(quick.errors() == 0);
}
