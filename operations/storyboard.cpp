#include "operations/storyboard.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "operations/codes.hpp"
#include "pal/pan/dot.hpp"
#include "pal/support/xml.hpp"

namespace pal::operations {
namespace {

struct Scene {
  std::string title;
  std::vector<std::string> sentences;  // each a paragraph
  std::vector<std::string> branches;   // each an item of a list
};

struct Chapter {
  std::string title;
  std::vector<std::string> introduction;
  std::vector<Scene> scenes;
  std::string dot;
};

/// The icons by which something is told, in the order in which the token first comes to them.
std::vector<std::size_t> told(const Operation& operation) {
  std::vector<std::size_t> order, waiting;
  std::vector<bool> seen(operation.icons.size(), false);
  for (std::size_t i = operation.icons.size(); i > 0; --i)
    if (operation.icons[i - 1].kind == IconKind::start) waiting.push_back(i - 1);
  while (!waiting.empty()) {
    const std::size_t here = waiting.back();
    waiting.pop_back();
    if (seen[here]) continue;
    seen[here] = true;
    const Icon& icon = operation.icons[here];
    if (icon.kind == IconKind::skill || icon.kind == IconKind::sub_operation || icon.kind == IconKind::delay)
      order.push_back(here);
    const auto next = outputs(icon);
    for (auto to = next.rbegin(); to != next.rend(); ++to)
      if (const auto index = find_icon(operation, to->icon)) waiting.push_back(*index);
  }
  return order;
}

class Teller {
 public:
  Teller(const Program& program, const Skills& skills, std::size_t index)
      : program_(program),
        operation_(program.operations[index]),
        skills_(skills),
        exits_(possible_codes(program, skills).exits),
        order_(told(operation_)) {}

  std::vector<Scene> scenes() const {
    std::vector<Scene> result;
    for (std::size_t i = 0; i < order_.size(); ++i) result.push_back(scene(i));
    return result;
  }

  std::string beginning() const {
    for (const Icon& icon : operation_.icons)
      if (icon.kind == IconKind::start) {
        const std::string first = destination(icon.next, 0);
        return first.starts_with("on to ") ? fmt::format("It begins with {}.", first.substr(6))
                                           : fmt::format("It begins, and {}.", first);
      }
    return {};
  }

 private:
  Scene scene(std::size_t number) const {
    const Icon& icon = operation_.icons[order_[number]];
    Scene scene;
    scene.title = fmt::format("Scene {}: {}", number + 1, icon.id);
    if (!icon.note.empty()) scene.sentences.push_back(icon.note);
    switch (icon.kind) {
      case IconKind::skill:
        tell_skill(icon, scene);
        break;
      case IconKind::sub_operation:
        tell_sub_operation(icon, scene);
        break;
      default:
        scene.sentences.push_back(fmt::format("The robot waits for {:g} s.", icon.seconds));
        scene.branches.push_back(fmt::format("Then {}.", destination(icon.next, 0)));
    }
    return scene;
  }

  void tell_skill(const Icon& icon, Scene& scene) const {
    const auto found = skills_.find(icon.skill);
    if (found == skills_.end()) {
      scene.sentences.push_back(fmt::format("The skill {} runs. Nothing is known of it.", icon.skill));
      tell_branches(icon, scene);
      return;
    }
    const pan::Template& skill = found->second;
    if (!skill.preconditions.empty())
      scene.sentences.push_back(fmt::format("Before: {}", fmt::join(skill.preconditions, " ")));
    scene.sentences.push_back(fmt::format("The skill {} runs{}. {}", icon.skill, settings(icon, skill),
                                          fmt::join(skill.descriptions, " ")));
    if (!skill.postconditions.empty())
      scene.sentences.push_back(
          fmt::format("Afterwards, if the code is normal: {}", fmt::join(skill.postconditions, " ")));
    tell_branches(icon, scene);
  }

  static std::string settings(const Icon& icon, const pan::Template& skill) {
    std::vector<std::string> texts;
    for (const Parameter& given : icon.parameters) {
      std::string unit;
      for (const pan::Parameter& parameter : skill.parameters)
        if (parameter.name == given.name && !parameter.unit.empty()) unit = " " + parameter.unit;
      texts.push_back(fmt::format("{} {}{}", given.name, to_text(given), given.count_of.empty() ? unit : ""));
    }
    return texts.empty() ? "" : fmt::format(", with {}", fmt::join(texts, ", "));
  }

  void tell_sub_operation(const Icon& icon, Scene& scene) const {
    if (const auto sub = find_sub_operation(program_, operation_, icon)) {
      const Operation& inside = program_.operations[*sub];
      scene.sentences.push_back(fmt::format("The operation {} runs; its own scenes are told below.{}{}",
                                            inside.name, inside.description.empty() ? "" : " ",
                                            inside.description));
    }
    tell_branches(icon, scene);
  }

