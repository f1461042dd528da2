/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Facts of the format: ASPRS, LAS Specification 1.4, R15.
#include "formats/las/las_file.h"

#include "files/field_value.h" // for appendTo
#include "formats/las/las_fields.h"
#include "formats/las/las_header.h"
#include "formats/las/las_source.h"

#include <pcl/PCLPointField.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <limits>
#include <vector>

namespace pcl::indoor::tool {
namespace {

/** How many records are read at once: fewer of long ones, so that a file cannot ask for
 * more memory than it fills. */
std::size_t
pointsAtOnce(std::size_t record_size)
{
  constexpr std::size_t most_points = 1 << 18; // a few chunks of a LAZ file
  constexpr std::size_t most_bytes = 64 << 20;
  return std::clamp<std::size_t>(most_bytes / record_size, 1, most_points);
}

/** What a look at all points of a file tells. */
struct LasLook {
  std::uint64_t withheld = 0;
  std::uint16_t largest_color = 0;
  bool has_fine_colors = false;    ///< of which 8 bits are not all
  std::uint64_t narrow_colors = 0; ///< of points: no channel exceeds 255, one exceeds 0

  bool
  hasWideColors() const
  {
    return largest_color > 255;
  }

  /** Colours of 8 bits and of 16; the darkest of 16 bits are fewer. */
  bool
  hasMixedColors(std::uint64_t points) const
  {
    constexpr double clearly = 0.05;
    return hasWideColors() &&
           static_cast<double>(narrow_colors) > clearly * static_cast<double>(points);
  }
};

/** Look at some records. */
void
lookAt(const std::string& records, const LasHeader& header, LasLook& look)
{
  const auto colors = header.places().colors;
  for (std::size_t at = 0; at < records.size(); at += header.step) {
    look.withheld += header.isWithheld(&records[at]);
    std::uint16_t largest = 0;
    for (std::size_t channel = 0; channel < 3 && colors > 0; ++channel) {
      const auto value = numberAt<std::uint16_t>(&records[at + colors + 2 * channel]);
      const unsigned low = value & 0xffu, high = value >> 8;
      largest = std::max(largest, value);
      look.has_fine_colors = look.has_fine_colors || (low != 0 && low != high);
    }
    look.largest_color = std::max(look.largest_color, largest);
    look.narrow_colors += largest > 0 && largest <= 255;
  }
}

/** Read all records, a part at a time. */
void
forEachPart(const OpenLas& file, const std::function<void(std::string records)>& visit)
{
  const auto at_once = pointsAtOnce(file.header.step);
  for (std::uint64_t done = 0; done < file.header.points; done += at_once) {
    const auto count = static_cast<std::size_t>(
        std::min<std::uint64_t>(at_once, file.header.points - done));
    std::string records(count * file.header.step, '\0');
    file.source->read(done, count, records.data());
    visit(std::move(records));
  }
}

/** Copies the fields of a point; of one that is withheld without its place. */
std::function<void(const char*, char*)>
copierOf(const std::vector<LasField>& fields,
         const LasLook& look,
         const LasHeader& header)
{
  return [fields, has_withheld = look.withheld > 0, header](const char* record,
                                                            char* point) {
    char* const begin = point;
    for (const auto& field : fields) {
      field.copy(record, point);
      point += field.size;
    }
    constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
    if (has_withheld && header.isWithheld(record))
      for (std::size_t axis = 0; axis < 3; ++axis)
        std::memcpy(begin + axis * sizeof(double), &nowhere, sizeof(double));
  };
}

/** Fields and width of the cloud. */
void
layOut(const std::vector<LasField>& fields,
       const LasHeader& header,
       PCLPointCloud2& layout)
{
  layout.width = static_cast<std::uint32_t>(header.points);
  layout.height = 1;
  for (const auto& field : fields)
    appendTo(layout, field.name, field.type);
  layout.row_step = layout.point_step * layout.width;
}

void
addLookNotes(const LasLook& look, bool are_mixed, std::vector<std::string>& notes)
{
  if (look.largest_color > 0 && look.largest_color <= 255)
    notes.emplace_back(
        "its colours have 8 bits in fields of 16, none exceeds 255: they "
        "are taken as they are");
  if (are_mixed)
    notes.push_back("its colours have 8 bits in " + std::to_string(look.narrow_colors) +
                    " points, of which none exceeds 255, and 16 in others: they are "
                    "taken so");
  if (look.withheld > 0)
    notes.push_back("points that are flagged as withheld are left out: " +
                    std::to_string(look.withheld));
}

/** How the points lie in the file, and how they become those of a cloud. */
struct LasRecords {
  PCLPointCloud2 layout; ///< fields and width, no points
  std::size_t record_size = 0;
  std::shared_ptr<LasSource> source;
  std::function<void(const char* record, char* point)> copy;
  std::vector<std::string> notes; ///< see CloudFile::notes
};

LasRecords
recordsOf(OpenLas file, const LasLook& look)
{
  LasRecords records;
  const bool are_wide = look.hasWideColors();
  const LasColors colors{are_wide ? 8u : 0u,
                         are_wide && look.has_fine_colors,
                         look.hasMixedColors(file.header.points)};
  const auto fields = lasFields(file.bytes, file.header, colors, file.notes);
  addLookNotes(look, colors.are_mixed, file.notes);
  layOut(fields, file.header, records.layout);
  records.record_size = file.header.step;
  records.copy = copierOf(fields, look, file.header);
  records.notes = std::move(file.notes);
  records.source = std::move(file.source);
  return records;
}

/** Decodes its points part by part. */
class LasStream : public CloudStream {
public:
  explicit LasStream(LasRecords records)
  : records_(std::move(records))
  {
    layout_ = records_.layout;
    notes_ = records_.notes;
  }

