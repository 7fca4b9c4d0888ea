#include "pal/syntax/parse.hpp"

#include "pal/syntax/build.hpp"
#include "pal/syntax/reading.hpp"

namespace pal::syntax {

Tree parse(const SourceManager& sources, FileId file, Diagnostics& diagnostics) {
  const Reading reading(file, sources.text(file), diagnostics);
  if (reading.root() == nullptr) return {file, false, {}};
  auto tree = Builder(reading.tokens(), diagnostics).build(reading.root());
  tree.complete = reading.complete();
  return tree;
}

}  // namespace pal::syntax
