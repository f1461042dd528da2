/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl_indoor_ros/occupancy_grid.h>
#include <pcl_indoor_ros/point_clouds.h>
#include <pcl_indoor_ros/scene_markers.h>

#include <pcl/conversions.h>
#include <pcl/io/memory_scan.h>
#include <pcl/io/scan_file.h>
#include <pcl/scene/describe_building.h>
#include <pcl/scene/scene_file.h>
#include <pcl/scene/storey_maps.h>

#include <nav_msgs/msg/occupancy_grid.hpp>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp/version.h>
#include <sensor_msgs/msg/point_cloud2.hpp>
#include <std_srvs/srv/trigger.hpp>
#include <visualization_msgs/msg/marker_array.hpp>

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using nav_msgs::msg::OccupancyGrid;
using sensor_msgs::msg::PointCloud2;
using std_srvs::srv::Trigger;
using visualization_msgs::msg::MarkerArray;

using Header = PointCloud2::_header_type;
using Json = nlohmann::ordered_json;

/** A scan, and how its points are published. */
struct Input {
  pcl::indoor::Scan scan;
  pcl::PCLPointCloud2 cloud;
  Eigen::Vector3d origin; ///< of the header's frame, in that of the scan
  Header header;
};

/** Describes the clouds of a topic, or a file: the work is done in the order of the
 * clouds, the last one that came in the meantime is the next; services but ~/describe
 * answer while it goes on. */
class IndoorNode : public rclcpp::Node {
public:
  IndoorNode()
  : Node("pcl_indoor")
  {
    declareParameters();
    const auto kept = rclcpp::QoS(1).transient_local(); // for those who come later
    cloud_publisher_ = create_publisher<PointCloud2>("~/cloud", kept);
    marker_publisher_ = create_publisher<MarkerArray>("~/markers", kept);
    work_group_ = create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive);
    subscribe();
    offerServices();
    if (!get_parameter("input").as_string().empty())
      start_ = create_wall_timer(
          std::chrono::milliseconds(0),
          [this] {
            start_->cancel();
            describe();
          },
          work_group_);
  }

