// The flow of messages: what may stand in a TXM or a WTM, and who sends what to whom as a hierarchy of calls.
#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "language_server/session.hpp"
#include "language_server/text.hpp"
#include "pal/pan/dump.hpp"
#include "pal/syntax/text_tokens.hpp"

namespace pal::language_server {

namespace {

using check::SymbolKind;
using syntax::TextToken;

/// A TXM or WTM whose parenthesis is open at the end of a line's beginning.
struct OpenStatement {
  bool sends = false;
  bool request = false;
  std::string message;          // as far as it is written
  bool behind_message = false;  // FROM or TO is there
};

std::optional<OpenStatement> open_statement(std::string_view before) {
  std::optional<OpenStatement> open;
  std::string last;
  for (const auto& token : syntax::text_tokens(before)) {
    const auto written = before.substr(token.begin, token.end - token.begin);
    const std::string word = capitals(written);
    if (token.kind == TextToken::Kind::comment) return std::nullopt;
    if (word == "(" && (last == "TXM" || last == "WTM")) {
      open = OpenStatement{last == "TXM", false, {}, false};
    } else if (word == ")") {
      open.reset();
    } else if (open && (word == "FROM" || word == "TO")) {
      open->behind_message = true;
    } else if (open && word == "REQUEST") {
      open->request = true;
    } else if (open && !open->behind_message) {
      open->message = written;
    }
    last = word;
  }
  return open;
}

/// What an item of the hierarchy stands for. Kept by the client, and given back.
struct Item {
  std::string root, kind, name;
};

Item item_of(const Json& params) {
  const Json& data = member(member(params, "item"), "data");
  return {string_of(data, "root"), string_of(data, "kind"), string_of(data, "name")};
}

/// Every statement that sends or takes, with the channels that it does so on.
template <class Visit>
void visit_ends(const pan::Network& network, bool sends, const Visit& visit) {
  for (std::size_t m = 0; m < network.modules.size(); ++m) {
    for (const auto& node : network.modules[m].body.nodes) {
      if (const auto* send = std::get_if<pan::Send>(&node.content); send != nullptr && sends)
        visit(send->channel, node.where);
      if (const auto* wait = std::get_if<pan::Wait>(&node.content); wait != nullptr && !sends)
        for (const auto channel : wait->channels) visit(channel, node.where);
    }
  }
}

}  // namespace

Json Session::signature_help(const Json& params) {
  const auto place = place_in(params);
  const auto at = place.text->position(place.offset);
  const auto before = place.text->line(at.line).substr(0, place.offset - place.text->offset({at.line, 0}));
  const auto open = open_statement(before);
  if (!open) return nullptr;
  const auto family = index_.family(place.path);
  std::string text;
  for (const auto& symbol : family->symbols.all) {
    if (symbol.kind == SymbolKind::message && symbol.name == open->message && text.empty())
      text = about(symbol, *family);
  }
  const std::string message = (open->request ? "request " : "") + (text.empty() ? "message" : open->message);
  const bool from = !open->sends || open->request;
  const std::string label =
      std::string(open->sends ? "TXM" : "WTM") + "( " + message + (from ? " from" : " to") + " module )";
  const auto parameter = [&](const std::string& part, const std::string& words) {
    const auto begin = label.find(part, 3);
    return Json{{"label", {begin, begin + part.size()}}, {"documentation", words}};
  };
  Json signature{{"label", label},
                 {"parameters",
                  {parameter(message, "what is sent: a message, or `request` and a message"),
                   parameter("module", !open->sends ? "who sends it: a module or a device of the next layer"
                                       : from       ? "who is asked for it"
                                                    : "who takes it")}}};
  if (!text.empty()) signature["documentation"] = {{"kind", "markdown"}, {"value", text}};
  return {{"signatures", {std::move(signature)}},
          {"activeSignature", 0},
          {"activeParameter", open->behind_message ? 1 : 0}};
}

namespace {

/// The hierarchy of one network. Its places are those of the text as it is.
class Flow {
 public:
  Flow(const Analysis& analysis, const pan::Network& network, const Workspace& workspace)
      : analysis_(analysis), network_(network), workspace_(workspace) {}

  /// Of a module, a device or a message; null: the network has none of this name.
  Json item(const std::string& kind, const std::string& name) const {
    SourceSpan where;
    int symbol = 2;
    std::string detail = kind == "module" ? "" : kind;
    for (const auto& each : network_.modules) {
      if (kind == "module" && each.name == name) where = each.where, detail = pan::kind_text(each.kind);
    }
    for (const auto& each : network_.devices) {
      if (kind == "device" && each.name == name) where = each.where, symbol = 11;
    }
    for (const auto& each : network_.messages) {
      if (kind == "message" && each.name == name && each.where.valid()) where = each.where, symbol = 23;
    }
    if (!where.valid()) return nullptr;
    const Json range = range_of(analysis_.text(where.file), where.begin, where.end);
    return {{"name", name},
            {"kind", symbol},
            {"detail", detail + " of " + network_.skill.name},
            {"uri", workspace_.uri(analysis_.path(where.file))},
            {"range", range},
            {"selectionRange", range},
            {"data", {{"root", analysis_.root}, {"kind", kind}, {"name", name}}}};
  }

