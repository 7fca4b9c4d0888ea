#include "pal/check/network/build_body.hpp"

#include <string>
#include <utility>
#include <vector>

#include "pal/support/finding.hpp"

namespace pal::check {

namespace {

/// Appends nodes in the order of the text. `open_` are the ways on that wait for their next node.
class BodyBuilder {
 public:
  BodyBuilder(pan::ModuleId module, pan::ModuleId speaker, Names& names, Diagnostics& diagnostics)
      : module_(module), speaker_(speaker), names_(names), diagnostics_(diagnostics) {}

  void build(const syntax::ModuleUnit& unit) {
    thread_names_.push_back(unit.name.text);
    append(pan::Start{}, unit.where);
    list(unit.body);
    append(pan::End{}, unit.end);
  }

  std::vector<std::string> thread_names() && { return std::move(thread_names_); }
  pan::Graph graph() && { return std::move(graph_); }

 private:
  struct Way {
    pan::NodeId from;
    std::size_t slot;
  };

  pan::Node& node(pan::NodeId id) { return graph_.nodes[id.index()]; }

  /// A node without ways on.
  pan::NodeId place(pan::Content content, SourceSpan where) {
    const pan::NodeId id(graph_.nodes.size());
    graph_.nodes.push_back({std::move(content), {}, {}, where});
    for (const auto& way : open_) node(way.from).out[way.slot] = id;
    open_.clear();
    return id;
  }

  void open(pan::NodeId from) {
    auto& out = node(from).out;
    out.emplace_back();
    open_.push_back({from, out.size() - 1});
  }

  pan::NodeId append(pan::Content content, SourceSpan where) {
    const bool ends = std::holds_alternative<pan::End>(content);
    const auto id = place(std::move(content), where);
    if (!ends) open(id);
    return id;
  }

  void list(const syntax::Statements& statements) {
    for (const auto& statement : statements) {
      std::visit([&](const auto& content) { add(content, statement); }, statement.content);
    }
  }

  // Where branches come together: their open ends, and the node.
  void merge(pan::NodeId split, std::vector<Way> ends, SourceSpan where) {
    open_ = std::move(ends);
    const auto id = append(pan::Merge{}, where);
    node(id).mate = split;
    node(split).mate = id;
  }

  /// Builds a branch of `split` and moves its open ends to `ends`.
  void branch(pan::NodeId split, const syntax::Statements& body, std::vector<Way>& ends) {
    open(split);
    list(body);
    ends.insert(ends.end(), open_.begin(), open_.end());
    open_.clear();
  }

  const std::string& name_of_speaker() const { return names_.name_of(speaker_); }

  std::optional<pan::ChannelId> incoming(const syntax::Source& source, SourceSpan where) {
    const auto message = names_.message(source.message);
    const auto from = names_.party(source.from, name_of_speaker());
    if (!message || !from) return std::nullopt;
    return names_.channel(*from, *message, speaker_, where);
  }

  void add(const syntax::WaitForStart&, const syntax::Statement& s) { append(pan::WaitForStart{}, s.where); }

  void add(const syntax::Wait& wait, const syntax::Statement& s) {
    if (const auto channel = incoming(wait.source, s.where))
      append(pan::Wait{{*channel}, std::nullopt}, s.where);
  }

  void add(const syntax::WaitBranches& wait, const syntax::Statement& s) {
    pan::Wait content;
    content.within = wait.within;
    std::vector<const syntax::WaitArm*> arms;
    for (const auto& arm : wait.arms) {
      if (const auto channel = incoming(arm.source, arm.where)) {
        check_twice(content.channels, *channel, arm, arms);
        content.channels.push_back(*channel);
        arms.push_back(&arm);
      }
    }
    if (arms.empty()) return;
    // One message and all the time there is: a plain wait, and what follows it.
    if (arms.size() == 1 && !wait.within) {
      append(std::move(content), s.where);
      list(arms.front()->body);
      return;
    }
    const auto split = place(std::move(content), s.where);
    std::vector<Way> ends;
    for (const auto* arm : arms) branch(split, arm->body, ends);
    if (wait.within) branch(split, wait.otherwise, ends);
    merge(split, std::move(ends), s.end);
  }

  void check_twice(const std::vector<pan::ChannelId>& channels, pan::ChannelId channel,
                   const syntax::WaitArm& arm, const std::vector<const syntax::WaitArm*>& arms) {
    for (std::size_t i = 0; i < channels.size(); ++i) {
      if (channels[i] != channel) continue;
      auto& finding = diagnostics_.report(Finding::taken_by_earlier_branch, arm.where);
      finding.note(arms[i]->where, Remark::taken_here);
      return;
    }
  }

  void add(const syntax::Send& send, const syntax::Statement& s) {
    const auto message = names_.message(send.message);
    const auto to = names_.party(send.to, name_of_speaker());
    if (!message || !to) return;
    append(pan::Send{names_.channel(speaker_, *message, *to, s.where)}, s.where);
  }

