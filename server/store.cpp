#include "server/store.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "operations/parse.hpp"
#include "pal/support/text_width.hpp"
#include "pal/support/utf8.hpp"
#include "server/disk_file.hpp"

namespace pal::server {
namespace {

namespace fs = std::filesystem;
using StoreJson = nlohmann::ordered_json;
using Why = Refusal::Why;

constexpr std::size_t longest_name = 100;

void check_name(const std::string& name) {
  const bool well = !name.empty() && name.size() <= longest_name && name.front() != '.' &&
                    name.front() != ' ' && name.back() != ' ' &&
                    name.find_first_of("/\\:*?\"<>|") == std::string::npos && !utf8::first_invalid(name) &&
                    printable(name) == name && !name.ends_with(".op.json");
  if (!well)
    refuse(Why::wrong, fmt::format("'{}' is no name for an operation", printable(name)),
           fmt::format(
               "a name has 1 to {} bytes, no / \\ : * ? \" < > |, does not begin with a dot and does not "
               "end with .op.json",
               longest_name));
}

std::string text_path(const std::string& folder, std::uint64_t version) {
  return fmt::format("{}/{:06}.op.json", folder, version);
}
std::string notes_path(const std::string& folder, std::uint64_t version) {
  return fmt::format("{}/{:06}.json", folder, version);
}

/// The name in the text; nothing: it is no operation.
std::optional<std::string> operation_name(const std::string& text) {
  SourceManager sources;
  Diagnostics ignored;
  const auto document = operations::parse(sources, sources.add("text", text), ignored);
  if (!document || document->operations.empty()) return std::nullopt;
  return document->operations.front().name;
}

}  // namespace

Store::Store(std::string folder) : folder_(std::move(folder)) {
  std::error_code problem;
  fs::create_directories(folder_, problem);
  if (problem) throw std::runtime_error(folder_ + ": " + problem.message());
  if (!fs::is_directory(folder_)) throw std::runtime_error(folder_ + ": it is no folder");
  fs::create_directory(folder_ + "/.deleted", problem);
  if (problem) throw std::runtime_error(folder_ + ": " + problem.message());
}

std::string Store::folder_of(const std::string& name) const {
  return folder_ + "/" + name;
}

/// Ascending; empty: there is no such operation.
std::vector<std::uint64_t> Store::numbers(const std::string& name) const {
  std::vector<std::uint64_t> result;
  std::error_code problem;
  for (fs::directory_iterator each(folder_of(name), problem), end; !problem && each != end;
       each.increment(problem)) {
    const std::string file = each->path().filename().string();
    constexpr std::string_view ending = ".op.json";
    if (file.size() <= ending.size() || !file.ends_with(ending)) continue;
    const std::string digits = file.substr(0, file.size() - ending.size());
    if (digits.size() > 18 || digits.find_first_not_of("0123456789") != std::string::npos) continue;
    result.push_back(std::stoull(digits));
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::uint64_t Store::newest_of(const std::string& name) const {
  check_name(name);
  const auto all = numbers(name);
  if (all.empty())
    refuse(Why::absent, fmt::format("the store has no operation '{}'", name),
           "store.list names those that it has");
  return all.back();
}

StoredEntry Store::entry(const std::string& name, std::uint64_t version) const {
  StoredEntry result;
  result.name = name;
  result.version = version;
  const std::string folder = folder_of(name), path = text_path(folder, version);
  struct stat found {};
  if (::stat(path.c_str(), &found) != 0) {
    if (errno == ENOENT)
      refuse(Why::absent, fmt::format("the store has no version {} of '{}'", version, name),
             "store.versions lists those that it has");
    fail_on_disk(path);
  }
  result.size = static_cast<std::size_t>(found.st_size);
  result.saved = std::chrono::system_clock::from_time_t(found.st_mtime);
  StoreJson notes;
  try {
    const std::string at = notes_path(folder, version);
    notes = StoreJson::parse(DiskFile(at, O_RDONLY).read(at, largest_text), nullptr, false);
  } catch (const StoreProblem&) {
    // Somebody put the text here by hand.
  }
  const auto text_of = [&notes](const char* field) {
    const auto at = notes.is_object() ? notes.find(field) : notes.end();
    return notes.is_object() && at != notes.end() && at->is_string() ? at->get<std::string>() : std::string();
  };
  result.by = text_of("by");
  result.note = text_of("note");
  if (notes.is_object() && notes.contains("operation")) {
    result.operation = text_of("operation");
  } else {
    result.operation = operation_name(DiskFile(path, O_RDONLY).read(path, largest_text)).value_or("");
  }
  if (notes.is_object() && notes.contains("saved_ms") && notes["saved_ms"].is_number_integer())
    result.saved = WallTime(std::chrono::milliseconds(notes["saved_ms"].get<std::int64_t>()));
  return result;
}

std::vector<StoredEntry> Store::list() const {
  std::vector<StoredEntry> result;
  std::error_code problem;
  for (fs::directory_iterator each(folder_, problem), end; !problem && each != end; each.increment(problem)) {
    const std::string name = each->path().filename().string();
    if (name.front() == '.' || !each->is_directory()) continue;
    const auto all = numbers(name);
    if (all.empty()) continue;
    try {
      check_name(name);
      result.push_back(entry(name, all.back()));
    } catch (const StoreProblem&) {
      continue;  // not ours, or it went meanwhile
    }
  }
  if (problem) refuse(Why::failed, folder_ + ": " + problem.message());
  std::sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return result;
}

StoredText Store::read(const std::string& name, std::optional<std::uint64_t> version) const {
  StoredText result;
  result.newest = newest_of(name);
  result.entry = entry(name, version.value_or(result.newest));
  const std::string path = text_path(folder_of(name), result.entry.version);
  result.text = DiskFile(path, O_RDONLY).read(path, largest_text);
  return result;
}

StoredEntry Store::save(const std::string& name, const std::string& text, std::uint64_t based_on,
                        const std::string& by, const std::string& note) {
  check_name(name);
  if (text.size() > largest_text)
    refuse(Why::too_much, fmt::format("an operation has at most {} bytes", largest_text),
           "divide it into several");
  const auto operation = operation_name(text);
  if (!operation) refuse(Why::wrong, "the text is no operation", "operation.check tells what is wrong");
  const auto all = numbers(name);
  const std::uint64_t newest = all.empty() ? 0 : all.back();
  const auto refuse_newer = [&](std::uint64_t there) {
    Refusal refusal{Why::newer, fmt::format("'{}' has version {} meanwhile", name, there),
                    "look at the difference, then save it based on that version, or under another name"};
    refusal.newest = there;
    throw StoreProblem{refusal};
  };
  if (based_on == 0 && newest > 0) {
    Refusal refusal{Why::exists, fmt::format("there is an operation '{}'", name), "choose another name"};
    refusal.newest = newest;
    throw StoreProblem{refusal};
  }
  if (based_on > 0 && all.empty())
    refuse(Why::absent, fmt::format("the store has no operation '{}' any more", name),
           "save it as a new one, based on 0");
  if (based_on != newest) refuse_newer(newest);

  const std::string folder = folder_of(name);
  if (newest == 0) {
    std::error_code ignored;
    const auto names = std::distance(fs::directory_iterator(folder_, ignored), fs::directory_iterator());
    if (static_cast<std::size_t>(names) > most_names)
      refuse(Why::too_much, fmt::format("the store has {} operations", most_names), "delete some");
    if (::mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST) fail_on_disk(folder);
    sync_folder(folder_);
  }
  const WallTime now = std::chrono::system_clock::now();
  const StoreJson notes{
      {"by", by}, {"note", note}, {"operation", *operation}, {"saved_ms", milliseconds(now)}};
  const std::uint64_t version = newest + 1;
  const std::string beside =
      write_aside(folder, notes.dump(-1, ' ', false, StoreJson::error_handler_t::replace) + "\n");
  if (::rename(beside.c_str(), notes_path(folder, version).c_str()) != 0) fail_on_disk(folder);
  const std::string fresh = write_aside(folder, text);
  // Unlike a rename, a link never replaces what another program has saved meanwhile.
  const int linked = ::link(fresh.c_str(), text_path(folder, version).c_str());
  const int why = errno;
  ::unlink(fresh.c_str());
  if (linked != 0) {
    if (why == EEXIST) refuse_newer(version);
    errno = why;
    fail_on_disk(folder);
  }
  sync_folder(folder);
  for (const std::uint64_t old : all) {
    if (old + most_versions > version) break;
    ::unlink(text_path(folder, old).c_str());
    ::unlink(notes_path(folder, old).c_str());
  }
  StoredEntry result{name, version, *operation, now, by, note, text.size()};
  return result;
}

StoredEntry Store::rename(const std::string& name, const std::string& to, std::uint64_t based_on) {
  check_name(to);
  const std::uint64_t newest = newest_of(name);
  if (based_on != newest) {
    Refusal refusal{Why::newer, fmt::format("'{}' has version {} meanwhile", name, newest), "read it again"};
    refusal.newest = newest;
    throw StoreProblem{refusal};
  }
  if (!numbers(to).empty())
    refuse(Why::exists, fmt::format("there is an operation '{}'", to), "choose another name");
  // An empty folder of that name is replaced.
  if (::rename(folder_of(name).c_str(), folder_of(to).c_str()) != 0) fail_on_disk(folder_of(to));
  sync_folder(folder_);
  return entry(to, newest);
}

void Store::remove(const std::string& name, std::uint64_t based_on) {
  const std::uint64_t newest = newest_of(name);
  if (based_on != newest) {
    Refusal refusal{Why::newer, fmt::format("'{}' has version {} meanwhile", name, newest), "read it again"};
    refusal.newest = newest;
    throw StoreProblem{refusal};
  }
  const std::string aside =
      fmt::format("{}/.deleted/{}-{}", folder_, name, milliseconds(std::chrono::system_clock::now()));
  if (::rename(folder_of(name).c_str(), aside.c_str()) != 0) fail_on_disk(aside);
  sync_folder(folder_);
}

std::vector<StoredEntry> Store::versions(const std::string& name) const {
  newest_of(name);
  std::vector<StoredEntry> result;
  for (const std::uint64_t each : numbers(name)) result.push_back(entry(name, each));
  std::reverse(result.begin(), result.end());
  return result;
}

}  // namespace pal::server
