/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_file.h"
#include "files/cloud_stream.h"

#include <cstring>
#include <stdexcept>
#include <vector>

namespace pcl::indoor::fuzz {

/** \brief All bytes of the points that a stream gives, part by part. */
inline std::vector<std::uint8_t>
bytesOf(tool::CloudStream& stream)
{
  std::vector<std::uint8_t> bytes;
  stream.forEachPart([&bytes](std::uint64_t, PCLPointCloud2& part) {
    bytes.insert(bytes.end(), part.data.begin(), part.data.end());
  });
  return bytes;
}

inline bool
haveTheSameFields(const PCLPointCloud2& a, const PCLPointCloud2& b)
{
  const auto same = [](const PCLPointField& p, const PCLPointField& q) {
    return p.name == q.name && p.offset == q.offset && p.datatype == q.datatype &&
           p.count == q.count;
  };
  return a.width == b.width && a.height == b.height && a.point_step == b.point_step &&
         a.fields.size() == b.fields.size() &&
         std::equal(a.fields.begin(), a.fields.end(), b.fields.begin(), same);
}

/** \brief Make sure that a file is the same cloud in parts as in one piece.
 * \param[in] stream of the file
 * \throws std::logic_error if it is not
 */
inline void
requireTheSame(tool::CloudStream& stream, const tool::CloudFile& file)
{
  const auto& pose = stream.pose();
  if (!haveTheSameFields(stream.layout(), file.cloud) ||
      pose.origin != file.pose.origin || pose.offset != file.pose.offset ||
      pose.orientation.coeffs() != file.pose.orientation.coeffs() ||
      bytesOf(stream) != file.cloud.data)
    throw std::logic_error("a cloud in parts is not what it is in one piece");
}

} // namespace pcl::indoor::fuzz
