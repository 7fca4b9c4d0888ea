#include "pal/pan/dot.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "pal/pan/dot_attributes.hpp"
#include "pal/pan/dot_flow.hpp"
#include "pal/pan/dot_folds.hpp"
#include "pal/pan/dot_look.hpp"
#include "pal/pan/dump.hpp"

namespace pal::pan {

namespace {

// So many nodes one after the other fit on a page: with their texts from the top down, and with letters from
// left to right.
constexpr std::size_t most_texts = 48;
constexpr std::size_t most_letters = 30;

class DotWriter {
 public:
  DotWriter(const Network& network, ModuleId module, const DotOptions& options)
      : network_(network),
        module_(module),
        body_(network.modules[module.index()].body),
        downwards_(options.direction == DotOptions::Direction::top_down),
        flow_(body_),
        folds_(body_, flow_, options.letters ? most_letters : most_texts),
        look_(network, module, options) {}

  std::string write() {
    begin();
    for (std::size_t i = 0; i < body_.nodes.size(); ++i) {
      if (flow_.drawn(i)) draw_node(i);
    }
    for (std::size_t i = 0; i < body_.nodes.size(); ++i) {
      if (flow_.drawn(i)) draw_ways(i);
    }
    line("}");
    return std::move(out_);
  }

 private:
  void line(const std::string& text) { out_ += text + "\n"; }

  template <class Kind>
  const Kind* as(std::size_t node) const {
    return std::get_if<Kind>(&body_.nodes[node].content);
  }

  /// Names say what the node is: they are what a viewer shows when the pointer is over it.
  std::string name(std::size_t node) const {
    return dot_quoted(std::to_string(node) + " " + statement_text(network_, module_, NodeId(node)));
  }

  std::string arm_name(std::size_t node, std::size_t arm) const {
    const auto& guards = as<Choose>(node)->guards;
    return dot_quoted(std::to_string(node) + "." + std::to_string(arm) + " " +
                      guard_text(network_, guards[arm]));
  }

  std::string column(std::size_t i) const {
    const std::size_t fold = folds_.column(i);
    return "column" + std::to_string(flow_.column(i)) + (fold == 0 ? "" : "." + std::to_string(fold));
  }

  /// An arm's condition is in the column of the arm's first node, if it has one of its own.
  std::string arm_column(std::size_t node, std::size_t arm) const {
    const std::size_t first = body_.nodes[node].out[arm].index();
    return as<Merge>(first) != nullptr ? std::string() : column(first);
  }

  void begin() {
    const Module& module = network_.modules[module_.index()];
    line("digraph " + dot_quoted(module.name) + " {");
    line("  graph " + dot_list(content_attributes(network_, module_)));
    line("  graph " + dot_list(look_.graph()));
    line("  node " + dot_list(DotLook::nodes()));
    line("  edge " + dot_list(DotLook::edges()));
  }

  void draw_node(std::size_t i) {
    const bool reached = flow_.reached(i);
    DotAttributes attributes = content_attributes(network_, body_.nodes[i]);
    attributes.emplace_back("pal_node", std::to_string(i));
    if (body_.nodes[i].mate.valid())
      attributes.emplace_back("pal_mate", std::to_string(body_.nodes[i].mate.index()));
    add(look_.node(i, reached), attributes);
    attributes.emplace_back("group", column(i));
    line("  " + name(i) + " " + dot_list(attributes));
    const auto* choose = as<Choose>(i);
    for (std::size_t arm = 0; choose != nullptr && arm < choose->guards.size(); ++arm) {
      DotAttributes guard = {{"pal_kind", "guard"}, {"pal_guard", guard_text(network_, choose->guards[arm])}};
      add(look_.arm(i, arm, reached), guard);
      guard.emplace_back("group", arm_column(i, arm));
      line("  " + arm_name(i, arm) + " " + dot_list(guard));
    }
  }

