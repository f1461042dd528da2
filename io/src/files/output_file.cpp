/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/output_file.h"

#include "files/tool_error.h"
#include "files/unfinished_files.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <optional>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace pcl::indoor::tool {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void
refuse(const std::string& path, const std::string& reason)
{
  throw ToolError(path + ": cannot be written, " + reason);
}

/** The state of what is there, at the end of all links; none if nothing is. */
std::optional<struct stat>
stateOf(const std::string& path)
{
  struct stat state {};
  return stat(path.c_str(), &state) == 0 ? std::optional(state) : std::nullopt;
}

bool
isStream(const std::optional<struct stat>& state)
{
  return state && (S_ISFIFO(state->st_mode) || S_ISCHR(state->st_mode));
}

/** The end of a chain of links, also where nothing is there. */
std::string
endOfLinks(const std::string& path)
{
  constexpr int longest_chain = 40;
  std::error_code error;
  fs::path end = path;
  for (int k = 0; k < longest_chain && fs::is_symlink(end, error); ++k)
    end = end.parent_path() / fs::read_symlink(end, error); // or an absolute one
  return end.string();
}

std::string
folderOf(const std::string& path)
{
  const auto folder = fs::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

/** Outdated files give way; nothing else does. */
void
removeOutdated(const std::string& path)
{
  const auto state = stateOf(path);
  if (state && S_ISREG(state->st_mode) && unlink(endOfLinks(path).c_str()) != 0)
    throw ToolError(path + ": cannot be replaced, " + std::strerror(errno));
}

} // namespace

void
requireWritable(const std::string& path)
{
  const auto state = stateOf(path);
  if (isStream(state)) {
    if (access(path.c_str(), W_OK) != 0)
      refuse(path, std::strerror(errno));
    return;
  }
  if (state && S_ISDIR(state->st_mode))
    refuse(path, "it is a folder");
  if (state && !S_ISREG(state->st_mode))
    refuse(path, "it is neither a file, a pipe nor a character device");
  const auto target = endOfLinks(path);
  std::error_code error;
  if (fs::is_symlink(target, error))
    refuse(path, "its links have no end");
  const auto folder = folderOf(target);
  if (!fs::is_directory(folder, error))
    refuse(path, "there is no folder " + folder);
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    refuse(path, std::strerror(errno));
}

void
requireFolder(const std::string& folder)
{
  std::error_code error;
  auto nearest = fs::absolute(folder, error);
  while (!fs::exists(nearest, error) && nearest.has_relative_path())
    nearest = nearest.parent_path();
  if (!fs::is_directory(nearest, error))
    throw ToolError(folder + ": cannot be used as a folder, " + nearest.string() +
                    " is none");
  if (access(nearest.c_str(), W_OK | X_OK) != 0)
    refuse(folder, std::strerror(errno));
}

bool
makeFolder(const std::string& folder)
{
  std::error_code error;
  const bool is_made = fs::create_directories(folder, error);
  if (error)
    throw ToolError(folder + ": cannot be made, " + error.message());
  return is_made;
}

OutputFile::OutputFile(const std::string& path)
: path_(path)
{
  requireWritable(path);
  prepareForWriting();
  const auto state = stateOf(path);
  if (isStream(state)) {
    descriptor_ = open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
    if (descriptor_ < 0)
      fail(errno);
    return;
  }
  target_ = endOfLinks(path);
  part_ = target_ + ".part" + std::to_string(getpid());
  if (!addUnfinished(part_)) {
    part_.clear();
    refuse(path, "two outputs have this name");
  }
  constexpr mode_t anybody = 0666; // less what the user's mask takes away
  descriptor_ = open(part_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, anybody);
  if (descriptor_ < 0) {
    const int reason = errno;
    removeUnfinished(std::exchange(part_, {}));
    fail(reason);
  }
  if (state) // who may read the old file may read the new one, and nobody else
    static_cast<void>(fchmod(descriptor_, state->st_mode & 07777) == 0);
}

OutputFile::OutputFile(OutputFile&& other) noexcept
: path_(std::move(other.path_))
, target_(std::move(other.target_))
, part_(std::exchange(other.part_, {}))
, descriptor_(std::exchange(other.descriptor_, -1))
{}

OutputFile::~OutputFile()
{
  if (descriptor_ >= 0)
    ::close(descriptor_);
  if (part_.empty())
    return;
  unlink(part_.c_str());
  removeUnfinished(part_);
}

void
OutputFile::fail(int reason) const
{
  refuse(path_, std::strerror(reason));
}

void
OutputFile::write(const void* bytes, std::size_t size)
{
  const auto* next = static_cast<const char*>(bytes);
  while (size > 0) {
    const ssize_t written = ::write(descriptor_, next, size);
    if (written < 0 && errno == EINTR)
      continue;
    if (written < 0)
      fail(errno);
    next += written;
    size -= static_cast<std::size_t>(written);
  }
}

void
OutputFile::close()
{
  if (descriptor_ >= 0 && ::close(std::exchange(descriptor_, -1)) != 0)
    fail(errno);
}

void
OutputFile::commit()
{
  close();
  if (part_.empty())
    return;
  if (rename(part_.c_str(), target_.c_str()) != 0)
    fail(errno);
  removeUnfinished(std::exchange(part_, {}));
}

void
saveText(const std::string& path, const std::string& text)
{
  writtenBeside(path, text).commit();
}

OutputFile
writtenBeside(const std::string& path, const std::string& text)
{
  OutputFile file(path);
  file.write(text);
  file.close();
  return file;
}

void
commitTogether(std::vector<OutputFile>& files, const std::vector<std::string>& outdated)
{
  for (auto& file : files)
    file.close();
  const SignalPause pause;
  for (const auto& path : outdated)
    removeOutdated(path);
  for (auto& file : files)
    file.commit();
}

} // namespace pcl::indoor::tool
