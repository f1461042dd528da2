/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/scan_files.h"

#include "files/cloud_formats.h"
#include "files/result_names.h"
#include "files/tool_error.h"
#include "formats/file_beginning.h"
#include "formats/file_ending.h"
#include "formats/foreign_format.h"
#include "formats/mesh_file.h"
#include "formats/table/table_file.h"

#include <algorithm>
#include <filesystem>
#include <map>

namespace pcl::indoor::tool {
namespace {

namespace fs = std::filesystem;

/** A text by its ending, such as notes beside the scans, without a row of a table. */
bool
isOtherText(const std::string& path)
{
  constexpr std::size_t longest_header = 1 << 16; // bytes
  const auto& endings = tableEndings();
  return std::count(endings.begin(), endings.end(), fileEnding(path)) > 0 &&
         tablePointCount(path, beginningOf(path, longest_header)) == 0;
}

/** What is in a folder, by name, without hidden files. */
struct FolderContent {
  std::vector<std::string> scans, folders;
  std::map<std::string, std::vector<std::string>> others; ///< by their endings
};

FolderContent
contentOf(const std::string& folder)
{
  FolderContent content;
  std::error_code error;
  std::vector<fs::directory_entry> entries;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    entries.push_back(*entry);
  if (error)
    throw ToolError(folder + ": the folder cannot be read");
  std::sort(entries.begin(), entries.end());
  for (const auto& entry : entries) {
    const auto path = entry.path().string();
    std::error_code unknown;
    if (entry.path().filename().string().front() == '.')
      continue;
    if (entry.is_directory(unknown))
      content.folders.push_back(entry.path().filename().string());
    else if (entry.is_regular_file(unknown) &&
             (hasCloudEnding(path) || hasPackedEnding(path)) && !isOtherText(path))
      content.scans.push_back(path);
    else if (entry.is_regular_file(unknown))
      content.others[fileEnding(path)].push_back(path);
  }
  return content;
}

std::string
nameOf(const std::string& path)
{
  return fs::path(path).filename().string();
}

/** Take away what an earlier run has written into the folder. */
void
removeResults(const std::string& folder, FolderContent& content, ScanFiles& files)
{
  std::error_code error;
  if (!fs::exists(folder + "/scene.json", error))
    return;
  const auto remove = [](std::vector<std::string>& paths) {
    const auto is_result = [](const auto& path) { return isResultName(nameOf(path)); };
    const auto begin = std::remove_if(paths.begin(), paths.end(), is_result);
    const bool was_there = begin != paths.end();
    paths.erase(begin, paths.end());
    return was_there;
  };
  for (auto& [ending, paths] : content.others)
    remove(paths);
  auto scans = content.scans;
  if (!remove(scans) || scans.empty()) // alone it may be a scan once more
    return;
  content.scans = scans;
  files.notes.push_back("cloud.pcd beside scene.json is the result of an earlier run "
                        "and left out");
}

/** Files of one ending, and why they are no scans. */
std::string
whyLeftOut(const std::vector<std::string>& paths)
{
  const auto beginning = beginningOf(paths[0]);
  const auto format = describeForeignFormat(paths[0], beginning);
  const auto more = paths.size() - 1;
  return nameOf(paths[0]) + (more > 0 ? " and " + std::to_string(more) + " more" : "") +
         (!format.empty()                   ? ": " + format
          : isOtherText(paths[0])           ? ": a text without rows of points"
          : meshFormat(paths[0], beginning) ? ": a mesh, read where it is named itself"
                                            : ": not read by this ending");
}

[[noreturn]] void
refuseEmpty(const std::string& folder, const FolderContent& content)
{
  std::string instead;
  for (const auto& [ending, paths] : content.others)
    if (!paths.empty())
      instead += (instead.empty() ? ", but " : "; ") + whyLeftOut(paths);
  if (instead.empty() && !content.folders.empty())
    instead = ", but folders: give one of them, for example " + folder + "/" +
              content.folders.front();
  throw ToolError(folder + ": the folder holds no " + cloudFormatNames() +
                  " file or table" + instead);
}

/** \param[in] name that the folder is given to users by */
void
addContent(const std::string& folder,
           const std::string& name,
           FolderContent content,
           ScanFiles& files)
{
  removeResults(folder, content, files);
  if (content.scans.empty())
    refuseEmpty(name, content);
  for (const auto& [ending, paths] : content.others)
    if (!paths.empty())
      files.notes.push_back("left out: " + whyLeftOut(paths));
  files.paths.insert(files.paths.end(), content.scans.begin(), content.scans.end());
}

/** The scans in a file that was packed; where there is none, its only file. */
ScanFiles
scansIn(const std::string& path, const UnpackedFiles& unpacked)
{
  ScanFiles files;
  if (unpacked.files().size() == 1) {
    files.paths = unpacked.files();
    return files;
  }
  auto content = contentOf(unpacked.folder());
  std::vector<std::string> meshes;
  for (const auto& file : unpacked.files())
    if (meshFormat(file, beginningOf(file)))
      meshes.push_back(file);
  if (content.scans.empty() && meshes.size() == 1)
    files.paths = meshes;
  else
    addContent(unpacked.folder(), path, std::move(content), files);
  return files;
}

} // namespace

ScanFiles
scanFiles(const std::vector<std::string>& inputs)
{
  ScanFiles files;
  for (const auto& input : inputs) {
    std::error_code error;
    if (fs::is_directory(input, error))
      addContent(input, input, contentOf(input), files);
    else
      files.paths.push_back(input);
  }
  return files;
}

std::vector<std::unique_ptr<UnpackedFiles>>
unpackScans(ScanFiles& files)
{
  std::vector<std::unique_ptr<UnpackedFiles>> unpacked;
  std::vector<std::string> paths;
  for (const auto& path : files.paths) {
    if (!isPacked(path)) {
      paths.push_back(path);
      continue;
    }
    unpacked.push_back(std::make_unique<UnpackedFiles>(path));
    auto inner = scansIn(path, *unpacked.back());
    for (const auto& scan : inner.paths)
      if (isPacked(scan)) // without end, in files that are made so
        throw ToolError(path + ": " + nameOf(scan) +
                        " in it is packed, too; unpack it");
    paths.insert(paths.end(), inner.paths.begin(), inner.paths.end());
    files.notes.insert(files.notes.end(), inner.notes.begin(), inner.notes.end());
  }
  files.paths = std::move(paths);
  return unpacked;
}

std::string
nameOfScan(const std::vector<std::string>& inputs,
           const std::vector<std::string>& files)
{
  if (inputs.size() == 1) { // of a folder without the slash that may end it
    const fs::path path(inputs[0]);
    return (path.has_filename() ? path : path.parent_path()).string();
  }
  return files.front() + " and " + std::to_string(files.size() - 1) + " more";
}

} // namespace pcl::indoor::tool
