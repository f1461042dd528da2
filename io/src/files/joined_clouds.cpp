/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/joined_clouds.h"

#include "files/field_value.h"
#include "files/tool_error.h"

#include <pcl/common/io.h> // for getFieldIndex

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <cstring>
#include <limits>
#include <utility>

namespace pcl::indoor::tool {
namespace {

constexpr const char* station_field = "station";
constexpr const char* coordinates[] = {"x", "y", "z"};

bool
isAxis(const std::string& name)
{
  return std::find(std::begin(coordinates), std::end(coordinates), name) !=
         std::end(coordinates);
}

const PCLPointField*
fieldOf(const PCLPointCloud2& layout, const std::string& name)
{
  const int index = getFieldIndex(layout, name);
  return index < 0 ? nullptr : &layout.fields[static_cast<std::size_t>(index)];
}

/** The notes of several scans, those that are the same as one. */
std::vector<std::string>
notesOf(const std::vector<std::string>& scan_names,
        const std::vector<std::unique_ptr<CloudStream>>& scans)
{
  std::vector<std::pair<std::string, std::vector<std::string>>> scans_of_note;
  for (std::size_t i = 0; i < scans.size(); ++i)
    for (const auto& note : scans[i]->notes()) {
      auto same = std::find_if(scans_of_note.begin(),
                               scans_of_note.end(),
                               [&](const auto& other) { return other.first == note; });
      if (same == scans_of_note.end())
        same = scans_of_note.insert(same, {note, {}});
      same->second.push_back(scan_names[i]);
    }
  std::vector<std::string> notes;
  for (const auto& [note, names] : scans_of_note)
    notes.push_back(
        names.front() +
        (names.size() > 1 ? " and " + std::to_string(names.size() - 1) + " more" : "") +
        ": " + note);
  return notes;
}

class StreamInMemory : public CloudStream {
public:
  StreamInMemory(PCLPointCloud2 cloud,
                 const CloudPose& pose,
                 std::vector<std::string> notes,
                 std::vector<Station> stations)
  : data_(std::move(cloud.data))
  {
    notes_ = std::move(notes);
    stations_ = std::move(stations);
    layout_ = std::move(cloud);
    layout_.data.clear();
    pose_ = pose;
  }

  PCLPointCloud2
  read(std::uint64_t first, std::size_t count) override
  {
    auto part = emptyPart(layout_, count);
    const auto* begin = data_.data() + first * layout_.point_step;
    part.data.assign(begin, begin + count * layout_.point_step);
    return part;
  }

private:
  std::vector<std::uint8_t> data_;
};

class JoinedStream : public CloudStream {
public:
  JoinedStream(std::vector<std::unique_ptr<CloudStream>> scans,
               const std::vector<std::string>& names)
  : scans_(std::move(scans))
  {
    pose_.offset = scans_.front()->pose().offset;
    for (std::size_t s = 0; s < scans_.size(); ++s)
      addStations(*scans_[s], names[s]);
    notes_ = notesOf(names, scans_);
    makeFields();
    std::uint64_t count = 0;
    for (const auto& scan : scans_)
      count += scan->pointCount();
    if (count > std::numeric_limits<std::uint32_t>::max())
      throw ToolError("the scans have " + std::to_string(count) +
                      " points, more than the 4294967295 of a file");
    layout_.width = static_cast<std::uint32_t>(count);
    layout_.height = 1;
    layout_.row_step = layout_.point_step * layout_.width;
  }

  PCLPointCloud2
  read(std::uint64_t first, std::size_t count) override
  {
    auto part = emptyPart(layout_, count);
    part.data.resize(count * layout_.point_step);
    auto* target = part.data.data();
    for (std::size_t s = 0; s < scans_.size() && count > 0; ++s) {
      const auto own = scans_[s]->pointCount();
      if (first >= own) {
        first -= own;
        continue;
      }
      const auto taken = static_cast<std::size_t>(
          std::min<std::uint64_t>(own - first, static_cast<std::uint64_t>(count)));
      put(scans_[s]->read(first, taken), s, target);
      target += taken * layout_.point_step;
      count -= taken;
      first = 0;
    }
    return part;
  }

private:
  void
  addStations(const CloudStream& scan, const std::string& name)
  {
    const auto& own = scan.stations();
    first_stations_.push_back(static_cast<std::uint32_t>(stations_.size() + 1));
    if (own.empty()) {
      const Eigen::Vector3d origin = scan.pose().origin.head<3>().cast<double>();
      stations_.push_back({name, {}});
      if (!origin.isZero())
        stations_.back().position = origin + scan.pose().offset;
    }
    for (const auto& station : own)
      stations_.push_back(
          {own.size() > 1 ? name + ": " + station.name : name, station.position});
  }

