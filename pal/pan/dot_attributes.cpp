#include "pal/pan/dot_attributes.hpp"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>
#include <variant>

#include "pal/pan/dump.hpp"
#include "pal/support/duration_text.hpp"

namespace pal::pan {

namespace {

using Activities = std::vector<std::size_t>;

Activities declared(const Network& network, ModuleId module) {
  Activities result;
  for (std::size_t i = 0; i < network.activities.size(); ++i) {
    if (network.activities[i].module == module) result.push_back(i);
  }
  return result;
}

Activities performed(const Network& network, ModuleId module) {
  Activities result;
  std::set<std::size_t> seen;
  for (const Node& node : network.modules[module.index()].body.nodes) {
    const auto* perform = std::get_if<Perform>(&node.content);
    if (perform != nullptr && seen.insert(perform->activity.index()).second)
      result.push_back(perform->activity.index());
  }
  return result;
}

/// "think READS force WRITES motion TIME 1 ms; look", as the heading of a module has them.
std::string headings(const Network& network, const Activities& activities) {
  std::string result;
  for (const std::size_t i : activities) {
    const Activity& activity = network.activities[i];
    result += (result.empty() ? "" : "; ") + activity.name;
    for (const auto& [word, list] :
         {std::pair(" READS ", &activity.reads), std::pair(" WRITES ", &activity.writes)}) {
      for (std::size_t k = 0; k < list->size(); ++k)
        result += (k == 0 ? word : ", ") + network.messages[(*list)[k].index()].name;
    }
    if (activity.time) result += " TIME " + to_text(*activity.time);
  }
  return result;
}

/// A text of a template as a part of a list: what DOT or the list would read as something else is %XX.
std::string encoded(const std::string& text) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string result;
  for (const char c : text) {
    if (std::string_view("%;\"\\<>").find(c) == std::string_view::npos) {
      result += c;
      continue;
    }
    const auto byte = static_cast<unsigned char>(c);
    result += '%';
    result += digits[byte / 16];
    result += digits[byte % 16];
  }
  return result;
}

/// Parts with semicolons between; nothing if there are none.
void add_list(const char* name, const std::vector<std::string>& parts, DotAttributes& to) {
  std::string all;
  for (const auto& part : parts) all += (&part == &parts.front() ? "" : ";") + part;
  if (!parts.empty()) to.emplace_back(name, all);
}

void add_texts(const char* name, const std::vector<std::string>& texts, DotAttributes& to) {
  std::vector<std::string> parts;
  for (const auto& text : texts) parts.push_back(encoded(text));
  add_list(name, parts, to);
}

void add_names(const char* name, const std::optional<std::vector<std::string>>& names, DotAttributes& to) {
  if (names) add_list(name, names->empty() ? std::vector<std::string>{"NONE"} : *names, to);
}

struct Describe {
  const Network& network;

  const std::string& condition(ConditionId id) const { return network.conditions[id.index()].name; }

  std::string names(const std::vector<MessageId>& messages) const {
    std::string result;
    for (const MessageId id : messages)
      result += (result.empty() ? "" : ";") + network.messages[id.index()].name;
    return result;
  }

