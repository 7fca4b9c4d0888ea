// What is known of a name or a statement, in Markdown.
#include <algorithm>
#include <set>
#include <utility>

#include "language_server/session.hpp"
#include "pal/doc/facts.hpp"
#include "pal/explain/page.hpp"
#include "pal/pan/dump.hpp"
#include "pal/pan/threads.hpp"

namespace pal::language_server {

namespace {

using check::Symbol;
using check::SymbolKind;

std::string fenced(std::string_view text) {
  return "```pal\n" + std::string(text) + "\n```\n";
}

std::string code(const std::string& text) {
  return "`" + text + "`";
}

/// "SM1 line 12": a place in the text of an analysis.
std::string line_of(const Analysis& analysis, const SourceSpan& where) {
  return where.valid() ? "line " + std::to_string(analysis.sources.line_column(where.file, where.begin).line)
                       : "";
}

template <class Thing>
std::optional<std::size_t> index_of(const std::vector<Thing>& things, const std::string& name) {
  for (std::size_t i = 0; i < things.size(); ++i) {
    if (things[i].name == name) return i;
  }
  return std::nullopt;
}

class Teller {
 public:
  Teller(const Analysis& analysis, std::size_t skill)
      : analysis_(analysis),
        network_(analysis.specification.skills[skill]),
        environment_(analysis.environment(skill)) {}

  std::string about(const Symbol& symbol) const {
    switch (symbol.kind) {
      case SymbolKind::message:
        return message(symbol.name);
      case SymbolKind::condition:
        return condition(symbol.name);
      case SymbolKind::module:
        return module(symbol.name);
      case SymbolKind::device:
        return behaviour(symbol.name);
      case SymbolKind::activity:
        return activity(symbol.name, symbol.owner);
      default:
        return {};
    }
  }

  /// Of the statement at a place: who is at the other end.
  std::string statement(FileId file, std::uint32_t offset) const {
    for (std::size_t m = 0; m < network_.modules.size(); ++m) {
      for (const auto& node : network_.modules[m].body.nodes) {
        if (node.where.file != file || offset < node.where.begin || offset > node.where.end) continue;
        if (const auto* wait = std::get_if<pan::Wait>(&node.content)) {
          std::string text;
          for (const auto channel : wait->channels) text += ends(channel, true);
          return text;
        }
        if (const auto* send = std::get_if<pan::Send>(&node.content)) return ends(send->channel, false);
      }
    }
    return {};
  }

 private:
  const std::string& party(const pan::Party& party) const { return pan::party_name(network_, party); }

  /// The statements at the other end of a channel.
  std::string ends(pan::ChannelId id, bool senders) const {
    const auto& channel = network_.channels[id.index()];
    const std::string who = code(party(senders ? channel.sender : channel.receiver));
    std::string text = code(network_.messages[channel.message.index()].name) +
                       (senders ? " is sent by " : " is taken by ") + who;
    std::string places;
    for (std::size_t m = 0; m < network_.modules.size(); ++m) {
      const auto& nodes = network_.modules[m].body.nodes;
      for (std::size_t n = 0; n < nodes.size(); ++n) {
        const auto* send = std::get_if<pan::Send>(&nodes[n].content);
        const auto* wait = std::get_if<pan::Wait>(&nodes[n].content);
        const bool is_end =
            senders ? send != nullptr && send->channel == id
                    : wait != nullptr &&
                          std::find(wait->channels.begin(), wait->channels.end(), id) != wait->channels.end();
        if (is_end)
          places += "\n- " + code(pan::statement_text(network_, pan::ModuleId(m), pan::NodeId(n))) + ", " +
                    line_of(analysis_, nodes[n].where);
      }
    }
    return text + (places.empty() ? "" : ":" + places) + "\n\n";
  }

  /// The words of `pal doc`, each fact in a line.
  static std::string lines(const std::vector<doc::Fact>& facts) {
    std::string text;
    for (const auto& fact : facts) {
      const std::string line = doc::markdown(fact.line);
      if (!line.empty()) text += "\n- " + fact.head + ": " + line;
    }
    return text.empty() ? text : text + "\n\n";
  }

  std::string message(const std::string& name) const {
    const auto index = index_of(network_.messages, name);
    if (!index) return {};
    auto facts = doc::facts_of(network_, pan::MessageId(*index));
    for (std::size_t i = 0; i < network_.messages.size(); ++i) {
      if (network_.messages[i].asks_for == pan::MessageId(*index))
        facts.push_back({"Requests", doc::facts_of(network_, pan::MessageId(i)).back().line});
    }
    return lines(facts);
  }

  std::string condition(const std::string& name) const {
    const auto index = index_of(network_.conditions, name);
    return index ? lines(doc::facts_of(network_, pan::ConditionId(*index))) : std::string();
  }

  std::string module(const std::string& name) const {
    const auto index = index_of(network_.modules, name);
    if (!index) return {};
    const auto& module = network_.modules[*index];
    std::string text = pan::kind_text(module.kind) + " " +
                       doc::markdown(doc::line_of(network_, pan::ModuleId(*index))) + "\n\n";
    for (std::size_t i = 0; environment_ != nullptr && i < module.threads.size(); ++i) {
      const auto* place = pan::place_of(*environment_, module.threads[i]);
      if (place != nullptr)
        text += "- " + code(module.threads[i]) + " on " + code(place->processor) + ", priority " +
                std::to_string(place->priority) + ", in " + environment_->name + "\n";
    }
    return text + behaviour(name);
  }

  std::string behaviour(const std::string& device) const {
    for (std::size_t i = 0; environment_ != nullptr && i < environment_->devices.size(); ++i) {
      if (environment_->devices[i].device == device)
        return "In " + environment_->name + ":\n" +
               fenced(analysis_.sources.text(environment_->devices[i].where));
    }
    return {};
  }

