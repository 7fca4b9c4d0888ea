// From names to declarations and uses.
#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "language_server/session.hpp"
#include "pal/syntax/text_tokens.hpp"

namespace pal::language_server {

namespace {

using PlaceOfName = std::tuple<FileId, std::uint32_t, std::uint32_t>;

PlaceOfName key(const SourceSpan& where) {
  return {where.file, where.begin, where.end};
}

bool is_number(check::SymbolKind kind) {
  return kind == check::SymbolKind::contingency || kind == check::SymbolKind::completion;
}

/// A word that can name something: no keyword that is reserved.
bool may_name(const std::string& name) {
  const auto tokens = syntax::text_tokens(name);
  using Kind = syntax::TextToken::Kind;
  return tokens.size() == 1 && tokens.front().begin == 0 && tokens.front().end == name.size() &&
         (tokens.front().kind == Kind::name || tokens.front().kind == Kind::contextual);
}

}  // namespace

std::vector<std::size_t> Session::symbols_at(const Place& place, std::shared_ptr<const Family>& family) {
  family = index_.family(place.path);
  std::vector<std::size_t> result;
  for (const auto* use : family->symbols.at(index_.id(place.path), place.offset)) {
    if (std::find(result.begin(), result.end(), use->symbol) == result.end()) result.push_back(use->symbol);
  }
  return result;
}

Json Session::definition(const Json& params) {
  const auto place = place_in(params);
  std::shared_ptr<const Family> family;
  Json result = Json::array();
  for (const std::size_t symbol : symbols_at(place, family))
    result.push_back(location(family->symbols.all[symbol].name_where));
  if (!result.empty()) return result;
  // The file that a USES names.
  const auto* tree = index_.tree(place.path);
  for (std::size_t i = 0; tree != nullptr && i < tree->units.size(); ++i) {
    const auto* uses = std::get_if<syntax::Uses>(&tree->units[i]);
    if (uses == nullptr || place.offset < uses->where.begin || place.offset > uses->where.end) continue;
    const auto used = resolve_path(place.path, uses->path);
    if (workspace_.text(used) != nullptr)
      result.push_back({{"uri", workspace_.uri(used)}, {"range", range_of(Text(), 0, 0)}});
  }
  return result;
}

/// Where a file is used by others that the first family does not have, their families count, too.
std::vector<SourceSpan> Session::uses_of(const Place& place, bool declarations) {
  std::set<PlaceOfName> declared;  // the declarations that are meant
  std::map<PlaceOfName, SourceSpan> found;
  std::set<std::string> looked_at;
  std::vector<std::string> open{place.path};
  std::shared_ptr<const Family> first;
  for (const std::size_t symbol : symbols_at(place, first)) {
    const auto& where = first->symbols.all[symbol].name_where;
    declared.insert(key(where));
    open.push_back(index_.path(where.file));
  }
  if (declared.empty()) return {};
  while (!open.empty()) {
    const std::string path = open.back();
    open.pop_back();
    if (!looked_at.insert(path).second) continue;
    const auto family = index_.family(path);
    for (const auto& use : family->symbols.uses) {
      const auto& symbol = family->symbols.all[use.symbol];
      if (!declared.contains(key(symbol.name_where))) continue;
      const bool is_declaration = use.role == check::UseRole::declaration;
      if (declarations || !is_declaration) found.emplace(key(use.where), use.where);
    }
  }
  std::vector<SourceSpan> result;
  for (const auto& [place_of_name, where] : found) result.push_back(where);
  return result;
}

Json Session::references(const Json& params) {
  Json result = Json::array();
  const bool declarations = flag_of(member(params, "context"), "includeDeclaration", true);
  for (const auto& where : uses_of(place_in(params), declarations)) result.push_back(location(where));
  return result;
}

Json Session::document_highlight(const Json& params) {
  const auto place = place_in(params);
  std::shared_ptr<const Family> family;
  const auto symbols = symbols_at(place, family);
  const FileId file = index_.id(place.path);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> kinds;
  for (const auto& use : family->symbols.uses) {
    if (use.where.file != file || std::find(symbols.begin(), symbols.end(), use.symbol) == symbols.end()) continue;
    kinds[{use.where.begin, use.where.end}] = use.role == check::UseRole::read    ? 2
                                              : use.role == check::UseRole::write ? 3
                                                                                  : 1;
  }
  Json result = Json::array();
  for (const auto& [span, kind] : kinds)
    result.push_back({{"range", range_of(*place.text, span.first, span.second)}, {"kind", kind}});
  return result;
}

Json Session::prepare_rename(const Json& params) {
  const auto place = place_in(params);
  std::shared_ptr<const Family> family = index_.family(place.path);
  for (const auto* use : family->symbols.at(index_.id(place.path), place.offset)) {
    const auto& symbol = family->symbols.all[use->symbol];
    if (is_number(symbol.kind)) throw Refusal{request_failed, "a number is no name"};
    return {{"range", range_of(*place.text, use->where.begin, use->where.end)}, {"placeholder", symbol.name}};
  }
  throw Refusal{request_failed, "there is no name here that is declared"};
}

Json Session::rename(const Json& params) {
  const auto place = place_in(params);
  const std::string name = string_of(params, "newName");
  if (!may_name(name))
    throw Refusal{invalid_params, "'" + name + "' is no name: letters, digits, _ and - between them; no keyword"};
  std::shared_ptr<const Family> first;
  std::set<PlaceOfName> declared;
  std::set<std::string> files;
  for (const std::size_t symbol : symbols_at(place, first)) {
    if (is_number(first->symbols.all[symbol].kind)) throw Refusal{request_failed, "a number is no name"};
    declared.insert(key(first->symbols.all[symbol].name_where));
  }
  if (declared.empty()) throw Refusal{request_failed, "there is no name here that is declared"};
  // A place that means several declarations, in several skills, joins them: all are renamed, or none.
  std::map<PlaceOfName, SourceSpan> places;
  for (std::size_t before = 0; before != declared.size();) {
    before = declared.size();
    std::set<std::string> open;
    for (const auto& each : declared) open.insert(index_.path(std::get<0>(each)));
    for (const auto& [at, where] : places) open.insert(index_.path(where.file));
    open.insert(place.path);
    for (const auto& path : open) {
      const auto family = index_.family(path);
      for (const auto& use : family->symbols.uses) {
        if (declared.contains(key(family->symbols.all[use.symbol].name_where))) places.emplace(key(use.where), use.where);
      }
      for (const auto& use : family->symbols.uses) {
        if (places.contains(key(use.where))) declared.insert(key(family->symbols.all[use.symbol].name_where));
      }
      // What has the new name already, and the same sort and owner, would become the same.
      for (const auto& symbol : family->symbols.all) {
        if (!declared.contains(key(symbol.name_where))) continue;
        for (const auto& other : family->symbols.all) {
          const bool one_sort = other.kind == symbol.kind ||
                                (other.kind == check::SymbolKind::device && symbol.kind == check::SymbolKind::module) ||
                                (other.kind == check::SymbolKind::module && symbol.kind == check::SymbolKind::device);
          if (other.name == name && one_sort && other.owner == symbol.owner && symbol.name != name)
            throw Refusal{request_failed, "there is a " + std::string(check::name(other.kind)) + " '" + name +
                                              "' already, in " + index_.path(other.name_where.file)};
        }
      }
    }
  }
  Json changes = Json::object();
  for (const auto& [at, where] : places) {
    const auto& path = index_.path(where.file);
    if (const auto text = workspace_.text(path))
      changes[workspace_.uri(path)].push_back(text_edit(*text, where.begin, where.end, name));
  }
  return {{"changes", std::move(changes)}};
}

}  // namespace pal::language_server
