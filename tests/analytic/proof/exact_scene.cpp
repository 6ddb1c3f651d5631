#include "tests/analytic/proof/exact_scene.hpp"

#include <toml++/toml.h>
#include <fstream>
#include <set>
#include <stdexcept>

namespace rockstack::proof {
namespace {

using Shape = ExactMotion::Shape;

[[noreturn]] void leave_out(const std::string& what) {
  throw std::runtime_error("the prover leaves out " + what);
}

void allow_keys(const toml::table& table, const std::set<std::string_view>& allowed) {
  for (const auto& [key, value] : table)
    if (!allowed.contains(key.str())) leave_out("key " + std::string(key.str()));
}

Rational number(const toml::node& node) {
  if (const auto whole = node.as_integer()) return decimal(std::to_string(whole->get()));
  if (const auto real = node.as_floating_point(); real && std::isfinite(real->get()))
    return decimal(real->get());
  throw std::runtime_error("expected a finite number");
}

Rational number_or(const toml::table& table, std::string_view key, const Rational& otherwise) {
  const toml::node* node = table.get(key);
  return node ? number(*node) : otherwise;
}

Rational required(const toml::table& table, std::string_view key) {
  const toml::node* node = table.get(key);
  if (!node) throw std::runtime_error("missing key " + std::string(key));
  return number(*node);
}

std::vector<Rational> numbers(const toml::table& table, std::string_view key, std::size_t size) {
  const toml::array* list = table[key].as_array();
  if (!list) return std::vector<Rational>(size);
  std::vector<Rational> result;
  for (const toml::node& node : *list) result.push_back(number(node));
  if (result.size() != size) throw std::runtime_error(std::string(key) + ": a number for each block");
  return result;
}

ExactBlock block(const toml::table& table) {
  allow_keys(table, {"width", "height", "density", "mass", "inertia", "center_of_mass"});
  const Rational width = required(table, "width");
  const Rational height = required(table, "height");
  ExactBlock result;
  result.half_width = width / 2;
  result.half_height = height / 2;
  result.mass = table.get("mass") ? required(table, "mass") : required(table, "density") * width * height;
  result.inertia = number_or(table, "inertia", result.mass * (width * width + height * height) / 12);
  const std::vector<Rational> centre = numbers(table, "center_of_mass", 2);
  result.offset_x = centre[0];
  result.offset_y = centre[1];
  return result;
}

/// The values of a record in units of g or m/s², and its interval in s: a line each, after lines that begin
/// with #.
ExactMotion read_values(const std::filesystem::path& file) {
  std::ifstream input(file);
  if (!input) throw std::runtime_error("no file " + file.string());
  ExactMotion motion{.shape = Shape::samples};
  Rational unit(1);
  for (std::string line; std::getline(input, line);) {
    if (line == "# units: g") unit = decimal("9.80665");
    if (line.starts_with("# dt = ")) motion.interval = decimal(line.substr(7, line.find(" s", 7) - 7));
    if (line.empty() || line[0] == '#') continue;
    if (line.find_first_not_of("+-.0123456789eE") != std::string::npos)
      leave_out("records of several columns");
    motion.samples.push_back(decimal(line) * unit);
  }
  if (motion.interval.sign() <= 0) leave_out("records without a line '# dt = … s'");
  return motion;
}

void scale_to_peak(std::vector<Rational>& samples, const Rational& wanted) {
  Rational largest;
  for (const Rational& sample : samples) {
    const Rational size = sample.sign() < 0 ? Rational() - sample : sample;
    if (largest < size) largest = size;
  }
  for (Rational& sample : samples) sample = sample / largest * wanted;
}

ExactMotion record(const toml::table& table, const std::filesystem::path& folder) {
  allow_keys(table, {"record", "samples", "interval", "scale", "peak"});
  ExactMotion motion{.shape = Shape::samples};
  if (const auto file = table["record"].value<std::string>()) {
    motion = read_values(folder / *file);
  } else {
    motion.interval = required(table, "interval");
    motion.samples = numbers(table, "samples", table["samples"].as_array()->size());
  }
  const Rational scale = number_or(table, "scale", 1);
  for (Rational& sample : motion.samples) sample = sample * scale;
  if (table.get("peak")) scale_to_peak(motion.samples, required(table, "peak"));
  return motion;
}

Shape shape_named(const std::string& name) {
  if (name == "sine" || name == "half-sine") return Shape::sine;
  if (name == "cosine") return Shape::cosine;
  if (name == "rectangle") return Shape::rectangle;
  if (name == "mavroeidis-papageorgiou") return Shape::mavroeidis_papageorgiou;
  leave_out("pulse " + name);
}

ExactMotion pulse(const toml::table& table, const std::string& name) {
  allow_keys(table, {"pulse", "amplitude", "period", "start", "cycles", "phase"});
  const Rational cycles = name == "half-sine" ? Rational(1) / 2 : number_or(table, "cycles", 1);
  return {.shape = shape_named(name),
          .amplitude = required(table, "amplitude"),
          .period = required(table, "period"),
          .start = number_or(table, "start", 0),
          .cycles = cycles,
          .phase = number_or(table, "phase", 0)};
}

ExactMotion motion(const toml::table& ground, std::string_view axis, const std::filesystem::path& folder) {
  const toml::table* table = ground[axis].as_table();
  if (!table) return {};
  if (const auto name = (*table)["pulse"].value<std::string>()) return pulse(*table, *name);
  if (table->get("synthetic")) leave_out("synthetic motions, which no decimal text tells");
  return record(*table, folder);
}

void read_start(const toml::table& table, ExactScene& scene) {
  allow_keys(table, {"angles", "velocities"});
  scene.angles = numbers(table, "angles", scene.blocks.size());
  scene.velocities = numbers(table, "velocities", scene.blocks.size());
}

void read_ground(const toml::table& table, const std::filesystem::path& folder, ExactScene& scene) {
  allow_keys(table, {"horizontal", "vertical", "inclination"});
  scene.inclination = number_or(table, "inclination", 0);
  scene.horizontal = motion(table, "horizontal", folder);
  scene.vertical = motion(table, "vertical", folder);
}

}  // namespace

ExactScene read_exact_scene(const std::filesystem::path& file) {
  const toml::table root = toml::parse_file(file.string());
  // Friction is for laws that slip, depth and engine are for engines.
  allow_keys(root, {"title", "duration", "gravity", "law", "equations", "blocks", "initial", "ground",
                    "contact", "engine", "measured"});
  const std::string law = root["law"].value_or<std::string>("consistent");
  if (law != "paper" && law != "consistent") leave_out("law " + law);
  if (root["equations"].value_or<std::string>("nonlinear") != "nonlinear")
    leave_out("equations that are not in full");
  const toml::array* blocks = root["blocks"].as_array();
  if (!blocks) throw std::runtime_error("missing key blocks");
  ExactScene scene{.paper = law == "paper",
                   .duration = required(root, "duration"),
                   .gravity = number_or(root, "gravity", decimal("9.81"))};
  for (const toml::node& one : *blocks) scene.blocks.push_back(block(*one.as_table()));
  const toml::table none;
  const toml::table* start = root["initial"].as_table();
  read_start(start ? *start : none, scene);
  if (const toml::table* ground = root["ground"].as_table()) read_ground(*ground, file.parent_path(), scene);
  return scene;
}

}  // namespace rockstack::proof
