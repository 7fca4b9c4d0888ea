#include "pal/syntax/dot/contents.hpp"

#include <algorithm>
#include <limits>
#include <unordered_map>
#include <utility>

#include "pal/support/finding.hpp"
#include "pal/syntax/dot/vocabulary.hpp"
#include "pal/syntax/dot/words.hpp"

namespace pal::syntax {

namespace {

constexpr std::size_t most_bad_nodes = 100;

bool same_names(const std::vector<Name>& a, const std::vector<Name>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Name& x, const Name& y) { return x.text == y.text; });
}

class ContentsReader {
 public:
  ContentsReader(const DotGraph& graph, Diagnostics& diagnostics)
      : graph_(graph), diagnostics_(diagnostics), words_(diagnostics) {}

  DotContents read() {
    if (const DotValue* listed = graph_.values.find("pal_activities")) {
      for (const DotValue& part : dot_parts(*listed)) declare(words_.activity(part));
    }
    const std::size_t count = graph_.nodes.size();
    result_.kinds.resize(count);
    result_.statements.resize(count);
    result_.guards.resize(count);
    std::size_t bad = 0;
    for (std::size_t i = 0; i < count && bad < most_bad_nodes; ++i) {
      try {
        read_node(i);
      } catch (const Reported&) {
        ++bad;
      }
    }
    if (bad > 0) throw Reported{};
    return std::move(result_);
  }

 private:
  void read_node(std::size_t i) {
    const DotNode& node = graph_.nodes[i];
    if (!check_attributes(node, diagnostics_)) throw Reported{};
    result_.kinds[i] = node.values.find("pal_kind")->text;
    Statement& to = result_.statements[i];
    to.where = node.where;
    to.end = node.where;
    const std::string& kind = result_.kinds[i];
    const auto value = [&](const char* name) -> const DotValue& { return *node.values.find(name); };
    if (kind == "wait") {
      to.content = wait(node);
    } else if (kind == "wait_for_start") {
      to.content = WaitForStart{};
    } else if (kind == "send") {
      to.content = Send{words_.message(value("pal_message")), words_.party(value("pal_receiver"))};
    } else if (kind == "complete") {
      const auto code = words_.number(value("pal_code"), std::numeric_limits<int>::max());
      to.content = Complete{static_cast<int>(code), value("pal_code").where};
    } else if (kind == "set") {
      Set set{words_.name(value("pal_condition")), std::nullopt};
      if (const DotValue* truth = node.values.find("pal_value")) set.value = words_.truth(*truth);
      to.content = std::move(set);
    } else if (kind == "read") {
      to.content = Read{words_.name(value("pal_condition"))};
    } else if (kind == "perform") {
      to.content = perform(node);
    } else if (kind == "execute") {
      to.content = Execute{words_.party(value("pal_module"))};
    } else if (kind == "nothing") {
      to.content = Nothing{};
    } else if (kind == "guard" || kind == "until") {
      if (const DotValue* guard = node.values.find("pal_guard")) result_.guards[i] = words_.guard(*guard);
    }
  }

  decltype(Statement::content) wait(const DotNode& node) {
    const auto messages = dot_parts(*node.values.find("pal_message"));
    const auto senders = dot_parts(*node.values.find("pal_sender"));
    if (messages.size() != senders.size()) {
      diagnostics_.report(Finding::messages_without_senders, node.where, messages.size(), senders.size());
      throw Reported{};
    }
    WaitBranches branches;
    branches.first = messages.size() > 1;
    if (const DotValue* within = node.values.find("pal_within_ns"))
      branches.within = Duration(words_.number(*within, std::numeric_limits<std::int64_t>::max()));
    for (std::size_t k = 0; k < messages.size(); ++k)
      branches.arms.push_back({{words_.message(messages[k]), words_.party(senders[k])}, {}, node.where});
    if (branches.first || branches.within) return branches;
    return Wait{std::move(branches.arms.front().source)};
  }

  Perform perform(const DotNode& node) {
    const DotValue& activity = *node.values.find("pal_activity");
    ActivityHeading heading{words_.activity_name(activity), {}, {}, node.where};
    for (const auto& [attribute, list] :
         {std::pair("pal_reads", &heading.reads), std::pair("pal_writes", &heading.writes)}) {
      const DotValue* given = node.values.find(attribute);
      if (given == nullptr) continue;
      for (const DotValue& part : dot_parts(*given)) list->push_back(words_.name(part));
    }
    Perform result{heading.name};
    declare(std::move(heading));
    return result;
  }

  /// One node of an activity may say what it reads and writes for all of them.
  void declare(ActivityHeading heading) {
    const auto [found, fresh] = declared_.emplace(heading.name.text, result_.activities.size());
    if (fresh) {
      result_.activities.push_back(std::move(heading));
      return;
    }
    if (heading.reads.empty() && heading.writes.empty()) return;
    ActivityHeading& first = result_.activities[found->second];
    if (first.reads.empty() && first.writes.empty()) {
      heading.time = first.time;
      first = std::move(heading);
    } else if (!same_names(first.reads, heading.reads) || !same_names(first.writes, heading.writes)) {
      auto& finding =
          diagnostics_.report(Finding::activity_differs_between_nodes, heading.where, heading.name.text);
      finding.note(first.where, Remark::than_here);
      throw Reported{};
    }
  }

  const DotGraph& graph_;
  Diagnostics& diagnostics_;
  DotWords words_;
  DotContents result_;
  std::unordered_map<std::string, std::size_t> declared_;
};

}  // namespace

DotContents read_contents(const DotGraph& graph, Diagnostics& diagnostics) {
  return ContentsReader(graph, diagnostics).read();
}

}  // namespace pal::syntax
