// The template of a skill as a document, whatever it is written in.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "pal/pan/network.hpp"
#include "pal/support/source.hpp"

namespace pal::doc {

/// A piece of text; `is_code`: it stands in the program in these words.
struct Span {
  std::string text;
  bool is_code = false;
};
using Line = std::vector<Span>;

struct Paragraphs {
  std::vector<Line> lines;
};
struct Items {
  std::vector<Line> lines;
};
struct Table {
  std::vector<std::string> heads;
  std::vector<std::vector<Line>> rows;  // each as long as the heads
};
/// A module's Process Activity Network.
struct Picture {
  std::string title;
  std::string file;  // what `pal pan` calls it
  std::string dot;
};
using Block = std::variant<Paragraphs, Items, Table, Picture>;

/// One slot of a template.
struct Section {
  std::string title;
  std::vector<Block> blocks;  // none: the slot is empty
};
struct Part {
  std::string title;
  std::vector<Section> sections;
};
struct Document {
  std::string title;
  std::vector<Part> parts;
};

/// The generic skill template in the order of the thesis, figure 2.3. Then come the requirements and what the
/// programmers need, the templates of the logical sensors (section 2.3.5), and the Process Activity Networks.
/// Requirements stand as they are written in `sources`. The same network gives the same document.
Document document(const pan::Network& network, const SourceManager& sources);

/// Text for people to read or to publish. All that comes from the program is escaped.
std::string markdown(const Document& document);
std::string markdown(const Line& line);

/// A page that needs no other file: styles and drawings are in it. It prints on A4.
std::string html(const std::vector<Document>& documents);

}  // namespace pal::doc
