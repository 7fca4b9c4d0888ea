#include "pal/pan/dot.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <optional>
#include <type_traits>

#include "pal/pan/dot_attributes.hpp"
#include "pal/pan/dot_letters.hpp"
#include "pal/pan/dump.hpp"

namespace pal::pan {

namespace {

// The colours of the charts, made light where text stands on them.
constexpr const char* message_fill = "#cfe8f8";
constexpr const char* condition_fill = "#fbf5b7";
constexpr const char* computation_fill = "#0072b2";
constexpr const char* fonts = "DejaVu Sans,Verdana,sans-serif";
// Points; a column of a CONCURRENT with text in full, and with letters.
constexpr int text_column = 230;
constexpr int letter_column = 60;

/// Breaks a long text at its OR and AND.
std::string wrapped(std::string text) {
  if (text.size() <= 32) return text;
  for (const char* word : {" OR ", " AND ", " WITHIN "}) {
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 2))
      text.replace(at, 1, "\\n");
  }
  return text;
}

class DotWriter {
 public:
  DotWriter(const Network& network, ModuleId module, const DotOptions& options)
      : network_(network),
        module_(module),
        body_(network.modules[module.index()].body),
        options_(options),
        letters_(network, module),
        reached_(body_.nodes.size(), false) {
    for (const Node& node : body_.nodes) {
      for (const NodeId next : node.out) reached_[next.index()] = true;
      if (std::holds_alternative<Fork>(node.content)) reached_[node.mate.index()] = true;
    }
    if (!reached_.empty()) reached_[0] = true;
    find_columns();
  }

  std::string write() {
    begin();
    for (std::size_t i = 0; i < body_.nodes.size(); ++i) {
      if (reached_[i] && !ends_block(i)) draw_node(i);
    }
    for (std::size_t i = 0; i < body_.nodes.size(); ++i) {
      if (reached_[i] && !ends_block(i)) draw_ways(i);
    }
    line("}");
    return std::move(out_);
  }

 private:
  /// Which nodes follow each other without a branch between: they are drawn on one straight line.
  void find_columns() {
    columns_.assign(body_.nodes.size(), 0);
    std::size_t columns = 1;
    for (std::size_t i = 0; i < body_.nodes.size(); ++i) {
      const Node& node = body_.nodes[i];
      const bool splits =
          as<Choose>(i) != nullptr || as<Fork>(i) != nullptr || (as<Wait>(i) != nullptr && node.mate.valid());
      if (splits) columns_[node.mate.index()] = columns_[i];
      for (const NodeId next : node.out) {
        const bool joins = as<Merge>(next.index()) != nullptr;
        if (!joins) columns_[next.index()] = splits ? columns++ : columns_[i];
      }
    }
  }

  std::string column(std::size_t i) const { return "column" + std::to_string(columns_[i]); }

  bool downwards() const { return options_.direction == DotOptions::Direction::top_down; }

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

  /// An arm's condition is in the column of the arm's first node, if it has one of its own.
  std::string arm_column(std::size_t node, std::size_t arm) const {
    const std::size_t first = body_.nodes[node].out[arm].index();
    return as<Merge>(first) != nullptr ? std::string() : column(first);
  }

  std::string guard(const Guard& it) const {
    return options_.letters ? letters_.guard(it) : wrapped(guard_text(network_, it));
  }

