#include "pal/check/shared_uses.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "pal/check/report.hpp"
#include "pal/pan/threads.hpp"
#include "pal/support/finding.hpp"

namespace pal::check {

namespace {

/// Of these there is an error already (PAL0730), or there will be: a skill has far fewer blocks.
constexpr std::size_t most_blocks = 10'000;

/// What runs a body: a thread, and where the environment has it.
struct Runner {
  std::string name;
  bool is_block = false;
  const pan::Placement* place = nullptr;
};

/// A statement that uses what its module keeps: of a message, or in the class of an activity. `kept` numbers
/// the messages of the skill, then its activities.
struct SharedUse {
  std::size_t kept = 0;
  bool writes = false;
  Runner by;
  SourceSpan where;
};

/// Only blocks are at work at the same time: of a CONCURRENT of its own, or of a module that it executes.
bool may_have_blocks(const pan::Module& module) {
  return std::any_of(module.body.nodes.begin(), module.body.nodes.end(), [](const pan::Node& node) {
    return std::holds_alternative<pan::Fork>(node.content) ||
           std::holds_alternative<pan::Execute>(node.content);
  });
}

class Finder {
 public:
  Finder(const pan::Network& network, const pan::Environment& environment, Diagnostics& diagnostics)
      : network_(network), environment_(environment), diagnostics_(diagnostics) {}

  void find() {
    for (std::size_t m = 0; m < network_.modules.size(); ++m) {
      const pan::Module& module = network_.modules[m];
      if (!may_have_blocks(module) || module.executed_by.valid()) continue;
      const Runner runner{module.name, false, pan::place_of(environment_, module.name)};
      std::set<pan::ModuleId> entered;
      const std::vector<SharedUse> all =
          uses_of(pan::ModuleId(m), 0, module.body.nodes.size(), runner, runner, entered);
      for (const auto& [write, other] : found_) {
        if (is_message(write)) {
          if (is_read(write.kept, all)) report(write, other);
        } else if (!has_result(activity(write), all)) {
          report_activity(write, other);
        }
      }
      found_.clear();
    }
  }

 private:
  /// The uses in nodes [begin, end), which `thread` follows in a body that `runner` runs, each kind once.
  /// Compares the blocks in them.
  std::vector<SharedUse> uses_of(pan::ModuleId id, std::size_t begin, std::size_t end, const Runner& thread,
                                 const Runner& runner, std::set<pan::ModuleId>& entered) {
    std::vector<SharedUse> result;
    const pan::Module& module = network_.modules[id.index()];
    const auto& nodes = module.body.nodes;
    for (std::size_t n = begin; n < end; ++n) {
      const pan::Node& node = nodes[n];
      if (const auto* fork = std::get_if<pan::Fork>(&node.content)) {
        join(uses_of_blocks(id, node, *fork, runner), result);
        n = node.mate.index();
      } else if (const auto* execute = std::get_if<pan::Execute>(&node.content)) {
        if (!entered.insert(execute->module).second) continue;
        const auto& body = network_.modules[execute->module.index()].body.nodes;
        join(uses_of(execute->module, 0, body.size(), thread, thread, entered), result);
      } else {
        add_uses(node, thread, result);
      }
    }
    return result;
  }

  std::vector<SharedUse> uses_of_blocks(pan::ModuleId id, const pan::Node& here, const pan::Fork& fork,
                                        const Runner& runner) {
    std::vector<SharedUse> earlier;
    for (std::size_t i = 0; i < fork.threads.size() && ++blocks_ <= most_blocks; ++i) {
      Runner block;
      block.name = pan::block_name(runner.name, runner.is_block,
                                   network_.modules[id.index()].threads[fork.threads[i]]);
      block.is_block = true;
      const pan::Placement* own = pan::place_of(environment_, block.name);
      block.place = own != nullptr ? own : runner.place;
      const std::size_t end = i + 1 < here.out.size() ? here.out[i + 1].index() : here.mate.index();
      std::set<pan::ModuleId> entered;
      const std::vector<SharedUse> uses = uses_of(id, here.out[i].index(), end, block, runner, entered);
      compare(earlier, uses);
      join(uses, earlier);
    }
    return earlier;
  }

  void add_uses(const pan::Node& node, const Runner& thread, std::vector<SharedUse>& result) const {
    const auto add = [&](pan::MessageId message, bool writes) {
      if (network_.messages[message.index()].fields.empty()) return;
      join({{message.index(), writes, thread, node.where}}, result);
    };
    if (const auto* wait = std::get_if<pan::Wait>(&node.content)) {
      for (const pan::ChannelId channel : wait->channels)
        add(network_.channels[channel.index()].message, true);
    } else if (const auto* send = std::get_if<pan::Send>(&node.content)) {
      add(network_.channels[send->channel.index()].message, false);
    } else if (const auto* perform = std::get_if<pan::Perform>(&node.content)) {
      const pan::Activity& activity = network_.activities[perform->activity.index()];
      for (const pan::MessageId message : activity.reads) add(message, false);
      for (const pan::MessageId message : activity.writes) add(message, true);
      join({{network_.messages.size() + perform->activity.index(), true, thread, node.where}}, result);
    } else if (const auto* set = std::get_if<pan::Set>(&node.content); set != nullptr && !set->value) {
      for (const pan::MessageId message : network_.conditions[set->condition.index()].from)
        add(message, false);
    }
  }

