/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Runs pcl_eppf_train, found by PCL_INDOOR_TOOLS, on small sets that are made here, and
// looks at what it writes.
#include "files/mesh_sampling.h"
#include "support/folder_test.h"
#include "support/run_tool.h"

#include <pcl/ml/model_file.h>
#include <pcl/ml/object_classifier.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>

#include <csignal>
#include <sys/wait.h> // for WIFEXITED

using namespace pcl::indoor;
using namespace pcl::indoor::tool;

namespace {

using pcl::indoor::test::bytesOf;

std::ptrdiff_t
lineCount(const std::string& path)
{
  const auto text = bytesOf(path);
  return std::count(text.begin(), text.end(), '\n');
}

/** An upright body of rings: radius 1 at the corners of a polygon in each height. */
Mesh
bodyOf(int corners,
       const std::vector<Eigen::Vector2f>& rings,
       const Eigen::Array3f& size)
{
  Mesh mesh;
  for (const auto& ring : rings)
    for (int k = 0; k < corners; ++k) {
      const double angle = 2.0 * M_PI * (k + 0.5) / corners;
      const Eigen::Array3f place(ring.x() * static_cast<float>(std::cos(angle)),
                                 ring.x() * static_cast<float>(std::sin(angle)),
                                 ring.y());
      mesh.vertices.emplace_back((place * size).matrix());
    }
  const auto n = static_cast<std::uint32_t>(corners);
  for (std::uint32_t ring = 0; ring + 1 < rings.size(); ++ring)
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t a = ring * n + k, b = ring * n + (k + 1) % n;
      mesh.triangles.push_back({a, b, b + n});
      mesh.triangles.push_back({a, b + n, a + n});
    }
  return mesh;
}

/** A box, a cylinder or a sphere of its own proportions. */
Mesh
shapeOf(const std::string& name, int number)
{
  std::mt19937 rng(static_cast<std::uint32_t>(number));
  Eigen::Array3f size;
  for (float& extent : size)
    extent = 1.0f + 0.2f * static_cast<float>(rng() % 100) / 100.0f;
  if (name == "box")
    return bodyOf(4, {{0, -1}, {1, -1}, {1, 1}, {0, 1}}, size);
  if (name == "cylinder") // long and thin
    return bodyOf(24, {{0, -4}, {0.5f, -4}, {0.5f, 4}, {0, 4}}, size);
  std::vector<Eigen::Vector2f> rings;
  for (int k = 0; k <= 12; ++k)
    rings.emplace_back(static_cast<float>(std::sin(M_PI * k / 12)),
                       static_cast<float>(-std::cos(M_PI * k / 12)));
  return bodyOf(24, rings, size);
}

/** One of the kinds of files that hold objects; which one, the number says. */
std::pair<std::string, std::string>
fileOf(const Mesh& mesh, int number)
{
  std::ostringstream text;
  const bool is_off = number % 4 == 0;
  if (number % 4 < 2) { // OFF and OBJ
    if (is_off)
      text << "OFF" << mesh.vertices.size() << " " << mesh.triangles.size() << " 0\n";
    for (const auto& v : mesh.vertices)
      text << (is_off ? "" : "v ") << v.transpose() << "\n";
    for (const auto& t : mesh.triangles)
      text << (is_off ? "3" : "f") << " " << t[0] + !is_off << " " << t[1] + !is_off
           << " " << t[2] + !is_off << "\n";
    return {text.str(), is_off ? ".off" : ".obj"};
  }
  const bool is_mesh = number % 4 == 2; // a PLY with faces, else a PCD of points
  const auto points = sampleMesh(mesh, 500, 1);
  if (!is_mesh)
    text << "VERSION .7\nFIELDS x y z normal_x normal_y normal_z\nSIZE 4 4 4 4 4 4\n"
            "TYPE F F F F F F\nCOUNT 1 1 1 1 1 1\nWIDTH 500\nHEIGHT 1\n"
            "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 500\nDATA ascii\n";
  else
    text << "ply\nformat ascii 1.0\nelement vertex " << mesh.vertices.size()
         << "\nproperty float x\nproperty float y\nproperty float z\nelement face "
         << mesh.triangles.size()
         << "\nproperty list uchar int vertex_indices\nend_header\n";
  if (!is_mesh)
    for (const auto& point : points)
      text << point.position.transpose() << " " << point.normal.transpose() << "\n";
  else {
    for (const auto& v : mesh.vertices)
      text << v.transpose() << "\n";
    for (const auto& t : mesh.triangles)
      text << "3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
  }
  return {text.str(), is_mesh ? ".ply" : ".pcd"};
}

const std::vector<std::string> shapes{"box", "cylinder", "sphere"};

/** A network that learns within a second. */
const std::string tiny = " -hidden 16 -pairs 500 -draws 3 -learning_rate 0.01 "
                         "-batch_size 8 -training_threads 1 -quiet ";

