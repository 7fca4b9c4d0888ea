// The only file that knows Graphviz.
#include <graphviz/gvc.h>

#include <functional>
#include <memory>
#include <mutex>
#include <stdexcept>

#include "pal/pan/dot.hpp"

namespace pal::pan {

namespace {

struct CloseContext {
  void operator()(GVC_t* context) const { gvFreeContext(context); }
};
struct CloseGraph {
  void operator()(Agraph_t* graph) const { agclose(graph); }
};

[[noreturn]] void fail(const std::string& what) {
  const char* reason = aglasterr();
  std::string text = reason == nullptr ? "" : reason;
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  throw std::runtime_error(text.empty() ? what : what + ": " + text);
}

/// Calls `use` with the graph, laid out; Graphviz keeps its complaints meanwhile. It is no template: all uses
/// share one mutex and one context.
void with_layout(const std::string& dot, const std::function<void(GVC_t*, Agraph_t*)>& use) {
  // Graphviz has globals, and draws in one thread at a time.
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  // It prints its complaints unless it is told to keep them.
  const agerrlevel_t before = agseterr(AGMAX);
  struct Restore {
    agerrlevel_t level;
    ~Restore() { agseterr(level); }
  } restore{before};
  agreseterrors();

  // One for all drawings: Graphviz's measuring of texts keeps a pointer to the last font's name, which is the
  // context's.
  static const std::unique_ptr<GVC_t, CloseContext> context(gvContext());
  if (!context) fail("Graphviz cannot start");
  const std::unique_ptr<Agraph_t, CloseGraph> graph(agmemread(dot.c_str()));
  if (!graph) fail("the graph is not DOT");
  if (gvLayout(context.get(), graph.get(), "dot") != 0) fail("the graph cannot be laid out");
  struct FreeLayout {
    GVC_t* context;
    Agraph_t* graph;
    ~FreeLayout() { gvFreeLayout(context, graph); }
  } free_layout{context.get(), graph.get()};
  use(context.get(), graph.get());
}

}  // namespace

std::string svg(const std::string& dot) {
  std::string result;
  with_layout(dot, [&result](GVC_t* context, Agraph_t* graph) {
    char* data = nullptr;
    unsigned length = 0;
    const int failed = gvRenderData(context, graph, "svg", &data, &length);
    if (failed == 0 && data != nullptr) result.assign(data, length);
    if (data != nullptr) gvFreeRenderData(data);
    // Some errors, such as a label that is no table, only leave their part of the picture out.
    if (failed != 0 || result.empty() || agerrors() >= AGERR) fail("the graph cannot be drawn");
  });
  return result;
}

std::vector<DotPlace> lay_out(const std::string& dot) {
  std::vector<DotPlace> result;
  with_layout(dot, [&result](GVC_t*, Agraph_t* graph) {
    const double top = GD_bb(graph).UR.y;
    for (Agnode_t* node = agfstnode(graph); node != nullptr; node = agnxtnode(graph, node))
      result.push_back({agnameof(node), ND_coord(node).x, top - ND_coord(node).y});
  });
  return result;
}

}  // namespace pal::pan
