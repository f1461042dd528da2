/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "rooms/spooled_rooms.h"

#include "files/digest.h"
#include "files/tool_error.h"
#include "formats/record.h"
#include "rooms/room_points_file.h"
#include "scan/scan.h"

#include <pcl/common/point_tests.h> // for isFinite

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <optional>
#include <set>
#include <utility>

namespace pcl::indoor::tool {

template <typename Record>
void
exchange(Record& record, RoomExtent& room)
{
  record(room.point_count, room.lower, room.upper, room.sum);
}

template <typename Record>
void
exchange(Record& record, SpooledRooms& spooled)
{
  record(spooled.rooms,
         spooled.sizes,
         spooled.point_count,
         spooled.outside,
         spooled.digests);
}

namespace {

constexpr const char* stage_file = "points_filed";  // written when all are
constexpr const char* labels_file = "points_rooms"; // a number per point
constexpr std::uint32_t in_no_file = 0xffffffffu;
constexpr std::uint32_t in_no_room = 0x80000000u; // added to the number of the file
constexpr std::size_t block_size = 12 << 10;      // bytes: whole vectors, whole labels

void
appendTo(const std::string& path, const std::string& bytes)
{
  std::ofstream stream(path, std::ios::binary | std::ios::app);
  errno = 0;
  if (!stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size())) ||
      !stream.flush())
    throw ToolError(path + ": cannot be written, " + std::strerror(errno));
}

/** The files of the points of some rooms and of those in none, and that of labels. */
std::vector<std::string>
fileNames(std::size_t room_count)
{
  std::vector<std::string> names;
  for (std::size_t room = 0; room <= room_count; ++room)
    names.push_back(pointsFile(room));
  names.emplace_back(labels_file);
  return names;
}

/** Collects what goes to the end of several files, block by block. */
class Appender {
public:
  Appender(WorkFolder& folder, const std::vector<std::string>& names)
  : buffers_(names.size())
  , digests_(names.size(), 0)
  {
    for (const auto& name : names) {
      folder.removeFile(name);
      paths_.push_back(folder.path(name));
      appendTo(paths_.back(), "");
    }
  }

  void
  add(std::size_t file, const void* bytes, std::size_t size)
  {
    buffers_[file].append(static_cast<const char*>(bytes), size);
    if (buffers_[file].size() == block_size)
      flush(file);
  }

  /** \return the digest of each file, as digestOfFile() gives it */
  const std::vector<std::uint64_t>&
  flushAll()
  {
    for (std::size_t file = 0; file < buffers_.size(); ++file)
      flush(file);
    return digests_;
  }

private:
  void
  flush(std::size_t file)
  {
    appendTo(paths_[file], buffers_[file]);
    digests_[file] = digestOf(buffers_[file], digests_[file]);
    buffers_[file].clear();
  }

  std::vector<std::string> paths_, buffers_;
  std::vector<std::uint64_t> digests_;
};

void
extend(RoomExtent& room, const Eigen::Vector3f& point)
{
  if (room.point_count++ == 0)
    room.lower = room.upper = point;
  room.lower = room.lower.cwiseMin(point);
  room.upper = room.upper.cwiseMax(point);
  room.sum += point.cast<double>();
}

/** Points of a strip of the building across x, and what is around it. The first one is
 * none but the corner of the building, from which cells are counted in every strip. */
struct Strip {
  std::vector<std::size_t> points;
  std::vector<Eigen::Vector3f> positions;
  std::vector<std::uint32_t> rooms;
};

/** \param[in] range of x, metres */
Strip
stripOf(const Scene& scene,
        const PointCloud<PointXYZ>& upright,
        const Eigen::Vector3f& corner,
        const std::pair<float, float>& range)
{
  Strip strip = {{0}, {corner}, {0}};
  for (std::size_t i = 0; i < upright.size(); ++i)
    if (const auto& point = upright[i];
        isFinite(point) && point.x >= range.first && point.x < range.second) {
      strip.points.push_back(i);
      strip.positions.emplace_back(point.getVector3fMap());
      strip.rooms.push_back(scene.room_of_point[i]);
    }
  return strip;
}

