/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/cloud_stream.h"

#include "files/cloud_check.h" // for MemoryStream
#include "files/cloud_file.h"
#include "files/cloud_formats.h"
#include "files/cloud_sample.h"
#include "files/tool_error.h"
#include "files/usual_fields.h"
#include "formats/file_header.h"
#include "formats/las_file.h"
#include "formats/pcd_header.h"
#include "formats/ply_file.h"
#include "formats/silent_pcl.h"

#include <pcl/io/pcd_io.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <utility>

namespace pcl::indoor::tool {
namespace {

constexpr std::size_t points_of_part = 1 << 18;

/** A file whose points are records of one size. */
class FileStream : public CloudStream {
public:
  explicit FileStream(const std::string& path)
  : path_(path)
  {}

  /** Read the header.
   * \return false if the file is of no kind that can be read in parts */
  bool
  open();

  PCLPointCloud2
  read(std::uint64_t first, std::size_t count) override;

private:
  bool
  openPcd();

  bool
  openPly();

  bool
  openLas();

  void
  nameFields();

  std::string path_;
  std::ifstream stream_;
  std::size_t body_begin_ = 0, record_size_ = 0;
  std::function<PCLPointCloud2(std::string records, std::size_t count)> points_;
  std::optional<UsualFields> fields_;
  std::shared_ptr<LasSource> las_; ///< gives the records of LAS and LAZ
};

bool
FileStream::open()
{
  stream_.open(path_, std::ios::binary);
  std::string beginning(512, '\0');
  stream_.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  stream_.clear();
  stream_.seekg(0);
  const bool is_open = isLas(path_, beginning)               ? openLas()
                       : beginning.compare(0, 3, "ply") == 0 ? openPly()
                                                             : openPcd();
  std::error_code error;
  const auto size = std::filesystem::file_size(path_, error);
  if (!is_open || error || pointCount() == 0 || record_size_ == 0)
    return false;
  if (!las_ &&
      (size < body_begin_ || (size - body_begin_) / record_size_ < pointCount()))
    return false;
  if (!las_)
    nameFields();
  return isRealField(layout_, "x") && isRealField(layout_, "y") &&
         isRealField(layout_, "z");
}

void
FileStream::nameFields()
{
  PCLPointCloud2 some;
  UsualFields fields(
      layout_, [&]() -> const auto& { return some = pointsFromAllOver(*this); });
  layout_ = fields.of(std::move(layout_));
  notes_.insert(notes_.end(), fields.notes().begin(), fields.notes().end());
  fields_ = std::move(fields);
}

bool
FileStream::openPcd()
{
  auto header = readFileHeader(stream_, "DATA", path_);
  auto pcd = readPcdHeader(header, path_);
  if (pcd.data != "binary")
    return false;
  std::error_code error; // of what is no plain file the size is not known
  if (const auto size = std::filesystem::file_size(path_, error);
      !error && size > header.body_begin)
    pcd.noteBytes(size - header.body_begin);
  const auto text = pcdHeaderText(header, true);
  MemoryStream stream(text.data(), text.size());
  int version = 0, encoding = 0;
  unsigned int body_begin = 0;
  const SilentPcl silence;
  if (PCDReader().readHeader(stream,
                             layout_,
                             pose_.origin,
                             pose_.orientation,
                             version,
                             encoding,
                             body_begin) != 0 ||
      layout_.point_step != pcd.bytesPerPoint())
    return false;
  readPose(header, pose_);
  pose_.offset = header.offset;
  layout_.data.clear();
  layout_.width = static_cast<std::uint32_t>(pcd.width);
  layout_.height = static_cast<std::uint32_t>(pcd.height);
  layout_.row_step = layout_.point_step * layout_.width;
  body_begin_ = header.body_begin;
  record_size_ = layout_.point_step;
  notes_ = pcd.notes;
  points_ = [layout = layout_](const std::string& records, std::size_t count) {
    auto part = emptyPart(layout, count);
    part.data.assign(records.begin(), records.end());
    return part;
  };
  return true;
}

bool
FileStream::openPly()
{
  auto records = plyRecords(path_);
  if (!records)
    return false;
  layout_ = std::move(records->layout);
  pose_ = {records->origin, records->orientation, records->offset};
  body_begin_ = records->body_begin;
  record_size_ = records->record_size;
  points_ = std::move(records->points);
  return true;
}

bool
FileStream::openLas()
{
  auto records = lasRecords(path_);
  notes_ = records.notes;
  layout_ = records.layout;
  las_ = records.source;
  record_size_ = records.record_size;
  points_ = [this, copy = records.copy](const std::string& bytes, std::size_t count) {
    auto part = emptyPart(layout_, count);
    part.data.resize(count * part.point_step);
    for (std::size_t i = 0; i < count; ++i)
      copy(&bytes[i * record_size_],
           reinterpret_cast<char*>(&part.data[i * part.point_step]));
    return part;
  };
  return true;
}

PCLPointCloud2
FileStream::read(std::uint64_t first, std::size_t count)
{
  std::string records(count * record_size_, '\0');
  stream_.clear();
  stream_.seekg(static_cast<std::streamoff>(body_begin_ + first * record_size_));
  if (las_)
    las_->read(first, count, records.data());
  else if (!stream_.read(records.data(), static_cast<std::streamsize>(records.size())))
    throw ToolError(path_ + ": the file can no longer be read");
  auto part = points_(std::move(records), count);
  return fields_ ? fields_->of(std::move(part)) : part;
}

} // namespace

PCLPointCloud2
emptyPart(const PCLPointCloud2& layout, std::size_t count)
{
  auto part = layout;
  part.width = static_cast<std::uint32_t>(count);
  part.height = 1;
  part.row_step = part.point_step * part.width;
  return part;
}

void
CloudStream::setStation(const std::string& name,
                        const Eigen::Vector3d& position,
                        const Eigen::Matrix3d& turn)
{
  constexpr double tolerance = 1e-3; // as text with three decimals has it
  stations_ = {{name, position}};
  const Eigen::Vector3f origin = position.cast<float>();
  if (!origin.allFinite() || !turn.isUnitary(tolerance) || turn.determinant() < 0)
    return;
  pose_.origin.head<3>() = origin;
  pose_.orientation = Eigen::Quaterniond(turn).cast<float>();
}

std::unique_ptr<CloudStream>
openRecords(const std::string& path)
{
  auto file = std::make_unique<FileStream>(path);
  if (!file->open())
    return nullptr;
  return file;
}

std::unique_ptr<CloudStream>
CloudStream::open(const std::string& path)
{
  try {
    const auto* const format = cloudFormatOf(path);
    return format != nullptr ? format->open(path) : nullptr;
  } catch (const ToolError&) {
    return nullptr;
  }
}

void
CloudStream::forEachPart(
    const std::function<void(std::uint64_t first, PCLPointCloud2& part)>& visit)
{
  for (std::uint64_t first = 0; first < pointCount();) {
    const auto count = static_cast<std::size_t>(
        std::min<std::uint64_t>(points_of_part, pointCount() - first));
    auto part = read(first, count);
    visit(first, part);
    first += count;
  }
}

} // namespace pcl::indoor::tool
