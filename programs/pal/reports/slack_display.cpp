#include "programs/pal/reports/slack_display.hpp"

#include <ostream>
#include <vector>

namespace pal::program {
namespace {

constexpr std::size_t bar_width = 30;

std::vector<std::string> names(const pan::Network& skill, const pan::Environment& environment) {
  std::vector<std::string> all;
  for (const analyzer::whatif::Figure& figure : analyzer::whatif::figures(skill, environment))
    all.push_back(figure.name);
  return all;
}

}  // namespace

SlackDisplay::SlackDisplay(const pan::Network& skill, const pan::Environment& environment,
                           WhatIfAnswer& answer, std::ostream& out)
    : answer_(answer), out_(out), table_(names(skill, environment)) {
  out_ << answer.skill << " in " << answer.environment << "\n" << table_.heading() << std::flush;
}

analyzer::whatif::SlackObserver SlackDisplay::observer() {
  return {[this](const analyzer::whatif::Slack& slack) { show(slack); },
          [this](std::size_t settled, std::size_t all) { draw_bar(settled, all); }};
}

void SlackDisplay::show(const analyzer::whatif::Slack& slack) {
  erase_bar();
  shown_.insert(slack.figure);
  out_ << table_.row(answer_, slack) << std::flush;
}

void SlackDisplay::draw_bar(std::size_t settled, std::size_t all) {
  erase_bar();
  const std::size_t filled = all == 0 ? bar_width : bar_width * settled / all;
  out_ << "  [" << std::string(filled, '#') << std::string(bar_width - filled, '.') << "] " << settled
       << " of " << all << " figures known" << std::flush;
  bar_ = true;
}

void SlackDisplay::erase_bar() {
  if (bar_) out_ << "\r\x1b[K";
  bar_ = false;
}

void SlackDisplay::finish() {
  erase_bar();
  for (const analyzer::whatif::Slack& slack : answer_.slacks) {
    if (!shown_.contains(slack.figure)) show(slack);
  }
  answer_.slacks_shown = true;
}

}  // namespace pal::program
