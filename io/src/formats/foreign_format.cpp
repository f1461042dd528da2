/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/foreign_format.h"

#include "formats/file_ending.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <vector>

namespace pcl::indoor::tool {
namespace {

/** A format that is not read. */
struct Format {
  const char* name;
  std::vector<std::string> beginnings; ///< first bytes
  std::vector<std::string> endings;    ///< of file names, small letters
  const char*
      advice; ///< IN stands for the file, OUT for it with the ending that follows
};

constexpr const char* laspy =
    "unpack it (needs python3-venv): python3 -m venv las && las/bin/pip install "
    "'laspy[lazrs]' && las/bin/python -c 'import sys, laspy; "
    "laspy.read(sys.argv[1]).write(sys.argv[2])' IN OUT.las";
constexpr const char* cloud_compare =
    "convert it (needs cloudcompare): QT_QPA_PLATFORM=offscreen "
    "CloudCompare -SILENT -AUTO_SAVE OFF -O -GLOBAL_SHIFT AUTO IN -C_EXPORT_FMT PLY "
    "-MERGE_CLOUDS -SAVE_CLOUDS";
constexpr const char* assimp =
    "convert it (needs assimp-utils): assimp export IN OUT.obj";
constexpr const char* from_its_program =
    "only its maker's programs read it: export it from there as E57, LAS, PLY or PTX";

/** Of two that fit, the earlier one is meant. */
const std::vector<Format> formats = {
    {"a LAZ file", {"LASF"}, {".laz"}, laspy}, // LAS is none of these
    {"a file of CloudCompare", {"CCB"}, {}, cloud_compare},
    {"a ReCap project or scan", {}, {".rcp", ".rcs"}, from_its_program},
    {"a scan of FARO", {}, {".fls", ".fws", ".lsproj"}, from_its_program},
    {"a scan of Leica", {}, {".lgs", ".lgsx", ".imp"}, from_its_program},
    {"a scan of Z+F", {}, {".zfs", ".zfprj"}, from_its_program},
    {"a scan of Riegl", {}, {".rdbx", ".rxp"}, from_its_program},
    {"a scan of Trimble", {}, {".tzf", ".rwp", ".tdx"}, from_its_program},
    {"a scan of Topcon", {}, {".cl3", ".clr"}, from_its_program},
    {"a cloud of Pointools or ReCap", {}, {".pod", ".pcg"}, from_its_program},
    {"a cloud compressed by Draco",
     {"DRACO"},
     {".drc"},
     "unpack it (needs draco): draco_decoder -i IN -o OUT.ply"},
    {"a USD scene",
     {"PXR-USDC", "#usda"},
     {".usdz", ".usdc", ".usda", ".usd"},
     "export the scan as GLB, OBJ or PLY from the program that made it"},
    {"a glTF file in parts", {}, {".gltf"}, assimp},
    {"an FBX scene", {"Kaydara FBX"}, {".fbx"}, assimp},
    {"a COLLADA scene", {}, {".dae"}, assimp},
    {"a 3DS scene", {}, {".3ds"}, assimp},
    {"an X3D scene", {}, {".x3d", ".wrl"}, assimp},
    {"a Blender scene",
     {"BLENDER"},
     {".blend"},
     "export it: blender -b IN --python-expr 'import bpy; "
     "bpy.ops.wm.obj_export(filepath=\"scan.obj\")'"},
    {"a drawing (DXF)",
     {"AutoCAD Binary DXF"},
     {".dxf"},
     "it has lines and no scan: give the scan that it was drawn from"},
    {"a drawing (DWG)",
     {"AC10"},
     {".dwg"},
     "it has lines and no scan: give the scan that it was drawn from"},
    {"a model of a drawing program",
     {"ISO-10303-21"},
     {".ifc", ".stp", ".step", ".rvt", ".skp", ".3dm", ".nwd"},
     "export its surfaces as OBJ, GLB or STL from the program that made it"},
    {"a ROS bag",
     {"#ROSBAG"},
     {".bag"},
     "it holds single messages: save the map that was made of them as PCD or PLY"},
    {"a ROS 2 bag",
     {"\x89MCAP", "SQLite format 3"},
     {".mcap", ".db3"},
     "it holds single messages: save the map that was made of them as PCD or PLY"},
    {"a capture of packets",
     {"\xd4\xc3\xb2\xa1", "\xa1\xb2\xc3\xd4", "\x0a\x0d\x0d\x0a"},
     {".pcap", ".pcapng"},
     "it holds single packets: save the map that was made of them as PCD or PLY"},
    {"an array of NumPy",
     {"\x93NUMPY"},
     {".npy"},
     "write its columns x, y, z (needs python3-numpy): python3 -c 'import sys, numpy; "
     "numpy.savetxt(sys.argv[2], numpy.load(sys.argv[1])[:, :3], \"%.4f\")' IN "
     "OUT.xyz"},
    {"numbers without names",
     {},
     {".bin", ".dat", ".raw"},
     "if they are floats x, y, z, intensity, as KITTI has them (needs python3-numpy): "
     "python3 -c 'import sys, numpy; numpy.savetxt(sys.argv[2], numpy.fromfile("
     "sys.argv[1], numpy.float32).reshape(-1, 4)[:, :3], \"%.4f\")' IN OUT.xyz"},
    {"arrays of NumPy",
     {},
     {".npz"},
     "write the columns x, y, z of its points as text by numpy.savetxt()"},
    {"an HDF5 file",
     {"\x89HDF"},
     {".h5", ".hdf5"},
     "write the columns x, y, z of its points as text"},
    {"data of Python", {}, {".pkl", ".pth", ".pt"}, "write its points as text or PLY"},
    {"data of MATLAB",
     {"MATLAB 5.0"},
     {".mat"},
     "write the columns x, y, z of its points as text"},
    {"a file of VTK",
     {"# vtk DataFile", "<VTKFile"},
     {".vtk", ".vtp", ".vtu"},
     "save its points as CSV or its surface as PLY from ParaView"},
    {"a tile for web maps",
     {"pnts", "b3dm", "i3dm", "cmpt"},
     {".pnts", ".b3dm"},
     "give the scan that the tiles were made of"},
    {"a spreadsheet", {}, {".xlsx", ".xls", ".ods"}, "save it as CSV"},
    {"a web page",
     {"<!DOCTYPE html", "<!doctype html", "<html"},
     {".html"},
     "the download has failed: fetch the scan again"},
    {"a pointer of Git LFS",
     {"version https://git-lfs"},
     {},
     "fetch the file that it stands for: git lfs pull"},
    {"a picture or film",
     {"\x89PNG", "\xff\xd8\xff", "GIF8", "II*", "%PDF"},
     {".png", ".jpg", ".jpeg", ".tif", ".tiff", ".mp4", ".mov", ".pdf"},
     "it has no points: give the scan"},
    {"a text in UTF-16",
     {"\xff\xfe", "\xfe\xff"},
     {},
     "convert it: iconv -f UTF-16 -t UTF-8 IN -o OUT.txt"}};

/** By its first bytes, else by the ending of its name. */
const Format*
formatOf(const std::string& path, const std::string& beginning)
{
  const auto begins = [&](const Format& format) {
    return std::any_of(
        format.beginnings.begin(), format.beginnings.end(), [&](const auto& magic) {
          return beginning.compare(0, magic.size(), magic) == 0;
        });
  };
  const auto ends = [ending = fileEnding(path)](const Format& format) {
    return std::count(format.endings.begin(), format.endings.end(), ending) > 0;
  };
  const auto first = [](const auto& is_it) {
    const auto found = std::find_if(formats.begin(), formats.end(), is_it);
    return found == formats.end() ? nullptr : &*found;
  };
  const auto* by_bytes = first(begins);
  const auto* by_name = first(ends);
  return by_bytes != nullptr ? by_bytes : by_name;
}

/** A file name as a shell wants it. */
std::string
quoted(const std::string& name)
{
  const auto is_plain = [](char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) != 0 ||
           std::string("/._-+:@%").find(letter) != std::string::npos;
  };
  if (std::all_of(name.begin(), name.end(), is_plain))
    return name;
  std::string text = "'";
  for (const char letter : name)
    text += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return text + "'";
}

/** The file with another ending; never the file itself. */
std::string
outputOf(const std::string& path, const std::string& ending)
{
  auto output = std::filesystem::path(path).replace_extension(ending);
  if (output == path)
    output.replace_extension(".unpacked" + ending);
  return quoted(output.string());
}

} // namespace

std::string
describeForeignFormat(const std::string& path, const std::string& beginning)
{
  const auto* const format = formatOf(path, beginning);
  if (format == nullptr)
    return "";
  std::string advice = format->advice;
  if (const auto out = advice.rfind(" OUT."); out != advice.npos)
    advice.replace(out + 1, advice.npos, outputOf(path, advice.substr(out + 4)));
  if (const auto in = advice.find(" IN"); in != advice.npos)
    advice.replace(in + 1, 2, quoted(path));
  return std::string(format->name) + "; " + advice;
}

} // namespace pcl::indoor::tool
