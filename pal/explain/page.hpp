// The page on a finding: what it means, why it matters, an example that has it and a cure.
//
// A page is pages/PAL0123.md. It is Markdown without a title, because the table has the title. First come
// paragraphs on what the finding means and why it matters. Then come `### Example` and `### Cure`, each with
// one or more fences
//
//     ```pal [FILE] [OPTIONS of pal check]
//
// that hold files. The first file of the example is what `pal check` is given, with the options of its fence;
// without a name it is example.pal. The cure keeps the files of the example that it does not give itself. A
// page whose example no PAL text can show has no such fence below `### Example`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pal/support/diagnostic_code.hpp"

namespace pal::explain {

/// One file of a sample.
struct SampleFile {
  std::string name;
  std::string text;
};

/// Files, of which the first is checked with `options`. Without files: something that PAL text cannot show.
struct Sample {
  std::vector<SampleFile> files;
  std::vector<std::string> options;
};

struct Page {
  std::string_view markdown;  // as it was written
  std::string summary;        // its first paragraph, on one line
  Sample example;             // gives the finding
  Sample cure;                // does not, and has no errors
};

/// The page on `code`; empty if there is none (a test checks that all exist).
Page explain(Code code);

/// The parts of a page's text.
Page read_page(std::string_view markdown);

}  // namespace pal::explain
