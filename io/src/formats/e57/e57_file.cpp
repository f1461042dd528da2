/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/e57/e57_file.h"

#include "files/joined_clouds.h"
#include "files/tool_error.h"
#include "formats/e57/e57_packets.h"
#include "formats/e57/e57_pages.h"
#include "formats/e57/e57_points.h"
#include "formats/e57/e57_scans.h"
#include "formats/e57/e57_values.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace pcl::indoor::tool {
namespace {

/** The first names of a list. */
std::string
someOf(const std::vector<std::string>& names)
{
  constexpr std::size_t shown = 5; // fit into a line
  std::string text;
  for (std::size_t i = 0; i < std::min(shown, names.size()); ++i)
    text += (i == 0 ? "" : ", ") + names[i];
  if (names.size() > shown)
    text += " and " + std::to_string(names.size() - shown) + " more";
  return text;
}

/** Counts the values of a field that are not 0, as the bytes of its stream come. */
class FlagCounter {
public:
  FlagCounter(const E57Field& field, std::uint64_t values)
  : field_(field)
  , left_(values)
  {}

  void
  add(const char* bytes, std::size_t size)
  {
    constexpr std::size_t whole_bytes = 8; // after so many values
    pending_.append(bytes, size);
    const auto values =
        std::min<std::uint64_t>(left_, pending_.size() * 8 / field_.bits);
    const auto count = static_cast<std::size_t>(
        values == left_ ? values : values / whole_bytes * whole_bytes);
    values_.resize(count);
    const auto used = count * field_.bits / 8;
    pending_.append(whole_bytes, '\0');
    unpackE57Values(field_, pending_.data(), 0, count, values_.data());
    pending_.resize(pending_.size() - whole_bytes);
    pending_.erase(0, used);
    left_ -= count;
    count_ += static_cast<std::uint64_t>(
        std::count_if(values_.begin(), values_.end(), [](double v) { return v != 0; }));
  }

  std::uint64_t
  count() const
  {
    return count_;
  }

private:
  E57Field field_;
  std::uint64_t left_, count_ = 0;
  std::string pending_;
  std::vector<double> values_;
};

/** The points of one scan. */
class ScanStream : public CloudStream {
public:
  ScanStream(std::shared_ptr<E57Pages> pages, E57Scan scan)
  : pages_(std::move(pages))
  , scan_(std::move(scan))
  , points_(scan_, pages_->path())
  , flags_(scan_.fields[points_.flag().value_or(0)], scan_.count)
  , packets_(*pages_, scan_, [this](std::size_t field, const char* bytes, auto size) {
    if (field == points_.flag() && scan_.fields[field].bits > 0)
      flags_.add(bytes, size);
  })
  {
    layout_ = points_.layout();
    stations_ = {{scan_.name, {}}};
    if (!points_.isAtStation() && scan_.pose.isApprox(Eigen::Isometry3d::Identity()))
      return; // joined and exported before: nobody knows
    setStation(scan_.name, scan_.pose.translation(), scan_.pose.linear());
  }

  /** \brief Points that are flagged as invalid. */
  std::uint64_t
  invalidCount() const
  {
    const auto flag = points_.flag();
    const bool are_same = flag && scan_.fields[*flag].bits == 0;
    return are_same && scan_.fields[*flag].minimum != 0 ? scan_.count : flags_.count();
  }

  const E57Packets&
  packets() const
  {
    return packets_;
  }

  const E57Points&
  points() const
  {
    return points_;
  }

  PCLPointCloud2
  read(std::uint64_t first, std::size_t count) override
  {
    auto part = emptyPart(layout_, count);
    part.data.resize(count * part.point_step);
    const auto streams = packets_.read(first, count, points_.wanted());
    points_.convert(streams, first, count, part.data.data());
    return part;
  }

private:
  std::shared_ptr<E57Pages> pages_; ///< of the file, for all of its scans
  E57Scan scan_;
  E57Points points_;
  FlagCounter flags_;
  E57Packets packets_;
};

} // namespace

bool
isE57(const std::string& /*path*/, const std::string& beginning)
{
  return beginning.compare(0, 8, "ASTM-E57") == 0;
}

std::uint64_t
e57PointCount(const std::string& path, const std::string& /*beginning*/)
{
  E57Pages pages(path);
  std::uint64_t count = 0;
  for (const auto& scan : readE57Scans(pages))
    count += scan.count;
  return count;
}

std::unique_ptr<CloudStream>
openE57(const std::string& path)
{
  const auto pages = std::make_shared<E57Pages>(path);
  std::vector<std::unique_ptr<CloudStream>> streams;
  std::vector<std::string> names, left_out;
  std::uint64_t invalid = 0, size = 0;
  for (auto& scan : readE57Scans(*pages)) {
    if (scan.count > 0x7fffffff)
      throw ToolError(path + ": '" + scan.name + "' has more than 2^31 - 1 points");
    if (scan.count == 0)
      continue;
    names.push_back(scan.name);
    auto stream = std::make_unique<ScanStream>(pages, std::move(scan));
    size += stream->packets().size();
    if (size > pages->size()) // a small file could ask for any time and memory
      throw ToolError(path + ": the file is damaged, its scans share their points");
    invalid += stream->invalidCount();
    for (const auto& name : stream->points().leftOut())
      if (std::count(left_out.begin(), left_out.end(), name) == 0)
        left_out.push_back(name);
    streams.push_back(std::move(stream));
  }
  if (streams.empty())
    throw ToolError(path + ": the cloud is empty (0 points)");
  auto cloud = streams.size() == 1 ? std::move(streams[0])
                                   : joinedStream(std::move(streams), names);
  if (invalid > 0)
    cloud->addNote("points that are flagged as invalid are left out: " +
                   std::to_string(invalid));
  if (!left_out.empty())
    cloud->addNote("fields that are left out: " + someOf(left_out));
  return cloud;
}

} // namespace pcl::indoor::tool