  void begin() {
    const Module& module = network_.modules[module_.index()];
    std::string kind = kind_text(module.kind);
    line("digraph " + dot_quoted(module.name) + " {");
    line("  graph " + dot_list({{"pal_format", "1"},
                                {"pal_skill", network_.skill.name},
                                {"pal_module", module.name},
                                {"pal_module_kind", kind}}));
    DotAttributes look = {{"rankdir", downwards() ? "TB" : "LR"},
                          {"ordering", "out"},
                          {"nodesep", "0.3"},
                          {"ranksep", downwards() ? "0.24" : "0.3"},
                          {"fontname", fonts},
                          {"fontsize", options_.letters ? "11" : "13"},
                          {"pad", "0.1"}};
    // No cluster holds the title: inside one, Graphviz does not keep the order of the arms.
    const std::string skill = network_.skill.name.empty() ? std::string() : " of " + network_.skill.name;
    const std::string title = kind + " " + module.name + skill;
    look.emplace_back("label", options_.letters ? key(title) : title);
    look.emplace_back("labelloc", options_.letters ? "b" : "t");
    line("  graph " + dot_list(look));
    line("  node " + dot_list({{"shape", "box"},
                               {"fontname", fonts},
                               {"fontsize", "11"},
                               {"height", "0.28"},
                               {"margin", "0.1,0.04"},
                               {"style", "filled"},
                               {"ordering", "out"},
                               {"fillcolor", "white"}}));
    line("  edge " + dot_list({{"arrowsize", "0.6"}, {"fontname", fonts}, {"fontsize", "10"}}));
  }

  /// Letters and conditions with their meanings, as a table under the drawing.
  std::string key(const std::string& title) const {
    std::vector<std::pair<std::string, std::string>> rows = letters_.statements();
    rows.insert(rows.end(), letters_.conditions().begin(), letters_.conditions().end());
    const std::size_t columns = downwards() ? 2 : 3;
    const std::size_t height = (rows.size() + columns - 1) / columns;
    std::string table = "<<TABLE BORDER=\"0\" CELLSPACING=\"0\" CELLPADDING=\"2\">";
    table += "<TR><TD COLSPAN=\"" + std::to_string(2 * columns) + "\"><FONT POINT-SIZE=\"13\">" +
             dot_html(title) + "</FONT></TD></TR>";
    for (std::size_t row = 0; row < height; ++row) {
      table += "<TR>";
      for (std::size_t column = 0; column < columns; ++column) {
        const std::size_t i = column * height + row;
        const bool filled = i < rows.size();
        table += "<TD ALIGN=\"RIGHT\"><B>" + (filled ? dot_html(rows[i].first) : std::string()) +
                 "</B></TD><TD ALIGN=\"LEFT\">" + (filled ? dot_html(rows[i].second) : std::string()) +
                 "</TD>";
      }
      table += "</TR>";
    }
    return table + "</TABLE>>";
  }

  void draw_node(std::size_t i) {
    DotAttributes attributes = content_attributes(network_, body_.nodes[i]);
    attributes.emplace_back("pal_node", std::to_string(i));
    if (body_.nodes[i].mate.valid())
      attributes.emplace_back("pal_mate", std::to_string(body_.nodes[i].mate.index()));
    const DotAttributes look =
        std::visit([&](const auto& content) { return look_of(content, i); }, body_.nodes[i].content);
    attributes.insert(attributes.end(), look.begin(), look.end());
    attributes.emplace_back("group", column(i));
    line("  " + name(i) + " " + dot_list(attributes));
    if (const auto* choose = as<Choose>(i)) {
      for (std::size_t arm = 0; arm < choose->guards.size(); ++arm) {
        line("  " + arm_name(i, arm) + " " +
             dot_list({{"pal_kind", "guard"},
                       {"pal_guard", guard_text(network_, choose->guards[arm])},
                       {"label", guard(choose->guards[arm])},
                       {"style", "filled,rounded"},
                       {"fillcolor", condition_fill},
                       {"group", arm_column(i, arm)}}));
      }
    }
  }

  DotAttributes box(std::size_t i, const char* fill, const char* ink = "black") const {
    const std::string text = statement_text(network_, module_, NodeId(i));
    DotAttributes look = {{"label", options_.letters ? letters_.letter(text) : wrapped(text)},
                          {"fillcolor", fill}};
    if (options_.letters) {
      look.insert(look.end(), {{"shape", "circle"}, {"width", "0.34"}, {"fixedsize", "true"}});
    }
    look.emplace_back("fontcolor", ink);
    return look;
  }

