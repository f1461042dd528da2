/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/io/scan_file.h>

#include "files/opened_scan.h"
#include "files/station_choice.h"

#include <utility>

namespace pcl::indoor {

Scan::Scan(std::shared_ptr<ScanContent> content)
: content_(std::move(content))
{}

const std::string&
Scan::name() const
{
  return content_->file.path;
}

std::uint64_t
Scan::pointCount() const
{
  return content_->pointCount();
}

bool
Scan::isReadInParts() const
{
  return content_->stream != nullptr;
}

const PCLPointCloud2&
Scan::cloud() const
{
  return content_->file.cloud;
}

PointCloud<PointXYZ>::ConstPtr
Scan::points() const
{
  return isReadInParts() ? nullptr : content_->file.points;
}

Eigen::Vector3d
Scan::offset() const
{
  const auto& file = content_->file;
  return isReadInParts() ? file.pose.offset : file.offset;
}

const std::vector<Station>&
Scan::stations() const
{
  return content_->file.stations;
}

const std::vector<std::string>&
Scan::notes() const
{
  return content_->file.notes;
}

Scan
loadScan(const std::string& path, const ScanOptions& options)
{
  return loadScan(std::vector<std::string>{path}, options);
}

Scan
loadScan(const std::vector<std::string>& paths, const ScanOptions& options)
{
  const tool::TableColumns columns{options.columns};
  auto opened = tool::openScan(paths, options.points_at_once);
  auto content = opened.isLargerThan(options.points_at_once)
                     ? tool::readLater(std::move(opened), columns)
                     : tool::readWhole(std::move(opened), columns);
  content.points_at_once = options.points_at_once;
  content.stations = {options.stations, options.ignore_stations};
  tool::choose(content.stations, content.file);
  return Scan(std::make_shared<ScanContent>(std::move(content)));
}

} // namespace pcl::indoor