  static void join(const std::vector<SharedUse>& more, std::vector<SharedUse>& into) {
    for (const SharedUse& use : more) {
      const bool known = std::any_of(into.begin(), into.end(), [&](const SharedUse& other) {
        return std::tie(other.kept, other.writes, other.by.name) ==
               std::tie(use.kept, use.writes, use.by.name);
      });
      if (!known) into.push_back(use);
    }
  }

  /// One block's uses against another's: a write in the one, a use in the other, at the same time.
  void compare(const std::vector<SharedUse>& earlier, const std::vector<SharedUse>& later) {
    for (const SharedUse& a : later) {
      for (const SharedUse& b : earlier) {
        if (a.kept != b.kept || (!a.writes && !b.writes)) continue;
        const SharedUse& write = a.writes ? a : b;
        const SharedUse& other = a.writes ? b : a;
        if (meet(a.by, b.by) && seen_.emplace(a.kept, write.by.name, other.by.name).second)
          found_.emplace_back(write, other);
      }
    }
  }

  /// Whether the one may be at a statement while the other is at one.
  bool meet(const Runner& a, const Runner& b) const {
    if (a.place == nullptr || b.place == nullptr) return false;  // an error of its own
    if (a.place->processor != b.place->processor) return true;
    const auto processor =
        std::find_if(environment_.processors.begin(), environment_.processors.end(),
                     [&](const pan::Processor& each) { return each.name == a.place->processor; });
    return processor != environment_.processors.end() && processor->preemptive &&
           a.place->priority != b.place->priority;
  }

  bool is_message(const SharedUse& use) const { return use.kept < network_.messages.size(); }
  const pan::Activity& activity(const SharedUse& use) const {
    return network_.activities[use.kept - network_.messages.size()];
  }

  /// A message that no statement reads is not kept.
  static bool is_read(std::size_t message, const std::vector<SharedUse>& all) {
    return std::any_of(all.begin(), all.end(),
                       [&](const SharedUse& use) { return use.kept == message && !use.writes; });
  }

  /// One with a result may need nothing that its class keeps; two that write one message are reported for it.
  bool has_result(const pan::Activity& activity, const std::vector<SharedUse>& all) const {
    return std::any_of(activity.writes.begin(), activity.writes.end(), [&](pan::MessageId message) {
      return !network_.messages[message.index()].fields.empty() && is_read(message.index(), all);
    });
  }

  static std::string where_both_run(const SharedUse& one, const SharedUse& other) {
    const bool two = one.by.place->processor != other.by.place->processor;
    return two ? "on " + one.by.place->processor + " and " + other.by.place->processor
               : "with two priorities on " + one.by.place->processor;
  }

  void report(const SharedUse& write, const SharedUse& other) {
    const std::string& message = network_.messages[write.kept].name;
    auto& finding = diagnostics_.report(Finding::message_used_by_two, other.where, message,
                                        (other.writes ? "written" : "read"), other.by.name, write.by.name,
                                        where_both_run(write, other), environment_.name);
    finding.note(write.where, Remark::written_here);
    add_places(write, other, finding);
  }

  void report_activity(const SharedUse& one, const SharedUse& other) {
    auto& finding =
        diagnostics_.report(Finding::activity_used_by_two, other.where, other.by.name, activity(one).name,
                            one.by.name, where_both_run(one, other), environment_.name);
    finding.note(one.where, Remark::also_runs_here);
    add_places(one, other, finding);
  }

  static void add_places(const SharedUse& write, const SharedUse& other, Diagnostic& finding) {
    finding.note(write.by.place->where, Remark::placed_here, write.by.name);
    if (other.by.place != write.by.place)
      finding.note(other.by.place->where, Remark::placed_here, other.by.name);
  }

  const pan::Network& network_;
  const pan::Environment& environment_;
  Diagnostics& diagnostics_;
  std::size_t blocks_ = 0;
  std::vector<std::pair<SharedUse, SharedUse>> found_;  // a write, and another use at the same time
  std::set<std::tuple<std::size_t, std::string, std::string>> seen_;
};

}  // namespace

void check_shared_uses(const pan::Network& network, const pan::Environment& environment,
                       Diagnostics& diagnostics) {
  Finder(network, environment, diagnostics).find();
}

}  // namespace pal::check
