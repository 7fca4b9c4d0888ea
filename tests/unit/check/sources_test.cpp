#include <catch2/catch.hpp>

#include "pal/support/file_system.hpp"
#include "pal/support/nearest.hpp"
#include "pal/support/source.hpp"
#include "pal/support/text_width.hpp"
#include "pal/support/utf8.hpp"

using namespace pal;

TEST_CASE("places count lines and code points from 1") {
  SourceManager sources;
  const auto file = sources.add("a.pal", "ab\n\tcd\r\n\xC3\xA9x");
  const auto at = [&](std::uint32_t offset) {
    const auto [line, column] = sources.line_column(file, offset);
    return std::pair(line, column);
  };
  CHECK(at(0) == std::pair(1, 1));
  CHECK(at(2) == std::pair(1, 3));  // the line break belongs to its line
  CHECK(at(3) == std::pair(2, 1));
  CHECK(at(4) == std::pair(2, 2));   // a tab is one column
  CHECK(at(10) == std::pair(3, 2));  // two bytes, one code point
  CHECK(at(99) == std::pair(3, 3));
  CHECK(sources.line_text(file, 2) == "\tcd");
  CHECK(sources.line_text(file, 4).empty());
  CHECK(sources.text(SourceSpan{file, 4, 6}) == "cd");
  CHECK(sources.find("a.pal") == file);
  CHECK_FALSE(sources.find("b.pal"));
}

TEST_CASE("only UTF-8 is UTF-8") {
  CHECK_FALSE(utf8::first_invalid("plain, \xC3\xA9, \xE2\x82\xAC, \xF0\x9F\xA4\x96"));
  CHECK(utf8::first_invalid("a\xFF") == 1u);
  CHECK(utf8::first_invalid("\xC0\x80") == 0u);          // overlong
  CHECK(utf8::first_invalid("x\xED\xA0\x80") == 1u);     // a surrogate
  CHECK(utf8::first_invalid("\xF4\x90\x80\x80") == 0u);  // above the last code point
  CHECK(utf8::first_invalid("\xE2\x82") == 0u);          // cut off
}

TEST_CASE("carets stand below what they mean") {
  CHECK(width("ab\tc") == 5);
  CHECK(width("\xE5\x8A\x9B") == 2);  // a wide character
  CHECK(width("e\xCC\x81") == 1);     // an accent of its own
  CHECK(printable("a\tb") == "a   b");
  CHECK(printable("a\x1B[31m") == "a\xEF\xBF\xBD[31m");  // no colours from a source text
  CHECK(width("\x1B") == 1);
}

TEST_CASE("misspelled names get suggestions") {
  const std::vector<std::string> names{"LS1", "SM1", "pc-force", "pc-reach"};
  CHECK(nearest("LS2", names) == "LS1");
  CHECK(nearest("pc-froce", names) == "pc-force");
  CHECK(nearest("PC-FORCE", {"pc-force"}) == std::nullopt);  // too far, even at half the price
  CHECK(nearest("Pc-force", names) == "pc-force");
  CHECK_FALSE(nearest("camera", names));
}

TEST_CASE("a file is named from where it is used") {
  CHECK(resolve_path("skills/touch/touch.pal", "modules.pal") == "skills/touch/modules.pal");
  CHECK(resolve_path("skills/touch/touch.pal", "../cell.pal") == "skills/cell.pal");
  CHECK(resolve_path("touch.pal", "modules.pal") == "modules.pal");
  CHECK(resolve_path("a/b.pal", "/c.pal") == "/c.pal");
}

TEST_CASE("the disk gives reasons") {
  const DiskFileSystem files;
  CHECK(std::get<FileError>(files.read("/no/such/file")).reason == "no such file");
  CHECK(std::get<FileError>(files.read("/")).reason == "it is a directory");
  CHECK(std::holds_alternative<std::string>(files.read(PAL_SOURCE_DIR "/skills_pal/touch/touch.pal")));
}
