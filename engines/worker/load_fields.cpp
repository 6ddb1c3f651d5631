#include "engines/worker/load_fields.hpp"

namespace rockstack {
namespace {

using nlohmann::json;

constexpr std::array<Named<BodyPoint>, 2> point_fields{{{"x", &BodyPoint::x}, {"y", &BodyPoint::y}}};

constexpr std::array<Named<AppliedPush>, 2> push_fields{
    {{"direction_x", &AppliedPush::direction_x}, {"direction_y", &AppliedPush::direction_y}}};

constexpr std::array<Named<AppliedRestraint>, 5> restraint_fields{
    {{"length", &AppliedRestraint::length},
     {"stiffness", &AppliedRestraint::stiffness},
     {"prestress", &AppliedRestraint::prestress},
     {"yield", &AppliedRestraint::yield},
     {"damping", &AppliedRestraint::damping}}};

json fields_of(const BodyPoint& point) {
  json object = object_of(point, point_fields);
  object["block"] = point.block;
  return object;
}

json fields_of(const AppliedPush& push, Form form) {
  json object = object_of(push, push_fields);
  object["point"] = fields_of(push.point);
  object["forces"] = to_field(push.forces, form);
  return object;
}

json fields_of(const AppliedRestraint& restraint) {
  json object = object_of(restraint, restraint_fields);
  object["from"] = fields_of(restraint.from);
  object["to"] = fields_of(restraint.to);
  return object;
}

/// A point of one of so many blocks, from `least` on.
BodyPoint read_point(const json& object, const char* name, std::size_t least, std::size_t blocks) {
  return within(name, [&] {
    const json& fields = field(object, name);
    BodyPoint point = read_object(fields, point_fields);
    point.block = count_field(fields, "block");
    if (point.block < least || point.block > blocks) throw WrongField("block", "a block's number");
    return point;
  });
}

AppliedPush read_push(const json& object, std::size_t blocks) {
  AppliedPush push = read_object(object, push_fields);
  push.point = read_point(object, "point", 1, blocks);
  push.forces = numbers_field(object, "forces");
  return push;
}

AppliedRestraint read_restraint(const json& object, std::size_t blocks) {
  AppliedRestraint restraint = read_object(object, restraint_fields);
  restraint.from = read_point(object, "from", 0, blocks);
  restraint.to = read_point(object, "to", 0, blocks);
  return restraint;
}

}  // namespace

void write_loads(const Setup& setup, Form form, nlohmann::json& object) {
  for (const AppliedPush& push : setup.pushes) object["pushes"].push_back(fields_of(push, form));
  for (const AppliedRestraint& restraint : setup.restraints)
    object["restraints"].push_back(fields_of(restraint));
  if (!setup.pushes.empty() || !setup.restraints.empty()) object["lookahead"] = setup.lookahead;
}

void read_loads(const nlohmann::json& object, Setup& setup) {
  const std::size_t blocks = setup.blocks.size();
  if (has_field(object, "pushes"))
    setup.pushes =
        read_list(object, "pushes", [&](const nlohmann::json& push) { return read_push(push, blocks); });
  if (has_field(object, "restraints"))
    setup.restraints = read_list(object, "restraints",
                                 [&](const nlohmann::json& one) { return read_restraint(one, blocks); });
  if (has_field(object, "lookahead")) setup.lookahead = number_field(object, "lookahead");
}

}  // namespace rockstack
