#include "pal/support/source.hpp"

#include <algorithm>
#include <utility>

#include "pal/support/utf8.hpp"

namespace pal {

FileId SourceManager::add(std::string name, std::string text) {
  File file{std::move(name), std::move(text), {0}};
  for (std::size_t at = file.text.find('\n'); at != std::string::npos; at = file.text.find('\n', at + 1)) {
    file.line_starts.push_back(static_cast<std::uint32_t>(at + 1));
  }
  files_.push_back(std::move(file));
  return FileId(files_.size() - 1);
}

std::optional<FileId> SourceManager::find(std::string_view name) const {
  const auto found =
      std::find_if(files_.begin(), files_.end(), [&](const File& f) { return f.name == name; });
  if (found == files_.end()) return std::nullopt;
  return FileId(static_cast<std::size_t>(found - files_.begin()));
}

const std::string& SourceManager::name(FileId file) const {
  return files_.at(file.index()).name;
}

std::string_view SourceManager::text(FileId file) const {
  return files_.at(file.index()).text;
}

std::string_view SourceManager::text(SourceSpan span) const {
  const auto whole = text(span.file);
  const auto begin = std::min<std::size_t>(span.begin, whole.size());
  const auto end = std::clamp<std::size_t>(span.end, begin, whole.size());
  return whole.substr(begin, end - begin);
}

LineColumn SourceManager::line_column(FileId file, std::uint32_t offset) const {
  const auto& f = files_.at(file.index());
  const auto bounded = std::min<std::size_t>(offset, f.text.size());
  const auto after = std::upper_bound(f.line_starts.begin(), f.line_starts.end(), bounded);
  const auto line = after - f.line_starts.begin();
  const std::size_t start = *(after - 1);
  auto before = std::string_view(f.text).substr(start, bounded - start);
  // A byte order mark is no character of the text.
  if (start == 0 && before.starts_with("\xEF\xBB\xBF")) before.remove_prefix(3);
  return {static_cast<int>(line), static_cast<int>(utf8::length(before)) + 1};
}

std::string_view SourceManager::line_text(FileId file, int line) const {
  const auto& f = files_.at(file.index());
  if (line < 1 || static_cast<std::size_t>(line) > f.line_starts.size()) return {};
  const std::size_t begin = f.line_starts[static_cast<std::size_t>(line) - 1];
  auto end = f.text.find('\n', begin);
  if (end == std::string::npos) end = f.text.size();
  if (end > begin && f.text[end - 1] == '\r') --end;
  return std::string_view(f.text).substr(begin, end - begin);
}

}  // namespace pal