private:
  void
  declareParameters()
  {
    const pcl::indoor::SceneOptions defaults;
    declare_parameter("input", ""); // a file or a folder of them, in place of a topic
    declare_parameter("frame_id", "map"); // of a file
    declare_parameter("describe_on_arrival", true);
    declare_parameter("resolution", 0.05); // of the maps, metres
    declare_parameter("voxel_size", defaults.rooms.voxel_size);
    declare_parameter("min_area", static_cast<double>(defaults.rooms.map.min_area));
    declare_parameter("voxel_resolution", defaults.voxel_resolution);
    declare_parameter("seed_resolution", defaults.seed_resolution);
    declare_parameter("partition", defaults.partition);
    declare_parameter("normals", defaults.preparation.normals);
    declare_parameter("remove_outliers", defaults.preparation.removes_outliers);
    declare_parameter("ignore_normals", defaults.ignore_normals);
    declare_parameter("model", defaults.model);
    declare_parameter("up", defaults.scan.up);
    declare_parameter("threads", defaults.threads);
  }

  pcl::indoor::SceneOptions
  sceneOptions() const
  {
    pcl::indoor::SceneOptions options;
    options.rooms.voxel_size = get_parameter("voxel_size").as_double();
    options.rooms.map.min_area = get_parameter("min_area").as_double();
    options.voxel_resolution = get_parameter("voxel_resolution").as_double();
    options.seed_resolution = get_parameter("seed_resolution").as_double();
    options.partition = get_parameter("partition").as_string();
    options.preparation.normals = get_parameter("normals").as_string();
    options.preparation.removes_outliers = get_parameter("remove_outliers").as_bool();
    options.ignore_normals = get_parameter("ignore_normals").as_bool();
    options.model = get_parameter("model").as_string();
    options.scan.up = get_parameter("up").as_string();
    options.scan.unit = "m"; // as all of ROS
    options.threads = static_cast<int>(get_parameter("threads").as_int());
    options.progress = [](const std::string&, std::size_t, std::size_t) {
      if (!rclcpp::ok())
        throw std::runtime_error("stopped");
    };
    return options;
  }

  void
  subscribe()
  {
    rclcpp::SubscriptionOptions options;
    options.callback_group = work_group_;
    options.qos_overriding_options =
        rclcpp::QosOverridingOptions({rclcpp::QosPolicyKind::Depth,
                                      rclcpp::QosPolicyKind::Durability,
                                      rclcpp::QosPolicyKind::Reliability});
    subscription_ = create_subscription<PointCloud2>(
        "cloud",
        rclcpp::QoS(1),
        [this](PointCloud2::ConstSharedPtr message) {
          message_ = std::move(message);
          if (get_parameter("describe_on_arrival").as_bool())
            describe();
        },
        options);
  }

  void
  offerServices()
  {
    const auto describes = [this](Trigger::Response& response) {
      response.success = describe(&response.message);
    };
    offer("~/describe", describes, work_group_);
    offer("~/scene", [this](Trigger::Response& response) {
      answer(response, [](const Json& scene) { return scene.dump(); });
    });
    offer("~/rooms", [this](Trigger::Response& response) {
      answer(response, [](const Json& scene) { return scene.at("rooms").dump(); });
    });
  }

  /** \param[in] group none: that of what is answered at once */
  void
  offer(const std::string& name,
        const std::function<void(Trigger::Response&)>& work,
        const rclcpp::CallbackGroup::SharedPtr& group = nullptr)
  {
#if RCLCPP_VERSION_GTE(21, 0, 0)
    const rclcpp::ServicesQoS quality;
#else // Humble
    const auto quality = rmw_qos_profile_services_default;
#endif
    services_.push_back(create_service<Trigger>(
        name,
        [work](const std::shared_ptr<Trigger::Request>,
               std::shared_ptr<Trigger::Response> response) { work(*response); },
        quality,
        group));
  }

  void
  answer(Trigger::Response& response,
         const std::function<std::string(const Json&)>& text) const
  {
    const std::lock_guard<std::mutex> lock(scene_mutex_);
    response.success = !scene_.is_null();
    response.message = response.success ? text(scene_) : "no cloud was described yet";
  }

  /** Of the last message, or of the file.
   * \param[out] summary what was found, or the problem */
  bool
  describe(std::string* summary = nullptr)
  {
    std::string text;
    bool is_done = false;
    try {
      text = publishScene(input());
      is_done = true;
      RCLCPP_INFO(get_logger(), "%s", text.c_str());
    } catch (const std::exception& error) {
      text = error.what();
      RCLCPP_ERROR(get_logger(), "%s", text.c_str());
    }
    if (summary != nullptr)
      *summary = text;
    return is_done;
  }

  Input
  input() const
  {
    if (message_ == nullptr)
      return inputOfFile();
    auto scan = pcl::indoor::memoryScan(pcl_indoor_ros::cloudOf(*message_),
                                        subscription_->get_topic_name());
    return {scan, scan.cloud(), Eigen::Vector3d::Zero(), message_->header};
  }

  Input
  inputOfFile() const
  {
    const auto path = get_parameter("input").as_string();
    if (path.empty())
      throw pcl::indoor::InputError("no cloud has come, and there is no input file");
    pcl::indoor::ScanOptions options;
    options.points_at_once = 0; // all, for their labels
    const auto scan = pcl::indoor::loadScan(path, options);
    Header header;
    header.stamp = now();
    header.frame_id = get_parameter("frame_id").as_string();
    pcl::PCLPointCloud2 cloud;
    pcl::toPCLPointCloud2(*scan.points(), cloud);
    if (!scan.offset().isZero())
      RCLCPP_INFO(get_logger(),
                  "The origin of %s is at %.3f, %.3f, %.3f of the file",
                  header.frame_id.c_str(),
                  scan.offset().x(),
                  scan.offset().y(),
                  scan.offset().z());
    return {scan, cloud, scan.offset(), header};
  }

  /** \return what was found */
  std::string
  publishScene(const Input& input)
  {
    for (const auto& note : input.scan.notes())
      RCLCPP_WARN(get_logger(), "%s: %s", input.scan.name().c_str(), note.c_str());
    const auto scene = pcl::indoor::describeBuilding(input.scan, sceneOptions());
    const auto text = pcl::indoor::sceneText(scene);
    const auto json = Json::parse(text);
    for (const auto& warning : json.at("warnings"))
      RCLCPP_WARN(get_logger(), "%s", warning.get<std::string>().c_str());
    cloud_publisher_->publish(pcl_indoor_ros::messageOf<PointCloud2>(
        pcl_indoor_ros::labelled(input.cloud, pcl_indoor_ros::pointLabels(scene)),
        input.header));
    marker_publisher_->publish(
        pcl_indoor_ros::SceneMarkers<MarkerArray>(json, input.origin, input.header)
            .make());
    for (const bool furnished : {false, true})
      publishMaps(text, furnished, input);
    const std::lock_guard<std::mutex> lock(scene_mutex_);
    scene_ = json;
    return input.scan.name() + ": " + std::to_string(json.at("storeys").size()) +
           " storeys, " + std::to_string(json.at("rooms").size()) + " rooms, " +
           std::to_string(json.at("openings").size()) + " doors, windows and passages";
  }

  /** Their topics are called as the files of pcl_indoor_export are. */
  void
  publishMaps(const std::string& scene, bool furnished, const Input& input)
  {
    const auto maps = pcl::indoor::storeyMaps(
        scene, get_parameter("resolution").as_double(), furnished);
    for (std::size_t storey = 0; storey < maps.size(); ++storey) {
      const auto name = "~/map" +
                        (storey > 0 ? "_storey" + std::to_string(storey) : "") +
                        (furnished ? "_furnished" : "");
      auto& publisher = map_publishers_[name];
      if (publisher == nullptr)
        publisher =
            create_publisher<OccupancyGrid>(name, rclcpp::QoS(1).transient_local());
      publisher->publish(pcl_indoor_ros::occupancyGrid<OccupancyGrid>(
          maps[storey], input.origin, input.header));
    }
  }

  rclcpp::CallbackGroup::SharedPtr work_group_; ///< of all that calls describe()
  rclcpp::Publisher<PointCloud2>::SharedPtr cloud_publisher_;
  rclcpp::Publisher<MarkerArray>::SharedPtr marker_publisher_;
  std::map<std::string, rclcpp::Publisher<OccupancyGrid>::SharedPtr> map_publishers_;
  rclcpp::Subscription<PointCloud2>::SharedPtr subscription_;
  std::vector<rclcpp::Service<Trigger>::SharedPtr> services_;
  rclcpp::TimerBase::SharedPtr start_;

  PointCloud2::ConstSharedPtr message_; ///< the last one; the work group's
  mutable std::mutex scene_mutex_;
  Json scene_;
};

} // namespace

int
main(int argc, char** argv)
{
  rclcpp::init(argc, argv);
  {
    const auto node = std::make_shared<IndoorNode>();
    rclcpp::executors::MultiThreadedExecutor executor(rclcpp::ExecutorOptions(), 2);
    executor.add_node(node);
    executor.spin();
  }
  rclcpp::shutdown();
}