  void tell_branches(const Icon& icon, Scene& scene) const {
    for (const auto& [code, normal] : completions_of(program_, operation_, icon, skills_, exits_)) {
      const auto way = route(operation_, icon, code, normal);
      scene.branches.push_back(
          fmt::format("Code {}{}: {}.", code, meaning(icon, code),
                      way ? destination(*way, code) : "nobody handles it, and the operation ends here"));
    }
  }

  std::string meaning(const Icon& icon, int code) const {
    const auto skill = skills_.find(icon.skill);
    if (skill == skills_.end()) return {};
    for (const pan::Completion& completion : skill->second.completions) {
      if (completion.code != code || completion.description.empty()) continue;
      std::string text = completion.description;
      if (text.ends_with('.')) text.pop_back();
      return fmt::format(" ({})", text);
    }
    return {};
  }

  /// "on to scene 3, rub", after all MERGEs and CASEs.
  std::string destination(const Connection& to, int code) const {
    auto at = find_icon(operation_, to.icon);
    for (std::size_t steps = 0; at && steps <= operation_.icons.size(); ++steps) {
      const Icon& icon = operation_.icons[*at];
      if (icon.kind == IconKind::exit)
        return fmt::format("the operation ends with code {}", icon.code.value_or(code));
      if (icon.kind == IconKind::restart) return "all begins again from START";
      const auto scene = std::find(order_.begin(), order_.end(), *at);
      if (scene != order_.end())
        return fmt::format("on to scene {}, {}", scene - order_.begin() + 1, icon.id);
      const auto way = icon.kind == IconKind::branch ? way_of(icon, code) : std::optional(icon.next);
      if (!way) return fmt::format("CASE {} has no way for it, and the operation ends here", icon.id);
      at = find_icon(operation_, way->icon);
    }
    return "nowhere";
  }

  const Program& program_;
  const Operation& operation_;
  const Skills& skills_;
  std::vector<std::set<int>> exits_;
  std::vector<std::size_t> order_;
};

std::vector<Chapter> chapters(const Program& program, const Skills& skills) {
  std::vector<Chapter> result;
  for (std::size_t i = 0; i < program.operations.size(); ++i) {
    const Operation& operation = program.operations[i];
    const Teller teller(program, skills, i);
    Chapter chapter{operation.name, {}, teller.scenes(), to_dot(program, i)};
    if (!operation.description.empty()) chapter.introduction.push_back(operation.description);
    chapter.introduction.push_back(teller.beginning());
    result.push_back(std::move(chapter));
  }
  return result;
}

/// What Markdown would take for its own marks stands for itself.
std::string plain(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (std::string_view("\\`*_<>[]#|").find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

constexpr const char* style = R"(
body { max-width: 60rem; margin: 0 auto; padding: 1.5rem; color: #1a1a1a; font: 1rem/1.5 "Liberation Sans", Arial, sans-serif; }
h2 { border-bottom: 2px solid #1a1a1a; margin-top: 2.5rem; } h3 { margin-bottom: .2rem; }
p { margin: .3rem 0; } ul { margin: .3rem 0; padding-left: 1.2rem; }
svg { display: block; max-width: 100%; height: auto; margin: 1rem 0; }
@page { size: A4; margin: 18mm 16mm; } section { break-inside: avoid; }
)";

}  // namespace

std::string storyboard_markdown(const Program& program, const Skills& skills) {
  std::string out;
  for (const Chapter& chapter : chapters(program, skills)) {
    out += fmt::format("{}# {}\n", out.empty() ? "" : "\n#", plain(chapter.title));
    for (const std::string& text : chapter.introduction) out += "\n" + plain(text) + "\n";
    for (const Scene& scene : chapter.scenes) {
      out += "\n### " + plain(scene.title) + "\n";
      for (const std::string& text : scene.sentences) out += "\n" + plain(text) + "\n";
      out += "\n";
      for (const std::string& text : scene.branches) out += "- " + plain(text) + "\n";
    }
  }
  return out;
}

std::string storyboard_html(const Program& program, const Skills& skills) {
  const std::string title = xml_escaped(program.operations.front().name);
  std::string out = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>{}</title>\n"
      "<style>{}</style>\n</head>\n<body>\n<h1>{}</h1>\n",
      title, style, title);
  for (const Chapter& chapter : chapters(program, skills)) {
    if (xml_escaped(chapter.title) != title) out += "<h2>" + xml_escaped(chapter.title) + "</h2>\n";
    for (const std::string& text : chapter.introduction) out += "<p>" + xml_escaped(text) + "</p>\n";
    const std::string drawing = pan::svg(chapter.dot);
    // Without the prologue, which stands once, before a whole document.
    out += drawing.substr(drawing.find("<svg"));
    for (const Scene& scene : chapter.scenes) {
      out += "<section>\n<h3>" + xml_escaped(scene.title) + "</h3>\n";
      for (const std::string& text : scene.sentences) out += "<p>" + xml_escaped(text) + "</p>\n";
      out += "<ul>\n";
      for (const std::string& text : scene.branches) out += "<li>" + xml_escaped(text) + "</li>\n";
      out += "</ul>\n</section>\n";
    }
  }
  return out + "</body>\n</html>\n";
}

}  // namespace pal::operations
