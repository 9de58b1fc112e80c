// Reading and writing files: sizes bounded, written whole or not at all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "waywright/core/result.hpp"

namespace waywright {

/// The whole file, refused beyond `limit` bytes, when missing, a directory or unreadable.
Parsed<std::string> read_file(const std::filesystem::path& path, std::uint64_t limit);

/// The first `count` bytes at most, for a look at a header; refused like read_file.
Parsed<std::string> read_head(const std::filesystem::path& path, std::size_t count);

/// Writes beside the target and renames: the file appears whole or not at all. Its folder must be there.
Parsed<void> write_file(const std::filesystem::path& path, const std::string& content);

struct NamedContent {
  std::filesystem::path path;
  std::string content;
};
/// All of them or none: all are written beside their targets and safe on disk before the first is renamed. Signals that end the program wait
/// meanwhile, so that no part is left behind. Their folders must be there.
Parsed<void> write_files(const std::vector<NamedContent>& files);

/// Lower-case hexadecimal SHA-256.
std::string sha256(const std::string& bytes);

}  // namespace waywright
