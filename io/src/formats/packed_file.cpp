/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/packed_file.h"

#include "files/tool_error.h"
#include "files/unfinished_files.h"
#include "formats/file_beginning.h"
#include "formats/file_ending.h"
#include "formats/foreign_format.h"

#include <algorithm>
#include <archive.h>
#include <archive_entry.h>
#include <cerrno>
#include <cstdlib> // for mkdtemp
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <unordered_map>
#include <utility>

namespace pcl::indoor::tool {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t block_size = std::size_t(1) << 20; // bytes read at once

/** How packed files of a kind begin. */
struct Packing {
  std::string beginning;
  std::size_t offset; ///< of it, bytes
  const char* ending;
};

const std::vector<Packing>&
packings()
{
  static const std::vector<Packing> all = {{"PK\x03\x04", 0, ".zip"},
                                           {"\x1f\x8b", 0, ".gz"},
                                           {"\x1f\x8b", 0, ".tgz"},
                                           {"BZh", 0, ".bz2"},
                                           {"\xfd"
                                            "7zXZ",
                                            0,
                                            ".xz"},
                                           {"\x28\xb5\x2f\xfd", 0, ".zst"},
                                           {"7z\xbc\xaf", 0, ".7z"},
                                           {"Rar!", 0, ".rar"},
                                           {"ustar", 257, ".tar"}};
  return all;
}

struct Closer {
  void
  operator()(archive* opened) const
  {
    archive_read_free(opened);
  }
};
using Reader = std::unique_ptr<archive, Closer>;

[[noreturn]] void
refuse(const std::string& path, archive& reader)
{
  const char* const reason = archive_error_string(&reader);
  throw ToolError(path + ": it cannot be unpacked, " +
                  (reason != nullptr ? reason : "it is damaged"));
}

Reader
opened(const std::string& path)
{
  Reader reader(archive_read_new());
  if (!reader)
    throw std::bad_alloc();
  archive_read_support_filter_all(reader.get());
  archive_read_support_format_zip(reader.get());
  archive_read_support_format_tar(reader.get());
  archive_read_support_format_7zip(reader.get());
  archive_read_support_format_rar(reader.get());
  archive_read_support_format_rar5(reader.get());
  archive_read_support_format_raw(reader.get()); // one file that is compressed
  if (archive_read_open_filename(reader.get(), path.c_str(), block_size) != ARCHIVE_OK)
    refuse(path, *reader);
  return reader;
}

/** Of a file in an archive, without its folders; of one that is compressed alone the
 * name of the packed file, less its ending. */
std::string
nameOf(archive_entry& entry, archive& reader, const std::string& path)
{
  if (archive_format(&reader) == ARCHIVE_FORMAT_RAW)
    return fs::path(path).stem().string();
  const char* const name = archive_entry_pathname(&entry);
  const auto own = fs::path(name != nullptr ? name : "").filename().string();
  return own.empty() || own == "." || own == ".." ? "file" : own;
}

/** Names of files in a folder that no other has. */
class FreePaths {
public:
  explicit FreePaths(std::string folder)
  : folder_(std::move(folder))
  {}

  /** Puts a number before a name that others have, too: never one again, so that many
   * of the same name take no longer. */
  std::string
  of(const std::string& name)
  {
    auto path = folder_ + "/" + name;
    auto& number = numbers_.try_emplace(name, 1).first->second;
    while (fs::exists(path))
      path = folder_ + "/" + std::to_string(++number) + "_" + name;
    return path;
  }

private:
  std::string folder_;
  std::unordered_map<std::string, int> numbers_; ///< the last that a name had
};

void
copyEntry(archive& reader, const std::string& path, const std::string& target)
{
  std::ofstream out(target, std::ios::binary);
  for (;;) {
    const void* bytes = nullptr;
    std::size_t size = 0;
    la_int64_t offset = 0; // files may have holes
    const int state = archive_read_data_block(&reader, &bytes, &size, &offset);
    if (state == ARCHIVE_EOF)
      break;
    if (state != ARCHIVE_OK)
      refuse(path, reader);
    out.seekp(offset);
    out.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(size));
    if (!out)
      break;
  }
  out.close();
  if (!out)
    throw ToolError(path + ": there is no room to unpack it in " +
                    fs::path(target).parent_path().string() +
                    "; the variable TMPDIR names another folder");
}

} // namespace

bool
isPacked(const std::string& path)
{
  const auto beginning = beginningOf(path);
  const auto& all = packings();
  return std::any_of(all.begin(), all.end(), [&](const Packing& packing) {
    const auto& magic = packing.beginning;
    return beginning.size() >= packing.offset + magic.size() &&
           beginning.compare(packing.offset, magic.size(), magic) == 0 &&
           (magic[0] != 'P' || describeForeignFormat(path, beginning).empty());
  });
}

bool
hasPackedEnding(const std::string& path)
{
  const auto& all = packings();
  return std::any_of(
      all.begin(), all.end(), [ending = fileEnding(path)](const Packing& packing) {
        return ending == packing.ending;
      });
}

UnpackedFiles::UnpackedFiles(const std::string& path)
{
  folder_ = (fs::temp_directory_path() / "pcl_indoor_XXXXXX").string();
  if (mkdtemp(folder_.data()) == nullptr)
    throw ToolError(path + ": no folder can be made to unpack it in, " +
                    std::strerror(errno));
  try {
    unpack(path);
  } catch (...) {
    remove();
    throw;
  }
}

UnpackedFiles::~UnpackedFiles() { remove(); }

void
UnpackedFiles::unpack(const std::string& path)
{
  const auto reader = opened(path);
  FreePaths free_paths(folder_);
  for (;;) {
    archive_entry* entry = nullptr;
    const int state = archive_read_next_header(reader.get(), &entry);
    if (state == ARCHIVE_EOF)
      break;
    const bool is_raw = archive_format(reader.get()) == ARCHIVE_FORMAT_RAW;
    if ((state != ARCHIVE_OK && state != ARCHIVE_WARN) ||
        (is_raw && archive_filter_count(reader.get()) < 2)) // nothing was unpacked
      refuse(path, *reader);
    if (!is_raw && archive_entry_filetype(entry) != AE_IFREG)
      continue; // folders and links
    files_.push_back(free_paths.of(nameOf(*entry, *reader, path)));
    addUnfinished(files_.back());
    copyEntry(*reader, path, files_.back());
  }
  if (files_.empty())
    throw ToolError(path + ": there is no file in it");
}

void
UnpackedFiles::remove()
{
  std::error_code error;
  fs::remove_all(folder_, error);
  for (const auto& file : files_)
    removeUnfinished(file);
}

} // namespace pcl::indoor::tool
