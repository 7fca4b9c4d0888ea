// Statements that are never reached, and loops that spin.
#include <vector>

#include "pal/check/rules/families.hpp"
#include "pal/check/rules/zero_time.hpp"
#include "pal/pan/dump.hpp"
#include "pal/support/finding.hpp"

namespace pal::check {

namespace {

class FlowCheck {
 public:
  FlowCheck(const pan::Network& network, const pan::Flow& flow, const ZeroTimePaths& zero_time,
            pan::ModuleId module, Diagnostics& diagnostics)
      : network_(network),
        flow_(flow),
        zero_time_(zero_time),
        module_(module),
        nodes_(network.modules[module.index()].body.nodes),
        diagnostics_(diagnostics) {}

  void check() {
    unreached();
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (std::holds_alternative<pan::Loop>(nodes_[i].content)) spinning(pan::NodeId(i));
    }
  }

 private:
  /// The first statement of each stretch that is never reached.
  void unreached() {
    bool before = true;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const bool here = flow_.reached(module_, pan::NodeId(i));
      if (!here && before && pan::is_statement(nodes_[i].content)) report_unreached(i);
      // Places where branches come together say nothing of what was written.
      if (here || pan::is_statement(nodes_[i].content)) before = here;
    }
  }

  void report_unreached(std::size_t index) {
    const auto& node = nodes_[index];
    const auto* cause = index > 0 ? &nodes_[index - 1] : nullptr;
    const auto* first = cause == nullptr ? nullptr : std::get_if<pan::Complete>(&cause->content);
    const auto* second = std::get_if<pan::Complete>(&node.content);
    const bool ended = first != nullptr;
    if (ended && second != nullptr) {
      const bool same = first->code == second->code;
      auto& finding = diagnostics_.report(
          either<Finding::same_completion_again, Finding::second_completion>(same), node.where);
      if (same) finding.fix = {{node.where, ""}};
      finding.note(cause->where, Remark::ends_here);
      return;
    }
    auto& finding = diagnostics_.report(Finding::never_reached, node.where);
    if (cause == nullptr || !cause->where.valid()) return;
    if (ended) {
      finding.note(cause->where, Remark::skill_ends);
    } else if (std::holds_alternative<pan::Until>(cause->content)) {
      finding.note(cause->where, Remark::loop_endless);
    } else if (std::holds_alternative<pan::Execute>(cause->content)) {
      finding.note(cause->where, Remark::module_endless);
    } else if (std::holds_alternative<pan::Join>(cause->content)) {
      finding.note(nodes_[cause->mate.index()].where, Remark::no_block_ends);
    } else if (std::holds_alternative<pan::Merge>(cause->content)) {
      finding.note(nodes_[cause->mate.index()].where, Remark::no_branch_ends);
    }
  }

  /// A way through the body of the loop on which nothing pauses.
  void spinning(pan::NodeId loop) {
    const auto until = nodes_[loop.index()].mate;
    if (!flow_.reached(module_, loop) || !flow_.reached(module_, until)) return;
    std::vector<pan::NodeId> from(nodes_.size());
    std::vector<bool> seen(nodes_.size(), false);
    std::vector<pan::NodeId> open{loop};
    seen[loop.index()] = true;
    for (std::size_t at = 0; at < open.size(); ++at) {
      const auto here = open[at];
      if (here == until) {
        report_spinning(loop, until, from);
        return;
      }
      if (!zero_time_.takes_no_time(module_, here)) continue;
      for (const auto to : zero_time_.next(module_, here)) {
        if (to < loop || to > until || seen[to.index()]) continue;
        seen[to.index()] = true;
        from[to.index()] = here;
        open.push_back(to);
      }
    }
  }

  void report_spinning(pan::NodeId loop, pan::NodeId until, const std::vector<pan::NodeId>& from) {
    auto& finding = diagnostics_.report(Finding::round_without_waiting, nodes_[loop.index()].where);
    std::vector<pan::NodeId> path;
    for (auto at = from[until.index()]; at.valid() && at != loop; at = from[at.index()]) path.push_back(at);
    for (auto at = path.rbegin(); at != path.rend(); ++at) {
      const auto& node = nodes_[at->index()];
      if (!pan::is_statement(node.content)) continue;
      finding.note(node.where, Remark::by_way_of, statement_text(network_, module_, *at));
    }
    finding.note(nodes_[until.index()].where, Remark::back_from_here);
  }

  const pan::Network& network_;
  const pan::Flow& flow_;
  const ZeroTimePaths& zero_time_;
  pan::ModuleId module_;
  const std::vector<pan::Node>& nodes_;
  Diagnostics& diagnostics_;
};

}  // namespace

void check_flow(const pan::Network& network, const pan::Flow& flow, Diagnostics& diagnostics) {
  const ZeroTimePaths zero_time(network, flow);
  for (std::size_t i = 0; i < network.modules.size(); ++i) {
    if (network.modules[i].body.empty()) continue;
    FlowCheck(network, flow, zero_time, pan::ModuleId(i), diagnostics).check();
  }
}

}  // namespace pal::check