  /** The field of a scan that a field of the whole comes from; null if it cannot. */
  const PCLPointField*
  source(const PCLPointField& field, const CloudStream& scan) const
  {
    const auto* own = fieldOf(scan.layout(), field.name);
    const bool fits =
        own != nullptr && (isAxis(field.name) || (own->datatype == field.datatype &&
                                                  byteCount(*own) == byteCount(field)));
    return fits ? own : nullptr;
  }

  bool
  hasExactFloats() const
  {
    return std::all_of(scans_.begin(), scans_.end(), [&](const auto& scan) {
      return scan->pose().offset == pose_.offset &&
             std::all_of(
                 std::begin(coordinates), std::end(coordinates), [&](const char* axis) {
                   return fieldOf(scan->layout(), axis)->datatype ==
                          PCLPointField::FLOAT32;
                 });
    });
  }

  void
  makeFields()
  {
    const auto real =
        hasExactFloats() ? PCLPointField::FLOAT32 : PCLPointField::FLOAT64;
    for (auto field : scans_.front()->layout().fields) {
      if (isAxis(field.name))
        field.datatype = real;
      const bool in_all = std::all_of(scans_.begin(), scans_.end(), [&](const auto& s) {
        return source(field, *s) != nullptr;
      });
      if (in_all && field.name != station_field && field.name != "_")
        appendTo(layout_, field.name, field.datatype, field.count);
    }
    std::vector<std::string> left_out;
    for (const auto& scan : scans_)
      for (const auto& field : scan->layout().fields)
        if (field.name != "_" && field.name != station_field &&
            fieldOf(layout_, field.name) == nullptr &&
            std::find(left_out.begin(), left_out.end(), field.name) == left_out.end())
          left_out.push_back(field.name);
    if (!left_out.empty())
      addNote("fields that not all of the scans have are left out: " +
              boost::algorithm::join(left_out, ", "));
    appendTo(layout_, station_field, PCLPointField::UINT32);
  }

  /** Write points of a scan with the fields of the whole. */
  void
  put(const PCLPointCloud2& points, std::size_t scan, std::uint8_t* target) const
  {
    const Eigen::Vector3d shift = scans_[scan]->pose().offset - pose_.offset;
    const std::size_t count = static_cast<std::size_t>(points.width) * points.height;
    for (const auto& field : layout_.fields) {
      const bool is_station = field.name == station_field;
      const auto* own = is_station ? nullptr : source(field, *scans_[scan]);
      const bool converts =
          isAxis(field.name) && field.datatype == PCLPointField::FLOAT64;
      const auto* own_station = scans_[scan]->stations().size() > 1
                                    ? fieldOf(points, station_field)
                                    : nullptr;
      for (std::size_t i = 0; i < count; ++i) {
        auto* to = target + i * layout_.point_step + field.offset;
        if (is_station) {
          std::uint32_t station = first_stations_[scan];
          if (own_station != nullptr)
            station += static_cast<std::uint32_t>(
                valueAt(&points.data[i * points.point_step + own_station->offset],
                        own_station->datatype) -
                1);
          std::memcpy(to, &station, sizeof(station));
          continue;
        }
        const auto* from = &points.data[i * points.point_step + own->offset];
        if (!converts) {
          std::memcpy(to, from, byteCount(field));
          continue;
        }
        const double value = valueAt(from, own->datatype) + shift[field.name[0] - 'x'];
        std::memcpy(to, &value, sizeof(value));
      }
    }
  }

  std::vector<std::unique_ptr<CloudStream>> scans_;
  std::vector<std::uint32_t> first_stations_; ///< of each scan, from 1
};

} // namespace

std::unique_ptr<CloudStream>
streamInMemory(PCLPointCloud2 cloud,
               const CloudPose& pose,
               std::vector<std::string> notes,
               std::vector<Station> stations)
{
  return std::make_unique<StreamInMemory>(
      std::move(cloud), pose, std::move(notes), std::move(stations));
}

std::unique_ptr<CloudStream>
joinedStream(std::vector<std::unique_ptr<CloudStream>> scans,
             const std::vector<std::string>& names)
{
  return std::make_unique<JoinedStream>(std::move(scans), names);
}

} // namespace pcl::indoor::tool