  std::string activity(const std::string& name, const std::string& owner) const {
    std::string text;
    for (std::size_t i = 0; i < network_.activities.size(); ++i) {
      const auto& activity = network_.activities[i];
      if (activity.name == name && network_.modules[activity.module.index()].name == owner)
        text += lines(doc::facts_of(network_, pan::ActivityId(i)));
    }
    const pan::ActivityTime* found = nullptr;
    for (std::size_t i = 0; environment_ != nullptr && i < environment_->activities.size(); ++i) {
      const auto& time = environment_->activities[i];
      if (time.activity == name && (time.module == owner || (time.module.empty() && found == nullptr)))
        found = &time;
    }
    if (found != nullptr)
      text += "In " + environment_->name + ":\n" + fenced(analysis_.sources.text(found->where));
    return text;
  }

  const Analysis& analysis_;
  const pan::Network& network_;
  const pan::Environment* environment_;
};

/// A declaration as it is written; of a long one its first line.
std::string declaration(const Text& text, const Symbol& symbol) {
  const bool whole = symbol.kind != SymbolKind::module && symbol.kind != SymbolKind::skill &&
                     symbol.kind != SymbolKind::environment;
  const auto& where = symbol.where.valid() ? symbol.where : symbol.name_where;
  const auto end = std::min<std::size_t>(where.end, text.content().size());
  if (where.begin > end) return symbol.name;
  auto written = std::string_view(text.content()).substr(where.begin, end - where.begin);
  if (!whole) written = written.substr(0, written.find_first_of("\r\n"));
  return std::string(written);
}

}  // namespace

std::string Session::about(const Symbol& symbol, const Family& family) {
  const auto& path = index_.path(symbol.name_where.file);
  const auto text = workspace_.text(path);
  std::string result = text == nullptr ? symbol.name : fenced(declaration(*text, symbol));
  std::set<std::string> told;
  for (const auto& root : roots_of(path)) {
    if (std::find(family.files.begin(), family.files.end(), root) == family.files.end()) continue;
    const auto sound = known(root).sound;
    if (sound == nullptr) continue;
    for (std::size_t skill = 0; skill < sound->specification.skills.size(); ++skill) {
      const std::string more = Teller(*sound, skill).about(symbol);
      if (more.find_first_not_of("\n") == std::string::npos || !told.insert(more).second) continue;
      if (told.size() > 3) continue;  // a module that a dozen skills use
      result += "\n**" + sound->specification.skills[skill].skill.name + "**: " + more;
    }
    const auto proofs = known(root).proofs;
    for (std::size_t i = 0; symbol.kind == SymbolKind::requirement && proofs != nullptr && i < proofs->size();
         ++i) {
      const auto& proof = (*proofs)[i];
      for (const auto& each : proof.requirements) {
        if (proof.skill != symbol.owner || each.name != symbol.name) continue;
        result += "\n" + each.measure + " in " + proof.environment + ": **" + each.state + "**, " +
                  each.bound + " of " + each.limit + (each.exact ? ", exact" : "") + "\n\n" +
                  each.explanation + "\n";
        for (const auto& finding : each.findings) {
          for (const auto& note : finding.notes) result += "- " + note.text + "\n";
        }
      }
    }
  }
  return result;
}

/// Editors show a finding themselves; this is what `pal explain` says of its kind.
std::string Session::pages_at(const Place& place) {
  std::string text;
  std::set<Code> told;
  for (const auto& root : roots_of(place.path)) {
    const Known& here = known(root);
    const auto file = here.analysis->file(place.path);
    for (const auto& finding : findings(here, place.path)) {
      const auto& where = finding.where;
      if (!file || where.file != *file || place.offset < where.begin || where.end < place.offset) continue;
      if (!told.insert(finding.code).second) continue;
      text += (text.empty() ? "" : "\n\n") + code(std::string(name(finding.code))) + " **" +
              std::string(title(finding.code)) + "**\n\n" + explain::explain(finding.code).summary + "\n";
    }
  }
  return text;
}

Json Session::hover(const Json& params) {
  const auto place = place_in(params);
  if (is_operation(place.path)) return operation_hover(place);
  std::shared_ptr<const Family> family;
  const auto symbols = symbols_at(place, family);
  std::string text;
  Json range;
  if (!symbols.empty()) {
    const auto* use = family->symbols.at(index_.id(place.path), place.offset).front();
    range = range_of(*place.text, use->where.begin, use->where.end);
    std::set<std::string> told;
    for (const std::size_t symbol : symbols) {
      const std::string more = about(family->symbols.all[symbol], *family);
      if (told.size() < 3 && told.insert(more).second) text += (text.empty() ? "" : "\n---\n") + more;
    }
  } else {
    std::set<std::string> told;
    for (const auto& root : roots_of(place.path)) {
      const auto sound = known(root).sound;
      // Places of an earlier text are others.
      if (sound == nullptr || sound != known(root).analysis) continue;
      const auto file = sound->file(place.path);
      for (std::size_t skill = 0; file && skill < sound->specification.skills.size(); ++skill) {
        const std::string more = Teller(*sound, skill).statement(*file, place.offset);
        if (!more.empty() && told.insert(more).second)
          text += "**" + sound->specification.skills[skill].skill.name + "**: " + more;
      }
    }
  }
  const std::string pages = pages_at(place);
  if (!pages.empty()) text += (text.empty() ? "" : "\n---\n") + pages;
  if (text.empty()) return nullptr;
  Json result{{"contents", {{"kind", "markdown"}, {"value", text}}}};
  if (!range.is_null()) result["range"] = range;
  return result;
}

}  // namespace pal::language_server
