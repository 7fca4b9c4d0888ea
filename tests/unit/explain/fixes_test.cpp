// Hints that a program can follow are followed, and the finding is gone.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "pal/explain/codes.hpp"
#include "pal/support/edit.hpp"
#include "pal/support/render.hpp"
#include "programs/pal/session/proof.hpp"
#include "programs/pal/session/selection.hpp"

using namespace pal;
using namespace pal::explain;

namespace {

/// The disk, with one file as it should be.
class MendedFileSystem : public FileSystem {
 public:
  void mend(std::string path, std::string text) {
    path_ = std::move(path);
    text_ = std::move(text);
  }
  std::variant<std::string, FileError> read(const std::string& path,
                                            std::size_t most = largest_file) const override {
    return path == path_ ? text_ : DiskFileSystem().read(path, most);
  }

 private:
  std::string path_, text_;
};

/// The findings of the whole of `pal check`, as long as the search for a proof is short.
program::Session checked(const std::string& path, const FileSystem& files) {
  std::ostringstream none;
  program::Session session;
  program::read({{path}, {}, {}, {}}, {none, none, files}, session);
  if (!session.diagnostics.has_errors())
    program::report_unmet(program::prove(session, {1000, 0}), false, session);
  return session;
}

std::size_t alike(const Diagnostics& diagnostics, const Diagnostic& finding) {
  const auto all = diagnostics.sorted();
  return static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [&](const Diagnostic& each) {
    return each.code == finding.code && each.message == finding.message;
  }));
}

std::vector<std::string> goldens() {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(PAL_SOURCE_DIR "/tests/golden/check")) {
    // The state space of this one takes a second, and it has no fix.
    if (entry.path().extension() == ".pal" && entry.path().stem() != "too_many_states")
      paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

}  // namespace

TEST_CASE("every finding of the goldens has a hint, and every fix cures it") {
  std::set<Code> fixed;
  for (const std::string& path : goldens()) {
    const auto before = checked(path, DiskFileSystem());
    for (const Diagnostic& finding : before.diagnostics.sorted()) {
      INFO(path << ": " << name(finding.code) << ": " << finding.message << "\nhint: " << finding.hint);
      CHECK_FALSE(finding.hint.empty());
      if (finding.fix.empty()) continue;
      const FileId file = finding.fix.front().where.file;
      MendedFileSystem files;
      files.mend(before.sources.name(file), apply(finding.fix, file, before.sources.text(file)));
      const auto after = checked(path, files);
      std::ostringstream text;
      render_text(after.diagnostics.sorted(), after.sources, text);
      INFO(text.str());
      // Gone, or at least one less: where two things are wrong alike, the other may be told now.
      const bool gone = alike(after.diagnostics, finding) < alike(before.diagnostics, finding);
      CHECK((gone || after.diagnostics.sorted().size() < before.diagnostics.sorted().size()));
      fixed.insert(finding.code);
    }
  }
  // Where following the hint needs no thought, the fix is there.
  for (const Code code :
       {Code::PAL0101, Code::PAL0102, Code::PAL0103, Code::PAL0106, Code::PAL0108, Code::PAL0110,
        Code::PAL0201, Code::PAL0202, Code::PAL0203, Code::PAL0204, Code::PAL0206, Code::PAL0505,
        Code::PAL0612, Code::PAL0705, Code::PAL0706, Code::PAL0711}) {
    CAPTURE(name(code));
    CHECK(fixed.contains(code));
  }
}
