#include "programs/workcell/session/person.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <optional>

#include "programs/workcell/session/failure.hpp"

namespace pal::workcell {
namespace {

// About as long as the cell's time goes on between two looks, so that a time limit is one for people.
constexpr int look_milliseconds = 10;

/// Whether a line can be read without a wait for a person.
bool has_line(std::istream& in) {
  if (&in != &std::cin || in.rdbuf()->in_avail() > 0) return true;
  pollfd input{STDIN_FILENO, POLLIN, 0};
  return ::poll(&input, 1, look_milliseconds) != 0;
}

/// By its number, from 1, or its text.
std::optional<std::size_t> choice_of(const std::string& line, const std::vector<std::string>& answers) {
  for (std::size_t i = 0; i < answers.size(); ++i)
    if (line == answers[i] || line == std::to_string(i + 1)) return i;
  return std::nullopt;
}

}  // namespace

PersonAtTerminal::PersonAtTerminal(const std::vector<std::string>& prepared, std::istream* in,
                                   std::ostream& out)
    : in_(in), out_(out) {
  for (const std::string& text : prepared) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
      throw Failure(ExitStatus::usage, "--answer " + text, "this names no icon and its answer",
                    "write ICON=ANSWER");
    prepared_.push_back({text.substr(0, equals), text.substr(equals + 1)});
  }
}

void PersonAtTerminal::ask(const operations::Question& question) {
  question_ = question;
  out_ << fmt::format("{}: {}\n", question.icon, question.text);
  for (std::size_t i = 0; i < question.answers.size(); ++i)
    out_ << fmt::format("  {}  {}\n", i + 1, question.answers[i]);
  out_ << std::flush;
}

operations::Reply PersonAtTerminal::answer() {
  for (Prepared& each : prepared_) {
    if (each.used || each.icon != question_.icon) continue;
    each.used = true;
    if (const auto choice = choice_of(each.answer, question_.answers)) return {choice, {}, false};
    return {{}, fmt::format("'{}' is none of the answers to '{}'", each.answer, question_.icon), false};
  }
  if (in_ == nullptr) return {{}, "there is nobody to ask", false};
  if (!has_line(*in_)) return {};
  std::string line;
  if (!std::getline(*in_, line)) return {{}, "there is nobody to ask: the input has ended", false};
  if (const auto choice = choice_of(line, question_.answers)) return {choice, {}, false};
  out_ << fmt::format("write a number from 1 to {}, or the answer\n", question_.answers.size()) << std::flush;
  return {};
}

}  // namespace pal::workcell
