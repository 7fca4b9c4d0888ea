// Looks names up and gives them their places in a network.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "pal/check/network/scope.hpp"
#include "pal/pan/network.hpp"
#include "pal/support/diagnostic.hpp"
#include "pal/syntax/tree.hpp"

namespace pal::check {

/// The tables of one network while it is built. Everything is entered where it is first named.
class Names {
 public:
  /// `trusting`: for a sketch. Names that are not declared are entered as they come, and nothing is reported.
  Names(const Scope& scope, bool trusting, pan::Network& network, Diagnostics& diagnostics)
      : scope_(scope), trusting_(trusting), network_(network), diagnostics_(diagnostics) {}

  /// Enters the module of this name; reports it if it is not a module. `listed`: the template names it.
  std::optional<pan::ModuleId> module(const syntax::Name& name, bool listed);
  /// The declaration of this module; nullptr if its name is only trusted.
  const syntax::ModuleUnit* unit_of(pan::ModuleId module) const { return units_[module.index()]; }
  std::optional<pan::ModuleId> entered_module(const std::string& name) const;

  /// A module or device that a message goes to or comes from. Checks kind words, and that the template lists
  /// a module.
  /// `speaker`: the module that communicates with it, and cannot be meant itself; empty: unknown.
  std::optional<pan::Party> party(const syntax::PartyName& name, const std::string& speaker = {});
  /// A module to execute, likewise.
  std::optional<pan::ModuleId> callee(const syntax::PartyName& name);

  std::optional<pan::MessageId> message(const syntax::MessageName& name);
  std::optional<pan::MessageId> message(const syntax::Name& name) {
    return message({false, name, name.where});
  }
  std::optional<pan::ConditionId> condition(const syntax::Name& name);

  /// A bare name in a body of `module`: one of its activities. If it has none of this name: nothing, and no
  /// report.
  std::optional<pan::ActivityId> activity(const syntax::Name& name, pan::ModuleId module) const;
  /// In a sketch: a bare name that is nothing else.
  pan::ActivityId trusted_activity(const syntax::Name& name, pan::ModuleId module);
  void enter_activities(pan::ModuleId module);
  void report_no_activity(const syntax::Name& name, pan::ModuleId module);

  /// The channel for this message between these parties, entered at its first use.
  pan::ChannelId channel(const pan::Party& sender, pan::MessageId message, const pan::Party& receiver,
                         SourceSpan where);

  bool trusting() const { return trusting_; }
  /// Every name looked up so far meant something.
  bool all_known() const { return unknown_.empty(); }
  const std::string& name_of(pan::ModuleId module) const { return network_.modules[module.index()].name; }
  bool is_module(const std::string& name) const { return scope_.modules.find(name) != nullptr; }

 private:
  pan::ModuleId enter_module(const syntax::ModuleUnit& unit);
  pan::DeviceId enter_device(const syntax::Name& name, const syntax::DeviceUnit* unit);
  void check_kind(const syntax::PartyName& name, pan::ModuleId module);
  void check_listed(const syntax::Name& name, pan::ModuleId module);
  /// Reports an unknown name, once, however often it is used.
  void unknown(const PartialDiagnostic& what, const syntax::Name& name,
               const std::vector<std::string>& known);
  /// Where this name is declared, as whatever; nothing if it is not.
  std::optional<SourceSpan> declaration(const std::string& name) const;

  const Scope& scope_;
  bool trusting_;
  pan::Network& network_;
  Diagnostics& diagnostics_;
  std::vector<const syntax::ModuleUnit*> units_;  // by ModuleId
  std::map<std::string, pan::ModuleId> modules_;
  std::set<pan::ModuleId> listed_;
  std::set<std::pair<Code, std::string>> unknown_;
  std::map<std::string, pan::DeviceId> devices_;
  std::map<std::string, pan::MessageId> messages_;
  std::map<std::string, pan::ConditionId> conditions_;
  std::map<std::pair<pan::ModuleId, std::string>, pan::ActivityId> activities_;
  std::map<std::tuple<pan::Party, pan::MessageId, pan::Party>, pan::ChannelId> channels_;
};

}  // namespace pal::check
