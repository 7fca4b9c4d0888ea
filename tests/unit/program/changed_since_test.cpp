#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/unit/program/program.hpp"
#include "tests/unit/whatif/two_chains.hpp"

using namespace pal::test;
using pal::program::ExitStatus;
namespace fs = std::filesystem;

namespace {

std::string replaced(std::string text, const std::string& old, const std::string& now) {
  for (auto at = text.find(old); at != std::string::npos; at = text.find(old, at + now.size()))
    text.replace(at, old.size(), now);
  return text;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Two skills that share a file with modules, and an environment: all committed.
class Repository {
 public:
  Repository() {
    fs::remove_all(path);
    fs::create_directories(path);
    const std::string text = two_chains("9 ms");
    const auto skill = text.find("SKILL s"), modules = text.find("Sensor Driver: SD1"),
               method = text.find("Skill Module: SM1"), environment = text.find("ENVIRONMENT cell");
    write("messages.pal", text.substr(0, skill));
    write("modules.pal", "USES \"messages.pal\"\n" + text.substr(modules, method - modules));
    for (const char* name : {"one", "two"})
      write(std::string(name) + ".pal",
            "USES \"messages.pal\"\nUSES \"modules.pal\"\n" +
                replaced(text.substr(skill, modules - skill), "SKILL s", std::string("SKILL ") + name) +
                text.substr(method, environment - method));
    write("cell.pal", text.substr(environment));
    REQUIRE(git("init -q") == 0);
    commit();
  }
  Repository(const Repository&) = delete;
  Repository& operator=(const Repository&) = delete;
  ~Repository() { fs::remove_all(path); }

  int git(const std::string& words) const {
    return std::system(
        ("git -C '" + path + "' -c user.name=t -c user.email=t@t " + words + " >/dev/null 2>&1").c_str());
  }
  void commit() const { REQUIRE(git("add -A") + git("commit -q --allow-empty -m x") == 0); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path + "/" + name) << text;
  }
  void append(const std::string& name, const std::string& text) const {
    std::ofstream(path + "/" + name, std::ios::app) << text;
  }

  Answer check(std::vector<std::string> more = {}) const {
    std::vector<std::string> words{"check", path + "/one.pal", path + "/two.pal", "-e", path + "/cell.pal"};
    words.insert(words.end(), more.begin(), more.end());
    if (std::find(more.begin(), more.end(), "--changed-since") == more.end())
      words.insert(words.end(), {"--changed-since", "HEAD"});
    return pal::test::pal(words);
  }

  const std::string path = (fs::temp_directory_path() / own_name("pal-git")).string();
};

const std::string left_out = "not checked  soon: none of its 4 files has changed since HEAD";

}  // namespace

TEST_CASE("nothing is proved where nothing has changed, and that is no fault") {
  const Repository repository;
  const Answer answer = repository.check({"--require-verdicts"});
  INFO(answer.err);
  CHECK(answer.status == ExitStatus::all_hold);
  CHECK(has(answer.out, "one in cell\n  " + left_out));
  CHECK(has(answer.out, "two in cell\n  " + left_out));
  CHECK(has(answer.err, "pal: nothing was proved, since nothing has changed that a proof depends on"));
  const auto told = nlohmann::json::parse(repository.check({"--format", "json"}).out);
  CHECK(told.at("not_checked").size() == 2);
  CHECK(told.at("requirements").at(0).at("verdict") == "not checked");
  const Answer junit = repository.check({"--format", "junit", "--require-verdicts"});
  CHECK(has(junit.out, "<skipped"));
  CHECK_FALSE(has(junit.out, "<error"));
}

TEST_CASE("a skill is proved if its own file has changed, committed or not") {
  const Repository repository;
  repository.append("one.pal", "# changed\n");
  for (const char* revision : {"HEAD", "HEAD~1"}) {
    const Answer answer = repository.check({"--changed-since", revision, "--require-verdicts"});
    INFO(answer.err);
    CHECK(answer.status == ExitStatus::all_hold);
    CHECK(has(answer.out, "one in cell\n  holds"));
    CHECK(has(answer.out, "two in cell\n  not checked  soon: none of its 4 files has changed since"));
    repository.commit();
  }
}

TEST_CASE("all skills are proved if a file that they use, or the environment, has changed") {
  for (const char* name : {"messages.pal", "modules.pal", "cell.pal"}) {
    const Repository repository;
    repository.append(name, "# changed\n");
    const Answer answer = repository.check();
    INFO(name << answer.err);
    CHECK(has(answer.out, "one in cell\n  holds"));
    CHECK(has(answer.out, "two in cell\n  holds"));
  }
}

TEST_CASE("a failure in what has changed is a failure") {
  const Repository repository;
  repository.write("cell.pal", replaced(two_chains("9 ms").substr(two_chains("9 ms").find("ENVIRONMENT")),
                                        "5 ms", "8 ms"));
  CHECK(repository.check().status == ExitStatus::not_met);
}

TEST_CASE("a file that git does not know counts as changed") {
  const Repository repository;
  REQUIRE(repository.git("rm --cached -q two.pal") == 0);
  REQUIRE(repository.git("commit -q -m x") == 0);
  repository.write(".gitignore", "two.pal\n");
  const Answer answer = repository.check({"--changed-since", "HEAD"});
  CHECK(has(answer.out, "one in cell\n  not checked"));
  CHECK(has(answer.out, "two in cell\n  holds"));
}

TEST_CASE("an unknown revision, and a folder without git, are told") {
  const Repository repository;
  for (const char* revision : {"--changed-since=no-such", "--changed-since=--all", "--changed-since=-1"})
    CHECK(
        pal::test::pal({"check", repository.path + "/one.pal", "-e", repository.path + "/cell.pal", revision})
            .status == ExitStatus::usage);
  const Answer unknown = repository.check({"--changed-since", "no-such"});
  CHECK(has(unknown.err, "git knows no revision 'no-such'"));
  fs::remove_all(repository.path + "/.git");
  const Answer without = repository.check();
  CHECK(without.status == ExitStatus::usage);
  CHECK(has(without.err, "--changed-since needs git"));
}
