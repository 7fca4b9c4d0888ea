// The only file that knows Graphviz.
#include <graphviz/gvc.h>

#include <memory>
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

}  // namespace

std::string svg(const std::string& dot) {
  // Graphviz prints its complaints unless it is told to keep them.
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
  char* data = nullptr;
  unsigned length = 0;
  const int failed = gvRenderData(context.get(), graph.get(), "svg", &data, &length);
  std::string result = failed == 0 && data != nullptr ? std::string(data, length) : std::string();
  if (data != nullptr) gvFreeRenderData(data);
  gvFreeLayout(context.get(), graph.get());
  // Some errors, such as a label that is no table, only leave their part of the picture out.
  if (failed != 0 || result.empty() || agerrors() >= AGERR) fail("the graph cannot be drawn");
  return result;
}

}  // namespace pal::pan
