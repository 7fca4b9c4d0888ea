#include "server/page_files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <optional>

namespace pal::server {

struct PageFiles::File {
  std::int64_t changed = 0;  // ns
  std::size_t size = 0;
  std::string bytes, packed;  // `packed` is empty if it saves nothing
  std::string tag;
};

namespace {

constexpr std::size_t largest_page_file = std::size_t{32} << 20;
constexpr std::size_t longest_target = 1000;

struct PageType {
  std::string_view ending, type;
  bool packs;
};
constexpr std::array page_types{
    PageType{".html", "text/html; charset=utf-8", true},
    PageType{".js", "text/javascript; charset=utf-8", true},
    PageType{".mjs", "text/javascript; charset=utf-8", true},
    PageType{".css", "text/css; charset=utf-8", true},
    PageType{".json", "application/json", true},
    PageType{".map", "application/json", true},
    PageType{".svg", "image/svg+xml", true},
    PageType{".md", "text/markdown; charset=utf-8", true},
    PageType{".txt", "text/plain; charset=utf-8", true},
    PageType{".png", "image/png", false},
    PageType{".ico", "image/x-icon", false},
    PageType{".woff2", "font/woff2", false},
    PageType{".wasm", "application/wasm", true},
};

const PageType* type_of(std::string_view path) {
  for (const PageType& each : page_types)
    if (path.ends_with(each.ending)) return &each;
  return nullptr;
}

/// Names between slashes; nothing for what no file of ours is called.
std::optional<std::vector<std::string>> names_in(std::string_view target) {
  target = target.substr(0, target.find_first_of("?#"));
  if (target.empty() || target.front() != '/' || target.size() > longest_target) return std::nullopt;
  std::vector<std::string> names;
  for (std::size_t begin = 1; begin <= target.size();) {
    const std::size_t end = std::min(target.find('/', begin), target.size());
    const std::string name(target.substr(begin, end - begin));
    begin = end + 1;
    if (name.empty() && end == target.size()) break;  // the folder itself
    const bool well =
        !name.empty() && name.front() != '.' && std::all_of(name.begin(), name.end(), [](unsigned char c) {
          return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.';
        });
    if (!well) return std::nullopt;
    names.push_back(name);
  }
  return names;
}

class PageDescriptor {
 public:
  explicit PageDescriptor(int number) : number_(number) {}
  ~PageDescriptor() {
    if (number_ >= 0) ::close(number_);
  }
  PageDescriptor(PageDescriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  PageDescriptor& operator=(PageDescriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  int number() const { return number_; }

 private:
  int number_;
};

/// Follows no link on the way down, so that nothing leads outside.
PageDescriptor open_below(const std::string& folder, const std::vector<std::string>& names) {
  PageDescriptor here(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  for (std::size_t i = 0; i < names.size() && here.number() >= 0; ++i) {
    const int kind = i + 1 < names.size() ? O_DIRECTORY : 0;
    here = PageDescriptor(
        ::openat(here.number(), names[i].c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK | kind));
  }
  return here;
}

std::string packed(const std::string& bytes) {
  z_stream stream{};
  constexpr int gzip = 15 + 16, level = 6, memory = 8;
  if (::deflateInit2(&stream, level, Z_DEFLATED, gzip, memory, Z_DEFAULT_STRATEGY) != Z_OK) return {};
  std::string result(::deflateBound(&stream, static_cast<uLong>(bytes.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  const bool done = ::deflate(&stream, Z_FINISH) == Z_STREAM_END;
  result.resize(stream.total_out);
  ::deflateEnd(&stream);
  return done && result.size() < bytes.size() ? result : std::string();
}

/// FNV-1a: it tells two versions of a file apart, and protects nothing.
std::string tag_of(const std::string& bytes) {
  std::uint64_t hash = 14695981039346656037U;
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211U;
  return fmt::format("\"{:016x}-{:x}\"", hash, bytes.size());
}

/// "main-QX7KJ2AB.js": another content has another name.
bool named_by_hash(std::string_view path) {
  constexpr std::size_t hash_size = 8;
  const std::size_t dot = path.rfind('.');
  const std::size_t dash = path.rfind('-', dot);
  if (dot == std::string_view::npos || dash == std::string_view::npos || dot - dash - 1 != hash_size)
    return false;
  return std::all_of(path.begin() + static_cast<std::ptrdiff_t>(dash) + 1,
                     path.begin() + static_cast<std::ptrdiff_t>(dot),
                     [](unsigned char c) { return std::isdigit(c) != 0 || std::isupper(c) != 0; });
}

std::string policy(const std::string& host) {
  return fmt::format(
      "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; font-src 'self'; "
      "connect-src 'self' ws://{}; worker-src 'self'; manifest-src 'self'; base-uri 'none'; form-action "
      "'none'; "
      "frame-ancestors 'none'",
      host);
}

PageAnswer in_words(unsigned status, std::string text) {
  return {status,
          {{"Content-Type", "text/plain; charset=utf-8"},
           {"X-Content-Type-Options", "nosniff"},
           {"Content-Security-Policy", "default-src 'none'; frame-ancestors 'none'"}},
          std::move(text)};
}

}  // namespace

PageFiles::PageFiles(std::vector<PageFolder> folders) : folders_(std::move(folders)) {
  // The longest prefix is the one that counts.
  std::sort(folders_.begin(), folders_.end(),
            [](const PageFolder& a, const PageFolder& b) { return a.prefix.size() > b.prefix.size(); });
}

PageFiles::~PageFiles() = default;

const PageFiles::File* PageFiles::find(const std::string& path) const {
  for (const PageFolder& folder : folders_) {
    if (!path.starts_with(folder.prefix)) continue;
    auto names = names_in("/" + path.substr(folder.prefix.size()));
    if (!names) return nullptr;
    if (names->empty()) names->push_back("index.html");
    const PageDescriptor opened = open_below(folder.folder, *names);
    struct stat found {};
    if (opened.number() < 0 || ::fstat(opened.number(), &found) != 0 || !S_ISREG(found.st_mode) ||
        static_cast<std::size_t>(found.st_size) > largest_page_file)
      return nullptr;
    const std::int64_t changed = found.st_mtim.tv_sec * 1'000'000'000 + found.st_mtim.tv_nsec;
    std::unique_ptr<File>& file = files_[path];
    if (file && file->changed == changed && file->size == static_cast<std::size_t>(found.st_size))
      return file.get();
    auto fresh = std::make_unique<File>();
    fresh->changed = changed;
    fresh->size = static_cast<std::size_t>(found.st_size);
    fresh->bytes.resize(fresh->size);
    std::size_t done = 0;
    while (done < fresh->size) {
      const ssize_t count = ::read(opened.number(), fresh->bytes.data() + done, fresh->size - done);
      if (count <= 0) return nullptr;
      done += static_cast<std::size_t>(count);
    }
    const PageType* type = type_of(names->back());
    if (type != nullptr && type->packs) fresh->packed = packed(fresh->bytes);
    fresh->tag = tag_of(fresh->bytes);
    file = std::move(fresh);
    return file.get();
  }
  return nullptr;
}

PageAnswer PageFiles::answer(const PageRequest& request) const {
  const std::string path = request.target.substr(0, request.target.find_first_of("?#"));
  const bool any_page = std::any_of(folders_.begin(), folders_.end(),
                                    [](const PageFolder& each) { return each.prefix == "/"; });
  if (!any_page && (path == "/" || path == "/index.html"))
    return in_words(404,
                    "There is no page here: this server was started without one (--page FOLDER).\n"
                    "It is a WebSocket that talks JSON-RPC 2.0.\n");
  const File* file = names_in(request.target) ? find(path) : nullptr;
  if (file == nullptr) return in_words(404, "There is no such file.\n");
  PageAnswer answer;
  const PageType* type = type_of(path.ends_with('/') ? "index.html" : path);
  answer.fields = {
      {"Content-Type", std::string(type != nullptr ? type->type : "application/octet-stream")},
      {"ETag", file->tag},
      {"Cache-Control", named_by_hash(path) ? "public, max-age=31536000, immutable" : "no-cache"},
      {"Vary", "Accept-Encoding"},
      {"Content-Security-Policy", policy(request.host)},
      {"X-Content-Type-Options", "nosniff"},
      {"Referrer-Policy", "no-referrer"},
      {"Cross-Origin-Opener-Policy", "same-origin"},
      {"Cross-Origin-Resource-Policy", "same-origin"}};
  if (request.if_none_match.find(file->tag) != std::string::npos) {
    answer.status = 304;
    return answer;
  }
  const bool takes_packed =
      !file->packed.empty() && request.accept_encoding.find("gzip") != std::string::npos;
  if (takes_packed) answer.fields.emplace_back("Content-Encoding", "gzip");
  answer.body = takes_packed ? file->packed : file->bytes;
  return answer;
}

}  // namespace pal::server