  DotAttributes operator()(const Start&) const { return {{"pal_kind", "start"}}; }
  DotAttributes operator()(const End&) const { return {{"pal_kind", "end"}}; }
  DotAttributes operator()(const WaitForStart&) const { return {{"pal_kind", "wait_for_start"}}; }
  DotAttributes operator()(const Wait& wait) const {
    DotAttributes result = {{"pal_kind", "wait"}};
    std::string messages;
    std::string senders;
    for (const ChannelId id : wait.channels) {
      const Channel& channel = network.channels[id.index()];
      if (!messages.empty()) {
        messages += ";";
        senders += ";";
      }
      messages += network.messages[channel.message.index()].name;
      senders += party_name(network, channel.sender);
    }
    result.emplace_back("pal_message", messages);
    result.emplace_back("pal_sender", senders);
    if (wait.within) result.emplace_back("pal_within_ns", std::to_string(wait.within->count()));
    return result;
  }
  DotAttributes operator()(const Send& send) const {
    const Channel& channel = network.channels[send.channel.index()];
    return {{"pal_kind", "send"},
            {"pal_message", network.messages[channel.message.index()].name},
            {"pal_receiver", party_name(network, channel.receiver)}};
  }
  DotAttributes operator()(const Complete& complete) const {
    return {{"pal_kind", "complete"}, {"pal_code", std::to_string(complete.code)}};
  }
  DotAttributes operator()(const Set& set) const {
    DotAttributes result = {{"pal_kind", "set"}, {"pal_condition", condition(set.condition)}};
    if (set.value) result.emplace_back("pal_value", *set.value ? "TRUE" : "FALSE");
    return result;
  }
  DotAttributes operator()(const Read& read) const {
    return {{"pal_kind", "read"}, {"pal_condition", condition(read.condition)}};
  }
  DotAttributes operator()(const Perform& perform) const {
    const Activity& activity = network.activities[perform.activity.index()];
    DotAttributes result = {{"pal_kind", "perform"}, {"pal_activity", activity.name}};
    if (!activity.reads.empty()) result.emplace_back("pal_reads", names(activity.reads));
    if (!activity.writes.empty()) result.emplace_back("pal_writes", names(activity.writes));
    return result;
  }
  DotAttributes operator()(const Execute& execute) const {
    return {{"pal_kind", "execute"}, {"pal_module", network.modules[execute.module.index()].name}};
  }
  DotAttributes operator()(const Nothing&) const { return {{"pal_kind", "nothing"}}; }
  DotAttributes operator()(const Choose&) const { return {{"pal_kind", "case"}}; }
  DotAttributes operator()(const Merge&) const { return {{"pal_kind", "merge"}}; }
  DotAttributes operator()(const Loop&) const { return {{"pal_kind", "repeat"}}; }
  DotAttributes operator()(const Until& until) const {
    DotAttributes result = {{"pal_kind", "until"}};
    if (until.guard) result.emplace_back("pal_guard", guard_text(network, *until.guard));
    return result;
  }
  DotAttributes operator()(const Fork&) const { return {{"pal_kind", "concurrent"}}; }
  DotAttributes operator()(const Join&) const { return {{"pal_kind", "join"}}; }
};

}  // namespace

std::string dot_quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '\\';
    result += c;
  }
  return result + "\"";
}

std::string dot_list(const DotAttributes& attributes) {
  std::string result = "[";
  for (const auto& [name, value] : attributes) {
    if (result.size() > 1) result += ", ";
    const bool html = value.size() > 1 && value.front() == '<' && value.back() == '>';
    result += name + "=" + (html ? value : dot_quoted(value));
  }
  return result + "]";
}

DotAttributes content_attributes(const Network& network, ModuleId module) {
  const Module& it = network.modules[module.index()];
  DotAttributes result = {{"pal_format", "1"},
                          {"pal_skill", network.skill.name},
                          {"pal_module", it.name},
                          {"pal_module_kind", kind_text(it.kind)}};
  add_texts("pal_description", it.descriptions, result);
  add_names("pal_drivers", it.drivers, result);
  add_texts("pal_method", it.methods, result);
  add_names("pal_returns", it.returns, result);
  const Activities all = declared(network, module);
  const bool timed = std::any_of(all.begin(), all.end(),
                                 [&](std::size_t i) { return network.activities[i].time.has_value(); });
  if (timed || all != performed(network, module))
    result.emplace_back("pal_activities", headings(network, all));
  return result;
}

DotAttributes content_attributes(const Network& network, const Node& node) {
  return std::visit(Describe{network}, node.content);
}

}  // namespace pal::pan
