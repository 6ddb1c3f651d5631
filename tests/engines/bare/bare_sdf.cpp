// bare_sdf FILE: what libsdformat reads, as Gazebo does. The first line has gravity (m/s²) and the step (s),
// each further one a model that moves: middle of its box, mass, moments of inertia about x, y and z, size,
// place, roll, pitch, yaw, friction, and the six velocities of the state.

#include <cstdio>
#include <sdf/sdf.hh>

namespace {

void print(const ignition::math::Vector3d& vector) {
  std::printf("%.17g %.17g %.17g ", vector.X(), vector.Y(), vector.Z());
}

/// The six numbers of an element as they stand there, as a quaternion would round angles.
void print_numbers(const sdf::ElementPtr& element) {
  std::printf("%s ", element->GetValue()->GetAsString().c_str());
}

/// Element of a model in the state of the world, by its name.
sdf::ElementPtr state_of(const sdf::World& world, const std::string& name) {
  sdf::ElementPtr model = world.Element()->GetElement("state")->GetElement("model");
  while (model && model->Get<std::string>("name") != name) model = model->GetNextElement("model");
  return model;
}

double friction_of(const sdf::ElementPtr& collision) {
  sdf::ElementPtr element = collision;
  for (const char* name : {"surface", "friction", "ode"}) element = element->GetElement(name);
  return element->Get<double>("mu");
}

void print(const sdf::World& world, const sdf::Model& model) {
  const sdf::Link& link = *model.LinkByIndex(0);
  const sdf::Collision& collision = *link.CollisionByIndex(0);
  const auto& inertia = link.Inertial().MassMatrix();
  print(collision.RawPose().Pos());
  std::printf("%.17g ", inertia.Mass());
  print(inertia.DiagonalMoments());
  print(collision.Geom()->BoxShape()->Size());
  print_numbers(model.Element()->GetElement("pose"));
  std::printf("%.17g ", friction_of(collision.Element()));
  print_numbers(state_of(world, model.Name())->GetElement("link")->GetElement("velocity"));
  std::printf("\n");
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return 2;
  sdf::Root root;
  for (const sdf::Error& error : root.Load(arguments[1])) {
    std::fprintf(stderr, "%s\n", error.Message().c_str());
    return 1;
  }
  const sdf::World& world = *root.WorldByIndex(0);
  print(world.Gravity());
  std::printf("%.17g\n", world.PhysicsByIndex(0)->MaxStepSize());
  for (std::uint64_t i = 0; i < world.ModelCount(); ++i)
    if (!world.ModelByIndex(i)->Static()) print(world, *world.ModelByIndex(i));
}
