#include "pal/check/network/requirements.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "pal/check/report.hpp"
#include "pal/pan/dump.hpp"
#include "pal/support/finding.hpp"
#include "pal/support/nearest.hpp"

namespace pal::check {

namespace {

constexpr std::size_t most_compared = 2000;  // statements that a misspelt one is held against

class RequirementBuilder {
 public:
  RequirementBuilder(Names& names, pan::Network& network, Diagnostics& diagnostics)
      : names_(names), network_(network), diagnostics_(diagnostics), bodies_known_(names.all_known()) {}

  void build(const syntax::Requirement& written) {
    auto measure = std::visit([&](const auto& m) { return build_measure(m); }, written.measure);
    std::optional<pan::Phase> phase;
    if (written.phase) {
      phase = build_phase(*written.phase);
      if (!phase || (measure && !fits(*written.phase, *measure))) return;
    }
    if (!measure) return;
    network_.requirements.push_back(
        {written.name.text, std::move(*measure), written.limit, std::move(phase), written.where});
  }

 private:
  std::optional<pan::Phase> build_phase(const syntax::Phase& written) {
    const std::vector<pan::StatementRef> named = statements(written.step);
    if (named.empty()) return std::nullopt;
    pan::Phase phase;
    phase.text = (written.kind == syntax::Phase::Kind::after ? "after " : "during the loop of ") +
                 text_of(written.step) + (written.step.in ? " in " + written.step.in->name.text : "");
    if (written.kind == syntax::Phase::Kind::after) {
      phase.after = named;
      return phase;
    }
    for (const pan::StatementRef& each : named) {
      const auto loop = loop_around(each);
      const auto same = [&loop](const pan::StatementRef& known) {
        return known.module == loop->module && known.node == loop->node;
      };
      if (loop && std::none_of(phase.during.begin(), phase.during.end(), same)) phase.during.push_back(*loop);
    }
    if (!phase.during.empty()) return phase;
    diagnostics_.report(Finding::statement_in_no_loop, written.step.where);
    return std::nullopt;
  }

  /// The REPEAT of the innermost loop around a statement. The nodes of a body stand in the order of the text.
  std::optional<pan::StatementRef> loop_around(const pan::StatementRef& statement) const {
    const pan::Graph& body = network_.modules[statement.module.index()].body;
    for (std::size_t n = statement.node.index(); n-- > 0;) {
      const pan::Node& node = body.nodes[n];
      if (std::holds_alternative<pan::Loop>(node.content) && node.mate.index() > statement.node.index())
        return pan::StatementRef{statement.module, pan::NodeId(n)};
    }
    return std::nullopt;
  }

  /// Whether what is measured can lie in such a part of a run; reports if not.
  bool fits(const syntax::Phase& phase, const pan::Measure& measure) {
    const bool load = std::holds_alternative<pan::Load>(measure);
    if (load || std::holds_alternative<pan::BusyPeriod>(measure)) {
      diagnostics_.report(Finding::measure_without_phase, phase.where, load ? "a load" : "a busy period");
      return false;
    }
    if (std::holds_alternative<pan::Completing>(measure) && phase.kind == syntax::Phase::Kind::during) {
      diagnostics_.report(Finding::duration_without_phase, phase.where);
      return false;
    }
    return true;
  }

  std::optional<pan::Measure> build_measure(const syntax::Requirement::Load& load) {
    return pan::Load{load.processor ? load.processor->text : std::string()};
  }

  std::optional<pan::Measure> build_measure(const syntax::Requirement::BusyPeriod& busy) {
    return pan::BusyPeriod{busy.processor ? busy.processor->text : std::string()};
  }

  std::optional<pan::Measure> build_measure(const syntax::Requirement::Age& age) {
    auto of = known(age.of);
    auto at = statements(age.at);
    if (!of || at.empty()) return std::nullopt;
    return pan::Age{std::move(*of), std::move(at)};
  }

  std::optional<pan::Measure> build_measure(const syntax::Requirement::Reaction& reaction) {
    auto of = known(reaction.of);
    auto at = statements(reaction.at);
    if (!of || at.empty()) return std::nullopt;
    return pan::Reaction{std::move(*of), std::move(at)};
  }

  std::optional<pan::Measure> build_measure(const syntax::Requirement::Passes& passes) {
    auto at = statements(passes.at);
    if (at.empty()) return std::nullopt;
    return pan::Passes{std::move(at), passes.least, passes.most};
  }

