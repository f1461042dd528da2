/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

/* Angular errors and times of HoughNormalEstimation beside pcl::NormalEstimation, on
 * surfaces whose normals are known, as one table. */

#include <pcl/features/hough_normals.h>
#include <pcl/features/multi_scale_normals.h>
#include <pcl/features/normal_3d.h>

#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <random>
#include <string>

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Normals = pcl::PointCloud<pcl::Normal>;

constexpr float radius = 0.05f;
constexpr double degrees = 180 / 3.14159265358979323846;

/** Points of a surface, and what is known of them. */
struct Scene {
  std::string name;
  Cloud::Ptr cloud = pcl::make_shared<Cloud>();
  std::vector<Eigen::Vector3f> normals;
  std::vector<float> edge_distances; ///< metres
};

class Surface {
public:
  Surface(std::string name, float noise)
  : noise_(noise)
  {
    scene_.name = std::move(name);
  }

  /** Random points of the rectangle corner + [0, 1] u + [0, 1] v, Gaussian noise. */
  void
  add(const Eigen::Vector3f& corner,
      const Eigen::Vector3f& u,
      const Eigen::Vector3f& v,
      float points_per_square_metre)
  {
    const Eigen::Vector3f normal = u.cross(v).normalized();
    std::uniform_real_distribution<float> uniform(0, 1);
    std::normal_distribution<float> error(0, 1);
    const auto count = static_cast<int>(points_per_square_metre * u.cross(v).norm());
    for (int i = 0; i < count; ++i) {
      const float s = uniform(rng_), t = uniform(rng_);
      const Eigen::Vector3f place =
          corner + s * u + t * v + noise_ * error(rng_) * normal;
      scene_.cloud->emplace_back(place.x(), place.y(), place.z());
      scene_.normals.push_back(normal);
      scene_.edge_distances.push_back(
          std::min(std::min(s, 1 - s) * u.norm(), std::min(t, 1 - t) * v.norm()));
    }
  }

  const Scene&
  scene() const
  {
    return scene_;
  }

private:
  std::mt19937 rng_{7};
  float noise_;
  Scene scene_;
};

Scene
cube(const std::string& name, float noise)
{
  Surface surface(name, noise);
  const float edge = 0.4f;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3f u = edge * Eigen::Vector3f::Unit((axis + 1) % 3);
    const Eigen::Vector3f v = edge * Eigen::Vector3f::Unit((axis + 2) % 3);
    surface.add(Eigen::Vector3f::Zero(), v, u, 10000);
    surface.add(edge * Eigen::Vector3f::Unit(axis), u, v, 10000);
  }
  return surface.scene();
}

/** Two rectangles that meet at the given bend, with densities of their own. */
Scene
fold(const std::string& name, float bend_degrees, float noise, float other_density)
{
  Surface surface(name, noise);
  const float bend = bend_degrees / static_cast<float>(degrees);
  const Eigen::Vector3f edge(0, 1, 0);
  surface.add({0, 0, 0}, {-0.4f, 0, 0}, edge, 10000);
  surface.add({0, 0, 0},
              edge,
              0.4f * Eigen::Vector3f(std::cos(bend), 0, -std::sin(bend)),
              other_density);
  return surface.scene();
}

using Method = std::function<void(const Scene&, Normals&)>;

Method
hough(const std::function<void(pcl::HoughNormalEstimation<pcl::PointXYZ>&)>& adjust)
{
  return [adjust](const Scene& scene, Normals& normals) {
    pcl::HoughNormalEstimation<pcl::PointXYZ> estimation(1);
    estimation.setInputCloud(scene.cloud);
    estimation.setRadiusSearch(radius);
    adjust(estimation);
    estimation.compute(normals);
  };
}

void
leastSquares(const Scene& scene, Normals& normals)
{
  pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud(scene.cloud);
  estimation.setRadiusSearch(radius);
  estimation.compute(normals);
}

void
multiScale(const Scene& scene, Normals& normals)
{
  pcl::indoor::MultiScaleNormalOptions options;
  options.radius = radius;
  options.threads = 1;
  normals = pcl::indoor::multiScaleNormals(*scene.cloud, options);
}

/** Root mean square of the angle to the truth, and share of it above ten degrees, of
 * the points whose distance to the edge is in the range. */
struct Errors {
  double rms = 0, bad = 0;
};

Errors
errorsOf(const Scene& scene, const Normals& normals, float nearest, float furthest)
{
  double sum = 0;
  std::size_t count = 0, bad = 0;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const float distance = scene.edge_distances[i];
    if (distance < nearest || distance >= furthest)
      continue;
    const float cosine =
        std::abs(normals[i].getNormalVector3fMap().dot(scene.normals[i]));
    // A normal that is missing counts as a right angle.
    const double angle =
        std::isfinite(cosine) ? degrees * std::acos(std::min(1.0f, cosine)) : 90;
    sum += angle * angle;
    bad += angle > 10;
    ++count;
  }
  return {std::sqrt(sum / static_cast<double>(count)),
          100.0 * static_cast<double>(bad) / static_cast<double>(count)};
}

} // namespace

int
main()
{
  using Estimation = pcl::HoughNormalEstimation<pcl::PointXYZ>;
  const std::vector<Scene> scenes = {
      cube("cube, no noise", 0),
      cube("cube, noise 2 mm", 0.002f),
      cube("cube, noise 5 mm", 0.005f),
      fold("fold of 90 deg, 1 side 8 times sparser", 90, 0.002f, 1250),
      fold("fold of 45 deg, noise 2 mm", 45, 0.002f, 10000),
      fold("fold of 30 deg, noise 2 mm", 30, 0.002f, 10000)};
  const std::vector<std::pair<std::string, Method>> methods = {
      {"NormalEstimation", leastSquares},
      {"planes at several scales", multiScale},
      {"Hough, as in the paper", hough([](Estimation& e) {
         auto options = e.getOptions();
         options.sampling = Estimation::Sampling::Points;
         options.plane_distance = 1;
         options.refine = false;
         e.setOptions(options);
       })},
      {"Hough, Sampling::Points",
       hough([](Estimation& e) { e.setSampling(Estimation::Sampling::Points); })},
      {"Hough", hough([](Estimation&) {})}};
  std::printf("| surface | method | RMS at edges [deg] | above 10 deg [%%] | RMS "
              "elsewhere [deg] | us per point |\n| --- | --- | ---: | ---: | ---: | "
              "---: |\n");
  for (const auto& scene : scenes)
    for (const auto& method : methods) {
      Normals normals;
      const auto begin = std::clock(); // all have one thread
      method.second(scene, normals);
      const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
      const auto edges = errorsOf(scene, normals, 0, radius);
      const auto others = errorsOf(scene, normals, radius, 1);
      std::printf("| %s | %s | %.2f | %.1f | %.2f | %.1f |\n",
                  scene.name.c_str(),
                  method.first.c_str(),
                  edges.rms,
                  edges.bad,
                  others.rms,
                  1e6 * seconds / static_cast<double>(scene.cloud->size()));
    }
}
