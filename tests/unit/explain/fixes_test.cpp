// Hints that a program can follow are followed, and the finding is gone.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cctype>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
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

bool is_word_letter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

/// Words, figures, texts and signs, as one who reads the text would divide it.
std::vector<std::string> pieces(std::string_view text) {
  std::vector<std::string> result;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at + 1;
    if (text[at] == '"') {
      end = std::min(text.find_first_of("\"\n", at + 1), text.size() - 1) + 1;
    } else if (is_word_letter(text[at])) {
      while (end < text.size() &&
             (is_word_letter(text[end]) || text[end] == '.' ||
              (text[end] == '-' && end + 1 < text.size() && is_word_letter(text[end + 1]))))
        ++end;
    }
    if (std::isspace(static_cast<unsigned char>(text[at])) == 0)
      result.emplace_back(text.substr(at, end - at));
    at = end;
  }
  return result;
}

bool is_figure(const std::string& piece) {
  return std::isdigit(static_cast<unsigned char>(piece.front())) != 0;
}

/// Whether a text may lose this without saying anything else: a bracket, a divider or an end too many.
bool says_nothing(const std::string& piece) {
  static const std::set<std::string> dividers{",",   ";",     ":",    "(",   ")",          "{",     "}",
                                              "END", "BEGIN", "CASE", "WTM", "CONCURRENT", "\u00A0"};
  return dividers.contains(piece);
}

/// What an edit takes out of a text: nothing that carries a meaning, unless the same stands right beside it,
/// or something is put in its place. A figure keeps its value.
void check_that_nothing_is_lost(const Edit& edit, std::string_view text) {
  const std::string removed(text.substr(edit.where.begin, edit.where.end - edit.where.begin));
  INFO("'" << removed << "' becomes '" << edit.text << "'");
  const auto put_in = pieces(edit.text);
  const std::string before(text.substr(0, edit.where.begin)), after(text.substr(edit.where.end));
  // A word is not cut.
  const bool cuts = edit.text.empty() && !before.empty() && !after.empty() && is_word_letter(before.back()) &&
                    is_word_letter(after.front());
  CHECK_FALSE(cuts);
  const bool repeats = !pieces(removed).empty() && edit.text.empty() && !pieces(before).empty() &&
                       before.find(removed) != std::string::npos;
  for (const std::string& piece : pieces(removed)) {
    const bool other_base = piece.starts_with("0x") || piece.starts_with("0b");
    if (is_figure(piece) && !other_base && !put_in.empty())
      CHECK((std::find(put_in.begin(), put_in.end(), piece) != put_in.end() ||
             piece.find_first_not_of("0123456789.") != piece.npos));
    if (put_in.empty()) CHECK((says_nothing(piece) || repeats));
  }
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
      for (const Edit& edit : finding.fix)
        check_that_nothing_is_lost(edit, before.sources.text(edit.where.file));
      MendedFileSystem files;
      files.mend(before.sources.name(file), apply(finding.fix, file, before.sources.text(file)));
      const auto after = checked(path, files);
      std::ostringstream text;
      render_text(after.diagnostics.sorted(), after.sources, text);
      INFO(text.str());
      // Gone, or at least one less: where two things are wrong alike, the other may be told now.
      const bool gone = alike(after.diagnostics, finding) < alike(before.diagnostics, finding);
      CHECK((gone || after.diagnostics.sorted().size() < before.diagnostics.sorted().size()));
      // And nothing else is wrong with the text as text.
      for (const Diagnostic& now : after.diagnostics.sorted()) {
        const bool of_text = name(now.code).starts_with("PAL01") && now.code != Code::PAL0104;
        const bool is_new = of_text && alike(before.diagnostics, now) < alike(after.diagnostics, now);
        INFO("new: " << name(now.code) << ": " << now.message);
        CHECK((!is_new || before.diagnostics.errors() > after.diagnostics.errors()));
      }
      fixed.insert(finding.code);
    }
  }
  // Where following the hint needs no thought, the fix is there.
  for (const Code code :
       {Code::PAL0101, Code::PAL0102, Code::PAL0103, Code::PAL0106, Code::PAL0108, Code::PAL0110,
        Code::PAL0201, Code::PAL0202, Code::PAL0203, Code::PAL0204, Code::PAL0206, Code::PAL0705}) {
    CAPTURE(name(code));
    CHECK(fixed.contains(code));
  }
}
