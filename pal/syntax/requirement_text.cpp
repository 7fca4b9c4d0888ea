#include "pal/syntax/requirement_text.hpp"

#include <array>
#include <charconv>

#include "pal/support/duration_text.hpp"
#include "pal/syntax/print.hpp"

namespace pal::syntax {
namespace {

std::string number(double value) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return {digits.data(), end};
}

std::string text_of(const Step& step) {
  std::string text;
  switch (step.kind) {
    case Step::Kind::wait:
      text = "WTM( " + spelling(step.message) + " from " + spelling(step.party) + " )";
      break;
    case Step::Kind::send:
      text = "TXM( " + spelling(step.message) + (step.message.request ? " from " : " to ") +
             spelling(step.party) + " )";
      break;
    case Step::Kind::set:
      text = "SPC( " + step.name.text + (!step.value ? "" : *step.value ? " = TRUE" : " = FALSE") + " )";
      break;
    case Step::Kind::read:
      text = "RPC( " + step.name.text + " )";
      break;
    case Step::Kind::perform:
      text = step.name.text;
      break;
  }
  return step.in ? text + " IN " + spelling(*step.in) : text;
}

std::string text_of(const Known& known) {
  if (const auto* condition = std::get_if<Name>(&known.of)) return condition->text;
  const auto& sample = std::get<Known::Sample>(known.of);
  return spelling(sample.message) + " FROM " + spelling(sample.from);
}

std::string text_of(const std::optional<Phase>& phase) {
  if (!phase) return {};
  return (phase->kind == Phase::Kind::after ? " AFTER " : " DURING REPEAT OF ") + text_of(phase->step);
}

/// A measure with its limit.
struct MeasureText {
  Duration limit;

  std::string operator()(const Requirement::Response& response) const {
    return "RESPONSE FROM " + spelling(response.event) + " OF " + spelling(response.of) + " TO " +
           text_of(response.to) + " AT MOST " + to_text(limit);
  }
  std::string operator()(const Requirement::Age& age) const {
    return "AGE OF " + text_of(age.of) + " AT " + text_of(age.at) + " AT MOST " + to_text(limit);
  }
  std::string operator()(const Requirement::Reaction& reaction) const {
    return "REACTION OF " + text_of(reaction.of) + " AT " + text_of(reaction.at) + " AT MOST " +
           to_text(limit);
  }
  std::string operator()(const Requirement::Passes& passes) const {
    const std::string text = "INTERVAL OF " + text_of(passes.at);
    if (!passes.least) return text + " AT MOST " + to_text(*passes.most);
    if (!passes.most) return text + " AT LEAST " + to_text(*passes.least);
    return text + " BETWEEN " + to_text(*passes.least) + " AND " + to_text(*passes.most);
  }
  std::string operator()(const Requirement::Loss& loss) const {
    const std::string text = "LOSS OF " + spelling(loss.of);
    if (loss.in == 1) return text + " NONE";
    const std::string most = loss.share ? percentage(*loss.share) : std::to_string(loss.most);
    return text + " AT MOST " + most + " IN " + std::to_string(loss.in);
  }
  std::string operator()(const Requirement::Completing& completing) const {
    return "DURATION TO COMPLETION " + std::to_string(completing.code) + " AT MOST " + to_text(limit);
  }
  std::string operator()(const Requirement::Load& load) const {
    return "LOAD OF " + (load.processor ? load.processor->text : "EACH PROCESSOR") + " AT MOST " +
           percentage(limit);
  }
  static std::string percentage(Duration share) {
    constexpr double nanoseconds_per_percent = 1e7;
    return number(static_cast<double>(share.count()) / nanoseconds_per_percent) + " %";
  }
  std::string operator()(const Requirement::BusyPeriod& busy) const {
    return "BUSY PERIOD OF " + (busy.processor ? busy.processor->text : "EACH PROCESSOR") + " AT MOST " +
           to_text(limit);
  }
};

}  // namespace

std::string requirement_text(const Requirement& requirement) {
  return "REQUIREMENT " + requirement.name.text + " : " +
         std::visit(MeasureText{requirement.limit}, requirement.measure) + text_of(requirement.phase);
}

}  // namespace pal::syntax
