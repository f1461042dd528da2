/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/io/input_error.h>
#include <pcl/PCLPointCloud2.h>
#include <pcl/scene/scene.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

/** What messages hold, from and to the library's own types. Messages are templates, so
 * that all of it is tested without ROS. */
namespace pcl_indoor_ros {

/** \brief The cloud of a sensor_msgs/PointCloud2; rows follow each other without gaps.
 * \throws pcl::indoor::InputError if the message has fewer bytes than it says
 */
template <typename Message>
pcl::PCLPointCloud2
cloudOf(const Message& message)
{
  const std::size_t row = std::size_t(message.width) * message.point_step;
  const std::size_t rows = row > 0 ? message.height : 0;
  if (rows > 0 && (message.row_step < row || message.data.size() / rows < row ||
                   (rows - 1) * message.row_step + row > message.data.size()))
    throw pcl::indoor::InputError("the cloud has " +
                                  std::to_string(message.data.size()) +
                                  " bytes, too few for " + std::to_string(rows) +
                                  " rows of " + std::to_string(row) + " bytes");
  pcl::PCLPointCloud2 cloud;
  for (const auto& field : message.fields) {
    pcl::PCLPointField copy;
    copy.name = field.name;
    copy.offset = field.offset;
    copy.datatype = field.datatype; // the numbers of the types are the same
    copy.count = field.count;
    cloud.fields.push_back(copy);
  }
  cloud.header.frame_id = message.header.frame_id;
  cloud.width = message.width;
  cloud.height = message.height;
  cloud.point_step = message.point_step;
  cloud.row_step = static_cast<std::uint32_t>(row);
  cloud.is_bigendian = message.is_bigendian;
  cloud.is_dense = message.is_dense;
  cloud.data.resize(rows * row);
  for (std::size_t i = 0; i < rows; ++i)
    std::memcpy(&cloud.data[i * row], &message.data[i * message.row_step], row);
  return cloud;
}

/** \brief A cloud as a message. */
template <typename Message, typename Header>
Message
messageOf(const pcl::PCLPointCloud2& cloud, const Header& header)
{
  Message message;
  message.header = header;
  for (const auto& field : cloud.fields) {
    auto& copy = message.fields.emplace_back();
    copy.name = field.name;
    copy.offset = field.offset;
    copy.datatype = field.datatype;
    copy.count = std::max(1u, field.count);
  }
  message.width = cloud.width;
  message.height = cloud.height;
  message.point_step = cloud.point_step;
  message.row_step = cloud.width * cloud.point_step;
  message.is_bigendian = cloud.is_bigendian != 0;
  message.is_dense = cloud.is_dense != 0;
  message.data.assign(cloud.data.begin(), cloud.data.end());
  return message;
}

/** \brief A number for each point. */
struct PointLabels {
  std::string name;
  std::vector<std::uint32_t> values;
};

/** \brief What a scene says of each point: room, object, structure and category. */
inline std::vector<PointLabels>
pointLabels(const pcl::indoor::Scene& scene)
{
  std::vector<std::uint32_t> categories(scene.object_of_point.size());
  if (!scene.classes.objects.empty())
    for (std::size_t i = 0; i < categories.size(); ++i)
      if (const auto object = scene.object_of_point[i]; object > 0)
        categories[i] = scene.classes.objects[object - 1].category;
  return {{"room", scene.room_of_point},
          {"object", scene.object_of_point},
          {"structure", scene.structure_of_point},
          {"category", categories}};
}

/** \brief The cloud with such fields; those of the same names are taken away.
 * \param[in] labels one value per point each */
inline pcl::PCLPointCloud2
labelled(const pcl::PCLPointCloud2& cloud, const std::vector<PointLabels>& labels)
{
  auto result = cloud;
  const std::size_t old_step = cloud.point_step;
  for (const auto& label : labels) {
    auto& fields = result.fields;
    fields.erase(
        std::remove_if(fields.begin(),
                       fields.end(),
                       [&](const auto& old) { return old.name == label.name; }),
        fields.end());
    pcl::PCLPointField field;
    field.name = label.name;
    field.offset = result.point_step;
    field.datatype = pcl::PCLPointField::UINT32;
    field.count = 1;
    fields.push_back(field);
    result.point_step += sizeof(std::uint32_t);
  }
  const std::size_t count = old_step > 0 ? cloud.data.size() / old_step : 0;
  result.row_step = result.width * result.point_step;
  result.data.resize(count * result.point_step);
  for (std::size_t i = 0; i < count; ++i) {
    auto* const point = &result.data[i * result.point_step];
    std::memcpy(point, &cloud.data[i * old_step], old_step);
    for (std::size_t k = 0; k < labels.size(); ++k)
      std::memcpy(point + old_step + k * sizeof(std::uint32_t),
                  &labels[k].values[i],
                  sizeof(std::uint32_t));
  }
  return result;
}

} // namespace pcl_indoor_ros
