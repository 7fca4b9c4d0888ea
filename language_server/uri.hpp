// Paths as URIs and back (RFC 3986, RFC 8089).
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pal::language_server {

/// The path of a `file:` URI, its escapes resolved and normalized. Of another URI: nothing.
std::optional<std::string> path_of(std::string_view uri);

/// The URI of an absolute path. All but letters, digits and - . _ ~ / is escaped.
std::string uri_of(std::string_view path);

}  // namespace pal::language_server
