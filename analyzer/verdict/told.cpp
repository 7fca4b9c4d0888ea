#include "analyzer/verdict/told.hpp"

namespace pal::analyzer {

Told Told::line(std::string file, int number) {
  Told told;
  told.pieces_.push_back({{}, std::move(file), number});
  return told;
}

std::string Told::text() const {
  std::string text;
  for (const Piece& piece : pieces_) {
    text += piece.text;
    if (piece.line != 0) text += std::to_string(piece.line);
  }
  return text;
}

Told& Told::operator+=(const Told& more) {
  pieces_.insert(pieces_.end(), more.pieces_.begin(), more.pieces_.end());
  return *this;
}

std::optional<Told> Told::with_lines(
    const std::function<bool(const std::string& file, int& line)>& move) const {
  Told moved = *this;
  for (Piece& piece : moved.pieces_) {
    if (piece.line != 0 && !move(piece.file, piece.line)) return std::nullopt;
  }
  return moved;
}

}  // namespace pal::analyzer
