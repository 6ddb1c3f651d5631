#include "engines/worker/request.hpp"

#include <cstdint>

#include "engines/worker/load_fields.hpp"

namespace rockstack {
namespace {

using nlohmann::json;

constexpr std::array<Named<Placement>, 15> placement_fields{
    {{"x", &Placement::x},
     {"y", &Placement::y},
     {"velocity_x", &Placement::velocity_x},
     {"velocity_y", &Placement::velocity_y},
     {"angle", &Placement::angle},
     {"angular_velocity", &Placement::angular_velocity},
     {"width", &Placement::width},
     {"height", &Placement::height},
     {"depth", &Placement::depth},
     {"offset_x", &Placement::offset_x},
     {"offset_y", &Placement::offset_y},
     {"mass", &Placement::mass},
     {"inertia", &Placement::inertia},
     {"inertia_about_x", &Placement::inertia_about_x},
     {"inertia_about_y", &Placement::inertia_about_y}}};

constexpr std::array<Named<FixedBox>, 5> box_fields{{{"x", &FixedBox::x},
                                                     {"y", &FixedBox::y},
                                                     {"width", &FixedBox::width},
                                                     {"height", &FixedBox::height},
                                                     {"depth", &FixedBox::depth}}};

constexpr std::array<Named<BodyAcceleration>, 2> acceleration_fields{
    {{"x", &BodyAcceleration::x}, {"y", &BodyAcceleration::y}}};

constexpr std::array<Named<GroundStep>, 4> ground_fields{{{"x", &GroundStep::x},
                                                          {"y", &GroundStep::y},
                                                          {"velocity_x", &GroundStep::velocity_x},
                                                          {"velocity_y", &GroundStep::velocity_y}}};

constexpr std::array<Named<BodyState>, 4> body_fields{{{"x", &BodyState::x},
                                                       {"y", &BodyState::y},
                                                       {"velocity_x", &BodyState::velocity_x},
                                                       {"velocity_y", &BodyState::velocity_y}}};

/// Only of engines that are not planar by nature.
constexpr std::array<Named<BodyState>, 2> out_of_plane_fields{
    {{"z", &BodyState::z}, {"tilt", &BodyState::tilt}}};

constexpr std::array<Named<Reaction>, 3> reaction_fields{
    {{"normal", &Reaction::normal}, {"tangential", &Reaction::tangential}, {"centre", &Reaction::centre}}};

constexpr std::array<Named<ContactImpact>, 3> impact_fields{
    {{"time", &ContactImpact::time}, {"speed", &ContactImpact::speed}, {"after", &ContactImpact::after}}};

constexpr std::array<Named<Setting>, 4> setting_fields{{{"default", &Setting::default_value},
                                                        {"tuned", &Setting::tuned},
                                                        {"least", &Setting::least},
                                                        {"most", &Setting::most}}};

/// In the order of SettingRole.
constexpr std::array role_names{"", "restitution", "restitution threshold"};

SettingRole named_role(const std::string& name) {
  const auto found = std::find(role_names.begin() + 1, role_names.end(), name);
  if (found == role_names.end()) throw WrongField("role", "\"restitution\" or \"restitution threshold\"");
  return static_cast<SettingRole>(found - role_names.begin());
}

/// Whole settings as whole numbers: some languages will not count to 400.0.
json parameter_field(const RunRequest& run, const std::string& name, double value) {
  constexpr double most = 9007199254740992;  // 2^53: up to there all are told apart
  const bool whole = run.whole.count(name) != 0 && std::abs(value) <= most;
  return whole ? json(static_cast<std::int64_t>(value)) : to_field(value);
}

json fields_of(const RunRequest& run, Form form) {
  const Setup& setup = run.setup;
  json object{{"solver", run.solver},
              {"dt", setup.dt},
              {"steps", setup.steps},
              {"gravity", object_of(setup.gravity, acceleration_fields)},
              {"friction", to_field(setup.friction, form)},
              {"toppling_angles", to_field(setup.toppling_angles, form)},
              {"repeats", run.repeats},
              {"bodies", run.bodies},
              {"blocks", json::array()},
              {"parameters", json::object()}};
  for (const Placement& block : setup.blocks) object["blocks"].push_back(object_of(block, placement_fields));
  for (const auto& [name, value] : run.parameters)
    object["parameters"][name] = parameter_field(run, name, value);
  if (run.warm_up > 0) object["warm_up"] = run.warm_up;
  if (!setup.kinetic_friction.empty()) object["kinetic_friction"] = to_field(setup.kinetic_friction, form);
  if (run.question > 0) object["question"] = run.question;
  if (run.reactions) object["reactions"] = true;
  if (setup.wall) object["wall"] = object_of(*setup.wall, box_fields);
  if (!setup.accelerations.empty())
    write_columns(object["accelerations"], setup.accelerations, acceleration_fields, form);
  if (!setup.ground.empty()) write_columns(object["ground"], setup.ground, ground_fields, form);
  write_loads(setup, form, object);
  return object;
}

RunRequest read_run_request(const json& object) {
  RunRequest run;
  Setup& setup = run.setup;
  run.solver = text_field(object, "solver");
  setup.dt = number_field(object, "dt");
  setup.steps = count_field(object, "steps");
  setup.gravity =
      within("gravity", [&] { return read_object(field(object, "gravity"), acceleration_fields); });
  setup.friction = numbers_field(object, "friction");
  setup.toppling_angles = numbers_field(object, "toppling_angles");
  run.repeats = count_field(object, "repeats");
  run.bodies = flag_field(object, "bodies");
  if (has_field(object, "warm_up")) run.warm_up = count_field(object, "warm_up");
  if (has_field(object, "kinetic_friction"))
    setup.kinetic_friction = numbers_field(object, "kinetic_friction");
  if (has_field(object, "question")) run.question = count_field(object, "question");
  if (has_field(object, "reactions")) run.reactions = flag_field(object, "reactions");
  setup.blocks =
      read_list(object, "blocks", [](const json& block) { return read_object(block, placement_fields); });
  for (const auto& [name, value] : field(object, "parameters").items()) {
    run.parameters[name] = number_field(object["parameters"], name.c_str());
    if (value.is_number_integer()) run.whole.insert(name);
  }
  if (has_field(object, "wall"))
    setup.wall = within("wall", [&] { return read_object(field(object, "wall"), box_fields); });
  if (has_field(object, "accelerations"))
    read_columns(object["accelerations"], setup.accelerations, acceleration_fields);
  if (has_field(object, "ground")) read_columns(object["ground"], setup.ground, ground_fields);
  read_loads(object, setup);
  return run;
}

json fields_of(const EngineDescription& engine) {
  json object{{"name", engine.name},
              {"solver", engine.solver},
              {"version", engine.version},
              {"licence", engine.licence},
              {"largest_friction", to_field(engine.capabilities.largest_friction)},
              {"single_precision", engine.capabilities.single_precision},
              {"planar", engine.capabilities.planar},
              {"center_of_mass", engine.capabilities.center_of_mass},
              {"lead", engine.capabilities.lead},
              {"tuned_lead", engine.capabilities.tuned_lead},
              {"settings", json::array()}};
  if (engine.capabilities.wall) object["wall"] = true;
  if (engine.capabilities.applied_forces) object["applied_forces"] = true;
  if (engine.capabilities.kinetic_friction) object["kinetic_friction"] = true;
  if (engine.warm_up > 0) object["warm_up"] = engine.warm_up;
  if (engine.runs_per_process > 1) object["runs_per_process"] = engine.runs_per_process;
  for (const Setting& setting : engine.settings) {
    json one = object_of(setting, setting_fields);
    one["name"] = setting.name;
    one["whole"] = setting.whole;
    if (!setting.choices.empty()) one["choices"] = setting.choices;
    if (!setting.unit.empty()) one["unit"] = setting.unit;
    if (setting.role != SettingRole::own) one["role"] = role_names[static_cast<std::size_t>(setting.role)];
    object["settings"].push_back(std::move(one));
  }
  return object;
}

Setting read_setting(const json& object) {
  Setting setting = read_object(object, setting_fields);
  setting.name = text_field(object, "name");
  if (has_field(object, "whole")) setting.whole = flag_field(object, "whole");
  if (has_field(object, "unit")) setting.unit = text_field(object, "unit");
  if (has_field(object, "role")) setting.role = named_role(text_field(object, "role"));
  if (!has_field(object, "choices")) return setting;
  for (const json& choice : list_field(object, "choices")) {
    if (!choice.is_string()) throw WrongField("choices", "a text", true);
    setting.choices.push_back(choice.get<std::string>());
  }
  return setting;
}

EngineDescription read_engine(const json& object) {
  EngineDescription engine;
  engine.name = text_field(object, "name");
  engine.solver = text_field(object, "solver");
  engine.version = text_field(object, "version");
  engine.licence = text_field(object, "licence");
  Capabilities& able = engine.capabilities;
  if (has_field(object, "largest_friction")) able.largest_friction = number_field(object, "largest_friction");
  if (has_field(object, "wall")) able.wall = flag_field(object, "wall");
  if (has_field(object, "applied_forces")) able.applied_forces = flag_field(object, "applied_forces");
  if (has_field(object, "kinetic_friction")) able.kinetic_friction = flag_field(object, "kinetic_friction");
  if (has_field(object, "single_precision")) able.single_precision = flag_field(object, "single_precision");
  if (has_field(object, "planar")) able.planar = flag_field(object, "planar");
  if (has_field(object, "center_of_mass")) able.center_of_mass = flag_field(object, "center_of_mass");
  if (has_field(object, "lead")) able.lead = number_field(object, "lead");
  able.tuned_lead = has_field(object, "tuned_lead") ? number_field(object, "tuned_lead") : able.lead;
  if (has_field(object, "warm_up")) engine.warm_up = count_field(object, "warm_up");
  if (has_field(object, "runs_per_process"))
    engine.runs_per_process = count_field(object, "runs_per_process");
  engine.settings = read_list(object, "settings", read_setting);
  return engine;
}

json fields_of(const ContactRecord& contacts, Form form) {
  json object{{"elastic", to_field(contacts.elastic, form)},
              {"complementarity", to_field(contacts.complementarity)},
              {"friction_excess", to_field(contacts.friction_excess)},
              {"stiffness", to_field(contacts.stiffness)},
              {"damping", to_field(contacts.damping)},
              {"points", to_field(contacts.points)},
              {"impacts", json::array()}};
  for (const ContactImpact& impact : contacts.impacts) {
    json one = object_of(impact, impact_fields);
    one["interface"] = impact.interface;
    object["impacts"].push_back(std::move(one));
  }
  return object;
}

ContactRecord read_contacts(const json& object) {
  ContactRecord contacts;
  contacts.elastic = numbers_field(object, "elastic");
  contacts.complementarity = number_field(object, "complementarity");
  contacts.friction_excess = number_field(object, "friction_excess");
  if (has_field(object, "stiffness")) contacts.stiffness = number_field(object, "stiffness");
  if (has_field(object, "damping")) contacts.damping = number_field(object, "damping");
  if (has_field(object, "points")) contacts.points = number_field(object, "points");
  contacts.impacts = read_list(object, "impacts", [](const json& one) {
    ContactImpact impact = read_object(one, impact_fields);
    constexpr std::size_t most = std::numeric_limits<int>::max();
    impact.interface = static_cast<int>(std::min(count_field(one, "interface"), most));
    return impact;
  });
  return contacts;
}

json fields_of(const RunReply& run, Form form) {
  const Trajectory& made = run.trajectory;
  json object{{"status", run.status}, {"reason", run.reason}, {"peak_memory", run.peak_memory}};
  if (run.question) object["question"] = *run.question;
  if (run.status != "done") return object;
  object["angles"] = to_field(made.angles, form);
  object["velocities"] = to_field(made.velocities, form);
  object["seconds"] = to_field(run.seconds, form);
  if (run.warm_up) object["warm_up"] = *run.warm_up;
  object["warnings"] = made.warnings;
  if (!made.bodies.empty()) {
    write_columns(object["bodies"], made.bodies, body_fields, form);
    write_columns(object["bodies"], made.bodies, out_of_plane_fields, form);
  }
  if (made.contacts) object["contacts"] = fields_of(*made.contacts, form);
  if (!made.reactions.empty()) write_columns(object["reactions"], made.reactions, reaction_fields, form);
  return object;
}

RunReply read_run_reply(const json& object) {
  RunReply run;
  run.status = text_field(object, "status");
  if (has_field(object, "reason")) run.reason = text_field(object, "reason");
  if (has_field(object, "peak_memory")) run.peak_memory = number_field(object, "peak_memory");
  if (has_field(object, "question")) run.question = count_field(object, "question");
  if (run.status != "done") return run;
  Trajectory& made = run.trajectory;
  made.angles = numbers_field(object, "angles");
  made.velocities = numbers_field(object, "velocities");
  if (has_field(object, "seconds")) run.seconds = numbers_field(object, "seconds");
  if (has_field(object, "warm_up")) run.warm_up = count_field(object, "warm_up");
  if (has_field(object, "warnings")) made.warnings = count_field(object, "warnings");
  if (has_field(object, "bodies"))
    within("bodies", [&, &bodies = object["bodies"]] {
      read_columns(bodies, made.bodies, body_fields);
      if (has_field(bodies, "z")) read_columns(bodies, made.bodies, out_of_plane_fields);
    });
  if (has_field(object, "contacts"))
    made.contacts = within("contacts", [&] { return read_contacts(object["contacts"]); });
  if (has_field(object, "reactions"))
    within("reactions", [&] { read_columns(object["reactions"], made.reactions, reaction_fields); });
  return run;
}

}  // namespace

std::string to_bytes(const RunRequest& run, Form form, const std::function<bool()>* cancelled) {
  Message message{json::object(), form};
  message.fields["run"] = fields_of(run, form);
  return to_bytes(std::move(message), cancelled);
}

std::string to_bytes(const Request& request, Form form) {
  if (request.run) return to_bytes(*request.run, form, nullptr);
  return to_bytes(Message{{{"describe", true}}, form});
}

std::string to_bytes(const Reply& reply, Form form) {
  json object = json::object();
  if (reply.run) {
    object["run"] = fields_of(*reply.run, form);
  } else {
    object["engines"] = json::array();
    for (const EngineDescription& engine : reply.engines) object["engines"].push_back(fields_of(engine));
  }
  return to_bytes(Message{std::move(object), form});
}

Request read_request(const Message& message) {
  if (!has_field(message.fields, "run")) return {};
  return {read_run_request(message.fields["run"])};
}

Reply read_reply(const Message& message) {
  if (has_field(message.fields, "run")) return {{}, read_run_reply(message.fields["run"])};
  return {read_list(message.fields, "engines", read_engine), {}};
}

}  // namespace rockstack