/** The file of each point of the sample: 0 ... rooms for the rooms with what surrounds
 * them, the last for the others. Strip by strip: a large building has many points.
 * \param[in] upright points of the sample, z up, metres; not finite where outside */
std::vector<std::uint32_t>
filesOfSample(const Scene& scene, const PointCloud<PointXYZ>& upright)
{
  constexpr float width = 64.0f; // metres
  constexpr float around = 1.0f; // metres, more than withSurroundings() looks at
  std::set<float> begins;        // of strips that have points
  Eigen::AlignedBox3f box;
  for (const auto& point : upright)
    if (isFinite(point)) {
      begins.insert(width * std::floor(point.x / width));
      box.extend(point.getVector3fMap());
    }
  const auto count = static_cast<std::uint32_t>(scene.rooms.size());
  std::vector<std::uint32_t> files(upright.size(), in_no_file);
  for (const float begin : begins) {
    const auto strip =
        stripOf(scene, upright, box.min(), {begin - around, begin + width + around});
    const auto rooms = withSurroundings(strip.positions, strip.rooms);
    for (std::size_t k = 1; k < rooms.size(); ++k)
      if (const float x = strip.positions[k].x(); x >= begin && x < begin + width)
        files[strip.points[k]] =
            (rooms[k] + count) % (count + 1) + (strip.rooms[k] == 0 ? in_no_room : 0);
  }
  return files;
}

SpooledRooms
spoolPoints(ScanContent& scan,
            bool with_normals,
            WorkFolder& folder,
            const Scene& scene,
            const PointCloud<PointXYZ>& upright,
            const PointsDone& report)
{
  const std::size_t file_count = scene.rooms.size() + 1;
  const auto file_of_sample = filesOfSample(scene, upright);
  folder.removeFile(stage_file);
  Appender files(folder, fileNames(scene.rooms.size()));
  SpooledRooms spooled;
  spooled.rooms.resize(file_count - 1);
  spooled.sizes.assign(file_count, 0);
  spooled.point_count = scan.stream->pointCount();
  scan.stream->forEachPart([&](std::uint64_t first, PCLPointCloud2& data) {
    const auto part = partOf(scan, std::move(data));
    const auto normals = with_normals ? readNormals(part) : nullptr;
    const auto numbers = scan.sample->find(*part.points);
    for (std::size_t i = 0; i < part.points->size(); ++i) {
      const auto& point = (*part.points)[i];
      std::uint32_t file = in_no_file;
      if (isFinite(point)) {
        if (numbers[i] == CellSample::absent)
          throw ToolError(scan.file.path + ": the file has changed, start again");
        file = file_of_sample[numbers[i]];
        spooled.outside += file == in_no_file;
      }
      files.add(file_count, &file, sizeof(file));
      if (file == in_no_file)
        continue;
      if (file < in_no_room)
        extend(spooled.rooms[file], point.getVector3fMap());
      file &= ~in_no_room;
      files.add(file, point.data, sizeof(Eigen::Vector3f));
      if (normals)
        files.add(file, (*normals)[i].normal, sizeof(Eigen::Vector3f));
      ++spooled.sizes[file];
    }
    report(first + part.points->size(), spooled.point_count);
  });
  spooled.digests = files.flushAll();
  RecordWriter record;
  record(spooled);
  folder.write(stage_file, record.bytes());
  return spooled;
}

/** Are all files as they were written? */
bool
areWhole(const WorkFolder& folder, const SpooledRooms& spooled)
{
  const auto names = fileNames(spooled.rooms.size());
  for (std::size_t file = 0; file < names.size(); ++file)
    if (digestOfFile(folder.path(names[file]), block_size) != spooled.digests.at(file))
      return false;
  return true;
}