  std::optional<pan::Measure> build_measure(const syntax::Requirement::Loss& loss) {
    const auto of = names_.party(loss.of);
    if (!of) return std::nullopt;
    if (!is_device(*of)) {
      diagnostics_.report(Finding::loss_of_no_device, loss.of.name.where, loss.of.name.text);
      return std::nullopt;
    }
    return pan::Loss{*of, loss.most, loss.in};
  }

  std::optional<pan::Measure> build_measure(const syntax::Requirement::Completing& completing) {
    const auto& listed = network_.skill.completions;
    if (std::none_of(listed.begin(), listed.end(),
                     [&](const pan::Completion& each) { return each.code == completing.code; })) {
      diagnostics_.report(Finding::no_such_completion, completing.where, completing.code);
      return std::nullopt;
    }
    return pan::Completing{completing.code};
  }

  bool is_device(const pan::Party& party) const {
    const auto* module = std::get_if<pan::ModuleId>(&party);
    return module == nullptr || network_.modules[module->index()].body.empty();
  }

  std::optional<pan::Known> known(const syntax::Known& written) {
    if (const auto* name = std::get_if<syntax::Name>(&written.of)) {
      const auto condition = names_.condition(*name);
      if (!condition) return std::nullopt;
      return *condition;
    }
    const auto& sample = std::get<syntax::Known::Sample>(written.of);
    const auto message = names_.message(sample.message);
    const auto sender = names_.party(sample.from);
    if (!message || !sender) return std::nullopt;
    std::vector<pan::ChannelId> channels = channels_of(*message, *sender);
    const std::string& from = sample.from.name.text;
    if (!is_device(*sender)) {
      diagnostics_.report(Finding::sample_from_no_device, sample.from.name.where, from);
      return std::nullopt;
    }
    if (channels.empty()) {
      diagnostics_.report(Finding::nothing_waits_for_sample, sample.message.where,
                          network_.messages[message->index()].name, from);
      return std::nullopt;
    }
    return channels;
  }

  std::optional<pan::Measure> build_measure(const syntax::Requirement::Response& response) {
    const auto message = names_.message(response.event);
    const auto sender = names_.party(response.of);
    auto at = statements(response.to);
    if (!message || !sender) return std::nullopt;
    std::vector<pan::ChannelId> of = channels_of(*message, *sender);
    if (of.empty()) {
      diagnostics_.report(Finding::nothing_waits_for_start, response.event.where,
                          network_.messages[message->index()].name, response.of.name.text);
      return std::nullopt;
    }
    if (at.empty()) return std::nullopt;
    return pan::Response{std::move(of), std::move(at)};
  }

  /// On which the party sends this message.
  std::vector<pan::ChannelId> channels_of(pan::MessageId message, const pan::Party& sender) const {
    std::vector<pan::ChannelId> channels;
    for (std::size_t c = 0; c < network_.channels.size(); ++c) {
      const pan::Channel& channel = network_.channels[c];
      if (channel.sender == sender && channel.message == message) channels.push_back(pan::ChannelId(c));
    }
    return channels;
  }

  /// All statements that the pattern means; reports if there are none.
  std::vector<pan::StatementRef> statements(const syntax::Step& step) {
    std::optional<pan::ModuleId> only;
    if (step.in) {
      only = names_.callee(*step.in);
      if (!only) return {};
    }
    const auto matches = matcher(step);
    if (!matches) return {};
    std::vector<pan::StatementRef> result;
    for (std::size_t m = 0; m < network_.modules.size(); ++m) {
      const pan::ModuleId module(m);
      if (only && *only != module) continue;
      const auto& nodes = network_.modules[m].body.nodes;
      for (std::size_t n = 0; n < nodes.size(); ++n) {
        if (matches->is(nodes[n].content, network_)) result.push_back({module, pan::NodeId(n)});
      }
    }
    // A statement with an unknown name in it is left out of its module: its own finding says so.
    if (result.empty() && bodies_known_) report_missing(step, only);
    return result;
  }

  void report_missing(const syntax::Step& step, std::optional<pan::ModuleId> only) {
    const auto meant = nearest(text_of(step), statements_of(only));
    auto& finding =
        only ? diagnostics_.report(Finding::no_such_statement_in_module, step.where, step.in->name.text)
             : diagnostics_.report(Finding::no_such_statement, step.where);
    finding.suggest(meant, "");
    if (meant && !step.in) finding.fix = {{step.where, *meant}};
  }

