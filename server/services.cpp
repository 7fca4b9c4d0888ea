#include "server/services.hpp"

#include "operations/load.hpp"

namespace pal::server {

std::variant<std::string, FileError> RequestFiles::read(const std::string& path, std::size_t most) const {
  const auto found = files_.find(path);
  if (found == files_.end()) {
    constexpr std::string_view ending = ".op.json";
    if (store_ != nullptr && path.ends_with(ending)) {
      try {
        std::string text = store_->read(path.substr(0, path.size() - ending.size())).text;
        return files_.emplace(path, std::move(text)).first->second;
      } catch (const StoreProblem&) {
        // Told below.
      }
    }
    return FileError{"its text was not sent, and the store has none of this name"};
  }
  if (found->second.size() > most) return FileError{"it is too large"};
  return found->second;
}

Store& store_of(SessionContext& context) {
  if (context.store == nullptr)
    fail(Refusal::Why::absent, "this server has no store", "start it with --store FOLDER");
  return *context.store;
}

LoadOperation load_stored(SessionContext& context, const std::string& name,
                          std::optional<std::uint64_t> version) {
  Store& store = store_of(context);
  const StoredText read = with_store([&] { return store.read(name, version); });
  LoadOperation command;
  command.main = name + ".op.json";
  command.files[command.main] = read.text;
  command.stored = StoredVersion{name, read.entry.version};
  return command;
}

void add_stored_files(SessionContext& context, LoadOperation& command) {
  if (context.store == nullptr) return;
  const RequestFiles files(command.files, context.store);
  SourceManager sources;
  Diagnostics ignored;
  operations::load(files, sources, command.main, ignored);
}

}  // namespace pal::server
