/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "rooms/work_folder.h"

#include "files/digest.h"
#include "files/output_file.h"
#include "files/tool_error.h"
#include "text/printable.h"

#include <cstring>
#include <dirent.h>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <unistd.h> // for rmdir, unlinkat
#include <utility>

namespace pcl::indoor::tool {
namespace {

namespace fs = std::filesystem;

constexpr const char* begun = "run";   // the first file
constexpr const char* locked = "lock"; // of the run that uses the folder

/** In front of the bytes of a file. */
struct Head {
  char name[8] = {'r', 'o', 'o', 'm', 's', ' ', '1', '\n'};
  std::uint64_t key = 0;
  std::uint64_t digest = 0; ///< of what follows
};

/** Does a file of this name belong to runs? Whatever else is there is left alone. */
bool
isOfRuns(std::string_view name)
{
  return name == begun || name == locked || name == "scene" ||
         name.compare(0, 5, "room_") == 0 || name.compare(0, 7, "points_") == 0 ||
         name.find(".part") != name.npos;
}

} // namespace

WorkFolder::WorkFolder(std::string folder, std::uint64_t key)
: folder_(std::move(folder))
, key_(key)
, is_begun_(read(begun).has_value())
{}

WorkFolder::~WorkFolder()
{
  if (!lock_ || is_begun_)
    return;
  remove(); // nothing was finished
  std::error_code error;
  if (made_parent_)
    fs::remove(fs::path(folder_).parent_path(), error);
}

void
WorkFolder::lock()
{
  made_parent_ = makeFolder(fs::path(folder_).parent_path().string());
  makeFolder(folder_);
  const auto file = path(locked);
  std::ofstream(file, std::ios::app); // locks are of files that exist
  try {
    lock_.emplace(file.c_str());
    if (lock_->try_lock())
      return;
  } catch (const boost::interprocess::interprocess_exception&) {
    lock_.reset(); // file systems without locks take no part
    return;
  }
  throw ToolError(folder_ + ": another run is at work there");
}

void
WorkFolder::removeOutdated()
{
  if (is_begun_)
    return;
  if (fs::exists(path(begun)))
    printWarning(folder_ +
                 ": what a run of another scan or with other options has left "
                 "unfinished is removed");
  removeFiles(true);
}

std::optional<std::string>
WorkFolder::read(const std::string& name) const
{
  std::ifstream stream(path(name), std::ios::binary);
  Head head;
  const Head right;
  if (!stream.read(reinterpret_cast<char*>(&head), sizeof(head)) ||
      std::memcmp(head.name, right.name, sizeof(head.name)) != 0 || head.key != key_)
    return {};
  std::error_code error;
  const auto size = fs::file_size(path(name), error);
  if (error || size < sizeof(head))
    return {};
  std::string bytes(size - sizeof(head), '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (static_cast<std::size_t>(stream.gcount()) != bytes.size() ||
      digestOf(bytes, key_) != head.digest)
    return {};
  return bytes;
}

void
WorkFolder::readPart(const std::string& name,
                     std::size_t first,
                     void* bytes,
                     std::size_t count) const
{
  std::ifstream stream(path(name), std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(sizeof(Head) + first));
  if (!stream.read(static_cast<char*>(bytes), static_cast<std::streamsize>(count)))
    throw ToolError(path(name) + ": the file is gone or too short");
}

void
WorkFolder::put(const std::string& name, const std::string& bytes)
{
  Head head;
  head.key = key_;
  head.digest = digestOf(bytes, key_);
  OutputFile file(path(name));
  file.write(&head, sizeof(head));
  file.write(bytes);
  file.commit();
}

void
WorkFolder::write(const std::string& name, const std::string& bytes)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!is_begun_) {
    makeFolder(folder_);
    put(begun, "");
    is_begun_ = true;
  }
  put(name, bytes);
}

void
WorkFolder::writePlain(const std::string& name, const std::string& bytes)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  saveText(path(name), bytes);
}

void
WorkFolder::removeFile(const std::string& name)
{
  std::error_code error;
  fs::remove(path(name), error);
}

void
WorkFolder::removeFiles(bool keep_lock)
{
  // Not by std::filesystem, which needs memory: the results are in place already.
  DIR* const folder = opendir(folder_.c_str());
  if (folder == nullptr)
    return;
  while (const auto* const entry = readdir(folder)) {
    const std::string_view name = entry->d_name;
    // one that cannot be removed is harmless: its key tells that it is outdated
    if (isOfRuns(name) && !(keep_lock && name == locked))
      unlinkat(dirfd(folder), entry->d_name, 0);
  }
  closedir(folder);
  rmdir(folder_.c_str()); // if it is empty
}

void
WorkFolder::remove()
{
  removeFiles(false);
}

std::string
roomFile(std::size_t room)
{
  return "room_" + std::to_string(room + 1);
}

} // namespace pcl::indoor::tool