  /// In canonical spelling.
  static std::string text_of(const syntax::Step& step) {
    const std::string message = (step.message.request ? "request " : "") + step.message.name.text;
    const std::string& party = step.party.name.text;
    switch (step.kind) {
      case syntax::Step::Kind::wait:
        return "WTM( " + message + " from " + party + " )";
      case syntax::Step::Kind::send:
        return "TXM( " + message + (step.message.request ? " from " : " to ") + party + " )";
      case syntax::Step::Kind::set:
        return "SPC( " + step.name.text + (!step.value ? "" : *step.value ? " = TRUE" : " = FALSE") + " )";
      case syntax::Step::Kind::read:
        return "RPC( " + step.name.text + " )";
      case syntax::Step::Kind::perform:
        return step.name.text;
    }
    return {};
  }

  /// That a requirement could name, of one module or of all.
  std::vector<std::string> statements_of(std::optional<pan::ModuleId> only) const {
    std::vector<std::string> texts;
    if (!may_guess(diagnostics_, network_.modules.size())) return texts;
    for (std::size_t m = 0; m < network_.modules.size(); ++m) {
      if (only && only->index() != m) continue;
      const auto& nodes = network_.modules[m].body.nodes;
      for (std::size_t n = 0; n < nodes.size() && texts.size() < most_compared; ++n)
        texts.push_back(pan::statement_text(network_, pan::ModuleId(m), pan::NodeId(n)));
    }
    return texts;
  }

  struct Matcher {
    syntax::Step::Kind kind;
    std::optional<pan::MessageId> message;
    std::optional<pan::Party> party;
    std::optional<pan::ConditionId> condition;
    std::optional<bool> value;
    std::string name;

    bool is(const pan::Content& content, const pan::Network& network) const {
      switch (kind) {
        case syntax::Step::Kind::wait: {
          const auto* wait = std::get_if<pan::Wait>(&content);
          return wait != nullptr &&
                 std::any_of(wait->channels.begin(), wait->channels.end(), [&](pan::ChannelId id) {
                   const auto& channel = network.channels[id.index()];
                   return channel.message == *message && channel.sender == *party;
                 });
        }
        case syntax::Step::Kind::send: {
          const auto* send = std::get_if<pan::Send>(&content);
          if (send == nullptr) return false;
          const auto& channel = network.channels[send->channel.index()];
          return channel.message == *message && channel.receiver == *party;
        }
        case syntax::Step::Kind::set: {
          const auto* set = std::get_if<pan::Set>(&content);
          return set != nullptr && set->condition == *condition && (!value || set->value == value);
        }
        case syntax::Step::Kind::read: {
          const auto* read = std::get_if<pan::Read>(&content);
          return read != nullptr && read->condition == *condition;
        }
        case syntax::Step::Kind::perform: {
          const auto* perform = std::get_if<pan::Perform>(&content);
          return perform != nullptr && network.activities[perform->activity.index()].name == name;
        }
      }
      return false;
    }
  };

  std::optional<Matcher> matcher(const syntax::Step& step) {
    Matcher result{step.kind, {}, {}, {}, step.value, step.name.text};
    if (step.kind == syntax::Step::Kind::wait || step.kind == syntax::Step::Kind::send) {
      result.message = names_.message(step.message);
      result.party = names_.party(step.party);
      if (!result.message || !result.party) return std::nullopt;
    }
    if (step.kind == syntax::Step::Kind::set || step.kind == syntax::Step::Kind::read) {
      result.condition = names_.condition(step.name);
      if (!result.condition) return std::nullopt;
    }
    return result;
  }

  Names& names_;
  pan::Network& network_;
  Diagnostics& diagnostics_;
  bool bodies_known_;  // every name in the modules means something
};

}  // namespace

void build_requirements(const syntax::SkillUnit& skill, Names& names, pan::Network& network,
                        Diagnostics& diagnostics) {
  std::map<std::string, const syntax::Name*> seen;
  RequirementBuilder builder(names, network, diagnostics);
  for (const auto& requirement : skill.requirements) {
    const auto [first, fresh] = seen.emplace(requirement.name.text, &requirement.name);
    if (!fresh) report_twice(diagnostics, "requirement", requirement.name, *first->second);
    builder.build(requirement);
  }
}

}  // namespace pal::check
