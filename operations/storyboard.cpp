#include "operations/storyboard.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "operations/codes.hpp"
#include "operations/graph.hpp"
#include "pal/pan/dot.hpp"
#include "pal/support/xml.hpp"

namespace pal::operations {
namespace {

/// The icons by which something is told, in the order in which the token first comes to them.
std::vector<std::size_t> told(const Graph& graph, std::size_t index) {
  const Operation& operation = graph.program().operations[index];
  std::vector<std::size_t> order, waiting;
  std::vector<bool> seen(operation.icons.size(), false);
  if (const auto start = graph.start(index)) waiting.push_back(*start);
  while (!waiting.empty()) {
    const std::size_t here = waiting.back();
    waiting.pop_back();
    if (seen[here]) continue;
    seen[here] = true;
    const Icon& icon = operation.icons[here];
    if (has_completions(icon.kind) || icon.kind == IconKind::delay) order.push_back(here);
    const auto next = graph.targets({index, here});
    waiting.insert(waiting.end(), next.rbegin(), next.rend());
  }
  return order;
}

class Teller {
 public:
  Teller(const Graph& graph, const Skills& skills, const PossibleCodes& codes, std::size_t index,
         const Happened* run)
      : graph_(graph),
        index_(index),
        run_(run),
        operation_(graph.program().operations[index]),
        skills_(skills),
        codes_(codes),
        order_(told(graph, index)) {
    scenes_.resize(operation_.icons.size());
    for (std::size_t i = 0; i < order_.size(); ++i) scenes_[order_[i]] = i;
  }

  std::vector<StoryScene> scenes() const {
    std::vector<StoryScene> result;
    for (std::size_t i = 0; i < order_.size(); ++i) result.push_back(scene(i));
    return result;
  }

  std::string beginning() const {
    for (const Icon& icon : operation_.icons)
      if (icon.kind == IconKind::start) {
        const auto first = scene_behind(icon.next, 0);
        return first ? fmt::format("It begins with {}.", name_of(*first)) : destination(icon.next, 0);
      }
    return {};
  }

 private:
  StoryScene scene(std::size_t number) const {
    const Place at{index_, order_[number]};
    const Icon& icon = graph_.icon(at);
    StoryScene scene;
    scene.icon = icon.id;
    scene.title = fmt::format("Scene {}: {}", number + 1, icon.id);
    if (!icon.note.empty()) scene.sentences.push_back(icon.note);
    switch (icon.kind) {
      case IconKind::skill:
        tell_skill(at, icon, scene);
        break;
      case IconKind::sub_operation:
        tell_sub_operation(at, icon, scene);
        break;
      case IconKind::test:
        scene.sentences.push_back(icon.limits.empty() ? fmt::format("It is looked whether {}.", awaited(icon))
                                                      : fmt::format("{} is read.", read_of(icon)));
        tell_branches(at, icon, scene);
        break;
      case IconKind::wait:
        scene.sentences.push_back(fmt::format("The robot waits until {}{}.", awaited(icon), at_most(icon)));
        tell_branches(at, icon, scene);
        break;
      case IconKind::question:
        scene.sentences.push_back(
            fmt::format("A person is asked: \"{}\"{}", icon.text, icon.timeout ? at_most(icon) + "." : ""));
        tell_branches(at, icon, scene);
        break;
      case IconKind::zero:
        scene.sentences.push_back(
            fmt::format("What the sensor {} shows now counts as zero from now on.", icon.sensor));
        tell_branches(at, icon, scene);
        break;
      case IconKind::planned:
        scene.sentences.push_back(fmt::format(
            "A person does what the skill {} will do one day, and says how it ended.", icon.skill));
        tell_branches(at, icon, scene);
        break;
      default:
        scene.sentences.push_back(fmt::format("The robot waits for {} s.", in_words(*icon.seconds)));
        scene.branches.push_back(destination(icon.next, 0));
    }
    if (run_ != nullptr) scene.sentences.push_back(run_->at(at));
    return scene;
  }

  void tell_skill(Place at, const Icon& icon, StoryScene& scene) const {
    const auto found = skills_.find(icon.skill);
    if (found == skills_.end()) {
      scene.sentences.push_back(fmt::format("The skill {} runs. Nothing is known of it.", icon.skill));
      tell_branches(at, icon, scene);
      return;
    }
    const pan::Template& skill = found->second;
    if (!skill.preconditions.empty())
      scene.sentences.push_back(fmt::format("Before: {}", fmt::join(skill.preconditions, " ")));
    scene.sentences.push_back(fmt::format("The skill {} runs{}{}", icon.skill,
                                          settings(icon, skill.parameters),
                                          continued(fmt::format("{}", fmt::join(skill.descriptions, " ")))));
    tell_runs(icon, scene);
    if (!skill.postconditions.empty())
      scene.sentences.push_back(
          fmt::format("Afterwards, if the code is normal: {}", fmt::join(skill.postconditions, " ")));
    tell_branches(at, icon, scene);
  }

