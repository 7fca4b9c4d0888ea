// The program pal, run without a process.
#pragma once

#include <unistd.h>

#include <catch2/catch.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "programs/pal/options/command_line.hpp"
#include "tests/support/project_file.hpp"

namespace pal::test {

struct Answer {
  program::ExitStatus status;
  std::string out, err;
};

inline Answer pal(const std::vector<std::string>& arguments, const FileSystem& files = DiskFileSystem()) {
  std::ostringstream out, err;
  const program::ExitStatus status = program::run(arguments, {out, err, files});
  return {status, out.str(), err.str()};
}

inline std::string skill(const std::string& file) {
  return std::string(PAL_SOURCE_DIR) + "/skills_pal/" + file;
}

inline const std::string cell = skill("workcell.pal");
inline const std::string touch = skill("touch/touch.pal");
inline const std::string read_first = skill("touch/touch_read_first.pal");

/// The text of a skill in tests/unit/driver.
inline std::string text_of(const std::string& name) {
  return project_file("tests/unit/program/" + name + ".pal");
}

/// A file s.pal with this text, and no other.
inline MemoryFileSystem in_memory(const std::string& text) {
  MemoryFileSystem files;
  files.add("s.pal", text);
  return files;
}

/// Checks that a command line is refused as one, and why.
inline void expect_refused(const std::vector<std::string>& arguments, const std::string& why) {
  const Answer answer = pal(arguments);
  INFO(answer.err);
  CHECK(answer.status == program::ExitStatus::usage);
  CHECK(answer.err.find(why) != std::string::npos);
}

/// A name for a temporary file or folder that no test running beside this one has.
inline std::string own_name(const std::string& name) {
  return name + "-" + std::to_string(::getpid());
}

}  // namespace pal::test
