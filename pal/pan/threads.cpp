#include "pal/pan/threads.hpp"

#include <algorithm>
#include <deque>
#include <set>
#include <utility>

namespace pal::pan {

namespace {

class Finder {
 public:
  Finder(const Network& network, std::size_t most) : network_(network), most_(most) {}

  std::vector<SkillThread> find() {
    for (std::size_t m = 0; m < network_.modules.size(); ++m) {
      const Module& module = network_.modules[m];
      if (module.body.empty() || module.executed_by.valid()) continue;
      threads_.push_back({module.name, ModuleId(m), 0, {}, {}});
      enter(ModuleId(m), threads_.size() - 1);
    }
    while (!open_.empty() && threads_.size() <= most_) {
      const Body body = open_.front();
      open_.pop_front();
      walk(body);
    }
    return std::move(threads_);
  }

 private:
  /// The nodes of a body, or of a block: they stand together, in the order of the text.
  struct Body {
    ModuleId module;
    std::size_t begin;
    std::size_t end;
    std::size_t thread;
    std::size_t runner;
  };

  void enter(ModuleId module, std::size_t thread) {
    const std::size_t nodes = network_.modules[module.index()].body.nodes.size();
    if (entered_.emplace(module, thread).second) open_.push_back({module, 0, nodes, thread, thread});
  }

  void walk(const Body& body) {
    const auto& nodes = network_.modules[body.module.index()].body.nodes;
    for (std::size_t n = body.begin; n < body.end && threads_.size() <= most_; ++n) {
      if (const auto* fork = std::get_if<Fork>(&nodes[n].content)) {
        begin_blocks(body, nodes[n], *fork);
        n = nodes[n].mate.index();
      } else if (const auto* execute = std::get_if<Execute>(&nodes[n].content)) {
        enter(execute->module, body.thread);
      }
    }
  }

  void begin_blocks(const Body& body, const Node& here, const Fork& fork) {
    const Module& module = network_.modules[body.module.index()];
    for (std::size_t i = 0; i < fork.threads.size(); ++i) {
      const SkillThread& runner = threads_[body.runner];
      std::string name = block_name(runner.name, runner.parent.has_value(), module.threads[fork.threads[i]]);
      const std::size_t end = i + 1 < here.out.size() ? here.out[i + 1].index() : here.mate.index();
      threads_.push_back({std::move(name), body.module, fork.threads[i], body.thread, body.runner});
      open_.push_back({body.module, here.out[i].index(), end, threads_.size() - 1, body.runner});
    }
  }

  const Network& network_;
  std::size_t most_;
  std::vector<SkillThread> threads_;
  std::set<std::pair<ModuleId, std::size_t>> entered_;
  std::deque<Body> open_;
};

const Placement* placement_of(const Environment& environment, const std::string& thread) {
  const auto found = std::find_if(environment.placements.begin(), environment.placements.end(),
                                  [&](const Placement& each) { return each.thread == thread; });
  return found == environment.placements.end() ? nullptr : &*found;
}

}  // namespace

std::string block_name(const std::string& runner, bool runner_is_block, const std::string& text) {
  return runner_is_block ? runner + "/" + text : text;
}

std::vector<SkillThread> threads_of(const Network& network, std::size_t most) {
  return Finder(network, most).find();
}

std::string module_of_thread(const std::string& name) {
  const auto slash = name.rfind('/');
  const std::string last = slash == std::string::npos ? name : name.substr(slash + 1);
  return last.substr(0, last.find('.'));
}

const Placement* place_of(const Environment& environment, const std::string& thread) {
  std::string name = thread;
  for (;;) {
    if (const Placement* found = placement_of(environment, name)) return found;
    const auto slash = name.find('/');
    if (slash == std::string::npos) return nullptr;
    name.erase(0, slash + 1);
  }
}

}  // namespace pal::pan