  /// "Moves the tool." becomes ": it moves the tool."
  static std::string continued(std::string text) {
    const std::string first = text.substr(0, text.find(' '));
    if (text.empty()) return ".";
    if (!first.ends_with('s') || text[0] < 'A' || text[0] > 'Z') return ". " + text;
    text[0] = static_cast<char>(text[0] - 'A' + 'a');
    return ": it " + text;
  }

  /// A unit as it is read aloud; most are read as they are written.
  static std::string spoken(const std::string& unit) { return unit == "deg" ? "degrees" : unit; }

  static std::string settings(const Icon& icon, const std::vector<pan::Parameter>& parameters) {
    std::vector<std::string> texts;
    for (const Parameter& given : icon.parameters) {
      if (!given.source.written()) {
        texts.push_back(fmt::format("{} equal to {}", given.name, in_words({0, {}, given.source})));
        continue;
      }
      std::string unit;
      for (const pan::Parameter& parameter : parameters)
        if (parameter.name == given.name && !parameter.unit.empty()) unit = " " + spoken(parameter.unit);
      texts.push_back(fmt::format("{} {}{}", given.name, to_text(given), unit));
    }
    if (texts.empty()) return "";
    const std::string last = texts.back();
    texts.pop_back();
    return texts.empty() ? " with " + last : fmt::format(" with {} and {}", fmt::join(texts, ", "), last);
  }

  void tell_sub_operation(Place at, const Icon& icon, StoryScene& scene) const {
    if (const auto sub = graph_.sub_operation(at)) {
      const Operation& inside = graph_.program().operations[*sub];
      scene.sentences.push_back(fmt::format("The operation {} runs{}{} Its own scenes are told below.",
                                            inside.name, settings(icon, inside.arguments),
                                            continued(inside.description)));
    }
    tell_runs(icon, scene);
    tell_branches(at, icon, scene);
  }

  void tell_branches(Place at, const Icon& icon, StoryScene& scene) const {
    for (const Ending& ending : endings_of(graph_, at, skills_, codes_.exits)) {
      const int code = ending.code;
      const auto way = route(graph_, at, code, ending.normal());
      scene.branches.push_back(
          fmt::format("{}{} {}", code == any_code ? "Any other code" : fmt::format("Code {}", code),
                      meaning(at, icon, code),
                      way ? destination(*way, code) : "No icon handles it, and the operation fails here."));
    }
  }