class TrainingResults : public pcl::indoor::test::FolderTest {
protected:
  /** Objects of each shape, in set/SHAPE/ or by their number in its train and test. */
  void
  makeSet(int count, bool with_parts = false) const
  {
    for (const auto& shape : shapes)
      for (int k = 0; k < count; ++k) {
        const auto [text, extension] = fileOf(shapeOf(shape, k), k);
        auto folder = path("set/" + shape);
        if (with_parts)
          folder += k % 4 == 3 ? "/test" : "/train";
        std::filesystem::create_directories(folder);
        std::ofstream(folder + "/" + shape + "_" + std::to_string(k) + extension)
            << text;
      }
  }

  /** Exit status of the tool; what it said is in "said" and "complaint". */
  int
  status(const std::string& arguments) const
  {
    const int result = pcl::indoor::test::runTool(
        "pcl_eppf_train", arguments, path("said"), path("complaint"));
    return WIFEXITED(result) ? WEXITSTATUS(result) : -1;
  }

  void
  train(const std::string& arguments) const
  {
    ASSERT_EQ(status(path("set") + " " + arguments), 0) << bytesOf(path("complaint"));
    EXPECT_EQ(bytesOf(path("complaint")), "");
  }

  /** The one line of complaint; the tool must fail and leave no model. */
  std::string
  complaint(const std::string& arguments) const
  {
    EXPECT_EQ(status(arguments), 1) << arguments;
    EXPECT_EQ(lineCount(path("complaint")), 1) << bytesOf(path("complaint"));
    EXPECT_EQ(bytesOf(path("said")), "");
    EXPECT_FALSE(std::filesystem::exists(path("model")));
    return bytesOf(path("complaint"));
  }

  /** Share of new objects that a model takes for what they are. */
  double
  accuracy(const std::string& model_path) const
  {
    const auto model = modelFromBytes(bytesOf(model_path));
    EXPECT_EQ(model.classes, shapes);
    std::vector<ClassifierObject> objects;
    for (const auto& shape : shapes)
      for (int k = 100; k < 105; ++k)
        objects.push_back({sampleMesh(shapeOf(shape, k), 1000, 1), {}});
    const auto found = classifyObjects(objects, model);
    int right = 0;
    for (std::size_t k = 0; k < found.size(); ++k)
      right += found[k].best() == static_cast<int>(k / 5);
    return right / static_cast<double>(found.size());
  }
};

} // namespace

TEST_F(TrainingResults, TellsShapesApartFromEveryKindOfFile)
{
  makeSet(8);
  train(path("model") + tiny + "-epochs 15 -log " + path("log.csv") + " -curves " +
        path("curves.png"));
  EXPECT_EQ(bytesOf(path("said")), "");
  EXPECT_GE(accuracy(path("model")), 0.9);
  EXPECT_EQ(lineCount(path("log.csv")), 16);
  EXPECT_EQ(bytesOf(path("curves.png")).substr(1, 3), "PNG");
}

TEST_F(TrainingResults, TestsWithTheFoldersOfTheTestPart)
{
  makeSet(8, true);
  train(path("model") + tiny + "-epochs 15 -split folders -confusion " +
        path("confusion.png"));
  EXPECT_NE(bytesOf(path("said")).find("6 objects: total accuracy 100.00 %"),
            std::string::npos)
      << bytesOf(path("said"));
  EXPECT_EQ(bytesOf(path("confusion.png")).substr(1, 3), "PNG");
}

TEST_F(TrainingResults, TestsUnderTheDisturbanceOfTheTraining)
{
  makeSet(8, true);
  std::ofstream small(path("set/box/test/small.pcd"));
  small << "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 100\n"
           "HEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 100\nDATA ascii\n";
  for (const auto& point : sampleMesh(shapeOf("box", 50), 100, 1))
    small << point.position.transpose() << "\n";
  small.close();
  const auto arguments = path("model") + tiny + "-epochs 2 -augment off -split folders";
  const auto boxes = [this] { // what the boxes were taken for
    const auto said = bytesOf(path("said"));
    const auto begin = said.find("\nbox ") + 1;
    return said.substr(begin, said.find('\n', begin) - begin);
  };
  train(arguments);
  EXPECT_NE(boxes().find(".  1"), std::string::npos) << boxes(); // none is unknown
  const auto model = bytesOf(path("model"));
  train(arguments + " -noise 3");
  EXPECT_NE(bytesOf(path("model")), model);
  train(arguments + " -occlusion 99"); // leaves one point of the small box
  EXPECT_NE(boxes().find("33  1"), std::string::npos) << boxes();
}

TEST_F(TrainingResults, ChoosesTheEpochByValidationAndAveragesNetworks)
{
  makeSet(5);
  std::ofstream(path("list")) << "box_0\nsphere_1\ncylinder_2.ply\n";
  train(path("model") + tiny +
        "-any_pose -epochs 4 -validation 0.25 -ensemble 2 -half -scale auto "
        "-class_balance 1 -split " +
        path("list") + " -log " + path("log.csv"));
  EXPECT_NE(bytesOf(path("said")).find("3 objects: "), std::string::npos);
  const auto model = modelFromBytes(bytesOf(path("model")));
  EXPECT_EQ(model.networks.size(), 2u);
  EXPECT_FALSE(model.input.context);
  EXPECT_GT(model.input.scale, 8.0); // the cylinder's length
  EXPECT_LT(model.input.scale, 10.0);
  EXPECT_EQ(lineCount(path("log.csv")), 9);
  EXPECT_EQ(bytesOf(path("log.csv")).find(",,"), std::string::npos);
}

