// The look of the nodes of a PAN (thesis, figure 3.4): attributes that only change the picture.
#pragma once

#include "pal/pan/dot.hpp"
#include "pal/pan/dot_attributes.hpp"
#include "pal/pan/dot_letters.hpp"
#include "pal/pan/network.hpp"

namespace pal::pan {

class DotLook {
 public:
  DotLook(const Network& network, ModuleId module, const DotOptions& options)
      : network_(network), module_(module), options_(options), letters_(network, module) {}

  /// Of a node; pale if no flow reaches it.
  DotAttributes node(std::size_t node, bool reached) const;
  /// Of the condition that an arm of a CASE begins with.
  DotAttributes arm(std::size_t node, std::size_t arm, bool reached) const;
  /// Of the graph, with its title, and the key to letters if there are any.
  DotAttributes graph() const;
  /// What nodes and edges have in common.
  static DotAttributes nodes();
  static DotAttributes edges();
  static DotAttributes pale_edge();

 private:
  DotAttributes of(const Start&, std::size_t) const;
  DotAttributes of(const End&, std::size_t) const;
  DotAttributes of(const WaitForStart&, std::size_t i) const;
  DotAttributes of(const Wait&, std::size_t i) const;
  DotAttributes of(const Send&, std::size_t i) const;
  DotAttributes of(const Complete&, std::size_t i) const;
  DotAttributes of(const Set&, std::size_t i) const;
  DotAttributes of(const Read&, std::size_t i) const;
  DotAttributes of(const Perform&, std::size_t i) const;
  DotAttributes of(const Execute&, std::size_t i) const;
  DotAttributes of(const Nothing&, std::size_t i) const;
  DotAttributes of(const Choose&, std::size_t) const;
  DotAttributes of(const Merge&, std::size_t) const;
  DotAttributes of(const Loop&, std::size_t) const;
  DotAttributes of(const Until& until, std::size_t i) const;
  DotAttributes of(const Fork&, std::size_t i) const;
  DotAttributes of(const Join&, std::size_t i) const;

  DotAttributes box(std::size_t i, const char* fill, const char* ink = "black") const;
  DotAttributes bar(std::size_t blocks) const;
  std::string guard(const Guard& it, std::size_t node, std::size_t arm) const;
  std::string sign_rows(std::size_t columns) const;
  std::string signs(const std::string& title) const;
  bool downwards() const { return options_.direction == DotOptions::Direction::top_down; }
  const Node& body(std::size_t i) const { return network_.modules[module_.index()].body.nodes[i]; }

  const Network& network_;
  ModuleId module_;
  DotOptions options_;
  DotLetters letters_;
};

}  // namespace pal::pan
