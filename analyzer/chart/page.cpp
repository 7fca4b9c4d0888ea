#include "analyzer/chart/page.hpp"

#include "analyzer/chart/detail.hpp"
#include "analyzer/chart/legend.hpp"
#include "analyzer/chart/margin.hpp"
#include "analyzer/chart/panel.hpp"
#include "analyzer/chart/promises.hpp"
#include "analyzer/chart/svg_style.hpp"
#include "pal/support/xml.hpp"

namespace pal::analyzer::chart {

namespace {

constexpr Length beyond_right = 150;
/// A picture of more bytes is drawn again, with more actions in one block.
constexpr std::size_t most_bytes = 200'000;

std::string document(const std::string& body, Length page_width, Length height,
                     const std::vector<std::string>& caption, bool crowds) {
  const std::string width = std::to_string(page_width / 10);
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  text += "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" +
          std::to_string(height / 10) + "\" viewBox=\"0 0 " + std::to_string(page_width) + " " +
          std::to_string(height) + "\" role=\"img\">\n";
  text += "<title>" + xml_escaped(caption.front()) + "</title>\n<desc>";
  for (std::size_t i = 1; i < caption.size(); ++i) text += (i > 1 ? "\n" : "") + xml_escaped(caption[i]);
  text += "</desc>\n";
  text += style_sheet;
  if (crowds) text += "<style>.crowd { fill: #8a8a8a } .crowd.backdrop { fill: #ddd }</style>\n";
  text += "<rect width=\"" + std::to_string(page_width) + "\" height=\"" + std::to_string(height) +
          "\" class=\"paper\"/>\n";
  return text + body + "</svg>\n";
}

/// `crowd`: how wide bars are that are drawn as one block, where they are not enlarged.
std::string drawn(const std::vector<Layer>& layers, Length crowd) {
  SvgWriter out;
  const bool both = layers.size() > 1;
  const Window window = overview_window(layers);
  const Margin margin = margin_for(layers);
  const Length right = panel_right(layers);
  const TimeScale overview({window}, margin.left, right, fold_width);
  std::vector<Window> details;
  if (layers.front().options->detail) {
    details = detail_windows(layers, window, right - margin.left, fold_width);
  }
  Length y = draw_caption(layers, 0, out);
  Numbering numbering;
  if (details.empty()) {
    numbering = Numbering(layers, overview);
    y = Panel(layers, overview, {true, both, margin, crowd}, numbering, 0, {}, y, out).draw();
  } else {
    const TimeScale detail(details, margin.left, right, fold_width);
    numbering = Numbering(layers, detail);
    y = Panel(layers, overview, {false, both, margin, crowd}, numbering, 0, details, y, out).draw();
    y = draw_panel_heading("Enlarged: where the axis above is thick", y, out);
    y = Panel(layers, detail, {true, both, margin}, numbering, 0, {}, y, out).draw();
  }
  y = draw_promise_list(layers, y, out);
  y = draw_explanation(layers, y, out);
  y = draw_statement_key(numbering, right, y, out);
  y = draw_sign_key(layers, y, out);
  return document(out.str(), right + beyond_right, (y + 9) / 10 * 10, caption_lines(layers),
                  out.has_drawn("crowd"));
}

}  // namespace

std::string page(const std::vector<Layer>& layers) {
  std::string picture = drawn(layers, 0);
  // Who asks for ids wants to find each bar.
  if (layers.front().options->ids) return picture;
  for (Length crowd = 30; picture.size() > most_bytes && crowd <= 1000; crowd *= 2)
    picture = drawn(layers, crowd);
  return picture;
}

}  // namespace pal::analyzer::chart