  /// ": It is there.", ", from its exit done." or "."
  std::string meaning(Place at, const Icon& icon, int code) const {
    if (icon.kind == IconKind::sub_operation) return exits_with(at, code);
    if (code == time_over) return ": The time is over.";
    if (icon.kind == IconKind::question)
      return ": " + (code < 0 ? "Nobody can be asked."
                              : fmt::format("The answer is \"{}\".",
                                            icon.ways[static_cast<std::size_t>(code)].text));
    if (icon.kind == IconKind::planned) {
      for (const Way& each : icon.ways)
        if (each.codes.front() == code) return fmt::format(": The person says \"{}\".", each.text);
      return ": Nobody can be asked.";
    }
    if (icon.kind == IconKind::zero) return code == 0 ? ": It is zero." : ": It cannot be zeroed.";
    if (!icon.conditions.empty()) return ": " + meaning_of_reading(icon, code);
    if (code == no_value) return ": A value that it needs is missing.";
    const auto skill = skills_.find(icon.skill);
    if (skill == skills_.end()) return ".";
    for (const pan::Completion& completion : skill->second.completions) {
      if (completion.code != code || completion.description.empty()) continue;
      return fmt::format(": {}{}", completion.description, completion.description.ends_with('.') ? "" : ".");
    }
    return ".";
  }
  /// By which of its exits a sub-operation ends with the code.
  std::string exits_with(Place at, int code) const {
    const auto sub = graph_.sub_operation(at);
    if (!sub) return ".";
    std::vector<std::string> names;
    const Operation& inside = graph_.program().operations[*sub];
    for (std::size_t i = 0; i < inside.icons.size(); ++i) {
      const Icon& exit = inside.icons[i];
      const CodeSet& codes = codes_.at[*sub][i];
      if (exit.kind != IconKind::exit || codes.empty()) continue;
      const int given = !exit.code                    ? code
                        : exit.code->source.written() ? static_cast<int>(exit.code->number)
                                                      : any_code;
      if (given == code && (exit.code || codes.contains(code))) names.push_back(exit.id);
    }
    if (names.empty()) return ".";
    return fmt::format(", from its exit {}.", fmt::join(names, " or "));
  }
  /// As a sentence has it: "5", "the count of put so far", "what press reported as force".
  static std::string in_words(const Amount& amount) {
    if (amount.source.kind == Source::Kind::count) return to_text(amount) + " so far";
    if (amount.source.kind == Source::Kind::output)
      return fmt::format("what {} reported as {}", amount.source.icon, amount.source.name);
    return amount.source.written() ? fmt::format("{:g}", amount.number) : to_text(amount);
  }
  /// How often it runs, and how long.
  static void tell_runs(const Icon& icon, StoryScene& scene) {
    if (icon.repeat)
      scene.sentences.push_back(
          fmt::format("It runs {} times, as long as it ends normally.", in_words(*icon.repeat)));
    if (icon.time_limit)
      scene.sentences.push_back(fmt::format("It is ended after {} s.", in_words(*icon.time_limit)));
    if (icon.retries == 0) return;
    const std::string when = icon.retry_on.empty()
                                 ? "If it does not end normally"
                                 : fmt::format("With code {}", fmt::join(icon.retry_on, " or "));
    scene.sentences.push_back(fmt::format("{}, it begins again, up to {} time{}.", when, icon.retries,
                                          icon.retries == 1 ? "" : "s"));
  }
  static std::string at_most(const Icon& icon) {
    return icon.timeout ? fmt::format("; it waits {} s at most", in_words(*icon.timeout)) : "";
  }
  /// "The sensor eye", "The count of put".
  static std::string read_of(const Icon& icon) {
    const Condition& only = icon.conditions.front();
    if (!only.sensor.empty())
      return only.mean_of == 1
                 ? fmt::format("The sensor {}", only.sensor)
                 : fmt::format("The mean of {} readings of the sensor {}", only.mean_of, only.sensor);
    std::string text = subject_text(only);
    if (text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
  }
  /// "280 or less"
  static std::string compared(const Condition& condition) {
    if (condition.at_least && condition.at_most) return condition_text(condition);
    return condition.at_least ? to_text(*condition.at_least) + " or more"
                              : to_text(*condition.at_most) + " or less";
  }
  /// "the sensor eye shows 280 or less and the count of put is 3 or more"
  static std::string awaited(const Icon& icon) {
    std::string text;
    for (const Condition& each : icon.conditions) {
      if (!text.empty()) text += icon.combination == Combination::any ? ", or " : ", and ";
      const std::string mean =
          each.mean_of == 1 ? "" : fmt::format(" in the mean of {} readings", each.mean_of);
      text += each.sensor.empty()
                  ? fmt::format("{} is {}", subject_text(each), compared(each))
                  : fmt::format("the sensor {} shows {}{}", each.sensor, compared(each), mean);
    }
    return text;
  }
  static std::string meaning_of_reading(const Icon& icon, int code) {
    if (code == no_value) return "There is no reading.";
    if (icon.kind == IconKind::wait) return code == 0 ? "It is so." : "The time is over.";
    if (icon.limits.empty()) return code == 1 ? "It is so." : "It is not so.";
    const auto index = static_cast<std::size_t>(code);
    if (index == 0) return fmt::format("It shows less than {}.", to_text(icon.limits.front()));
    if (index == icon.limits.size()) return fmt::format("It shows {} or more.", to_text(icon.limits.back()));
    return fmt::format("It shows {} or more, and less than {}.", to_text(icon.limits[index - 1]),
                       to_text(icon.limits[index]));
  }

  std::string name_of(std::size_t scene) const {
    return fmt::format("scene {}, {}", scene + 1, operation_.icons[order_[scene]].id);
  }
  /// After all MERGEs and CASEs; nothing: no scene comes.
  std::optional<std::size_t> scene_behind(const Connection& to, int code) const {
    auto at = graph_.target(index_, to);
    for (std::size_t steps = 0; at && steps <= operation_.icons.size(); ++steps) {
      if (scenes_[*at]) return scenes_[*at];
      const Icon& icon = operation_.icons[*at];
      if (icon.kind == IconKind::exit || icon.kind == IconKind::restart) return std::nullopt;
      const auto way = icon.kind == IconKind::branch ? way_of(icon, code) : std::optional(icon.next);
      if (!way) return std::nullopt;
      at = graph_.target(index_, *way);
    }
    return std::nullopt;
  }

  static std::string exit_text(const Icon& exit, int code) {
    if (!exit.code) return code == any_code ? "that code" : fmt::format("code {}", code);
    return exit.code->source.written() ? fmt::format("code {:g}", exit.code->number)
                                       : in_words(*exit.code) + " as its code";
  }

  /// "The story goes on with scene 3, rub."
  std::string destination(const Connection& to, int code) const {
    if (const auto scene = scene_behind(to, code))
      return fmt::format("The story goes on with {}.", name_of(*scene));
    auto at = graph_.target(index_, to);
    for (std::size_t steps = 0; at && steps <= operation_.icons.size(); ++steps) {
      const Icon& icon = operation_.icons[*at];
      if (icon.kind == IconKind::exit)
        return fmt::format("The operation ends at {} with {}.{}{}", icon.id, exit_text(icon, code),
                           icon.note.empty() ? "" : " ", icon.note);
      if (icon.kind == IconKind::restart) return "All begins again from START.";
      const auto way = icon.kind == IconKind::branch ? way_of(icon, code) : std::optional(icon.next);
      if (!way) return fmt::format("CASE {} has no way for it, and the operation fails here.", icon.id);
      at = graph_.target(index_, *way);
    }
    return "Nothing follows.";
  }

  const Graph& graph_;
  std::size_t index_;
  const Happened* run_;
  const Operation& operation_;
  const Skills& skills_;
  const PossibleCodes& codes_;
  std::vector<std::size_t> order_;                  // of scenes: their icons
  std::vector<std::optional<std::size_t>> scenes_;  // of icons: their scenes
};

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

std::vector<StoryChapter> story(const Program& program, const Skills& skills, const Happened* run) {
  std::vector<StoryChapter> result;
  const Graph graph(program);
  const PossibleCodes codes = possible_codes(graph, skills);
  for (std::size_t i = 0; i < program.operations.size(); ++i) {
    const Operation& operation = program.operations[i];
    const Teller teller(graph, skills, codes, i, run);
    StoryChapter chapter{operation.name, {}, {}, teller.scenes(), to_dot(program, i, run)};
    if (!operation.description.empty()) chapter.introduction.push_back(operation.description);
    if (const auto retreat = graph.on_stop(i))
      chapter.introduction.push_back(fmt::format("If it is stopped, the operation {} runs before all rests.",
                                                 program.operations[*retreat].name));
    chapter.introduction.push_back(teller.beginning());
    if (run != nullptr && i == 0) {
      chapter.introduction.push_back(run->summary());
      chapter.course = run->course();
    }
    result.push_back(std::move(chapter));
  }
  return result;
}

std::string storyboard_markdown(const Program& program, const Skills& skills, const Happened* run) {
  std::string out;
  for (const StoryChapter& chapter : story(program, skills, run)) {
    out += fmt::format("{}# {}\n", out.empty() ? "" : "\n#", plain(chapter.operation));
    for (const std::string& text : chapter.introduction) out += "\n" + plain(text) + "\n";
    if (!chapter.course.empty()) {
      out += "\n### What happened\n\n";
      for (const std::string& text : chapter.course) out += "1. " + plain(text) + "\n";
    }
    for (const StoryScene& scene : chapter.scenes) {
      out += "\n### " + plain(scene.title) + "\n";
      for (const std::string& text : scene.sentences) out += "\n" + plain(text) + "\n";
      out += "\n";
      for (const std::string& text : scene.branches) out += "- " + plain(text) + "\n";
    }
  }
  return out;
}

std::string storyboard_html(const Program& program, const Skills& skills, const Happened* run) {
  const std::string title = xml_escaped(program.operations.front().name);
  std::string out = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>{}</title>\n"
      "<style>{}</style>\n</head>\n<body>\n<h1>{}</h1>\n",
      title, style, title);
  for (const StoryChapter& chapter : story(program, skills, run)) {
    if (xml_escaped(chapter.operation) != title) out += "<h2>" + xml_escaped(chapter.operation) + "</h2>\n";
    for (const std::string& text : chapter.introduction) out += "<p>" + xml_escaped(text) + "</p>\n";
    if (!chapter.course.empty()) {
      out += "<h3>What happened</h3>\n<ol>\n";
      for (const std::string& text : chapter.course) out += "<li>" + xml_escaped(text) + "</li>\n";
      out += "</ol>\n";
    }
    const std::string drawing = pan::svg(chapter.dot);
    // Without the prologue, which stands once, before a whole document.
    out += drawing.substr(drawing.find("<svg"));
    for (const StoryScene& scene : chapter.scenes) {
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
