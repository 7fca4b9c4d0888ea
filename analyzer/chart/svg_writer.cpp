#include "analyzer/chart/svg_writer.hpp"

#include "pal/support/xml.hpp"

namespace pal::analyzer::chart {

namespace {

std::string attribute(const char* name, Length value) {
  return " " + std::string(name) + "=\"" + std::to_string(value) + "\"";
}

std::string attribute(const char* name, std::string_view value) {
  return " " + std::string(name) + "=\"" + xml_escaped(value) + "\"";
}

}  // namespace

std::string move_to(Point to) {
  return "M" + std::to_string(to.x) + " " + std::to_string(to.y);
}
std::string line_to(Point to) {
  return "L" + std::to_string(to.x) + " " + std::to_string(to.y);
}

void SvgWriter::end(std::string_view element, std::string_view title) {
  if (title.empty()) {
    out_ += "/>\n";
  } else {
    out_ += "><title>" + xml_escaped(title) + "</title></" + std::string(element) + ">\n";
  }
}

bool SvgWriter::has_drawn(std::string_view style) const {
  const std::string longer = std::string(style) + " ";
  const auto next = styles_.lower_bound(longer);
  return styles_.contains(style) || (next != styles_.end() && next->compare(0, longer.size(), longer) == 0);
}

void SvgWriter::rect(const Box& box, std::string_view style, std::string_view title, const std::string& id) {
  styles_.emplace(style);
  out_ += "<rect";
  if (!id.empty()) {
    const int count = ++ids_[id];
    out_ += attribute("id", count == 1 ? id : id + "-" + std::to_string(count));
  }
  out_ += attribute("x", box.x0) + attribute("y", box.y0) + attribute("width", box.x1 - box.x0) +
          attribute("height", box.y1 - box.y0) + attribute("class", style);
  end("rect", title);
}

void SvgWriter::line(Point from, Point to, std::string_view style, std::string_view title) {
  path(move_to(from) + line_to(to), style, title);
}

void SvgWriter::path(const std::string& data, std::string_view style, std::string_view title) {
  styles_.emplace(style);
  out_ += "<path" + attribute("d", data) + attribute("class", style);
  end("path", title);
}

void SvgWriter::text(Point at, Anchor anchor, std::string_view style, std::string_view content,
                     std::string_view title) {
  std::string classes(style);
  if (anchor == Anchor::middle) classes += " mid";
  if (anchor == Anchor::end) classes += " end";
  out_ += "<text" + attribute("x", at.x) + attribute("y", at.y) + attribute("class", classes) + ">";
  if (!title.empty()) out_ += "<title>" + xml_escaped(title) + "</title>";
  out_ += xml_escaped(content) + "</text>\n";
}

void SvgWriter::upright(Point at, std::string_view style, std::string_view content, std::string_view title) {
  const std::string turn = "rotate(-90 " + std::to_string(at.x) + " " + std::to_string(at.y) + ")";
  out_ += "<text" + attribute("x", at.x) + attribute("y", at.y) + attribute("transform", turn) +
          attribute("class", std::string(style) + " mid") + ">";
  if (!title.empty()) out_ += "<title>" + xml_escaped(title) + "</title>";
  out_ += xml_escaped(content) + "</text>\n";
}

}  // namespace pal::analyzer::chart
