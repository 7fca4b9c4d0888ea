// From ANTLR's parse tree to ours. Private to pal/syntax: shows ANTLR.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "PalParser.h"
#include "pal/support/diagnostic.hpp"
#include "pal/support/source.hpp"
#include "pal/syntax/tokens.hpp"
#include "pal/syntax/tree.hpp"

namespace pal::syntax {

/// Any part of the parse tree may be missing after a syntax error. So every function takes a null pointer.
/// For it the function gives an empty name, an invalid place, or nothing.
class Builder {
 public:
  using Parser = grammar::PalParser;

  Builder(const Tokens& tokens, Diagnostics& diagnostics) : tokens_(tokens), diagnostics_(diagnostics) {}

  Tree build(Parser::FileContext* file);

 private:
  struct TypeOf {
    pan::ScalarType type = pan::ScalarType::real;
    std::string unit;
    int size = 0;  // of an array; 0: a single value
  };

  // units: build_units.cpp
  std::optional<Unit> unit(Parser::UnitContext* context);
  Uses uses(Parser::UsesContext* context);
  MessageUnit message_unit(Parser::MessageUnitContext* context);
  ConditionUnit condition_unit(Parser::ConditionUnitContext* context);
  DeviceUnit device_unit(Parser::DeviceUnitContext* context);
  ModuleUnit module_unit(Parser::ModuleUnitContext* context);
  void add_heading(ModuleUnit& module, Parser::HeadingContext* context);
  void add_sensor_slot(SensorTemplate& sensor, Parser::HeadingContext* context);

  // statements: build_statements.cpp
  Statements statements(Parser::StatementsContext* context);
  std::optional<Statement> statement(Parser::StatementContext* context);
  Set set(Parser::SetContext* context);
  std::optional<Statement> wait(Parser::WaitContext* context);
  std::optional<Statement> send(Parser::SendContext* context);
  void report_no_else(SourceSpan wait, antlr4::tree::TerminalNode* end);
  Statement choose(Parser::ChooseContext* context);
  Statement repeat(Parser::RepeatContext* context);
  Statement concurrent(Parser::ConcurrentContext* context);
  Source source(Parser::SourceContext* context);
  Guard guard(Parser::GuardContext* context);
  Guard conjunction(Parser::ConjunctionContext* context);
  Guard factor(Parser::FactorContext* context);
  MessageName message(Parser::MessageContext* context);
  PartyName party(Parser::PartyContext* context);

  // skills: build_skill.cpp
  SkillUnit skill_unit(Parser::SkillUnitContext* context);
  void add_slot(SkillUnit& skill, Parser::SlotContext* context);
  Parameter parameter(Parser::ParameterSlotContext* context);
  std::optional<Completion> completion(Parser::CompletionSlotContext* context);

  // requirements: build_requirement.cpp
  std::optional<Requirement> requirement(Parser::RequirementSlotContext* context);
  std::optional<Requirement> measured(Requirement result, Parser::MeasureContext* measure);
  std::optional<Phase> phase(Parser::PhaseContext* context);
  std::optional<Requirement> passes(Requirement result, Parser::StepContext* at,
                                    Parser::DurationContext* least, Parser::DurationContext* most);
  Requirement::Loss loss(Parser::LossContext* context);
  Duration share(antlr4::tree::TerminalNode* number, antlr4::tree::TerminalNode* percent,
                 const std::string& subject, const std::string& example);
  Known known(Parser::KnownContext* context);
  std::optional<Step> step(Parser::StepContext* context);

  // environments: build_environment.cpp
  EnvironmentUnit environment_unit(Parser::EnvironmentUnitContext* context);
  bool add_resource(Resources& resources, Parser::ItemContext* context);
  void add_item(EnvironmentUnit& environment, Parser::ItemContext* context);
  void add_names(std::vector<ItemName>& names, Parser::ItemContext* context) const;
  std::string thread(Parser::ThreadContext* context);
  template <typename Behaviour>
  void add_device(EnvironmentUnit& environment, const std::string& name, SourceSpan where,
                  const Behaviour& behaviour);
  pan::EventDevice event_device(Parser::EventDeviceContext* context);
  pan::FrameDevice frame_device(Parser::FrameDeviceContext* context);

  // words and figures: build_words.cpp
  SourceSpan span(antlr4::ParserRuleContext* context) const;
  SourceSpan span(antlr4::tree::TerminalNode* node) const;
  SourceSpan span(antlr4::tree::TerminalNode* first, antlr4::tree::TerminalNode* last) const;
  SourceSpan span(SourceSpan first, SourceSpan last) const;
  Name name(antlr4::ParserRuleContext* context) const;
  std::vector<Name> names(const std::vector<Parser::NameContext*>& contexts) const;
  std::vector<Name> names(Parser::NamesContext* context) const;
  std::string text(antlr4::tree::TerminalNode* string);
  std::vector<std::string> texts(Parser::StringsContext* context);
  std::optional<int> integer(antlr4::tree::TerminalNode* number);
  std::optional<double> real(antlr4::tree::TerminalNode* number);
  std::optional<Literal> literal(Parser::LiteralContext* context);
  Duration duration(Parser::DurationContext* context);
  Duration duration(antlr4::tree::TerminalNode* number, antlr4::tree::TerminalNode* unit);
  Interval interval(Parser::IntervalContext* context);
  std::string unit(Parser::PhysicalUnitContext* context);
  int size(Parser::SizeContext* context);
  TypeOf type(Parser::TypeContext* context);
  std::optional<pan::ModuleKind> kind(Parser::KindContext* context) const;
  std::optional<pan::ModuleKind> kind(Parser::HeaderContext* context) const;

  const Tokens& tokens_;
  Diagnostics& diagnostics_;
};

}  // namespace pal::syntax
