// The methods of the JSON protocol on the store of operations.
#include <array>

#include "server/json_call.hpp"
#include "server/services.hpp"

namespace pal::server {
namespace {

constexpr std::int64_t greatest_version = std::int64_t{1} << 53;
constexpr std::size_t longest_note = 500;

void list(const Call& call) {
  call.beside(call.context().disk, [&store = store_of(call.context())](const Workshop::Stop&) {
    Json json = Json::array();
    for (const StoredEntry& each : with_store([&] { return store.list(); })) json.push_back(describe(each));
    return json;
  });
}

void read(const Call& call) {
  const auto version = call.members().may_be_whole("version", 1, greatest_version);
  call.beside(call.context().disk,
              [&store = store_of(call.context()), name = call.members().text("name"),
               version](const Workshop::Stop&) -> Json {
                const StoredText text = with_store([&] {
                  return store.read(name, version ? std::optional<std::uint64_t>(*version) : std::nullopt);
                });
                return {
                    {"name", name},           {"version", text.entry.version},        {"newest", text.newest},
                    {"text", text.text},      {"saved", wall_text(text.entry.saved)}, {"by", text.entry.by},
                    {"note", text.entry.note}};
              });
}

std::string name_of(const Call& call) {
  for (const Present& each : call.context().desk.clients())
    if (each.client == call.client()) return each.name;
  return {};
}

void save(const Call& call) {
  const Members& members = call.members();
  const auto based_on = static_cast<std::uint64_t>(members.whole("based_on", 0, greatest_version));
  call.beside(call.context().disk, [&store = store_of(call.context()), &desk = call.context().desk,
                                    name = members.text("name"), text = members.text("text"), based_on,
                                    by = name_of(call),
                                    note = members.short_text("note", longest_note)](const Workshop::Stop&) {
    const StoredEntry entry = with_store([&] { return store.save(name, text, based_on, by, note); });
    desk.tell(StoreChanged{name, StoreChanged::Change::saved, entry.version, {}, by});
    return describe(entry);
  });
}

void rename(const Call& call) {
  const Members& members = call.members();
  const auto based_on = static_cast<std::uint64_t>(members.whole("based_on", 1, greatest_version));
  call.beside(call.context().disk,
              [&store = store_of(call.context()), &desk = call.context().desk, name = members.text("name"),
               to = members.text("to"), based_on, by = name_of(call)](const Workshop::Stop&) {
                const StoredEntry entry = with_store([&] { return store.rename(name, to, based_on); });
                desk.tell(StoreChanged{name, StoreChanged::Change::renamed, entry.version, to, by});
                return describe(entry);
              });
}

void remove(const Call& call) {
  const Members& members = call.members();
  const auto based_on = static_cast<std::uint64_t>(members.whole("based_on", 1, greatest_version));
  call.beside(call.context().disk,
              [&store = store_of(call.context()), &desk = call.context().desk, name = members.text("name"),
               based_on, by = name_of(call)](const Workshop::Stop&) {
                with_store([&] { store.remove(name, based_on); });
                desk.tell(StoreChanged{name, StoreChanged::Change::deleted, based_on, {}, by});
                return Json::object();
              });
}

void versions(const Call& call) {
  call.beside(call.context().disk,
              [&store = store_of(call.context()), name = call.members().text("name")](const Workshop::Stop&) {
                Json json = Json::array();
                for (const StoredEntry& each : with_store([&] { return store.versions(name); }))
                  json.push_back({{"version", each.version},
                                  {"saved", wall_text(each.saved)},
                                  {"by", each.by},
                                  {"note", each.note},
                                  {"size", each.size}});
                return json;
              });
}

constexpr std::array store_methods{
    Method{"store.list", Role::viewer, false, list},
    Method{"store.read", Role::viewer, false, read},
    Method{"store.save", Role::programmer, false, save},
    Method{"store.rename", Role::programmer, false, rename},
    Method{"store.delete", Role::programmer, false, remove},
    Method{"store.versions", Role::viewer, false, versions},
};

}  // namespace

std::span<const Method> methods_of_the_store() {
  return store_methods;
}

}  // namespace pal::server
