/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_file.h"
#include "files/cloud_stream.h"
#include "formats/table/table_columns.h"

#include <pcl/indoor/exports.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief A format of point clouds that the tools read. */
struct CloudFormat {
  const char* name;                 ///< in messages
  std::vector<std::string> endings; ///< of file names; of folders such files are read
  /** Is a file of this format?
   * \param[in] beginning of the file, 512 bytes if it has as many */
  bool (*is)(const std::string& path, const std::string& beginning);
  /** How many points the header promises, 0 if it is not understood; reads no more.
   * Null where there is no such number. */
  std::uint64_t (*promisedPoints)(const std::string& path,
                                  const std::string& beginning);
  /** Opens a file; gives null if its points cannot be read in parts, is null where no
   * file can. Throws ToolError if it is damaged. */
  std::unique_ptr<CloudStream> (*open)(const std::string& path);
  /** Reads a whole file; null where all of its files can be opened. Throws ToolError,
   * or what the reader of a library throws. */
  void (*load)(CloudFile& file, const TableColumns& columns);
};

/** \brief The format of a file, by its content, or by the ending of a table's name.
 * \return null if it is none that is read, or if the file cannot be read
 */
const CloudFormat*
cloudFormatOf(const std::string& path);

/** \brief Read the fields of a cloud file, its pose, stations and notes.
 * \param[in,out] file has its path
 * \throws ToolError see loadCloud()
 */
PCL_INDOOR_EXPORTS void
readCloud(CloudFile& file, const TableColumns& columns);

/** \brief How many points the header of a cloud file promises, or a table about has; 0
 * if it is not understood. Reads no more than the header. */
PCL_INDOOR_EXPORTS std::uint64_t
promisedPoints(const std::string& path);

/** \brief Is the ending of a file's name that of a format of clouds? */
PCL_INDOOR_EXPORTS bool
hasCloudEnding(const std::string& path);

/** \brief The endings of clouds, for messages: ".pcd, .ply, ...". */
PCL_INDOOR_EXPORTS std::string
cloudEndings();

/** \brief The formats of clouds, for messages: "PCD, PLY, LAS". */
std::string
cloudFormatNames();

} // namespace pcl::indoor::tool
