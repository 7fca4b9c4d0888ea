#include "study/plot_page.hpp"

#include <algorithm>

#include "study/plots.hpp"

namespace pal::study {
namespace {

// Colours are those of Okabe and Ito, as in charts. Hatching tells apart what colours alone would.
constexpr const char* style = R"svg(<style>
text { font-family: "DejaVu Sans", Verdana, sans-serif; font-size: 100px; fill: #000 }
.mid { text-anchor: middle } .end { text-anchor: end }
.title { font-size: 150px; font-weight: bold } .axis-name { font-size: 110px; font-weight: bold } .small { font-size: 85px }
.paper { fill: #fff } .axis { stroke: #000; stroke-width: 10px; fill: none } .grid { stroke: #ddd; stroke-width: 6px }
.limit { stroke: #000; stroke-width: 16px; stroke-dasharray: 60 30 } .late { fill: #f6d9cb }
.field { stroke: #fff; stroke-width: 6px } .border { stroke: #000; stroke-width: 28px; stroke-linecap: square; fill: none }
.holds { fill: #7cc8ae } .fails { fill: #e8966a } .undecided { fill: url(#undecided) } .never { fill: url(#never) } .not-checked { fill: url(#not-checked) }
.curve { fill: none; stroke-width: 22px } .mark { stroke-width: 14px; fill: #fff } .cross { stroke-width: 22px; fill: none }
.c0 { stroke: #0072b2 } .c1 { stroke: #d55e00 } .c2 { stroke: #009e73 } .c3 { stroke: #cc79a7 } .c4 { stroke: #e69f00 } .c5 { stroke: #56b4e9 } .c6 { stroke: #000 } .c7 { stroke: #8a7f00 }
.d1 { stroke-dasharray: 70 35 } .d2 { stroke-dasharray: 20 30 } .d3 { stroke-dasharray: 90 30 20 30 }
</style>
<defs>
<pattern id="undecided" width="120" height="120" patternUnits="userSpaceOnUse" patternTransform="rotate(45)"><rect width="120" height="120" fill="#f7efb0"/><rect width="30" height="120" fill="#c9b400"/></pattern>
<pattern id="never" width="120" height="120" patternUnits="userSpaceOnUse"><rect width="120" height="120" fill="#eee"/><circle cx="60" cy="60" r="16" fill="#888"/></pattern>
<pattern id="not-checked" width="120" height="120" patternUnits="userSpaceOnUse" patternTransform="rotate(-45)"><rect width="120" height="120" fill="#ddd"/><rect width="30" height="120" fill="#999"/></pattern>
</defs>
)svg";

/// Letters that every file system and every address of the Web takes.
std::string plain(const std::string& text) {
  std::string made;
  for (const char c : text) {
    const bool keeps = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.';
    if (keeps) {
      made += c;
    } else if (!made.empty() && made.back() != '-') {
      made += '-';
    }
  }
  while (!made.empty() && made.back() == '-') made.pop_back();
  return made.empty() ? "figure" : made;
}

}  // namespace

std::string page(Length width, Length height, const std::string& drawn) {
  const std::string w = std::to_string(width), h = std::to_string(height);
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + std::to_string(width / 10) + "\" height=\"" +
         std::to_string(height / 10) + "\" viewBox=\"0 0 " + w + " " + h + "\">\n" + style +
         "<rect class=\"paper\" width=\"" + w + "\" height=\"" + h + "\"/>\n" + drawn + "</svg>\n";
}

std::size_t label_stride(const std::vector<std::string>& labels, Length step) {
  Length widest = label_font;
  for (const std::string& label : labels)
    widest = std::max(widest, analyzer::chart::text_width(label, label_font));
  return static_cast<std::size_t>((widest + label_font) / std::max<Length>(step, 1)) + 1;
}

std::vector<std::string> labels_of(const Figure& figure) {
  std::vector<std::string> labels;
  for (const Choice& choice : figure.choices) labels.push_back(choice.label);
  return labels;
}

std::string plot_name(const Study& study, const PlotWish& plot) {
  std::string name = plot.over.size() == 1 ? "slack-over" : "map-of";
  for (std::size_t i = 0; i < plot.over.size(); ++i)
    name += (i == 0 ? "-" : "-and-") + plain(study.figures[plot.over[i]].name);
  return name + ".svg";
}

std::string draw(const Table& table, const PlotWish& plot) {
  return plot.over.size() == 1 ? slack_plot(table, plot.over[0])
                               : heat_map(table, plot.over[0], plot.over[1]);
}

}  // namespace pal::study
