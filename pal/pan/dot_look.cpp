#include "pal/pan/dot_look.hpp"

#include <string>
#include <variant>

#include "pal/pan/dump.hpp"
#include "pal/support/xml.hpp"

namespace pal::pan {

namespace {

// The colours of the charts, made light where text stands on them.
constexpr const char* message_fill = "#cfe8f8";
constexpr const char* condition_fill = "#fbf5b7";
constexpr const char* computation_fill = "#0072b2";
constexpr const char* pale = "#999999";
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

DotAttributes dot(const char* shape, const char* width, const char* fill) {
  return {{"label", ""},     {"shape", shape},      {"width", width},
          {"height", width}, {"fixedsize", "true"}, {"fillcolor", fill}};
}

/// Grey lines and letters on white; a bar and a dot stay as they are.
void make_pale(DotAttributes& look) {
  for (auto& [name, value] : look) {
    if (name == "fontcolor") value = pale;
    if (name == "fillcolor" && value != "black") value = "white";
  }
  look.emplace_back("color", pale);
  look.emplace_back("fontcolor", pale);
}

}  // namespace

DotAttributes DotLook::node(std::size_t node, bool reached) const {
  DotAttributes look = std::visit([&](const auto& content) { return of(content, node); }, body(node).content);
  if (!reached) make_pale(look);
  return look;
}

DotAttributes DotLook::arm(std::size_t node, std::size_t arm, bool reached) const {
  const Guard& of = std::get<Choose>(body(node).content).guards[arm];
  DotAttributes look = {
      {"label", guard(of, node, arm)}, {"style", "filled,rounded"}, {"fillcolor", condition_fill}};
  if (!reached) make_pale(look);
  return look;
}

DotAttributes DotLook::graph() const {
  const Module& module = network_.modules[module_.index()];
  const std::string skill = network_.skill.name.empty() ? std::string() : " of " + network_.skill.name;
  const std::string title = kind_text(module.kind) + " " + module.name + skill;
  // No cluster holds the title: inside one, Graphviz does not keep the order of the arms.
  return {{"rankdir", downwards() ? "TB" : "LR"},
          {"ordering", "out"},
          {"nodesep", "0.3"},
          {"ranksep", downwards() ? "0.24" : "0.3"},
          {"fontname", fonts},
          {"fontsize", options_.letters ? "11" : "13"},
          {"pad", "0.1"},
          {"label", options_.letters ? letters_.key(title, downwards() ? 2 : 3, sign_rows(6)) : signs(title)},
          {"labelloc", options_.letters ? "b" : "t"}};
}

/// The signs that the drawing has, with what they mean, as rows of a table `columns` wide.
std::string DotLook::sign_rows(std::size_t columns) const {
  bool messages = false, conditions = false, computations = false, executes = false, chooses = false,
       loops = false;
  for (const Node& node : network_.modules[module_.index()].body.nodes) {
    const Content& content = node.content;
    messages = messages || std::holds_alternative<Wait>(content) || std::holds_alternative<Send>(content) ||
               std::holds_alternative<WaitForStart>(content) || std::holds_alternative<Complete>(content);
    conditions = conditions || std::holds_alternative<Set>(content) ||
                 std::holds_alternative<Read>(content) || std::holds_alternative<Choose>(content);
    computations = computations || std::holds_alternative<Perform>(content);
    executes = executes || std::holds_alternative<Execute>(content);
    chooses = chooses || std::holds_alternative<Choose>(content);
    loops = loops || std::holds_alternative<Until>(content);
  }
  std::vector<std::string> cells;
  const auto filled = [&](bool used, const std::string& fill, const std::string& ink, const std::string& text,
                          int border = 1) {
    if (!used) return;
    cells.push_back("<TD BORDER=\"" + std::to_string(border) + "\" BGCOLOR=\"" + fill +
                    "\"><FONT POINT-SIZE=\"10\" COLOR=\"" + ink + "\">" + text + "</FONT></TD>");
  };
  filled(messages, message_fill, "black", "message");
  filled(conditions, condition_fill, "black", "condition");
  filled(computations, computation_fill, "white", "activity");
  filled(executes, computation_fill, "white", "Execute: double frame");
  filled(chooses, "white", "black", "diamond: CASE", 0);
  filled(loops, "white", "black", "bold: back to REPEAT", 0);
  std::string rows;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i % columns == 0) rows += rows.empty() ? "<TR>" : "</TR><TR>";
    rows += cells[i];
  }
  return rows.empty() ? rows : rows + "</TR>";
}