  static DotAttributes dot(const char* shape, const char* width, const char* fill) {
    return {{"label", ""},     {"shape", shape},      {"width", width},
            {"height", width}, {"fixedsize", "true"}, {"fillcolor", fill}};
  }

  DotAttributes look_of(const Start&, std::size_t) const { return dot("circle", "0.16", "black"); }
  DotAttributes look_of(const End&, std::size_t) const { return dot("doublecircle", "0.12", "black"); }
  DotAttributes look_of(const WaitForStart&, std::size_t i) const { return box(i, message_fill); }
  DotAttributes look_of(const Wait&, std::size_t i) const { return box(i, message_fill); }
  DotAttributes look_of(const Send&, std::size_t i) const { return box(i, message_fill); }
  DotAttributes look_of(const Complete&, std::size_t i) const { return box(i, message_fill); }
  DotAttributes look_of(const Set&, std::size_t i) const { return box(i, condition_fill); }
  DotAttributes look_of(const Read&, std::size_t i) const { return box(i, condition_fill); }
  DotAttributes look_of(const Perform&, std::size_t i) const { return box(i, computation_fill, "white"); }
  DotAttributes look_of(const Execute&, std::size_t i) const {
    DotAttributes look = box(i, computation_fill, "white");
    look.emplace_back("peripheries", "2");
    return look;
  }
  DotAttributes look_of(const Nothing&, std::size_t i) const { return box(i, "white"); }
  DotAttributes look_of(const Choose&, std::size_t) const { return dot("diamond", "0.26", "white"); }
  DotAttributes look_of(const Merge&, std::size_t) const { return dot("diamond", "0.14", "black"); }
  DotAttributes look_of(const Loop&, std::size_t) const { return dot("circle", "0.14", "white"); }
  DotAttributes look_of(const Until& until, std::size_t) const {
    if (!until.guard) return dot("circle", "0.14", "white");
    const std::string text =
        options_.letters ? "until " + guard(*until.guard) : "UNTIL( " + guard(*until.guard) + " )";
    return {{"label", text}, {"style", "filled,rounded"}, {"fillcolor", condition_fill}};
  }
  DotAttributes look_of(const Fork&, std::size_t i) const { return bar(body_.nodes[i].out.size()); }
  DotAttributes look_of(const Join&, std::size_t i) const {
    return bar(body_.nodes[body_.nodes[i].mate.index()].out.size());
  }

  /// A thick bar across the flow, with a place for each block.
  DotAttributes bar(std::size_t blocks) const {
    const std::string length = std::to_string(options_.letters ? letter_column : text_column);
    const std::string size =
        downwards() ? "WIDTH=\"" + length + "\" HEIGHT=\"6\"" : "WIDTH=\"6\" HEIGHT=\"" + length + "\"";
    std::string table =
        "<<TABLE BORDER=\"0\" CELLBORDER=\"0\" CELLSPACING=\"0\" CELLPADDING=\"0\" BGCOLOR=\"black\">";
    if (downwards()) table += "<TR>";
    for (std::size_t block = 0; block < blocks; ++block) {
      const std::string cell =
          "<TD PORT=\"b" + std::to_string(block) + "\" FIXEDSIZE=\"TRUE\" " + size + "></TD>";
      table += downwards() ? cell : "<TR>" + cell + "</TR>";
    }
    if (downwards()) table += "</TR>";
    return {{"label", table + "</TABLE>>"}, {"shape", "plain"}, {"style", "solid"}};
  }

