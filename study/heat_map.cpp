// The map of two figures.
#include <algorithm>
#include <vector>

#include "study/cells.hpp"
#include "study/plot_page.hpp"
#include "study/plots.hpp"

namespace pal::study {
namespace {

using analyzer::chart::Anchor;
using analyzer::chart::SvgWriter;
using analyzer::chart::text_width;

struct Field {
  Outcome outcome = Outcome::holds;
  bool any = false;
  std::vector<bool> broken;  // by pair: something does not hold
};

class Map {
 public:
  Map(const Table& table, std::size_t across, std::size_t up)
      : table_(table),
        across_(table.study.figures[across]),
        up_(table.study.figures[up]),
        columns_(across_.choices.size()),
        rows_(up_.choices.size()),
        fields_(columns_ * rows_) {
    std::vector<std::size_t> choices;
    std::uint32_t point = 0;
    for (const Row& row : table.rows) {
      if (choices.empty() || row.point != point) choices = choices_at(table.study, row.point);
      point = row.point;
      Field& field = fields_[choices[up] * columns_ + choices[across]];
      field.broken.resize(table.pairs.size());
      field.any = true;
      field.outcome = worse(field.outcome, row.outcome);
      if (row.outcome != Outcome::holds) field.broken[row.pair] = true;
    }
  }

  std::string draw() {
    place();
    out_.text({margin, margin + title_font}, Anchor::start, "title", table_.study.title);
    for (std::size_t r = 0; r < rows_; ++r)
      for (std::size_t c = 0, end = 0; c < columns_; c = end) draw_fields(c, end = end_of_run(c, r), r);
    draw_border();
    draw_axes();
    draw_legend();
    const Length width =
        std::max({x(columns_) + margin, margin * 2 + text_width(table_.study.title, title_font, true),
                  legend_end_ + margin});
    return page(width, bottom_ + 1150, out_.str());
  }

 private:
  const Field& at(std::size_t column, std::size_t row) const { return fields_[row * columns_ + column]; }
  Outcome outcome(std::size_t column, std::size_t row) const {
    const Field& field = at(column, row);
    return field.any ? field.outcome : Outcome::not_checked;
  }
  Length x(std::size_t column) const { return left_ + static_cast<Length>(column) * width_; }
  /// The first row stands at the bottom, as on any axis.
  Length y(std::size_t row) const { return bottom_ - static_cast<Length>(row) * height_; }

  void place() {
    Length widest = 0;
    for (const Choice& choice : up_.choices) widest = std::max(widest, text_width(choice.label, label_font));
    const auto room = [](Length all, std::size_t parts, Length least, Length most) {
      return std::clamp(all / static_cast<Length>(std::max<std::size_t>(parts, 1)), least, most);
    };
    width_ = room(9000, columns_, 40, 1100);
    height_ = room(6000, rows_, 40, 600);
    left_ = margin + 250 + widest + 100;
    bottom_ = margin + title_font + 250 + static_cast<Length>(rows_) * height_;
  }

  static std::string style(Outcome outcome) {
    return outcome == Outcome::not_checked ? "not-checked" : name(outcome);
  }

  /// Whether each field is large enough to be told from the next one.
  bool apart() const { return std::min(width_, height_) > 100; }

  /// The first column after `column` that is drawn by itself. Fields too small to be pointed at are drawn as
  /// one, as long as they are equal.
  std::size_t end_of_run(std::size_t column, std::size_t row) const {
    std::size_t end = column + 1;
    if (apart()) return end;
    while (end < columns_ && outcome(end, row) == outcome(column, row) &&
           at(end, row).broken == at(column, row).broken)
      ++end;
    return end;
  }

