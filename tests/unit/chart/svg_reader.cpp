#include "tests/unit/chart/svg_reader.hpp"

#include <map>
#include <regex>

namespace pal::analyzer::chart {

namespace {

std::string resolved(std::string text) {
  const std::map<std::string, std::string> entities = {
      {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}};
  for (const auto& [entity, character] : entities) {
    for (std::size_t at = text.find(entity); at != std::string::npos;
         at = text.find(entity, at + character.size())) {
      text.replace(at, entity.size(), character);
    }
  }
  return text;
}

std::string attribute(const std::string& tag, const std::string& name) {
  const std::size_t at = tag.find(" " + name + "=\"");
  if (at == std::string::npos) return {};
  const std::size_t begin = at + name.size() + 3;
  return tag.substr(begin, tag.find('"', begin) - begin);
}

/// Font sizes by class, read from the style sheet; later rules win, as in CSS among equals.
class Styles {
 public:
  explicit Styles(const std::string& svg) {
    const std::string sheet = svg.substr(svg.find("<style>"), svg.find("</style>") - svg.find("<style>"));
    const std::regex rule("([^{}]+)\\{([^}]*)\\}");
    for (std::sregex_iterator it(sheet.begin(), sheet.end(), rule), end; it != end; ++it) {
      const std::string body = (*it)[2];
      std::smatch size;
      if (!std::regex_search(body, size, std::regex("font-size: ([0-9]+)px"))) continue;
      const std::string selectors = (*it)[1];
      const std::regex selector("([.a-z-]+)");
      for (std::sregex_iterator one(selectors.begin(), selectors.end(), selector); one != end; ++one) {
        rules_.emplace_back((*one)[1], std::stoll(size[1]));
      }
    }
  }

  Length size(const std::string& classes) const {
    Length result = 90;
    std::size_t strength = 0;
    for (const auto& [selector, size] : rules_) {
      const std::size_t parts = matches(selector, classes);
      if (parts >= strength && parts > 0) {
        strength = parts;
        result = size;
      }
    }
    return result;
  }

 private:
  // How many classes the selector ".a.b" names, if all of them are among `classes`; else 0.
  static std::size_t matches(const std::string& selector, const std::string& classes) {
    std::size_t parts = 0;
    std::size_t at = 0;
    while (at < selector.size() && selector[at] == '.') {
      const std::size_t next = std::min(selector.find('.', at + 1), selector.size());
      const std::string name = selector.substr(at + 1, next - at - 1);
      if ((" " + classes + " ").find(" " + name + " ") == std::string::npos) return 0;
      ++parts;
      at = next;
    }
    return at == selector.size() ? parts : 0;
  }

  std::vector<std::pair<std::string, Length>> rules_;
};

}  // namespace

SvgContent read_svg(const std::string& svg) {
  SvgContent content;
  const Styles styles(svg);
  std::vector<std::string> open;
  std::vector<std::string> tags;
  for (std::size_t at = svg.find('<'); at != std::string::npos; at = svg.find('<', at + 1)) {
    const std::size_t end = svg.find('>', at);
    if (end == std::string::npos) {
      content.problem = "a tag is not closed";
      return content;
    }
    const std::string tag = svg.substr(at + 1, end - at - 1);
    if (tag.front() == '?' || tag.front() == '!') continue;
    const std::string name = tag.substr(0, tag.find_first_of(" /", 1));
    if (tag.front() == '/') {
      if (open.empty() || "/" + open.back() != tag) {
        content.problem = "<" + tag + "> ends nothing";
        return content;
      }
      if (!open.empty()) open.pop_back();
      continue;
    }
    const bool empty = tag.back() == '/';
    const std::string style = attribute(tag, "class");
    const std::string inner = empty ? "" : svg.substr(end + 1, svg.find("</" + name + ">", end) - end - 1);
    std::string title;
    std::string rest = inner;
    if (inner.rfind("<title>", 0) == 0) {
      title = resolved(inner.substr(7, inner.find("</title>") - 7));
      rest = inner.substr(inner.find("</title>") + 8);
    }
    if (name == "svg") {
      std::smatch box;
      const std::string view = attribute(tag, "viewBox");
      if (std::regex_match(view, box, std::regex("0 0 ([0-9]+) ([0-9]+)"))) {
        content.width = std::stoll(box[1]);
        content.height = std::stoll(box[2]);
      }
    }
    if (name == "text") {
      const Length size = styles.size(style);
      const bool bold = style.find("strong") != std::string::npos || style.find("title") == 0;
      const std::string text = resolved(rest);
      const Length width = text_width(text, size, bold && style.find("subtitle") == std::string::npos);
      Length x = std::stoll(attribute(tag, "x"));
      const Length y = std::stoll(attribute(tag, "y"));
      if ((" " + style + " ").find(" mid ") != std::string::npos) x -= width / 2;
      if ((" " + style + " ").find(" end ") != std::string::npos) x -= width;
      Box box{x, y - size * 3 / 4, x + width, y + size / 5};
      // Upright: turned about the middle of its baseline.
      if (!attribute(tag, "transform").empty()) {
        const Length middle = x + width / 2;
        box = {middle - size * 3 / 4, y - width / 2, middle + size / 5, y + width / 2};
      }
      content.texts.push_back({text, box});
    }
    content.elements.push_back({name, style, title});
    if (!empty) open.push_back(name);
  }
  if (!open.empty()) content.problem = "<" + open.back() + "> is not closed";
  return content;
}

}  // namespace pal::analyzer::chart
