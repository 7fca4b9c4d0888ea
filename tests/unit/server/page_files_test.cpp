// Files for browsers: types, policy, caching, and nothing outside the folder.
#include "server/page_files.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "server/access.hpp"

using namespace pal::server;

namespace {

struct Folder {
  std::string path = std::filesystem::temp_directory_path() / ("pal-page-" + make_token());
  Folder() {
    std::filesystem::create_directories(path + "/page/assets");
    write("secret.txt", "secret");
    write("page/index.html", "<p>the cell</p>");
    write("page/assets/app-ABCD1234.js", std::string(10'000, 'a'));
    write("page/.hidden", "hidden");
    std::filesystem::create_symlink(path + "/secret.txt", path + "/page/link.txt");
    std::filesystem::create_symlink(path, path + "/page/up");
  }
  ~Folder() { std::filesystem::remove_all(path); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path + "/" + name, std::ios::binary) << text;
  }
};

std::string field(const PageAnswer& answer, const std::string& name) {
  for (const auto& [each, value] : answer.fields)
    if (each == name) return value;
  return {};
}

}  // namespace

TEST_CASE("a page comes with its type, a strict policy and a tag") {
  const Folder folder;
  const PageFiles files({{"/", folder.path + "/page"}});
  const PageAnswer page = files.answer({"/?x=1", "localhost:7400", "", ""});
  CHECK(page.status == 200);
  CHECK(page.body == "<p>the cell</p>");
  CHECK(field(page, "Content-Type") == "text/html; charset=utf-8");
  CHECK(field(page, "Cache-Control") == "no-cache");
  CHECK(field(page, "Content-Security-Policy").find("default-src 'none'; script-src 'self';") == 0);
  CHECK(field(page, "Content-Security-Policy").find("unsafe") == std::string::npos);
  CHECK(files.answer({"/", "localhost", "", field(page, "ETag")}).status == 304);
  folder.write("page/index.html", "<p>another cell</p>");
  CHECK(files.answer({"/", "localhost", "", field(page, "ETag")}).body == "<p>another cell</p>");
  const PageAnswer script = files.answer({"/assets/app-ABCD1234.js", "localhost", "br, gzip", ""});
  CHECK(field(script, "Content-Encoding") == "gzip");
  CHECK(script.body.size() < 200);
  CHECK(field(script, "Cache-Control").find("immutable") != std::string::npos);
  CHECK(files.answer({"/assets/app-ABCD1234.js", "localhost", "", ""}).body.size() == 10'000);
}

TEST_CASE("nothing outside the folder is given away") {
  const Folder folder;
  const PageFiles files({{"/", folder.path + "/page"}});
  for (const char* target : {"/../secret.txt", "/assets/../../secret.txt", "/%2e%2e/secret.txt", "/link.txt",
                             "/up/secret.txt", "/.hidden", "//secret.txt", "/assets", "/none.js",
                             "secret.txt", "", "/a\\b", "/assets/..%2fsecret.txt"}) {
    CAPTURE(target);
    CHECK(files.answer({target, "localhost", "", ""}).status == 404);
  }
  CHECK(PageFiles({}).answer({"/", "localhost", "", ""}).body.find("--page FOLDER") != std::string::npos);
}
