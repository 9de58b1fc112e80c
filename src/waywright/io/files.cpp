#include "waywright/io/files.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>

namespace waywright {

namespace fs = std::filesystem;

Parsed<std::string> read_file(const fs::path& path, std::uint64_t limit) {
  const auto refuse = [&](std::string problem, std::string allowed = "") {
    return tl::unexpected{InputError{path.string(), "", std::move(problem), std::move(allowed)}};
  };
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) return refuse("there is no such file");
  if (fs::is_directory(status)) return refuse("it is a folder", "a file");
  std::ifstream in{path, std::ios::binary};
  if (!in) return refuse("the file cannot be read");
  std::string content;
  std::array<char, 1 << 16> block;
  while (in.read(block.data(), block.size()) || in.gcount() > 0) {
    content.append(block.data(), static_cast<std::size_t>(in.gcount()));
    if (content.size() > limit) return refuse("the file is too large", fmt::format("at most {} bytes", limit));
  }
  if (in.bad()) return refuse("the file cannot be read");
  return content;
}

Parsed<void> write_file(const fs::path& path, const std::string& content) {
  const auto refuse = [&](const std::string& problem) {
    return tl::unexpected{InputError{path.string(), "", problem, ""}};
  };
  std::error_code error;
  if (path.has_parent_path()) {
    fs::create_directories(path.parent_path(), error);
    if (error) return refuse("its folder cannot be made: " + error.message());
  }
  fs::path beside = path;
  beside += fmt::format(".{}.part", ::getpid());
  {
    std::ofstream out{beside, std::ios::binary | std::ios::trunc};
    out.write(content.data(), static_cast<std::streamsize>(content.size()));
    out.flush();
    if (!out) {
      const std::string why = std::strerror(errno);
      out.close();
      fs::remove(beside, error);
      return refuse("the file cannot be written: " + why);
    }
  }
  fs::rename(beside, path, error);
  if (error) {
    std::error_code ignored;
    fs::remove(beside, ignored);
    return refuse("the file cannot be written: " + error.message());
  }
  return {};
}

std::string sha256(const std::string& bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned length = 0;
  EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr);
  std::string text;
  for (unsigned i = 0; i < length; ++i) text += fmt::format("{:02x}", digest[i]);
  return text;
}

}  // namespace waywright
