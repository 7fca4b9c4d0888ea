// An operation drawn as SVG by Graphviz.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "operations/codes.hpp"
#include "operations/storyboard.hpp"

namespace pal::operations {
namespace {

std::string in_quotes(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

std::string limits(const Icon& icon) {
  std::string text = subjects_text(icon) + "\n";
  for (const Amount& limit : icon.limits)
    text += (&limit == &icon.limits.front() ? "" : " | ") + to_text(limit);
  return text;
}

/// A condition a line.
std::string conditions(const Icon& icon) {
  std::string text = icon.combination == Combination::any ? "any of"
                     : icon.conditions.size() > 1         ? "all of"
                                                          : "";
  for (const Condition& each : icon.conditions)
    text += fmt::format("{}{} {}", text.empty() ? "" : "\n", subject_text(each), condition_text(each));
  return text;
}

/// How often it runs, and again; how long.
std::string runs(const Icon& icon) {
  std::string text;
  if (icon.repeat) text += "\nrepeat " + to_text(*icon.repeat);
  if (icon.retries > 0) text += fmt::format("\nretries {}", icon.retries);
  if (icon.time_limit) text += fmt::format("\nat most {} s", to_text(*icon.time_limit));
  return text;
}

std::string label(const Icon& icon) {
  switch (icon.kind) {
    case IconKind::start:
      return "START";
    case IconKind::exit:
      return (icon.code ? fmt::format("EXIT {}\n", to_text(*icon.code)) : "EXIT\n") + icon.id;
    case IconKind::restart:
      return "RESTART";
    case IconKind::branch:
      return "CASE";
    case IconKind::merge:
      return "";
    case IconKind::delay:
      return icon.seconds->source.written() ? fmt::format("wait {:g} s", icon.seconds->number)
                                            : "wait " + to_text(*icon.seconds);
    case IconKind::wait:
      return "wait for\n" + conditions(icon);
    case IconKind::test:
      return icon.id + "\n" + (icon.limits.empty() ? conditions(icon) : limits(icon));
    case IconKind::question:
      return icon.id + "\n" + icon.text;
    case IconKind::zero:
      return "zero\n" + icon.sensor;
    case IconKind::planned:
      return icon.id + "\n" + icon.skill + " (planned)";
    case IconKind::skill:
      return (icon.id == icon.skill ? icon.id : icon.id + "\n" + icon.skill) + runs(icon);
    case IconKind::sub_operation:
      return icon.id + runs(icon);
  }
  return {};
}

const char* look(IconKind kind) {
  switch (kind) {
    case IconKind::start:
    case IconKind::exit:
    case IconKind::restart:
      return "shape=box style=\"rounded,filled\" fillcolor=\"#e0e0e0\"";
    case IconKind::branch:
      return "shape=diamond style=filled fillcolor=\"#fff2cc\"";
    case IconKind::merge:
      return "shape=circle width=0.2 fixedsize=true style=filled fillcolor=\"#404040\"";
    case IconKind::delay:
    case IconKind::wait:
      return "shape=box style=dashed";
    case IconKind::zero:
      return "shape=box style=dashed";
    case IconKind::planned:
      return "shape=box style=\"dashed,filled\" fillcolor=\"#ead1dc\"";
    case IconKind::question:
      return "shape=hexagon style=filled fillcolor=\"#ead1dc\"";
    case IconKind::test:
      return "shape=hexagon style=filled fillcolor=\"#fce5cd\"";
    case IconKind::sub_operation:
      return "shape=box3d style=filled fillcolor=\"#d9ead3\"";
    case IconKind::skill:
      break;
  }
  return "shape=box style=filled fillcolor=\"#dae8fc\"";
}

std::string newlines(std::string text) {
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2)
    text.replace(at, 1, "\\n");
  return text;
}

}  // namespace

std::string to_dot(const Program& program, std::size_t operation, const Happened* run) {
  const Operation& shown = program.operations[operation];
  std::string out =
      "digraph operation {\n  rankdir=LR\n  node [fontname=\"Liberation Sans\" fontsize=11]\n"
      "  edge [fontname=\"Liberation Sans\" fontsize=9]\n";
  const auto line = [&](const Icon& from, const Connection& to, const std::string& text, bool dashed) {
    if (!to.connected()) return;
    out += fmt::format("  {} -> {} [label={}{}]\n", in_quotes(from.id), in_quotes(to.icon), in_quotes(text),
                       dashed ? " style=dashed" : "");
  };
  for (std::size_t i = 0; i < shown.icons.size(); ++i) {
    const Icon& icon = shown.icons[i];
    std::string text = label(icon), more;
    if (run != nullptr && (has_completions(icon.kind) || icon.kind == IconKind::delay)) {
      const std::size_t count = run->count({operation, i});
      if (icon.kind != IconKind::sub_operation && count > 0) text += fmt::format("\n{}×", count);
      more = count > 0 ? " penwidth=2.5" : " color=\"#999999\" fontcolor=\"#999999\"";
    }
    out += fmt::format("  {} [label={} {}{}]\n", in_quotes(icon.id), newlines(in_quotes(text)),
                       look(icon.kind), more);
  }
  for (const Icon& icon : shown.icons) {
    line(icon, icon.next, "", false);
    for (const Way& way : icon.ways)
      line(icon, way.to, way.text.empty() ? fmt::format("{}", fmt::join(way.codes, ", ")) : way.text, false);
    line(icon, icon.otherwise, "else", false);
    line(icon, icon.error, "error", true);
  }
  return out + "}\n";
}

}  // namespace pal::operations
