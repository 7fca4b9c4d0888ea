// How a page is read, and how codes are found.
#include "pal/explain/page.hpp"

#include <catch2/catch.hpp>

#include "pal/explain/codes.hpp"

using namespace pal;
using namespace pal::explain;

TEST_CASE("a page has a summary, an example and a cure of one file") {
  const auto page = read_page(
      "What it\nmeans.\n\nMore.\n\n### Example\n\n```pal\nMODULE\n```\n\n### Cure\n\nDo "
      "this:\n\n```pal\nEND\n```\n");
  CHECK(page.summary == "What it means.");
  REQUIRE(page.example.files.size() == 1);
  CHECK(page.example.files[0].name == "example.pal");
  CHECK(page.example.files[0].text == "MODULE\n");
  CHECK(page.example.options.empty());
  REQUIRE(page.cure.files.size() == 1);
  CHECK(page.cure.files[0].text == "END\n");
}

TEST_CASE("a page may have several files and options, and a cure repeats only changed files") {
  const auto page = read_page(
      "x\n\n### Example\n\n```pal a.pal -e b.pal\nA\n```\n```pal b.pal\nB\n```\n\n### Cure\n\n```pal "
      "b.pal\nC\n```\n");
  CHECK(page.example.options == std::vector<std::string>{"-e", "b.pal"});
  REQUIRE(page.cure.files.size() == 2);
  CHECK(page.cure.files[0].name == "a.pal");
  CHECK(page.cure.files[0].text == "A\n");
  CHECK(page.cure.files[1].text == "C\n");
  CHECK(page.cure.options == page.example.options);
}

TEST_CASE("a page without a fence of PAL has no sample") {
  const auto page = read_page("x\n\n### Example\n\n```\ntext\n```\n\n### Cure\n\nSave it as text.\n");
  CHECK(page.example.files.empty());
  CHECK(page.cure.files.empty());
}

TEST_CASE("a code may be written in any case, and without its letters") {
  for (const auto* text : {"PAL0101", "pal0101", "Pal0101", "0101", "101"})
    CHECK(find_code(text) == Code::PAL0101);
  for (const auto* text : {"", "PAL", "PAL01010", "PAL0100", "0x65", "-101", "PAL 0101"})
    CHECK_FALSE(find_code(text));
}

TEST_CASE("codes near to a number are its neighbours, near to a word the titles with it") {
  CHECK(codes_near("PAL0100") == std::vector{Code::PAL0101, Code::PAL0102});
  CHECK(codes_near("syntax") == std::vector{Code::PAL0101, Code::PAL0104});
  CHECK(codes_near("PLA0101") == std::vector{Code::PAL0101});
  CHECK(codes_near("nothing like it at all").empty());
}