  void add(const syntax::Complete& complete, const syntax::Statement& s) {
    append(pan::Complete{complete.code}, s.where);
  }

  void add(const syntax::Set& set, const syntax::Statement& s) {
    if (const auto id = names_.condition(set.condition)) append(pan::Set{*id, set.value}, s.where);
  }

  void add(const syntax::Read& read, const syntax::Statement& s) {
    if (const auto id = names_.condition(read.condition)) append(pan::Read{*id}, s.where);
  }

  /// Nothing if a condition in it is unknown.
  std::optional<pan::Guard> guard(const syntax::Guard& written) {
    pan::Guard result;
    result.value = written.value;
    bool known = true;
    switch (written.kind) {
      case syntax::Guard::Kind::equals: {
        const auto id = names_.condition(written.condition);
        if (!id) return std::nullopt;
        result.condition = *id;
        return result;
      }
      case syntax::Guard::Kind::all_of:
        result.kind = pan::Guard::Kind::all_of;
        break;
      case syntax::Guard::Kind::any_of:
        result.kind = pan::Guard::Kind::any_of;
        break;
      case syntax::Guard::Kind::negation:
        result.kind = pan::Guard::Kind::negation;
        break;
    }
    for (const auto& term : written.terms) {
      auto inner = guard(term);
      if (inner) {
        result.terms.push_back(std::move(*inner));
      } else {
        known = false;
      }
    }
    if (!known) return std::nullopt;
    return result;
  }

  void add(const syntax::Choose& choose, const syntax::Statement& s) {
    const auto split = place(pan::Choose{}, s.where);
    std::vector<pan::Guard> guards;
    std::vector<Way> ends;
    for (const auto& arm : choose.arms) {
      auto holds = guard(arm.guard);
      if (!holds) continue;
      guards.push_back(std::move(*holds));
      branch(split, arm.body, ends);
    }
    std::get<pan::Choose>(node(split).content).guards = std::move(guards);
    merge(split, std::move(ends), s.end);
  }

  void add(const syntax::Repeat& repeat, const syntax::Statement& s) {
    const auto loop = append(pan::Loop{}, s.where);
    list(repeat.body);
    std::optional<pan::Guard> until;
    if (repeat.until) until = guard(*repeat.until);
    const bool forever = !repeat.until;
    const auto end = place(pan::Until{std::move(until)}, repeat.until_where);
    if (!forever) open(end);
    node(end).mate = loop;
    node(loop).mate = end;
  }

  void add(const syntax::Concurrent& concurrent, const syntax::Statement& s) {
    const auto fork = place(pan::Fork{}, s.where);
    std::vector<std::size_t> threads;
    for (const auto& block : concurrent.blocks) {
      threads.push_back(thread_names_.size());
      thread_names_.push_back(thread_names_.front() + "." + std::to_string(thread_names_.size()));
      open(fork);
      list(block.body);
      place(pan::End{}, block.where);
    }
    std::get<pan::Fork>(node(fork).content).threads = std::move(threads);
    const auto join = append(pan::Join{}, s.end);
    node(join).mate = fork;
    node(fork).mate = join;
  }

  void call(const syntax::PartyName& name, const syntax::Statement& s) {
    if (const auto called = names_.callee(name)) append(pan::Execute{*called}, s.where);
  }

  void add(const syntax::Execute& execute, const syntax::Statement& s) {
    // Execute of an activity is that activity.
    if (!execute.module.kind) {
      if (const auto id = names_.activity(execute.module.name, module_)) {
        append(pan::Perform{*id}, s.where);
        return;
      }
    }
    call(execute.module, s);
  }

  void add(const syntax::Nothing&, const syntax::Statement& s) { append(pan::Nothing{}, s.where); }

  void add(const syntax::Perform& perform, const syntax::Statement& s) {
    if (const auto id = names_.activity(perform.name, module_)) {
      append(pan::Perform{*id}, s.where);
    } else if (names_.is_module(perform.name.text)) {
      call({std::nullopt, perform.name, perform.name.where}, s);
    } else if (names_.trusting()) {
      append(pan::Perform{names_.trusted_activity(perform.name, module_)}, s.where);
    } else if (!perform.name.text.empty()) {
      names_.report_no_activity(perform.name, module_);
    }
  }

  pan::ModuleId module_;
  pan::ModuleId speaker_;
  Names& names_;
  Diagnostics& diagnostics_;
  std::vector<std::string> thread_names_;
  pan::Graph graph_;
  std::vector<Way> open_;
};

}  // namespace

void build_body(pan::ModuleId module, pan::ModuleId speaker, Names& names, pan::Network& network,
                Diagnostics& diagnostics) {
  const auto* unit = names.unit_of(module);
  if (unit == nullptr || !unit->has_body) return;
  BodyBuilder builder(module, speaker, names, diagnostics);
  builder.build(*unit);
  // Names may have entered more modules meanwhile: look the module up only now.
  auto& result = network.modules[module.index()];
  result.threads = std::move(builder).thread_names();
  result.body = std::move(builder).graph();
}

}  // namespace pal::check