  /// Who sends to the item, or to whom it sends; of a message: who sends it, or who takes it. With the
  /// statements, which are the caller's, as the protocol wants it.
  Json calls(const Item& item, bool incoming) const {
    std::map<std::pair<std::string, std::string>, Json> ranges;  // by the other end
    const bool of_message = item.kind == "message";
    visit_ends(network_, incoming || !of_message, [&](pan::ChannelId id, const SourceSpan& where) {
      const auto& channel = network_.channels[id.index()];
      const auto& near = incoming ? channel.receiver : channel.sender;
      const auto& far = incoming ? channel.sender : channel.receiver;
      const bool meant = of_message ? network_.messages[channel.message.index()].name == item.name
                                    : pan::party_name(network_, near) == item.name;
      if (!meant || !where.valid()) return;
      ranges[{std::holds_alternative<pan::DeviceId>(far) ? "device" : "module",
              pan::party_name(network_, far)}]
          .push_back(range_of(analysis_.text(where.file), where.begin, where.end));
    });
    // A device sends without a statement: the waits for it show where.
    if (incoming) {
      visit_ends(network_, false, [&](pan::ChannelId id, const SourceSpan& where) {
        const auto& channel = network_.channels[id.index()];
        const bool meant = of_message ? network_.messages[channel.message.index()].name == item.name
                                      : pan::party_name(network_, channel.receiver) == item.name;
        if (!std::holds_alternative<pan::DeviceId>(channel.sender) || !where.valid() || !meant) return;
        ranges[{"device", pan::party_name(network_, channel.sender)}].push_back(
            range_of(analysis_.text(where.file), where.begin, where.end));
      });
    }
    Json result = Json::array();
    for (auto& [other, list] : ranges) {
      Json found = this->item(other.first, other.second);
      if (!found.is_null())
        result.push_back({{incoming ? "from" : "to", std::move(found)}, {"fromRanges", std::move(list)}});
    }
    return result;
  }

 private:
  const Analysis& analysis_;
  const pan::Network& network_;
  const Workspace& workspace_;
};

}  // namespace

Json Session::prepare_call_hierarchy(const Json& params) {
  const auto place = place_in(params);
  std::shared_ptr<const Family> family;
  std::vector<std::pair<std::string, std::string>> wanted;
  for (const std::size_t index : symbols_at(place, family)) {
    const auto& symbol = family->symbols.all[index];
    if (symbol.kind == SymbolKind::module || symbol.kind == SymbolKind::device ||
        symbol.kind == SymbolKind::message)
      wanted.emplace_back(check::name(symbol.kind), symbol.name);
  }
  if (wanted.empty()) {  // in a body: its module
    const auto* tree = index_.tree(place.path);
    for (std::size_t i = 0; tree != nullptr && i < tree->units.size(); ++i) {
      const auto* module = std::get_if<syntax::ModuleUnit>(&tree->units[i]);
      if (module != nullptr && module->whole.begin <= place.offset && place.offset <= module->whole.end)
        wanted.emplace_back("module", module->name.text);
    }
  }
  Json result = Json::array();
  for (const auto& root : roots_of(place.path)) {
    const auto analysis = known(root).analysis;
    for (const auto& network : analysis->specification.skills) {
      for (const auto& [kind, name] : wanted) {
        Json item = Flow(*analysis, network, workspace_).item(kind, name);
        if (!item.is_null() && result.size() < 5) result.push_back(std::move(item));
      }
    }
  }
  return result.empty() ? Json() : result;
}

Json Session::incoming_calls(const Json& params) {
  const Item item = item_of(params);
  Json result = Json::array();
  if (workspace_.text(item.root) == nullptr) return result;
  const auto analysis = known(item.root).analysis;
  for (const auto& network : analysis->specification.skills)
    for (auto& call : Flow(*analysis, network, workspace_).calls(item, true))
      result.push_back(std::move(call));
  return result;
}

Json Session::outgoing_calls(const Json& params) {
  const Item item = item_of(params);
  Json result = Json::array();
  if (workspace_.text(item.root) == nullptr) return result;
  const auto analysis = known(item.root).analysis;
  for (const auto& network : analysis->specification.skills)
    for (auto& call : Flow(*analysis, network, workspace_).calls(item, false))
      result.push_back(std::move(call));
  return result;
}

}  // namespace pal::language_server