  /// The CONCURRENT whose block ends here, and the block's number.
  struct Block {
    std::size_t fork;
    std::size_t number;
  };
  std::optional<Block> ends_block(std::size_t end) const {
    for (std::size_t i = 0; i < body_.nodes.size(); ++i) {
      if (as<Fork>(i) == nullptr) continue;
      const auto& out = body_.nodes[i].out;
      for (std::size_t block = 0; block < out.size(); ++block) {
        // A block reaches from its first node to the End before the next block, or before the Join.
        const std::size_t next =
            block + 1 < out.size() ? out[block + 1].index() : body_.nodes[i].mate.index();
        if (end + 1 == next) return Block{i, block};
      }
    }
    return std::nullopt;
  }

  std::string in_side() const { return downwards() ? ":n" : ":w"; }
  std::string out_side() const { return downwards() ? ":s" : ":e"; }

  void edge(const std::string& from, const std::string& to, const DotAttributes& attributes) {
    line("  " + from + " -> " + to + (attributes.empty() ? "" : " " + dot_list(attributes)));
  }

  void draw_ways(std::size_t i) {
    const Node& node = body_.nodes[i];
    for (std::size_t way = 0; way < node.out.size(); ++way) {
      const std::size_t next = node.out[way].index();
      DotAttributes attributes;
      if (node.out.size() > 1 || as<Choose>(i) != nullptr)
        attributes.emplace_back("pal_branch", std::to_string(way));
      std::string from = name(i);
      if (as<Fork>(i) != nullptr) {
        from += ":b" + std::to_string(way) + out_side();
        const std::string& thread =
            network_.modules[module_.index()].threads[std::get<Fork>(node.content).threads[way]];
        attributes.emplace_back("pal_thread", thread);
        attributes.emplace_back("label", "  " + thread);
      } else if (as<Choose>(i) != nullptr) {
        edge(from, arm_name(i, way), attributes);
        from = arm_name(i, way);
        attributes.clear();
      } else if (const auto* wait = as<Wait>(i); wait != nullptr && node.mate.valid()) {
        const bool otherwise = way >= wait->channels.size();
        const auto message = [&] {
          const Channel& channel = network_.channels[wait->channels[way].index()];
          return network_.messages[channel.message.index()].name;
        };
        attributes.emplace_back("label", "  " + (otherwise ? std::string("ELSE") : message()));
      }
      std::string to = name(next);
      if (const auto block = ends_block(next)) {
        to = place_at_join(*block);
        attributes.emplace_back("pal_block_end", "true");
      }
      // Where branches come together is where their lengths may differ.
      if (as<Merge>(next) == nullptr) attributes.emplace_back("weight", "8");
      edge(from, to, attributes);
    }
    if (as<Until>(i) != nullptr) draw_loop_back(i);
    draw_stop(i);
  }

  /// Written from REPEAT to UNTIL, so that it is laid out beside the body; its arrow points back to REPEAT.
  void draw_loop_back(std::size_t until) {
    edge(name(body_.nodes[until].mate.index()), name(until),
         {{"pal_back", "true"}, {"dir", "back"}, {"style", "bold"}, {"weight", "0"}});
  }

  std::string place_at_join(const Block& block) const {
    return name(body_.nodes[block.fork].mate.index()) + ":b" + std::to_string(block.number) + in_side();
  }

  /// From the UNTIL( forever ) of a block that cannot end to the bar: it is stopped there.
  void draw_stop(std::size_t i) {
    const auto* until = as<Until>(i);
    if (until == nullptr || until->guard || i + 1 >= body_.nodes.size() || reached_[i + 1]) return;
    if (const auto block = ends_block(i + 1)) {
      edge(name(i), place_at_join(*block),
           {{"pal_stops", "true"}, {"style", "dashed"}, {"label", "  stopped"}});
    }
  }

  const Network& network_;
  ModuleId module_;
  const Graph& body_;
  DotOptions options_;
  DotLetters letters_;
  std::vector<bool> reached_;
  std::vector<std::size_t> columns_;
  std::string out_;
};

}  // namespace

std::string to_dot(const Network& network, ModuleId module, const DotOptions& options) {
  return DotWriter(network, module, options).write();
}

}  // namespace pal::pan