  PCLPointCloud2
  read(std::uint64_t first, std::size_t count) override
  {
    const auto step = records_.record_size;
    const auto at_once = std::min(count, pointsAtOnce(step));
    std::string bytes(at_once * step, '\0');
    auto part = emptyPart(layout_, count);
    part.data.resize(count * part.point_step);
    auto* target = reinterpret_cast<char*>(part.data.data());
    for (std::size_t done = 0; done < count; done += at_once) {
      const auto some = std::min(at_once, count - done);
      records_.source->read(first + done, some, bytes.data());
      for (std::size_t i = 0; i < some; ++i, target += part.point_step)
        records_.copy(&bytes[i * step], target);
    }
    return part;
  }

private:
  LasRecords records_;
};

} // namespace

bool
isLas(const std::string& /*path*/, const std::string& beginning)
{
  return beginning.compare(0, 4, "LASF") == 0;
}

std::uint64_t
lasPointCount(const std::string& /*path*/, const std::string& beginning)
{
  const auto header = parseLasHeader(beginning);
  return header ? header->points : 0;
}

std::unique_ptr<CloudStream>
openLasFile(const std::string& path)
{
  auto file = openLas(path);
  LasLook look;
  forEachPart(file, [&](const std::string& part) { lookAt(part, file.header, look); });
  auto stream = std::make_unique<LasStream>(recordsOf(std::move(file), look));
  if (stream->pointCount() == 0)
    return nullptr;
  return stream;
}

void
loadLas(CloudFile& file, const TableColumns& /*columns*/)
{
  auto las = openLas(file.path);
  LasLook look;
  std::vector<std::string> parts; // read once: to decode a LAZ file takes longest
  forEachPart(las, [&](std::string part) {
    lookAt(part, las.header, look);
    parts.push_back(std::move(part));
  });
  const auto records = recordsOf(std::move(las), look);
  file.notes = records.notes;
  auto& cloud = file.cloud;
  cloud = records.layout;
  cloud.data.resize(static_cast<std::size_t>(cloud.point_step) * cloud.width);
  auto* target = reinterpret_cast<char*>(cloud.data.data());
  for (auto& part : parts) {
    for (std::size_t at = 0; at < part.size(); at += records.record_size) {
      records.copy(&part[at], target);
      target += cloud.point_step;
    }
    part = {};
  }
}

} // namespace pcl::indoor::tool