TEST_F(TrainingResults, DoesNotDependOnTheNumberOfThreadsButOnTheSeed)
{
  makeSet(4);
  train(path("one") + tiny + "-epochs 2 -threads 1");
  train(path("three") + tiny + "-epochs 2 -threads 3");
  train(path("other") + tiny + "-epochs 2 -seed 2");
  EXPECT_EQ(bytesOf(path("one")), bytesOf(path("three")));
  EXPECT_NE(bytesOf(path("one")), bytesOf(path("other")));
}

TEST_F(TrainingResults, GoesOnWhereItWasStopped)
{
  makeSet(4);
  const auto options = tiny + "-epochs 400 -checkpoint ";
  train(path("whole") + options + path("state_of_whole") + " -log " +
        path("whole.csv"));
  const auto arguments = path("set") + " " + path("model") + options + path("state") +
                         " -log " + path("log.csv");
  const auto command = "( " + std::string(PCL_INDOOR_TOOLS) + "/pcl_eppf_train " +
                       arguments + " > " + path("said") + " 2>&1 & echo $! > " +
                       path("pid") + "; wait $!; echo $? > " + path("status") + " ) &";
  ASSERT_EQ(std::system(command.c_str()), 0);
  while (lineCount(path("log.csv")) < 20 && !std::filesystem::exists(path("status")))
    std::system("sleep 0.01");
  kill(static_cast<pid_t>(std::stoi(bytesOf(path("pid")))), SIGTERM);
  while (lineCount(path("status")) < 1)
    std::system("sleep 0.01");
  EXPECT_EQ(bytesOf(path("status")), "1\n");
  EXPECT_NE(bytesOf(path("said")).find("the same command goes on from"),
            std::string::npos)
      << bytesOf(path("said"));
  EXPECT_FALSE(std::filesystem::exists(path("model")));
  EXPECT_LT(lineCount(path("log.csv")), 401);
  ASSERT_EQ(status(arguments), 0) << bytesOf(path("complaint"));
  EXPECT_EQ(bytesOf(path("model")), bytesOf(path("whole")));
  EXPECT_EQ(bytesOf(path("log.csv")), bytesOf(path("whole.csv")));
}

TEST_F(TrainingResults, TrainsEveryNetwork)
{
  makeSet(2);
  for (const std::string network :
       {"2d", "3d", "4d", "pointnet -points 32 -width 0.1"}) {
    train(path("model") + " -quiet -pairs 200 -draws 1 -epochs 1 -network " + network);
    EXPECT_NO_THROW(modelFromBytes(bytesOf(path("model")))) << network;
  }
}

TEST_F(TrainingResults, SaysInOneLineWhatIsWrong)
{
  const auto set = path("set") + " " + path("model") + " ";
  EXPECT_NE(complaint(set).find("no such folder"), std::string::npos);
  makeSet(1);
  const std::pair<std::string, std::string> cases[] = {
      {"-split random:0.8", "box: a class needs two objects"},
      {"-split random:1", "no share of the training part"},
      {"-split folders", "lies in neither folder train nor test"},
      {"-split " + path("none"), "no such list of the test part"},
      {"-scale big", "-scale: 'big'"},
      {"-hidden 12,x", "-hidden: '12,x'"},
      {"-network 4d -descriptor points", "-descriptor: points"},
      {"-network 3d -descriptor eppf_short", "need 1200 bins"},
      {"-patience 3", "-patience: needs -validation"},
      {"-confusion " + path("c.png"), "-confusion: needs a test part"},
      {"-log " + path("none/log.csv"), "log.csv: cannot be written"},
      {"-checkpoint " + path("none/state"), "state: cannot be written"},
      {"-epochs 0", "-epochs: '0' is out of range"}};
  for (const auto& [options, expected] : cases)
    EXPECT_NE(complaint(set + options).find(expected), std::string::npos)
        << options << ": " << bytesOf(path("complaint"));
  EXPECT_NE(complaint(path("set") + " " + path("none/model")).find("cannot be written"),
            std::string::npos);
  std::ofstream(path("set/box/broken.off")) << "OFF 3\n";
  std::ofstream(path("set/box/empty.pcd"));
  EXPECT_NE(
      complaint(set).find("broken.off: line 1 has too few numbers (the first of 2 "
                          "unreadable files of 5)"),
      std::string::npos)
      << bytesOf(path("complaint"));
}

TEST_F(TrainingResults, NamesObjectsThatCannotBeDescribed)
{
  makeSet(2);
  std::ofstream(path("set/box/same.pcd"))
      << "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 3\n"
         "HEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 3\nDATA ascii\n1 1 1\n1 1 1\n1 1 "
         "1\n";
  EXPECT_NE(complaint(path("set") + " " + path("model") + tiny)
                .find("box/same.pcd: no two points"),
            std::string::npos)
      << bytesOf(path("complaint"));
}
