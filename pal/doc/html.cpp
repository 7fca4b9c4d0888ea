// A document as HTML.
#include <algorithm>
#include <string_view>

#include "pal/doc/document.hpp"
#include "pal/pan/dot.hpp"
#include "pal/support/xml.hpp"

namespace pal::doc {

namespace {

constexpr std::string_view style = R"(
:root { color-scheme: light; }
* { box-sizing: border-box; }
body { margin: 0; color: #1a1a1a; background: #fff; font: 1rem/1.5 "Liberation Sans", Arial, Helvetica, sans-serif; }
main { max-width: 64rem; margin: 0 auto; padding: 1.5rem; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 1rem; }
h2 { font-size: 1.3rem; margin: 2.5rem 0 0; padding-bottom: .3rem; border-bottom: 2px solid #1a1a1a; }
h3 { font-size: 1rem; margin: 0; }
section.slot { display: table; table-layout: fixed; width: 100%; border-bottom: 1px solid #b0b0b0; }
section.slot > h3, section.slot > div { display: table-cell; vertical-align: top; padding: .6rem 0; }
section.slot > h3 { width: 12rem; padding-right: 1rem; }
section.slot p, section.slot ul, figure { margin: 0; }
section.slot p + p { margin-top: .5rem; }
ul { padding-left: 1.1rem; }
code { font: .92em "Liberation Mono", "DejaVu Sans Mono", monospace; overflow-wrap: break-word; }
table { border-collapse: collapse; width: 100%; }
th, td { text-align: left; vertical-align: top; padding: .2rem .8rem .2rem 0; }
thead th { border-bottom: 1px solid #1a1a1a; }
.none { color: #595959; }
.short { white-space: nowrap; }
.wide { overflow-x: auto; }
section.drawing { padding: .8rem 0 1.2rem; }
figure svg { display: block; max-width: 100%; height: auto; margin: .5rem 0; }
@media screen and (max-width: 40rem) {
  section.slot, section.slot > h3, section.slot > div { display: block; width: auto; }
  section.slot > h3 { padding-bottom: 0; }
  .short { white-space: normal; }
}
@page { size: A4; margin: 18mm 16mm; }
@media print {
  html { font-size: 10pt; }
  main { max-width: none; padding: 0; }
  section.slot > h3 { width: 36mm; }
  .slot, .drawing, tr { break-inside: avoid; }
  h2, .drawing h3 { break-after: avoid; }
  article + article { break-before: page; }
  figure svg { max-height: 210mm; }
}
)";

std::string html_text(const Line& line) {
  std::string result;
  for (const auto& span : line) {
    result += span.is_code ? "<code>" + xml_escaped(span.text) + "</code>" : xml_escaped(span.text);
  }
  return result;
}

/// Names, units and ranges: they are not broken.
bool is_short(const Line& line) {
  std::size_t length = 0;
  for (const auto& span : line) length += span.text.size();
  return length <= 20;
}

void replace_all(std::string& text, std::string_view from, const std::string& to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

/// Graphviz' drawing as a part of a page. It has no head of a file, it has ids of its own, and a screen
/// reader can read its title.
std::string inlined(const Picture& picture, int number) {
  auto svg = pan::svg(picture.dot);
  svg.erase(0, std::min(svg.find("<svg"), svg.size()));
  const auto prefix = "pan" + std::to_string(number) + "-";
  replace_all(svg, " id=\"", " id=\"" + prefix);
  replace_all(svg, "url(#", "url(#" + prefix);
  return svg.insert(4, " role=\"img\" aria-label=\"" + xml_escaped(picture.title) + "\"");
}

class Page {
 public:
  std::string run(const std::vector<Document>& documents) {
    std::string title;
    for (const auto& document : documents) title += (title.empty() ? "" : ", ") + document.title;
    out_ =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
        xml_escaped(title) + "</title>\n<style>" + std::string(style) + "</style>\n</head>\n<body>\n<main>\n";
    for (const auto& document : documents) article(document);
    return out_ + "</main>\n</body>\n</html>\n";
  }

  void operator()(const Paragraphs& paragraphs) {
    for (const auto& line : paragraphs.lines) out_ += "<p>" + html_text(line) + "</p>\n";
  }
  void operator()(const Items& items) {
    out_ += "<ul>\n";
    for (const auto& line : items.lines) out_ += "<li>" + html_text(line) + "</li>\n";
    out_ += "</ul>\n";
  }
  void operator()(const Table& table) {
    out_ += "<div class=\"wide\"><table>\n<thead><tr>";
    for (const auto& head : table.heads) {
      out_ += head.empty() ? "<td></td>" : "<th scope=\"col\">" + xml_escaped(head) + "</th>";
    }
    out_ += "</tr></thead>\n<tbody>\n";
    for (const auto& row : table.rows) {
      out_ += "<tr>";
      for (const auto& cell : row)
        out_ += (is_short(cell) ? "<td class=\"short\">" : "<td>") + html_text(cell) + "</td>";
      out_ += "</tr>\n";
    }
    out_ += "</tbody>\n</table></div>\n";
  }
  void operator()(const Picture& picture) {
    out_ += "<figure>\n" + inlined(picture, ++pictures_) + "</figure>\n";
  }

 private:
  void article(const Document& document) {
    out_ += "<article>\n<h1>" + xml_escaped(document.title) + "</h1>\n";
    for (const auto& part : document.parts) this->part(part);
    out_ += "</article>\n";
  }

  void part(const Part& part) {
    out_ += "<section>\n<h2>" + xml_escaped(part.title) + "</h2>\n";
    for (const auto& section : part.sections) {
      out_ += std::string("<section class=\"") + (is_drawing(section) ? "drawing" : "slot") + "\">\n<h3>" +
              xml_escaped(section.title) + "</h3>\n<div>\n";
      for (const auto& block : section.blocks) std::visit(*this, block);
      if (section.blocks.empty()) out_ += "<p class=\"none\">None.</p>\n";
      out_ += "</div>\n</section>\n";
    }
    out_ += "</section>\n";
  }

  static bool is_drawing(const Section& section) {
    return !section.blocks.empty() && std::holds_alternative<Picture>(section.blocks.front());
  }

  std::string out_;
  int pictures_ = 0;
};

}  // namespace

std::string html(const std::vector<Document>& documents) {
  return Page().run(documents);
}

}  // namespace pal::doc
