#include "programs/pal/session/colour.hpp"

#include <array>
#include <cstdlib>
#include <sstream>
#include <string_view>
#include <utility>

#include "pal/support/text_width.hpp"

namespace pal::program {
namespace {

constexpr std::string_view bold = "\x1b[1m";
constexpr std::string_view red = "\x1b[1;31m";
constexpr std::string_view green = "\x1b[32m";
constexpr std::string_view yellow = "\x1b[1;33m";
constexpr std::string_view blue = "\x1b[34m";
constexpr std::string_view cyan = "\x1b[36m";
constexpr std::string_view plain = "\x1b[0m";

std::string in(std::string_view colour, std::string_view text) {
  return std::string(colour) + std::string(text) + std::string(plain);
}

bool is_set(const char* name, const char* but = "") {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0' && std::string_view(value) != but;
}

/// The first word of the line in its colour.
std::string coloured_head(std::string_view line) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 4> heads{
      {{"error[", red}, {"warning[", yellow}, {"note", cyan}, {"hint:", cyan}}};
  for (const auto& [head, colour] : heads) {
    if (!line.starts_with(head)) continue;
    const auto end = line.find(':');
    if (end == std::string_view::npos) break;
    return in(colour, line.substr(0, end + 1)) +
           (colour == cyan ? std::string(line.substr(end + 1)) : in(bold, line.substr(end + 1)));
  }
  return std::string(line);
}

/// A line below a finding: its place, its text, its marks, or what its fix changes.
std::string coloured_line(std::string_view line) {
  const auto text = line.find_first_not_of(" 0123456789");
  if (text == std::string_view::npos) return std::string(line);
  const std::string_view rest = line.substr(text);
  const auto gutter = line.substr(0, text);
  if (rest.starts_with("--> ")) return in(blue, line);
  if (!gutter.empty() && rest.starts_with("- ")) return std::string(gutter) + in(red, rest);
  if (!gutter.empty() && rest.starts_with("+ ")) return std::string(gutter) + in(green, rest);
  if (!rest.starts_with("|")) return coloured_head(line);
  const std::string_view shown = rest.substr(1);
  const bool marks = !shown.empty() && shown.find_first_not_of(" ^-") == std::string_view::npos &&
                     shown.find_first_of("^-") != std::string_view::npos;
  return in(blue, line.substr(0, text + 1)) +
         (marks ? in(shown.find('^') != std::string_view::npos ? red : cyan, shown) : std::string(shown));
}

template <class Colour>
std::string by_line(const std::string& text, const Colour& colour) {
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    const auto end = std::min(text.find('\n', begin), text.size());
    result += colour(std::string_view(text).substr(begin, end - begin));
    if (end < text.size()) result += '\n';
    begin = end + 1;
  }
  return result;
}

/// One paragraph or item in lines, its code in a colour, its marks left out.
void write_filled(const std::string& paragraph, const std::string& first, const std::string& other,
                  bool colour, std::size_t width, std::string& out) {
  std::istringstream words(paragraph);
  std::string word;
  std::size_t column = static_cast<std::size_t>(pal::width(first));
  bool at_start = true, code = false;
  out += first;
  while (words >> word) {
    std::string shown, bare;
    for (const char c : word) {
      if (c == '`') {
        code = !code;
        if (colour) shown += code ? cyan : plain;
        continue;
      }
      if (c == '*' && !code) continue;
      shown += c;
      bare += c;
    }
    const auto length = static_cast<std::size_t>(pal::width(bare));
    if (!at_start && column + 1 + length > width) {
      out += "\n" + other;
      column = static_cast<std::size_t>(pal::width(other));
      at_start = true;
    }
    if (!at_start) {
      out += ' ';
      ++column;
    }
    out += shown;
    column += length;
    at_start = false;
  }
  if (colour && code) out += plain;
  out += "\n";
}

}  // namespace

bool wants_colour(bool is_terminal) {
  if (is_set("NO_COLOR")) return false;
  if (is_set("CLICOLOR_FORCE", "0")) return true;
  const char* terminal = std::getenv("TERM");
  return is_terminal && (terminal == nullptr || std::string_view(terminal) != "dumb");
}

std::string coloured_findings(const std::string& text) {
  return by_line(text, coloured_line);
}

std::string coloured_table(const std::string& text) {
  return by_line(text, [](std::string_view line) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 5> states{
        {{"  holds", green},
         {"  fails", red},
         {"  undecided", yellow},
         {"  never", yellow},
         {"  not checked", yellow}}};
    for (const auto& [state, colour] : states) {
      if (line.starts_with(state) && line.substr(state.size()).starts_with(" "))
        return in(colour, state) + std::string(line.substr(state.size()));
    }
    return std::string(line);
  });
}

std::string terminal_page(const std::string& markdown, bool colour, std::size_t width) {
  std::string out, paragraph, first, other;
  bool in_fence = false;
  const auto flush = [&] {
    if (!paragraph.empty()) write_filled(paragraph, first, other, colour, width, out);
    paragraph.clear();
    first.clear();
    other.clear();
  };
  std::istringstream lines(markdown);
  for (std::string line; std::getline(lines, line);) {
    const std::string_view bare =
        std::string_view(line).substr(std::min(line.find_first_not_of(' '), line.size()));
    if (bare.starts_with("```")) {
      flush();
      in_fence = !in_fence;
      // Of several files each says its name.
      const std::string_view info = bare.substr(3);
      const auto name = info.find(' ');
      if (in_fence && name != std::string_view::npos)
        out += "  " + std::string(info.substr(name + 1)) + ":\n";
    } else if (in_fence) {
      out += line.empty() ? "\n" : "    " + (colour ? in(cyan, line) : line) + "\n";
    } else if (line.starts_with("#")) {
      flush();
      const std::string title = line.substr(std::min(line.find_first_not_of("# "), line.size()));
      out += (colour ? in(bold, title) : title) + "\n";
    } else if (bare.empty()) {
      flush();
      out += "\n";
    } else if (bare.starts_with("|")) {  // a table stays as it is
      flush();
      out += line + "\n";
    } else {
      if (bare.starts_with("- ") || bare.starts_with("* ")) {
        flush();
        first = std::string(line.size() - bare.size(), ' ') + "- ";
        other = std::string(first.size(), ' ');
        paragraph = bare.substr(2);
      } else {
        paragraph += (paragraph.empty() ? "" : " ") + std::string(bare);
      }
    }
  }
  flush();
  return out;
}

}  // namespace pal::program
