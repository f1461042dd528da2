/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Is it an archive (ZIP, tar, 7z, RAR), or a file that is compressed (gzip,
 * bzip2, xz, zstd)? Its first bytes say so. Documents of other programs, which may be
 * ZIP files, too, are told by their names, see describeForeignFormat(). */
bool
isPacked(const std::string& path);

/** \brief Is the ending of a file's name that of a packed file? */
bool
hasPackedEnding(const std::string& path);

/** \brief The files in an archive, or the one in a compressed file, side by side in a
 * folder for temporary files, which is removed with this. */
class PCL_INDOOR_EXPORTS UnpackedFiles {
public:
  /** \throws ToolError if the file is damaged or encrypted, holds no file, or there is
   * no room for what it holds */
  explicit UnpackedFiles(const std::string& path);
  UnpackedFiles(const UnpackedFiles&) = delete;
  UnpackedFiles&
  operator=(const UnpackedFiles&) = delete;
  ~UnpackedFiles();

  const std::string&
  folder() const
  {
    return folder_;
  }

  /** \brief In the order of the archive. */
  const std::vector<std::string>&
  files() const
  {
    return files_;
  }

private:
  void
  unpack(const std::string& path);
  void
  remove();

  std::string folder_;
  std::vector<std::string> files_;
};

} // namespace pcl::indoor::tool