/// The title of a drawing with its texts in full, over the key to its signs.
std::string DotLook::signs(const std::string& title) const {
  constexpr std::size_t columns = 3;
  return "<<TABLE BORDER=\"0\" CELLBORDER=\"0\" CELLSPACING=\"4\" CELLPADDING=\"2\"><TR><TD COLSPAN=\"" +
         std::to_string(columns) + "\">" + xml_escaped(title) + "</TD></TR>" + sign_rows(columns) +
         "</TABLE>>";
}

DotAttributes DotLook::nodes() {
  return {{"shape", "box"},       {"fontname", fonts}, {"fontsize", "11"},  {"height", "0.28"},
          {"margin", "0.1,0.04"}, {"style", "filled"}, {"ordering", "out"}, {"fillcolor", "white"}};
}

DotAttributes DotLook::edges() {
  return {{"arrowsize", "0.6"}, {"fontname", fonts}, {"fontsize", "10"}};
}

DotAttributes DotLook::pale_edge() {
  return {{"color", pale}, {"style", "dashed"}};
}

std::string DotLook::guard(const Guard& it, std::size_t node, std::size_t arm) const {
  if (options_.letters) return letters_.guard(it);
  const std::string written = options_.written ? options_.written(NodeId(node), arm) : std::string();
  return wrapped(written.empty() ? guard_text(network_, it) : written);
}

DotAttributes DotLook::box(std::size_t i, const char* fill, const char* ink) const {
  const std::string text = statement_text(network_, module_, NodeId(i));
  DotAttributes look = {{"label", options_.letters ? letters_.letter(text) : wrapped(text)},
                        {"fillcolor", fill}};
  if (options_.letters)
    look.insert(look.end(), {{"shape", "circle"}, {"width", "0.34"}, {"fixedsize", "true"}});
  look.emplace_back("fontcolor", ink);
  return look;
}

DotAttributes DotLook::of(const Start&, std::size_t) const {
  return dot("circle", "0.16", "black");
}
DotAttributes DotLook::of(const End&, std::size_t) const {
  return dot("doublecircle", "0.12", "black");
}
DotAttributes DotLook::of(const WaitForStart&, std::size_t i) const {
  return box(i, message_fill);
}
DotAttributes DotLook::of(const Wait&, std::size_t i) const {
  return box(i, message_fill);
}
DotAttributes DotLook::of(const Send&, std::size_t i) const {
  return box(i, message_fill);
}
DotAttributes DotLook::of(const Complete&, std::size_t i) const {
  return box(i, message_fill);
}
DotAttributes DotLook::of(const Set&, std::size_t i) const {
  return box(i, condition_fill);
}
DotAttributes DotLook::of(const Read&, std::size_t i) const {
  return box(i, condition_fill);
}
DotAttributes DotLook::of(const Perform&, std::size_t i) const {
  return box(i, computation_fill, "white");
}
DotAttributes DotLook::of(const Execute&, std::size_t i) const {
  DotAttributes look = box(i, computation_fill, "white");
  look.emplace_back("peripheries", "2");
  return look;
}
DotAttributes DotLook::of(const Nothing&, std::size_t i) const {
  return box(i, "white");
}
DotAttributes DotLook::of(const Choose&, std::size_t) const {
  return dot("diamond", "0.26", "white");
}
DotAttributes DotLook::of(const Merge&, std::size_t) const {
  return dot("diamond", "0.14", "black");
}
DotAttributes DotLook::of(const Loop&, std::size_t) const {
  return dot("circle", "0.14", "white");
}
DotAttributes DotLook::of(const Until& until, std::size_t i) const {
  if (!until.guard) return dot("circle", "0.14", "white");
  const std::string condition = guard(*until.guard, i, 0);
  const std::string text = options_.letters ? "until " + condition : "UNTIL( " + condition + " )";
  return {{"label", text}, {"style", "filled,rounded"}, {"fillcolor", condition_fill}};
}
DotAttributes DotLook::of(const Fork&, std::size_t i) const {
  return bar(body(i).out.size());
}
DotAttributes DotLook::of(const Join&, std::size_t i) const {
  return bar(body(body(i).mate.index()).out.size());
}

/// A thick bar across the flow, with a place for each block.
DotAttributes DotLook::bar(std::size_t blocks) const {
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

}  // namespace pal::pan