/** What an earlier run has put into files; nothing if one of them is damaged. */
std::optional<SpooledRooms>
filedBefore(const WorkFolder& folder)
{
  const auto bytes = folder.read(stage_file);
  if (!bytes)
    return {};
  try {
    SpooledRooms spooled;
    RecordReader record(*bytes);
    record(spooled);
    record.finish();
    return areWhole(folder, spooled) ? std::optional(std::move(spooled)) : std::nullopt;
  } catch (const DamagedRecord&) {
    return {};
  } catch (const ToolError&) { // a file is gone
    return {};
  }
}

} // namespace

SpooledRooms
spoolRooms(ScanContent& scan,
           bool with_normals,
           WorkFolder& folder,
           const PointCloud<PointXYZ>& upright,
           Scene& scene,
           const PointsDone& report)
{
  auto before = filedBefore(folder);
  auto spooled = before
                     ? std::move(*before)
                     : spoolPoints(scan, with_normals, folder, scene, upright, report);
  for (std::size_t i = 0; i < scene.rooms.size(); ++i) {
    const auto& own = spooled.rooms.at(i);
    auto& room = scene.rooms[i];
    room.point_count = own.point_count;
    room.lower = own.lower.cast<double>();
    room.upper = own.upper.cast<double>();
    if (own.point_count > 0)
      room.centroid = own.sum / static_cast<double>(own.point_count);
  }
  return spooled;
}

RoomSource
spooledSource(const SpooledRooms& spooled, bool with_normals, const WorkFolder& folder)
{
  RoomSource source;
  source.is_spooled = true;
  source.has_normals = with_normals;
  source.sizes = spooled.sizes;
  source.points = [&folder, sizes = source.sizes, with_normals](std::size_t room) {
    return readRoomPoints(folder.path(pointsFile(room)), sizes[room], with_normals);
  };
  return source;
}

SpooledLabels::SpooledLabels(const SpooledRooms& spooled,
                             const WorkFolder& folder,
                             const std::vector<std::uint32_t>& first_object)
: filed_(spooled)
, folder_(folder)
, first_object_(first_object)
, rooms_(folder.path(labels_file), std::ios::binary)
, cursors_(spooled.sizes.size())
{}

void
SpooledLabels::refill(std::size_t room)
{
  constexpr std::size_t most = 4096;
  auto& cursor = cursors_[room];
  const auto size = filed_.sizes[room];
  const auto count = std::min(most, size - cursor.taken);
  const auto take = [&](std::size_t first, std::vector<std::uint32_t>& values) {
    values.resize(count);
    folder_.readPart(roomFile(room), first, values.data(), count * sizeof(values[0]));
  };
  // as roomBytes() lays them out: two lists, in front of each its length
  constexpr std::size_t length = sizeof(std::uint64_t), each = sizeof(std::uint32_t);
  take(length + each * cursor.taken, cursor.objects);
  take(2 * length + each * (size + cursor.taken), cursor.structures);
  cursor.taken += count;
  cursor.at = 0;
}

SpooledLabels::Label
SpooledLabels::next()
{
  std::uint32_t file = 0;
  if (!rooms_.read(reinterpret_cast<char*>(&file), sizeof(file)))
    throw ToolError(folder_.path(labels_file) + ": the file is gone or too short");
  if (file == in_no_file)
    return {};
  const bool is_in_room = file < in_no_room;
  file &= ~in_no_room;
  auto& cursor = cursors_.at(file);
  if (cursor.at == cursor.objects.size())
    refill(file);
  Label label;
  label.room = is_in_room ? file + 1 : 0;
  const auto object = cursor.objects[cursor.at];
  label.object = object > 0 ? first_object_[file] + object : 0;
  label.structure = cursor.structures[cursor.at++];
  return label;
}

} // namespace pcl::indoor::tool