  /// Fields [from, to) of a row, which are equal.
  void draw_fields(std::size_t from, std::size_t to, std::size_t row) {
    const Field& field = at(from, row);
    const auto broken = static_cast<std::size_t>(std::count(field.broken.begin(), field.broken.end(), true));
    const std::string count = std::to_string(field.any ? table_.pairs.size() - broken : 0) + "/" +
                              std::to_string(table_.pairs.size());
    std::string title = across_.name + " = " + across_.choices[from].label;
    if (to > from + 1) title += " to " + across_.choices[to - 1].label;
    title += ", " + up_.name + " = " + up_.choices[row].label + ": " + name(outcome(from, row));
    for (std::size_t i = 0; i < field.broken.size(); ++i)
      if (field.broken[i]) title += "\nnot " + table_.pairs[i].skill + " in " + table_.pairs[i].environment;
    out_.rect({x(from), y(row) - height_, x(to), y(row)},
              (apart() ? "field " : "") + style(outcome(from, row)), title);
    if (table_.pairs.size() > 1 && text_width(count, small_font) < width_ && height_ > 150)
      out_.text({(x(from) + x(to)) / 2, y(row) - height_ / 2 + 30}, Anchor::middle, "small mid", count);
  }

  void draw_border() {
    std::string border;
    for (std::size_t r = 0; r < rows_; ++r) {
      for (std::size_t c = 0; c < columns_; ++c) {
        using analyzer::chart::line_to;
        using analyzer::chart::move_to;
        if (c + 1 < columns_ && outcome(c, r) != outcome(c + 1, r))
          border += move_to({x(c + 1), y(r)}) + line_to({x(c + 1), y(r) - height_});
        if (r + 1 < rows_ && outcome(c, r) != outcome(c, r + 1))
          border += move_to({x(c), y(r) - height_}) + line_to({x(c) + width_, y(r) - height_});
      }
    }
    if (!border.empty()) out_.path(border, "border");
  }

  void draw_axes() {
    const auto columns = labels_of(across_);
    const std::size_t stride = label_stride(columns, width_);
    for (std::size_t c = 0; c < columns_; c += stride)
      out_.text({x(c) + width_ / 2, bottom_ + 160}, Anchor::middle, "mid", columns[c]);
    const auto rows = labels_of(up_);
    const auto row_stride = static_cast<std::size_t>(label_font * 3 / 2 / height_) + 1;
    for (std::size_t r = 0; r < rows_; r += row_stride)
      out_.text({left_ - 80, y(r) - height_ / 2 + 35}, Anchor::end, "end", rows[r]);
    out_.text({(x(0) + x(columns_)) / 2, bottom_ + 380}, Anchor::middle, "axis-name mid", across_.name);
    out_.upright({margin + 100, (y(0) + y(rows_)) / 2}, "axis-name mid", up_.name);
  }

  void draw_legend() {
    const bool many = table_.pairs.size() > 1;
    const bool others = table_.study.figures.size() > 2;
    Length at = left_;
    const Length line = bottom_ + 600;
    for (const Outcome each :
         {Outcome::holds, Outcome::fails, Outcome::undecided, Outcome::never, Outcome::not_checked}) {
      bool drawn = false;
      for (std::size_t r = 0; r < rows_ && !drawn; ++r)
        for (std::size_t c = 0; c < columns_ && !drawn; ++c) drawn = outcome(c, r) == each;
      if (!drawn) continue;
      const std::string text = each == Outcome::holds       ? "everything holds"
                               : each == Outcome::fails     ? "something fails"
                               : each == Outcome::undecided ? "something is undecided"
                               : each == Outcome::never     ? "something is never measured"
                                                            : "something was not checked";
      out_.rect({at, line - 90, at + 160, line + 30}, style(each));
      out_.text({at + 220, line}, Anchor::start, "label", text);
      at += 220 + text_width(text, label_font) + 300;
    }
    legend_end_ = at;
    std::string note =
        many ? "A field says how many of " + std::to_string(table_.pairs.size()) + " skills hold." : "";
    if (others)
      note += std::string(note.empty() ? "" : " ") +
              "It counts only if it does for all values of the other figures.";
    if (note.empty()) return;
    out_.text({left_, line + 250}, Anchor::start, "small", note);
    legend_end_ = std::max(legend_end_, left_ + text_width(note, small_font));
  }

  const Table& table_;
  const Figure& across_;
  const Figure& up_;
  std::size_t columns_;
  std::size_t rows_;
  std::vector<Field> fields_;
  SvgWriter out_;
  Length left_ = 0, bottom_ = 0, width_ = 0, height_ = 0, legend_end_ = 0;
};

}  // namespace

std::string heat_map(const Table& table, std::size_t across, std::size_t up) {
  return Map(table, across, up).draw();
}

}  // namespace pal::study
