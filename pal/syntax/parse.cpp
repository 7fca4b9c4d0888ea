#include "pal/syntax/parse.hpp"

#include <algorithm>
#include <memory>
#include <string_view>

#include "PalParser.h"
#include "pal/syntax/build.hpp"
#include "pal/syntax/recovery.hpp"
#include "pal/syntax/repair.hpp"
#include "pal/syntax/tokens.hpp"

namespace pal::syntax {

namespace {

using Parser = grammar::PalParser;
using Simulator = antlr4::atn::ParserATNSimulator;

/// The quick way: nearly every text that is right is told so with SLL prediction, and without recovery.
Parser::FileContext* parse_quickly(Parser& parser) {
  parser.getInterpreter<Simulator>()->setPredictionMode(antlr4::atn::PredictionMode::SLL);
  parser.setErrorHandler(std::make_shared<antlr4::BailErrorStrategy>());
  try {
    return parser.file();
  } catch (const antlr4::ParseCancellationException&) {
    return nullptr;
  }
}

/// Reports and mends one mistake after the other, as long as they can be mended. How many there were.
std::size_t mend(Tokens& tokens, Diagnostics& diagnostics) {
  for (std::size_t reported = 0;; ++reported) {
    const auto mistake = first_mistake(tokens);
    if (!mistake || reported == most_reports) return reported;
    const auto change = repair_of(*mistake, tokens);
    if (!change) return reported;
    auto told = told_by(*change, *mistake, tokens);
    auto& finding = diagnostics.report(told.code, told.where, std::move(told.message), std::move(told.hint));
    finding.notes = std::move(told.notes);
    finding.fix = std::move(told.fix);
    tokens.apply(*change);
  }
}

Parser::FileContext* parse_carefully(Parser& parser, const Tokens& tokens, std::size_t reported,
                                     Diagnostics& diagnostics) {
  parser.getInterpreter<Simulator>()->setPredictionMode(antlr4::atn::PredictionMode::LL);
  parser.setErrorHandler(std::make_shared<Recovery>(tokens, diagnostics, reported));
  return parser.file();
}

/// The whole line on which `place` begins.
SourceSpan line_of(const SourceManager& sources, SourceSpan place) {
  const auto text = sources.text(place.file);
  const auto end = std::min(text.find('\n', place.begin), text.size());
  const auto before = place.begin == 0 ? std::string_view::npos : text.rfind('\n', place.begin - 1);
  const auto begin = before == std::string_view::npos ? 0 : before + 1;
  return {place.file, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
}

}  // namespace

Tree parse(const SourceManager& sources, FileId file, Diagnostics& diagnostics) {
  const auto errors_before = diagnostics.errors();
  const auto findings_before = diagnostics.all().size();
  Tokens tokens(file, sources.text(file), diagnostics);
  Tree nothing;
  nothing.file = file;
  nothing.complete = false;
  if (!tokens.parseable()) return nothing;

  auto parser = std::make_unique<Parser>(&tokens.stream());
  parser->removeErrorListeners();  // the strategies report for themselves
  auto* root = parse_quickly(*parser);
  if (root == nullptr) {
    const auto reported = mend(tokens, diagnostics);
    tokens.stream().seek(0);
    parser = std::make_unique<Parser>(&tokens.stream());
    parser->removeErrorListeners();
    root = parse_carefully(*parser, tokens, reported, diagnostics);
  }
  const bool complete = diagnostics.errors() == errors_before;
  for (auto i = findings_before; i < diagnostics.all().size(); ++i) {
    diagnostics.distrust(line_of(sources, diagnostics.all()[i].where));
  }
  auto tree = Builder(tokens, diagnostics).build(root);
  tree.complete = complete;
  return tree;
}

}  // namespace pal::syntax
