/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/record_stream.h"

#include "files/cloud_file.h" // for isRealField
#include "files/cloud_sample.h"
#include "files/tool_error.h"
#include "files/usual_fields.h"

#include <filesystem>
#include <fstream>
#include <optional>
#include <utility>

namespace pcl::indoor::tool {
namespace {

class RecordStream : public CloudStream {
public:
  RecordStream(std::string path, CloudRecords records)
  : path_(std::move(path))
  , stream_(path_, std::ios::binary)
  , records_(std::move(records))
  {
    layout_ = std::move(records_.layout);
    pose_ = records_.pose;
    notes_ = std::move(records_.notes);
  }

  /** \return false if there are no points, or not all of them */
  bool
  isWhole() const
  {
    std::error_code error;
    const auto size = std::filesystem::file_size(path_, error);
    const auto begin = records_.body_begin, step = records_.record_size;
    return !error && pointCount() > 0 && step > 0 && size >= begin &&
           (size - begin) / step >= pointCount();
  }

  void
  nameFields()
  {
    PCLPointCloud2 some;
    UsualFields fields(
        layout_, [&]() -> const auto& { return some = pointsFromAllOver(*this); });
    layout_ = fields.of(std::move(layout_));
    notes_.insert(notes_.end(), fields.notes().begin(), fields.notes().end());
    fields_ = std::move(fields);
  }

  PCLPointCloud2
  read(std::uint64_t first, std::size_t count) override
  {
    const auto step = records_.record_size;
    std::string bytes(count * step, '\0');
    stream_.clear();
    stream_.seekg(static_cast<std::streamoff>(records_.body_begin + first * step));
    if (!stream_.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
      throw ToolError(path_ + ": the file can no longer be read");
    auto part = records_.points(std::move(bytes), count);
    return fields_ ? fields_->of(std::move(part)) : part;
  }

private:
  std::string path_;
  std::ifstream stream_;
  CloudRecords records_;
  std::optional<UsualFields> fields_;
};

} // namespace

std::unique_ptr<CloudStream>
recordStream(const std::string& path, CloudRecords records)
{
  auto stream = std::make_unique<RecordStream>(path, std::move(records));
  if (!stream->isWhole())
    return nullptr;
  stream->nameFields();
  for (const char* axis : {"x", "y", "z"})
    if (!isRealField(stream->layout(), axis))
      return nullptr;
  return stream;
}

} // namespace pcl::indoor::tool
