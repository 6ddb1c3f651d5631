// bare_urdf FILE: what liburdfdom reads, as most tools for URDF do. A line has a link on a planar joint:
// middle of its box, mass, moments of inertia about x, y and z, size, place, roll, pitch, yaw.

#include <urdf_parser/urdf_parser.h>

#include <cstdio>
#include <fstream>
#include <sstream>

int main(int count, char** arguments) {
  if (count != 2) return 2;
  std::ostringstream text;
  text << std::ifstream(arguments[1]).rdbuf();
  const urdf::ModelInterfaceSharedPtr model = urdf::parseURDF(text.str());
  if (!model) return 1;
  for (const auto& [name, link] : model->links_) {
    if (!link->parent_joint || link->parent_joint->type != urdf::Joint::PLANAR) continue;
    const auto box = std::dynamic_pointer_cast<urdf::Box>(link->collision->geometry);
    const urdf::Pose& pose = link->parent_joint->parent_to_joint_origin_transform;
    double roll = 0, pitch = 0, yaw = 0;
    pose.rotation.getRPY(roll, pitch, yaw);
    const urdf::Vector3& middle = link->collision->origin.position;
    std::printf("%.17g %.17g %.17g ", middle.x, middle.y, middle.z);
    std::printf("%.17g %.17g %.17g %.17g ", link->inertial->mass, link->inertial->ixx, link->inertial->iyy,
                link->inertial->izz);
    std::printf("%.17g %.17g %.17g ", box->dim.x, box->dim.y, box->dim.z);
    std::printf("%.17g %.17g %.17g %.17g %.17g %.17g\n", pose.position.x, pose.position.y, pose.position.z,
                roll, pitch, yaw);
  }
}
