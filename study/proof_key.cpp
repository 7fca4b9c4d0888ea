#include "study/proof_key.hpp"

#include <elf.h>
#include <link.h>
#include <openssl/evp.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "pal/pan/dump.hpp"

namespace pal::study {
namespace {

std::string hexadecimal(const unsigned char* bytes, std::size_t count) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    text += digits[bytes[i] >> 4];
    text += digits[bytes[i] & 15];
  }
  return text;
}

/// The build id that the linker wrote into the program itself, which is the first object.
int find_build_id(dl_phdr_info* info, std::size_t, void* data) {
  auto& id = *static_cast<std::string*>(data);
  for (int i = 0; i < info->dlpi_phnum; ++i) {
    const ElfW(Phdr)& header = info->dlpi_phdr[i];
    if (header.p_type != PT_NOTE) continue;
    // NOLINTNEXTLINE: the loader gives addresses as numbers.
    const auto* at = reinterpret_cast<const unsigned char*>(info->dlpi_addr + header.p_vaddr);
    const auto* const end = at + header.p_memsz;
    while (at + sizeof(ElfW(Nhdr)) <= end) {
      ElfW(Nhdr) note;
      std::memcpy(&note, at, sizeof note);
      const auto* const name = at + sizeof note;
      const auto* const content = name + (note.n_namesz + 3U) / 4U * 4U;
      if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == 4 && std::memcmp(name, "GNU", 4) == 0)
        id = hexadecimal(content, note.n_descsz);
      at = content + (note.n_descsz + 3U) / 4U * 4U;
    }
  }
  return 1;  // the first object alone
}

std::string find_engine_version() {
  std::string id;
  ::dl_iterate_phdr(find_build_id, &id);
  if (id.empty()) {  // a linker that writes none
    std::ifstream program("/proc/self/exe", std::ios::binary);
    id = sha256(std::string(std::istreambuf_iterator<char>(program), {}));
  }
  return "pal " PAL_VERSION " " + id;
}

/// Every bit of a number, where a dump for people has six digits.
std::string whole(double value) {
  std::uint64_t bits = 0;
  static_assert(sizeof bits == sizeof value);
  std::memcpy(&bits, &value, sizeof bits);
  return std::to_string(bits);
}

}  // namespace

std::string sha256(std::string_view text) {
  std::array<unsigned char, 32> digest{};
  unsigned size = 0;
  // Looked up once: with EVP_sha256() each call looks for it again.
  static const EVP_MD* const algorithm = ::EVP_MD_fetch(nullptr, "SHA256", nullptr);
  if (::EVP_Digest(text.data(), text.size(), digest.data(), &size, algorithm, nullptr) != 1 ||
      size != digest.size())
    throw std::runtime_error("SHA-256 is not available in this system's libcrypto");
  return hexadecimal(digest.data(), digest.size());
}

std::string canonical_text(const pan::Network& skill) {
  std::ostringstream text;
  pan::dump(skill, text);
  for (const pan::Parameter& each : skill.skill.parameters)
    text << "parameter " << whole(each.low) << ' ' << whole(each.high) << ' ' << whole(each.default_value)
         << '\n';
  return text.str();
}

std::string canonical_text(const pan::Environment& environment) {
  std::ostringstream text;
  pan::dump(environment, text);
  return text.str();
}

const std::string& engine_version() {
  static const std::string version = find_engine_version();
  return version;
}

std::string proof_key(const std::string& skill, const std::string& environment, const KeyOptions& options) {
  return sha256("proof 1\n" + engine_version() + "\n" + options.analysis + "\n" +
                std::to_string(options.max_states) + "\n" + skill + "\n" + environment + "\n");
}

}  // namespace pal::study
