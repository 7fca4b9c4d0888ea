// The text of a statement without what it has inside.
#include <cctype>

#include "pal/pan/dump.hpp"
#include "pal/support/duration_text.hpp"
#include "pal/syntax/print.hpp"

namespace pal::syntax {

namespace {

std::string joined(const Guard& guard, const char* word) {
  std::string result;
  for (const auto& term : guard.terms) {
    if (!result.empty()) result += word;
    const bool simple = term.kind == Guard::Kind::equals || term.kind == Guard::Kind::negation;
    result += simple ? spelling(term) : "( " + spelling(term) + " )";
  }
  return result;
}

std::string source_text(const Source& source) {
  return "( " + spelling(source.message) + " from " + spelling(source.from) + " )";
}

struct Head {
  std::string operator()(const WaitForStart&) const { return "WTM( Coordinator )"; }
  std::string operator()(const Wait& wait) const { return "WTM" + source_text(wait.source); }
  std::string operator()(const WaitBranches& wait) const {
    std::string text = "WTM";
    text += wait.first || wait.arms.empty() ? std::string(" FIRST") : source_text(wait.arms.front().source);
    return wait.within ? text + " WITHIN " + to_text(*wait.within) : text;
  }
  std::string operator()(const Send& send) const {
    return "TXM( " + spelling(send.message) + (send.message.request ? " from " : " to ") + spelling(send.to) +
           " )";
  }
  std::string operator()(const Complete& complete) const {
    return "TXM( Completion Protocol " + std::to_string(complete.code) + " )";
  }
  std::string operator()(const Set& set) const {
    return "SPC( " + set.condition.text + (!set.value ? "" : *set.value ? " = TRUE" : " = FALSE") + " )";
  }
  std::string operator()(const Read& read) const { return "RPC( " + read.condition.text + " )"; }
  std::string operator()(const Choose&) const { return "CASE"; }
  std::string operator()(const Repeat&) const { return "REPEAT"; }
  std::string operator()(const Concurrent&) const { return "CONCURRENT"; }
  std::string operator()(const Execute& execute) const { return "Execute " + spelling(execute.module); }
  std::string operator()(const Nothing&) const { return "Do Nothing"; }
  std::string operator()(const Perform& perform) const { return perform.name.text; }
};

}  // namespace

std::string head(const Statement& statement) {
  return std::visit(Head{}, statement.content);
}

std::string spelling(const MessageName& message) {
  return (message.request ? "request " : "") + message.name.text;
}

std::string spelling(const PartyName& party) {
  return (party.kind ? pan::kind_text(*party.kind) + " " : "") + party.name.text;
}

std::string spelling(const Guard& guard) {
  switch (guard.kind) {
    case Guard::Kind::equals:
      return guard.condition.text + (guard.value ? " = TRUE" : " = FALSE");
    case Guard::Kind::all_of:
      return joined(guard, " AND ");
    case Guard::Kind::any_of:
      return joined(guard, " OR ");
    case Guard::Kind::negation:
      return "NOT ( " + spelling(guard.terms.front()) + " )";
  }
  return {};
}

std::string title(pan::ModuleKind kind) {
  auto words = pan::kind_text(kind);
  bool begins = true;
  for (auto& c : words) {
    if (begins) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    begins = c == ' ';
  }
  return words;
}

}  // namespace pal::syntax
