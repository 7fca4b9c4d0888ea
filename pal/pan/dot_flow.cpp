#include "pal/pan/dot_flow.hpp"

#include <variant>

namespace pal::pan {

namespace {

template <class Kind>
bool is(const Node& node) {
  return std::holds_alternative<Kind>(node.content);
}

bool splits(const Node& node) {
  return is<Choose>(node) || is<Fork>(node) || (is<Wait>(node) && node.mate.valid());
}

}  // namespace

DotFlow::DotFlow(const Graph& body)
    : body_(body),
      ends_(body.nodes.size()),
      meets_(body.nodes.size()),
      reached_(body.nodes.size(), false),
      columns_(body.nodes.size(), 0) {
  find_ends();
  find_reached();
  find_columns();
}

void DotFlow::find_ends() {
  for (std::size_t i = 0; i < body_.nodes.size(); ++i) {
    const Node& node = body_.nodes[i];
    for (std::size_t way = 0; splits(node) && way < node.out.size(); ++way) {
      if (!is<Fork>(node)) {
        if (way > 0 && node.out[way] != node.mate) meets_[node.out[way].index()] = node.mate;
        continue;
      }
      // A block reaches from its first node to the End before the next block, or before the Join.
      const NodeId next = way + 1 < node.out.size() ? node.out[way + 1] : node.mate;
      ends_[next.index() - 1] = Block{i, way};
    }
  }
}

void DotFlow::find_reached() {
  if (body_.nodes.empty()) return;
  reached_[0] = true;
  // Every way but the one from UNTIL to REPEAT leads on in the text.
  for (std::size_t i = 0; i < body_.nodes.size(); ++i) {
    if (!reached_[i]) continue;
    for (const NodeId next : body_.nodes[i].out) reached_[next.index()] = true;
    if (is<Fork>(body_.nodes[i])) reached_[body_.nodes[i].mate.index()] = true;
  }
  // What only leads to the end of the module is no statement.
  std::vector<bool> only_ends(body_.nodes.size(), false);
  only_ends.back() = true;
  for (std::size_t i = body_.nodes.size(); i-- > 0;) {
    const Node& node = body_.nodes[i];
    if (is<Merge>(node) && only_ends[node.out.front().index()]) only_ends[i] = true;
    if (!reached_[i] && !only_ends[i] && !is<End>(node)) whole_ = true;
  }
}

void DotFlow::find_columns() {
  std::size_t columns = 1;
  for (std::size_t i = 0; i < body_.nodes.size(); ++i) {
    const Node& node = body_.nodes[i];
    if (splits(node)) columns_[node.mate.index()] = columns_[i];
    for (const NodeId next : node.out) {
      if (!is<Merge>(body_.nodes[next.index()]))
        columns_[next.index()] = splits(node) ? columns++ : columns_[i];
    }
    if (!goes_on_forever(i)) continue;
    const std::size_t next = next_in_text(i);
    if (!is<Merge>(body_.nodes[next])) columns_[next] = columns_[i];
  }
}

bool DotFlow::goes_on_forever(std::size_t node) const {
  const auto* until = std::get_if<Until>(&body_.nodes[node].content);
  return until != nullptr && !until->guard;
}

std::size_t DotFlow::next_in_text(std::size_t until) const {
  const NodeId meets = meets_[until + 1];
  return meets.valid() ? meets.index() : until + 1;
}

std::optional<std::size_t> DotFlow::behind(std::size_t until) const {
  if (!goes_on_forever(until)) return std::nullopt;
  const std::size_t next = next_in_text(until);
  if (!drawn(next) && !ends_[next]) return std::nullopt;
  return next;
}

}  // namespace pal::pan