  static void add(DotAttributes more, DotAttributes& to) {
    to.insert(to.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  }

  std::string in_side() const { return downwards_ ? ":n" : ":w"; }
  std::string out_side() const { return downwards_ ? ":s" : ":e"; }

  void edge(const std::string& from, const std::string& to, const DotAttributes& attributes) {
    line("  " + from + " -> " + to + (attributes.empty() ? "" : " " + dot_list(attributes)));
  }

  void draw_ways(std::size_t i) {
    const Node& node = body_.nodes[i];
    const std::size_t ways = node.out.size();
    for (std::size_t way = 0; way < ways; ++way) {
      if (as<Fork>(i) != nullptr && way == (ways + 1) / 2) align_bars(i);
      draw_way(i, way);
    }
    if (as<Fork>(i) != nullptr && ways == 1) align_bars(i);
    if (as<Until>(i) == nullptr) return;
    draw_loop_back(i);
    draw_behind(i);
  }

  void draw_way(std::size_t i, std::size_t way) {
    const Node& node = body_.nodes[i];
    const std::size_t next = node.out[way].index();
    DotAttributes attributes;
    if (node.out.size() > 1 || as<Choose>(i) != nullptr)
      attributes.emplace_back("pal_branch", std::to_string(way));
    if (!flow_.reached(i)) add(DotLook::pale_edge(), attributes);
    std::string from = name(i);
    if (const auto* fork = as<Fork>(i)) {
      from += ":b" + std::to_string(way) + out_side();
      const std::string& thread = network_.modules[module_.index()].threads[fork->threads[way]];
      attributes.emplace_back("pal_thread", thread);
      attributes.emplace_back("label", "  " + thread);
    } else if (as<Choose>(i) != nullptr) {
      edge(from, arm_name(i, way), attributes);
      from = arm_name(i, way);
      std::erase_if(attributes, [](const auto& attribute) { return attribute.first == "pal_branch"; });
    } else if (const auto* wait = as<Wait>(i); wait != nullptr && node.mate.valid()) {
      const bool otherwise = way >= wait->channels.size();
      attributes.emplace_back("label",
                              "  " + (otherwise ? std::string("ELSE") : message(wait->channels[way])));
    }
    if (guarded(i)) attributes.emplace_back("label", "  TRUE");
    std::string to = name(next);
    if (const auto block = flow_.block_ended_by(next)) {
      to = place_at_join(*block);
      attributes.emplace_back("pal_block_end", "true");
    }
    // Where branches come together is where their lengths may differ.
    if (folds_.begins(next)) {
      attributes.emplace_back("constraint", "false");
    } else if (as<Merge>(next) == nullptr) {
      attributes.emplace_back("weight", "8");
    }
    edge(from, to, attributes);
  }

  /// An UNTIL with conditions, whose two ways have names.
  bool guarded(std::size_t i) const {
    const auto* until = as<Until>(i);
    return until != nullptr && until->guard.has_value();
  }

  const std::string& message(ChannelId id) const {
    return network_.messages[network_.channels[id.index()].message.index()].name;
  }

  /// The two bars of a CONCURRENT stand one below the other: nothing pulls as hard as this does.
  void align_bars(std::size_t fork) {
    edge(name(fork), name(body_.nodes[fork].mate.index()),
         {{"pal_layout", "true"}, {"style", "invis"}, {"weight", "100"}});
  }

  /// Written from REPEAT to UNTIL, so that it is laid out beside the body; its arrow points back to REPEAT.
  void draw_loop_back(std::size_t until) {
    DotAttributes attributes = {{"pal_back", "true"}, {"dir", "back"}, {"style", "bold"}, {"weight", "0"}};
    if (guarded(until)) attributes.emplace_back("label", "  FALSE");
    const std::size_t repeat = body_.nodes[until].mate.index();
    if (folds_.column(repeat) != folds_.column(until)) attributes.emplace_back("constraint", "false");
    edge(name(repeat), name(until), attributes);
  }

  std::string place_at_join(const DotFlow::Block& block) const {
    return name(body_.nodes[block.fork].mate.index()) + ":b" + std::to_string(block.number) + in_side();
  }

  /// From an UNTIL( forever ): of a block that cannot end to the bar, where it is stopped; else to what no
  /// flow reaches.
  void draw_behind(std::size_t until) {
    const auto next = flow_.behind(until);
    if (!next) return;
    if (const auto block = flow_.block_ended_by(*next)) {
      edge(name(until), place_at_join(*block),
           {{"pal_stops", "true"}, {"style", "dashed"}, {"label", "  stopped"}, {"weight", "8"}});
      return;
    }
    DotAttributes attributes = {{"pal_never_taken", "true"}};
    add(DotLook::pale_edge(), attributes);
    edge(name(until), name(*next), attributes);
  }

  const Network& network_;
  ModuleId module_;
  const Graph& body_;
  bool downwards_;
  DotFlow flow_;
  DotFolds folds_;
  DotLook look_;
  std::string out_;
};

}  // namespace

std::string to_dot(const Network& network, ModuleId module, const DotOptions& options) {
  return DotWriter(network, module, options).write();
}

}  // namespace pal::pan
