#include "pal/explain/page.hpp"

#include <algorithm>
#include <sstream>

#include "pal/explain/embedded.hpp"

namespace pal::explain {
namespace {

constexpr std::string_view fence_begin = "```pal";
constexpr std::string_view fence_end = "```";

/// Takes the first line of `text` away and gives it, without its line break.
std::string_view next_line(std::string_view& text) {
  const auto end = std::min(text.find('\n'), text.size());
  const auto line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

/// Begins a file as the fence's first line says.
void open_fence(std::string_view line, Sample& sample) {
  std::istringstream words{std::string(line.substr(fence_begin.size()))};
  std::string word;
  std::vector<std::string> options;
  SampleFile file{"example.pal", ""};
  for (bool first = true; words >> word; first = false) {
    if (first && word.front() != '-') {
      file.name = word;
    } else {
      options.push_back(word);
    }
  }
  if (sample.files.empty()) sample.options = std::move(options);
  sample.files.push_back(std::move(file));
}

/// Adds the files of `example` that the cure leaves as they are.
void complete(Sample& cure, const Sample& example) {
  if (cure.files.empty() || example.files.empty()) return;
  const bool same_first = cure.files.front().name == example.files.front().name;
  std::vector<SampleFile> files;
  const auto given = [&](const SampleFile& file) {
    return std::find_if(cure.files.begin(), cure.files.end(),
                        [&](const SampleFile& each) { return each.name == file.name; });
  };
  for (const SampleFile& file : example.files) {
    const auto own = given(file);
    files.push_back(own == cure.files.end() ? file : *own);
  }
  for (const SampleFile& file : cure.files) {
    const bool new_one = std::none_of(example.files.begin(), example.files.end(),
                                      [&](const SampleFile& each) { return each.name == file.name; });
    if (new_one) files.push_back(file);
  }
  cure.files = std::move(files);
  if (!same_first) cure.options = example.options;
}

std::string first_paragraph(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const auto line = next_line(text);
    if (line.empty()) break;
    result += (result.empty() ? "" : " ") + std::string(line);
  }
  return result;
}

}  // namespace

Page read_page(std::string_view markdown) {
  Page page;
  page.markdown = markdown;
  page.summary = first_paragraph(markdown);
  Sample* sample = nullptr;
  bool inside = false;
  for (auto rest = markdown; !rest.empty();) {
    const auto line = next_line(rest);
    if (inside) {
      inside = line != fence_end;
      if (inside) sample->files.back().text += std::string(line) + "\n";
    } else if (line == "### Example") {
      sample = &page.example;
    } else if (line == "### Cure") {
      sample = &page.cure;
    } else if (sample != nullptr && line.starts_with(fence_begin)) {
      open_fence(line, *sample);
      inside = true;
    }
  }
  complete(page.cure, page.example);
  return page;
}

Page explain(Code code) {
  const auto pages = embedded_pages();
  const auto found =
      std::find_if(pages.begin(), pages.end(), [&](const EmbeddedPage& page) { return page.code == code; });
  return found == pages.end() ? Page{} : read_page(found->markdown);
}

}  // namespace pal::explain
